#include "ui/canvas/vulkan_canvas.h"

#include <QExposeEvent>
#include <QPlatformSurfaceEvent>
#include <QVulkanInstance>
#include <cmath>

namespace ui {

namespace {

constexpr int kAskMs = 15;

/// The window's size in device pixels, rounded as the window system does.
glm::uvec2 pixelSize(const QWindow& window) {
    const double ratio = window.devicePixelRatio();
    return {static_cast<std::uint32_t>(std::lround(window.width() * ratio)),
            static_cast<std::uint32_t>(std::lround(window.height() * ratio))};
}

bool losesSurface(const QEvent& event) {
    return event.type() == QEvent::PlatformSurface &&
           static_cast<const QPlatformSurfaceEvent&>(event).surfaceEventType() ==
               QPlatformSurfaceEvent::SurfaceAboutToBeDestroyed;
}

}  // namespace

VulkanCanvas::VulkanCanvas(GpuContext& context, CameraController& controller, const Picture& picture)
    : m_context(context), m_controller(controller), m_picture(picture) {
    setSurfaceType(QSurface::VulkanSurface);
    setVulkanInstance(context.surfaceInstance());
    m_times.setInterval(kAskMs);
    connect(&m_times, &QTimer::timeout, this, &VulkanCanvas::askForTimes);
}

VulkanCanvas::~VulkanCanvas() = default;

void VulkanCanvas::releaseDevice() {
    m_presenter.reset();
}

bool VulkanCanvas::event(QEvent* event) {
    if (event->type() == QEvent::UpdateRequest) {
        draw();
        return true;
    }
    if (losesSurface(*event)) {
        m_presenter.reset();  // the swapchain must go before its surface
    }
    return m_controller.handle(*event) || QWindow::event(event);
}

void VulkanCanvas::exposeEvent(QExposeEvent*) {
    if (isExposed()) {
        draw();  // at once: waiting for the next update would show an empty window first
    }
}

void VulkanCanvas::resizeEvent(QResizeEvent*) {
    m_controller.setViewport(size());
}

bool VulkanCanvas::makePresenter() {
    const VkSurfaceKHR surface = QVulkanInstance::surfaceForWindow(this);
    if (surface == VK_NULL_HANDLE || !m_context.device().canPresentTo(surface)) {
        emit unusable();
        return false;
    }
    m_presenter = std::make_unique<render::SwapchainPresenter>(m_context.device(), surface);
    return true;
}

void VulkanCanvas::askForTimes() {
    const auto stats = m_presenter ? m_presenter->finishedStats() : std::nullopt;
    if (stats || !m_presenter) {
        m_times.stop();
    }
    if (stats) {
        emit timed(*stats);
    }
}

void VulkanCanvas::draw() {
    if (!isExposed()) {
        return;
    }
    if (m_context.device().isLost()) {
        emit deviceLost();
        return;
    }
    if (!m_presenter && !makePresenter()) {
        return;
    }
    const glm::uvec2 size = pixelSize(*this);
    m_presenter->resize(size.x, size.y);
    m_picture.prepare(QSize(static_cast<int>(size.x), static_cast<int>(size.y)));
    switch (m_presenter->draw(m_picture.scene, m_controller.camera(), m_picture.frameSettings())) {
        case render::SwapchainPresenter::Outcome::Done:
            vulkanInstance()->presentQueued(this);
            m_times.start();
            emit drawn();
            break;
        case render::SwapchainPresenter::Outcome::Skipped: break;
        case render::SwapchainPresenter::Outcome::DeviceLost: emit deviceLost(); break;
    }
}

}  // namespace ui
