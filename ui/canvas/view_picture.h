#pragma once

#include <functional>
#include <mutex>
#include <optional>

#include "render/scene/scene_look.h"
#include "ui/canvas/gpu_context.h"
#include "ui/canvas/picture.h"
#include "ui/canvas/recorded_painting.h"

namespace ui {

/// What a view shows, to be drawn later: cameras, layers and selection may be others by then.
struct ViewShot {
    Picture picture;                        ///< without what is painted
    std::optional<render::SceneLook> look;  ///< of its scene, if there is one
    render::Camera camera;
    QSize pixels;
    RecordedPainting overlay;
    std::optional<RecordedPainting> plane;  ///< Picture::inPlane
};

/// A picture of a view in the making, step by step, so that the window needs to wait for none: `prepare`, asking what
/// is lacking and making it, `begin`, asking `isDone` until it is, `finish`. `prepare`, making and `finish` take long,
/// and may be done by any thread; the others belong to the thread of the device, and the scene must still be there.
class ViewPicture {
public:
    /// Can there be one of this size now? Errors: BadUsage, DeviceFailed.
    [[nodiscard]] static base::Status check(QSize pixels, const render::gpu::Device& device);

    ViewPicture(ViewShot shot, render::gpu::Device& device);

    /// Paints what lies in the plane.
    void prepare();
    /// What the device lacks for it, to be made: as Renderer::preparation.
    [[nodiscard]] std::function<void()> lacking();
    /// Has the device draw the board, as it looked for the shot; it looks as now for others. Errors: DeviceFailed.
    [[nodiscard]] base::Status begin();
    /// Waits so many nanoseconds for it at most. Errors: DeviceFailed.
    [[nodiscard]] base::Result<bool> isDone(std::uint64_t patienceNs = 0);
    /// The picture, with all that is painted over the board. Errors: DeviceFailed, if it was released.
    [[nodiscard]] base::Result<QImage> finish();
    /// Gives up what was made from the device, before it is renewed.
    void release();
    [[nodiscard]] const render::BoardScene* scene() const { return m_shot.picture.scene; }

private:
    [[nodiscard]] QImage ground() const;

    ViewShot m_shot;
    render::gpu::Device& m_device;
    std::mutex m_mutex;  ///< of the next
    std::optional<render::OffscreenPresenter> m_presenter;
};

}  // namespace ui
