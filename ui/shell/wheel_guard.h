#pragma once

#include <QObject>

namespace ui {

/// The wheel over a box, slider or choice that does not have the keyboard scrolls what it lies in, and does not change
/// its value: nobody who only wants to scroll past sets something by it. For all windows of the program, as long as it
/// lives.
class WheelGuard : public QObject {
    Q_OBJECT

public:
    explicit WheelGuard(QObject* parent = nullptr);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
};

}  // namespace ui
