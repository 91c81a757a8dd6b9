#pragma once

#include <QObject>
#include <deque>

namespace ui {

/// Who may use the device now. It does one thing after the other, and a frame may take it long: what is given to it
/// meanwhile waits, and so would the window. So there is one user at a time, who looks now and then whether the device
/// is done, and the others come in the order in which they asked. A turn comes from the event loop: while a window is
/// taken apart, where each of its users ends, none begins.
class DeviceTurns : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// True: it is the turn of `user` until `end`. Else its turn comes later, once however often it asks.
    [[nodiscard]] bool begin(QObject& user);
    /// The turn of `user` is over, or it no longer wants one.
    void end(QObject& user);
    /// It is nobody's turn: all that was to be drawn is shown.
    [[nodiscard]] bool isFree() const { return m_user == nullptr; }

signals:
    /// It is the turn of `user`: to be used, or ended, at once.
    void came(QObject* user);

private:
    void giveTurn();

    QObject* m_user = nullptr;
    bool m_isDue = false;  ///< it was not told yet
    std::deque<QObject*> m_waiting;
};

}  // namespace ui
