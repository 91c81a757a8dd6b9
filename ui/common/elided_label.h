#pragma once

#include <QLabel>

namespace ui {

/// A line of plain text that takes the room there is, or at most so many lines: what has no room is cut with an
/// ellipsis, and the whole text is in the tool tip.
class ElidedLabel : public QLabel {
    Q_OBJECT

public:
    explicit ElidedLabel(QWidget* parent = nullptr);
    /// More than one: the text is broken into as many lines as it needs, up to these.
    void setMostLines(int lines);
    /// What is seen of the text.
    [[nodiscard]] QString shown() const;
    [[nodiscard]] bool hasHeightForWidth() const override { return m_mostLines > 1; }
    [[nodiscard]] int heightForWidth(int width) const override;

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    /// Joined they are the text, or its beginning with an ellipsis.
    [[nodiscard]] QStringList linesIn(int width) const;

    int m_mostLines = 1;
};

}  // namespace ui
