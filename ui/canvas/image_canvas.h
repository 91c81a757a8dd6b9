#pragma once

#include <QImage>
#include <QTimer>
#include <QWidget>
#include <optional>

#include "ui/canvas/camera_controller.h"
#include "ui/canvas/gpu_context.h"
#include "ui/canvas/picture.h"

namespace ui {

/// A widget that shows the picture by drawing it to memory first: for platforms without Vulkan surfaces. Draws anew
/// only after `requestFrame` or a change of size; other paints reuse the last image. A flat picture that was drawn
/// roughly is refined in pieces once the view rests.
class ImageCanvas : public QWidget {
    Q_OBJECT

public:
    ImageCanvas(GpuContext& context, CameraController& controller, const Picture& picture, QWidget* parent = nullptr);

    void requestFrame();
    /// Gives up everything made from the device; the next frame makes it anew.
    void releaseDevice() { m_presenter.reset(); }

signals:
    void drawn();
    void timed(const render::FrameStats& stats);
    void deviceLost();

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void draw(QSize pixels);
    bool drawWithoutDevice(QSize pixels);
    void refine();

    GpuContext& m_context;
    CameraController& m_controller;
    const Picture& m_picture;
    std::optional<render::OffscreenPresenter> m_presenter;
    QImage m_image;
    bool m_isStale = true;
    QTimer m_refine;  ///< runs while the picture is rough
};

}  // namespace ui
