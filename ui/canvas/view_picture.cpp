#include "ui/canvas/view_picture.h"

#include <QColor>
#include <new>
#include <utility>

#include "render/gpu/check.h"

namespace ui {

namespace {

base::Error failedDevice() {
    return {base::ErrorCode::DeviceFailed, "The graphics device failed"};
}

/// `use` of all that makes the picture, while the scene looks as it did for the shot.
template <class Use>
auto asItLooked(const ViewShot& shot, const Use& use) {
    render::BoardScene& scene = *shot.picture.scene;
    const render::SceneLook now(scene);
    shot.look->applyTo(scene);
    auto result = use(scene, shot.camera, shot.picture.frameSettings(), static_cast<std::uint32_t>(shot.pixels.width()),
                      static_cast<std::uint32_t>(shot.pixels.height()));
    now.applyTo(scene);
    return result;
}

}  // namespace

base::Status ViewPicture::check(QSize pixels, const render::gpu::Device& device) {
    if (device.isLost()) {
        return failedDevice();
    }
    return render::OffscreenPresenter::checkSize(device, static_cast<std::uint32_t>(pixels.width()),
                                                 static_cast<std::uint32_t>(pixels.height()));
}

ViewPicture::ViewPicture(ViewShot shot, render::gpu::Device& device)
    : m_shot(std::move(shot)), m_device(device), m_presenter(std::in_place, device) {}

void ViewPicture::prepare() {
    if (m_shot.plane) {
        QImage plane(m_shot.pixels, QImage::Format_RGBA8888_Premultiplied);
        if (plane.isNull()) {
            throw std::bad_alloc();
        }
        plane.fill(Qt::transparent);
        m_shot.plane->paintOn(plane);
        m_shot.picture.inPlane = plane;
    }
}

std::function<void()> ViewPicture::lacking() {
    if (m_device.isLost() || !m_presenter || m_shot.picture.scene == nullptr) {
        return [] {};
    }
    std::function<void()> all =
        asItLooked(m_shot, [this](auto&&... picture) { return m_presenter->preparation(picture...); });
    return [this, all = std::move(all)] {
        const std::lock_guard lock(m_mutex);
        try {
            if (m_presenter && all) {
                all();
            }
        } catch (const render::gpu::OutOfMemory&) {
            return;  // tried again when the picture is begun, which says so
        }
    };
}

base::Status ViewPicture::begin() {
    if (m_device.isLost() || !m_presenter) {
        return failedDevice();
    }
    if (m_shot.picture.scene == nullptr) {
        return base::Done{};
    }
    return asItLooked(m_shot, [this](auto&&... picture) { return m_presenter->begin(picture...); });
}

base::Result<bool> ViewPicture::isDone(std::uint64_t patienceNs) {
    if (m_shot.picture.scene == nullptr || m_presenter->isDone(patienceNs)) {
        return true;
    }
    if (m_device.isLost()) {
        return failedDevice();
    }
    return false;
}

base::Result<QImage> ViewPicture::finish() {
    QImage picture;
    if (m_shot.picture.scene == nullptr) {
        picture = ground();
    } else {
        const std::lock_guard lock(m_mutex);
        if (!m_presenter) {
            return failedDevice();
        }
        picture = imageOf(m_presenter->image());
        m_presenter.reset();  // it holds several times as much as the picture
    }
    m_shot.overlay.paintOn(picture);
    return picture;
}

QImage ViewPicture::ground() const {
    const glm::vec3& colour = m_shot.picture.settings.background;
    QImage picture(m_shot.pixels, QImage::Format_RGBX8888);
    picture.fill(QColor::fromRgbF(colour.r, colour.g, colour.b));
    return picture;
}

void ViewPicture::release() {
    const std::lock_guard lock(m_mutex);
    m_presenter.reset();
}

}  // namespace ui
