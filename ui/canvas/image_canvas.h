#pragma once

#include <QImage>
#include <QTimer>
#include <QWidget>
#include <memory>
#include <optional>

#include "render/tiles/warped_picture.h"
#include "ui/canvas/camera_controller.h"
#include "ui/canvas/device_picture.h"
#include "ui/canvas/gpu_context.h"
#include "ui/canvas/picture.h"

namespace ui {

/// A widget that shows pictures from memory: where the device is software, or the platform has no Vulkan surfaces.
/// Never waits for the device. A flat picture comes from tiles, and is refined in pieces once the view rests; any other
/// from the device, and until that has drawn it the last one is shown as it would be seen from where the camera is.
/// Paints that ask for no frame show the last image.
class ImageCanvas : public QWidget {
    Q_OBJECT

public:
    ImageCanvas(GpuContext& context, CameraController& controller, const Picture& picture, QWidget* parent = nullptr);

    void requestFrame();
    /// Begins to make what pictures of the device need, in the background.
    void makeReady() { m_device.makeReady(); }
    /// Gives up everything made from the device, and what it drew; the next frame makes it anew.
    void releaseDevice();
    /// Another board is to be seen from now on: nothing that was drawn is.
    void clear();

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
    bool drawTiles(QSize pixels);
    void drawByDevice(QSize pixels);
    void goOn();
    /// What the device drew, as it is seen from where the camera is now; neither: it cannot be seen from there.
    struct Warped {
        std::optional<render::WarpedPicture> best;
        std::optional<render::WarpedPicture> rest;  ///< for what the best one does not reach
        bool isNear = false;                        ///< the last picture is as good as another one
    };
    [[nodiscard]] Warped warped(QSize pixels) const;
    [[nodiscard]] std::optional<render::WarpedPicture> warpedShot(const DevicePicture::Shot& shot, QSize pixels) const;
    [[nodiscard]] bool isCoarse() const;
    void prepareWhole();
    void keepFirstWhole(QSize pixels);
    void showShot(const Warped& warped, QSize pixels, bool isNew);
    void fill(QSize pixels);
    [[nodiscard]] std::uint32_t ground() const;
    void announce(const render::FrameStats& stats);

    GpuContext& m_context;
    CameraController& m_controller;
    const Picture& m_picture;
    DevicePicture m_device;
    QImage m_image;  ///< the board; shares the pixels of `m_picture.flat`, `m_warped` or `m_device`
    std::shared_ptr<render::FlatPicture::Pixels> m_warped;  ///< null: none yet
    render::CameraPose m_shown;                             ///< where the image is seen from
    bool m_isStale = true;
    bool m_isDue = true;          ///< the board is another one than the image has, or was asked for
    bool m_isAsked = true;        ///< somebody asked for a frame since the device was asked for one
    bool m_isPlaneShown = false;  ///< the last picture asked for has one in a plane of the board
    bool m_isShotNew = false;     ///< the device has drawn one that was not shown yet
    bool m_isByTiles = false;     ///< the image is
    QTimer m_goOn;                ///< runs while there is more to do
    bool m_isExact = false;       ///< what there is to do about the tiles is for frames to come
    bool m_isWholeDue = true;     ///< the device has drawn the board since it drew all of it
};

}  // namespace ui
