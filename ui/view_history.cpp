#include "ui/view_history.h"

namespace ui {

ViewHistory::ViewHistory(CameraController& controller, QObject* parent) : QObject(parent), m_controller(controller) {
    m_rest.setSingleShot(true);
    m_rest.setInterval(kRestMs);
    connect(&m_rest, &QTimer::timeout, this, &ViewHistory::onRest);
    connect(&controller, &CameraController::moved, &m_rest, qOverload<>(&QTimer::start));
}

void ViewHistory::clear() {
    m_places.clear();
    m_at = 0;
    m_rest.start();  // the first place is where the view comes to rest
}

void ViewHistory::onRest() {
    const render::CameraPose& pose = m_controller.camera().pose();
    if (!m_places.empty() && m_places[m_at] == pose) {
        return;
    }
    m_places.resize(m_places.empty() ? 0 : m_at + 1);
    m_places.push_back(pose);
    if (m_places.size() > kMost) {
        m_places.erase(m_places.begin());
    }
    m_at = m_places.size() - 1;
}

void ViewHistory::back() {
    if (m_rest.isActive()) {
        onRest();  // what is left now can be come back to
    }
    if (canGoBack()) {
        goTo(m_at - 1);
    }
}

void ViewHistory::forward() {
    if (canGoForward()) {
        goTo(m_at + 1);
    }
}

void ViewHistory::goTo(std::size_t place) {
    m_at = place;
    m_controller.setPose(m_places[place]);
    m_rest.stop();
}

}  // namespace ui
