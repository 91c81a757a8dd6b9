#pragma once

#include <QTimer>
#include <QWidget>

#include "ui/camera_controller.h"
#include "ui/gpu_context.h"
#include "ui/picture.h"

namespace ui {

class ImageCanvas;
class VulkanCanvas;

/// The 3D viewport: a camera, its input, and a canvas of the kind the platform can show. Draws only when something
/// changed, and once however much changed since the last frame. Where frames are slow (software Vulkan), edges are not
/// smoothed while the view moves, and are again as soon as it rests.
class BoardView : public QWidget {
    Q_OBJECT

public:
    explicit BoardView(GpuContext& context, QWidget* parent = nullptr);
    ~BoardView() override;

    /// Shows a scene, which the caller keeps alive until it sets another one; null shows the background. The camera is
    /// the caller's affair.
    void setScene(render::BoardScene* scene);
    /// Box of the board in model millimetres, before explosion.
    void setBoard(const glm::vec3& boxMin, const glm::vec3& boxMax);
    void setBackend(render::Backend backend);
    /// 0 to 1, see render::ViewSettings.
    void setExplode(float explode);
    void requestFrame();

    [[nodiscard]] CameraController& controller() { return m_controller; }
    /// The widget or window that takes the input.
    [[nodiscard]] QObject& canvas();
    /// What the canvas shows, drawn to memory in its size times `scale`. Errors: BadUsage, DeviceFailed.
    [[nodiscard]] base::Result<QImage> grabPicture(double scale = 1.0);
    /// Gives up what was made from the device, before it is renewed.
    void releaseDevice();

signals:
    void drawn();
    /// How long the frame drawn last took, once that is known.
    void timed(const render::FrameStats& stats);
    void deviceLost();

private:
    void showVulkanCanvas();
    void showImageCanvas();
    void replaceCanvas(QWidget* canvas);
    void requestMovingFrame();
    void requestRestingFrame();
    void onTimed(const render::FrameStats& stats);
    void updateBox();

    GpuContext& m_context;
    CameraController m_controller;
    Picture m_picture;
    glm::vec3 m_boxMin{-1.0F};
    glm::vec3 m_boxMax{1.0F};
    VulkanCanvas* m_window = nullptr;  ///< at most one of the two; owned by its container
    ImageCanvas* m_image = nullptr;
    QWidget* m_container = nullptr;
    QTimer m_rest;          ///< runs out when the view has not moved for a while
    bool m_isSlow = false;  ///< a frame of this scene took longer than an eye blinks away
};

}  // namespace ui
