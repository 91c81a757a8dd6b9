#pragma once

#include <QScrollArea>

class QLabel;

namespace ui {

/// Notes below a table, in plain text: as many lines as they need, but at most three, with a scroll bar for more.
/// Without any it is hidden.
class NotesArea : public QScrollArea {
    Q_OBJECT

public:
    explicit NotesArea(QWidget* parent = nullptr);

    /// Begins at the first line again.
    void setText(const QString& text);
    [[nodiscard]] bool hasHeightForWidth() const override { return true; }
    [[nodiscard]] int heightForWidth(int width) const override;

private:
    QLabel* m_text;
};

}  // namespace ui
