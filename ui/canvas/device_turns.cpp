#include "ui/canvas/device_turns.h"

#include <algorithm>

namespace ui {

bool DeviceTurns::begin(QObject& user) {
    if (m_user == nullptr) {
        m_user = &user;
    }
    if (m_user != &user && std::ranges::find(m_waiting, &user) == m_waiting.end()) {
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
    if (!m_waiting.empty()) {
        m_user = m_waiting.front();
        m_waiting.pop_front();
        emit came(m_user);
    }
}

}  // namespace ui
