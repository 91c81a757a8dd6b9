#include "ui/canvas/device_turns.h"

#include <QMetaObject>
#include <algorithm>
#include <utility>

namespace ui {

bool DeviceTurns::begin(QObject& user) {
    if (m_user == nullptr) {
        m_user = &user;
    }
    if (m_user == &user) {
        m_isDue = false;
    } else if (std::ranges::find(m_waiting, &user) == m_waiting.end()) {
        m_waiting.push_back(&user);
    }
    return m_user == &user;
}

void DeviceTurns::end(QObject& user) {
    std::erase(m_waiting, &user);
    if (m_user != &user) {
        return;
    }
    m_user = nullptr;
    m_isDue = !m_waiting.empty();
    if (m_isDue) {
        m_user = m_waiting.front();
        m_waiting.pop_front();
        QMetaObject::invokeMethod(this, &DeviceTurns::giveTurn, Qt::QueuedConnection);
    }
}

void DeviceTurns::giveTurn() {
    if (std::exchange(m_isDue, false)) {
        emit came(m_user);
    }
}

}  // namespace ui
