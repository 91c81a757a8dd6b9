#pragma once

#include <QImage>
#include <QSize>
#include <functional>
#include <memory>
#include <vector>

#include "model/base/result.h"
#include "render/frame/offscreen_presenter.h"
#include "render/tiles/flat_picture.h"

class QPainter;

namespace ui {

/// What a canvas draws; the board view owns it, its canvas reads it.
struct Picture {
    render::BoardScene* scene = nullptr;  ///< null while no board is open
    render::ViewSettings settings;
    std::vector<render::LayerStyle> styles;     ///< one per layer of the scene; views may differ
    QImage overlay;                             ///< null for none; RGBA8888_Premultiplied, in pixels of the picture
    QImage inPlane;                             ///< the same in a plane of the board; null for none
    float planeZ = 0.0F;                        ///< of that plane, mm
    std::shared_ptr<render::FlatPicture> flat;  ///< draws what it can of a flat view without the device; null: nothing
    glm::vec2 faces{0.0F};                      ///< heights of the board's faces, mm, as it is drawn: below, above
    /// Called before each frame of a canvas that has the device draw all of it, with its size in pixels: paints the
    /// overlay.
    std::function<void(QSize pixels)> prepare;
    /// Other canvases ask whether the board is as it was when they asked last,
    std::function<bool()> isBoardSame;
    /// paint the picture in a plane, if there is to be one, and over the board what else would be the overlay, in
    /// logical pixels.
    std::function<void(QSize pixels)> preparePlane;
    std::function<void(QPainter& painter)> paintOver;

    /// The settings with the overlay; the scene has the styles of this picture afterwards.
    [[nodiscard]] render::ViewSettings frameSettings() const;
};

/// The pixels as an image; no copy.
[[nodiscard]] QImage imageOf(render::Image pixels);

/// Draws to memory, `size` in pixels. Errors: those of OffscreenPresenter::render.
[[nodiscard]] base::Result<QImage> drawPicture(render::OffscreenPresenter& presenter, const Picture& picture,
                                               const render::Camera& camera, QSize size);

/// The board of `picture` without the device, in about `budgetMs`; its pixels are those of the flat picture. The scene
/// has its styles then.
[[nodiscard]] render::FlatPicture::Quality drawFlat(const Picture& picture, const render::Camera& camera, QSize pixels,
                                                    double budgetMs);

}  // namespace ui
