#include "ui/canvas/picture.h"

#include "render/scene/scene_buffers.h"

namespace ui {

namespace {

/// None of a null image.
render::Overlay pixelsOf(const QImage& image) {
    if (image.isNull()) {
        return {};
    }
    return {static_cast<std::uint32_t>(image.width()), static_cast<std::uint32_t>(image.height()), image.constBits()};
}

}  // namespace

render::ViewSettings Picture::frameSettings() const {
    if (scene != nullptr) {
        scene->setStyles(styles);
    }
    render::ViewSettings withOverlay = settings;
    withOverlay.overlay = pixelsOf(overlay);
    withOverlay.inPlane = {pixelsOf(inPlane), planeZ};
    return withOverlay;
}

/// They live as long as it does.
QImage imageOf(render::Image pixels) {
    auto* owner = new render::Image(std::move(pixels));
    return QImage(
        owner->rgba.data(), static_cast<int>(owner->width), static_cast<int>(owner->height),
        static_cast<qsizetype>(owner->width) * 4, QImage::Format_RGBX8888,
        [](void* image) { delete static_cast<render::Image*>(image); }, owner);
}

base::Result<QImage> drawPicture(render::OffscreenPresenter& presenter, const Picture& picture,
                                 const render::Camera& camera, QSize size) {
    ASSIGN_OR_RETURN(render::Image pixels, presenter.render(*picture.scene, camera, picture.frameSettings(),
                                                            static_cast<std::uint32_t>(size.width()),
                                                            static_cast<std::uint32_t>(size.height())));
    return imageOf(std::move(pixels));
}

render::FlatPicture::Quality drawFlat(const Picture& picture, const render::Camera& camera, QSize pixels,
                                      double budgetMs) {
    if (picture.flat == nullptr || picture.scene == nullptr || pixels.isEmpty()) {
        return render::FlatPicture::Quality::None;
    }
    picture.scene->setStyles(picture.styles);
    const render::BoardScene::Impl& scene = picture.scene->impl();
    std::vector<std::vector<render::ElementState>> states;
    for (const render::SceneStep& step : scene.steps) {
        states.push_back(step.states);
    }
    return picture.flat->draw({&scene.layers, states, camera, picture.settings, pixels.width(), pixels.height()},
                              budgetMs);
}

}  // namespace ui
