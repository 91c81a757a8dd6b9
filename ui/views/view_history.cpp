#include "ui/views/view_history.h"

namespace ui {

ViewHistory::ViewHistory(CameraController& controller, QObject* parent) : QObject(parent), m_controller(controller) {
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRestMs);
    connect(&m_rest, &QTimer::timeout, this, &ViewHistory::onRest);
    connect(&controller, &CameraController::moved, &m_rest, qOverload<>(&QTimer::start));
}

void ViewHistory::clear() {
    m_locations.clear();
    m_at = 0;
    m_rest.start();  // the first place is where the view comes to rest
}

void ViewHistory::onRest() {
    render::CameraPose pose = m_controller.camera().pose();
    pose.isOrthographic = false;  // no part of where it is
    if (!m_locations.empty() && m_locations[m_at] == pose) {
        return;
    }
    m_locations.resize(m_locations.empty() ? 0 : m_at + 1);
    m_locations.push_back(pose);
    if (m_locations.size() > kMost) {
        m_locations.erase(m_locations.begin());
    }
    m_at = m_locations.size() - 1;
}

void ViewHistory::back() {
    if (m_rest.isActive()) {
        onRest();  // what is left now can be come back to
    }
    if (m_at > 0) {
        goTo(m_at - 1);
    }
}

void ViewHistory::forward() {
    if (m_at + 1 < m_locations.size()) {
        goTo(m_at + 1);
    }
}

void ViewHistory::goTo(std::size_t location) {
    m_at = location;
    render::CameraPose pose = m_locations[location];
    pose.isOrthographic = m_controller.camera().isOrthographic();
    m_controller.setPose(pose);
    m_rest.stop();
}

}  // namespace ui
