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
/// frame, and not else; never waits for the device, but shows a picture once it is done.
class VulkanCanvas : public QWindow {
    Q_OBJECT

public:
    VulkanCanvas(GpuContext& context, CameraController& controller, const Picture& picture);
    ~VulkanCanvas() override;

    /// Gives up everything made from the device; the next frame makes it anew.
    void releaseDevice();

signals:
    /// The picture is shown.
    void drawn();
    /// The times of that picture.
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
    [[nodiscard]] render::SwapchainPresenter::Outcome beginPicture();
    void showIfDone(std::uint64_t patienceNs);
    void finish(render::SwapchainPresenter::Outcome outcome);
    void stop();

    GpuContext& m_context;
    CameraController& m_controller;
    const Picture& m_picture;
    std::unique_ptr<render::SwapchainPresenter> m_presenter;
    QTimer m_look;               ///< runs while the device draws: is it done?
    bool m_isWanted = false;     ///< another picture, after the one the device draws
    bool m_isSecondTry = false;  ///< after a picture that the window had no use for
};

}  // namespace ui
