#include "ui/canvas/vulkan_canvas.h"

#include <QExposeEvent>
#include <QPlatformSurfaceEvent>
#include <QVulkanInstance>
#include <cmath>
#include <utility>

namespace ui {

namespace {

constexpr int kLookMs = 2;
/// A picture that is done within this time is shown at once.
constexpr std::uint64_t kPatienceNs = 6'000'000;

using Outcome = render::SwapchainPresenter::Outcome;

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
    m_look.setTimerType(Qt::PreciseTimer);
    m_look.setInterval(kLookMs);
    connect(&m_look, &QTimer::timeout, this, [this] { showIfDone(0); });
    connect(&context.turns(), &DeviceTurns::came, this, [this](QObject* user) {
        if (user == this) {
            draw();
        }
    });
}

VulkanCanvas::~VulkanCanvas() {
    stop();
}

void VulkanCanvas::releaseDevice() {
    m_presenter.reset();
    stop();
}

/// Gives way to others.
void VulkanCanvas::stop() {
    m_look.stop();
    m_context.turns().end(*this);
}

bool VulkanCanvas::event(QEvent* event) {
    if (event->type() == QEvent::UpdateRequest) {
        draw();
        return true;
    }
    if (losesSurface(*event)) {
        releaseDevice();  // the swapchain must go before its surface
    }
    return m_controller.handle(*event) || QWindow::event(event);
}

void VulkanCanvas::exposeEvent(QExposeEvent*) {
    if (isExposed()) {
        draw();  // at once: waiting for the next update would show an empty window first
    }
}

void VulkanCanvas::resizeEvent(QResizeEvent*) {
    m_controller.setViewport(size(), devicePixelRatio());
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

Outcome VulkanCanvas::beginPicture() {
    if (m_context.device().isLost()) {
        return Outcome::DeviceLost;
    }
    if (!m_presenter && !makePresenter()) {
        return Outcome::Skipped;
    }
    const glm::uvec2 size = pixelSize(*this);
    if (const Outcome outcome = m_presenter->setSize(size.x, size.y); outcome != Outcome::Done) {
        return outcome;
    }
    m_picture.prepare(QSize(static_cast<int>(size.x), static_cast<int>(size.y)));
    const bool isBegun = m_presenter->draw(m_picture.scene, m_controller.camera(), m_picture.frameSettings());
    return isBegun ? Outcome::Done : Outcome::DeviceLost;
}

void VulkanCanvas::draw() {
    if (!isExposed()) {
        stop();
        return;
    }
    m_isWanted = m_look.isActive();
    if (m_isWanted || !m_context.turns().begin(*this)) {
        return;
    }
    if (const Outcome outcome = beginPicture(); outcome != Outcome::Done) {
        finish(outcome);
        return;
    }
    m_look.start();
    showIfDone(kPatienceNs);
}

void VulkanCanvas::showIfDone(std::uint64_t patienceNs) {
    if (m_presenter->isDrawn(patienceNs)) {
        finish(m_presenter->present());
    } else if (m_context.device().isLost()) {
        finish(Outcome::DeviceLost);
    }
}

void VulkanCanvas::finish(Outcome outcome) {
    const bool isResized = outcome == Outcome::Skipped && m_look.isActive();
    const bool isTriedAgain = isResized && !std::exchange(m_isSecondTry, true);
    stop();
    if (std::exchange(m_isWanted, false) || isTriedAgain) {
        requestUpdate();
    }
    if (outcome == Outcome::DeviceLost) {
        emit deviceLost();
    } else if (outcome == Outcome::Done) {
        m_isSecondTry = false;
        const render::FrameStats stats = m_presenter->stats();
        vulkanInstance()->presentQueued(this);
        emit drawn();
        emit timed(stats);
    }
}

}  // namespace ui
