#pragma once

#include "ui/workspace/feature.h"

namespace ui {

class BoardView;

/// The 2D and 3D views: cameras, what is drawn over the board, appearance, pictures.
void addViews(FeatureContext& context);

/// Writes what the view shows as PNG, `width` pixels wide (0: as on the screen). Errors: those of
/// BoardView::grabPicture, OutputFailed.
[[nodiscard]] base::Status savePicture(BoardView& view, const QString& path, int width = 0);

}  // namespace ui
