#pragma once

#include <QStatusBar>

namespace ui {

/// A status bar whose messages end with an ellipsis where they find no room.
class StatusBar : public QStatusBar {
    Q_OBJECT

public:
    using QStatusBar::QStatusBar;
    /// What is seen of the message.
    [[nodiscard]] QString shownMessage() const;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    [[nodiscard]] QRect messageRect() const;
};

}  // namespace ui
