#pragma once

#include <QLabel>

namespace ui {

/// A line of plain text that takes the room there is: what has none is cut with an ellipsis, and the whole text is in
/// its tool tip.
class ElidedLabel : public QLabel {
    Q_OBJECT

public:
    explicit ElidedLabel(QWidget* parent = nullptr);
    /// What is seen of the text.
    [[nodiscard]] QString shown() const;

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
};

}  // namespace ui
