#include "ui/canvas/view_picture.h"

#include <QColor>
#include <new>
#include <utility>

namespace ui {

namespace {

base::Error failedDevice() {
    return {base::ErrorCode::DeviceFailed, "The graphics device failed"};
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
    const std::lock_guard lock(m_mutex);
    if (m_presenter) {
        m_presenter->makeReady(render::Backend::Auto, m_shot.picture.settings.isSmoothed);
    }
}

base::Status ViewPicture::begin() {
    if (m_device.isLost() || !m_presenter) {
        return failedDevice();
    }
    if (m_shot.picture.scene == nullptr) {
        return base::Done{};
    }
    render::BoardScene& scene = *m_shot.picture.scene;
    const render::SceneLook now(scene);
    m_shot.look->applyTo(scene);
    const base::Status begun = m_presenter->begin(scene, m_shot.camera, m_shot.picture.frameSettings(),
                                                  static_cast<std::uint32_t>(m_shot.pixels.width()),
                                                  static_cast<std::uint32_t>(m_shot.pixels.height()));
    now.applyTo(scene);
    return begun;
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
