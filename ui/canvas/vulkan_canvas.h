#pragma once

#include <vulkan/vulkan.h>  // before any Qt header: Qt would hide the prototypes

#include <QTimer>
#include <QWindow>
#include <memory>

#include "render/frame/swapchain_presenter.h"
#include "ui/canvas/camera_controller.h"
#include "ui/canvas/gpu_context.h"
#include "ui/canvas/picture.h"

namespace ui {

/// A native window that shows the picture through a swapchain. Draws when `requestUpdate` was called since the last
/// frame, and not else.
class VulkanCanvas : public QWindow {
    Q_OBJECT

public:
    VulkanCanvas(GpuContext& context, CameraController& controller, const Picture& picture);
    ~VulkanCanvas() override;

    /// Gives up everything made from the device; the next frame makes it anew.
    void releaseDevice();

signals:
    void drawn();
    /// The times of the frame drawn last, a little later.
    void timed(const render::FrameStats& stats);
    void deviceLost();
    /// This window cannot be drawn to with our device.
    void unusable();

protected:
    bool event(QEvent* event) override;
    void exposeEvent(QExposeEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void draw();
    [[nodiscard]] bool makePresenter();
    void askForTimes();

    GpuContext& m_context;
    CameraController& m_controller;
    const Picture& m_picture;
    std::unique_ptr<render::SwapchainPresenter> m_presenter;
    QTimer m_times;  ///< runs while a frame's times are not known
};

}  // namespace ui
