#pragma once

#include <QImage>
#include <QSize>

#include "model/base/result.h"
#include "render/view.h"

namespace ui {

/// What a canvas draws; the board view owns it, its canvas reads it.
struct Picture {
    render::BoardScene* scene = nullptr;  ///< null while no board is open
    render::ViewSettings settings;
};

/// Draws to memory, `size` in pixels. A null scene gives the background. Errors: those of OffscreenPresenter::render.
[[nodiscard]] base::Result<QImage> drawPicture(render::OffscreenPresenter& presenter, const Picture& picture,
                                               const render::Camera& camera, QSize size);

}  // namespace ui
