#pragma once

#include "model/base/progress.h"
#include "model/generate/layout.h"
#include "model/generate/text_sink.h"

namespace model::generate {

/// Writes the board as a text model of the paper (docs/paper-format.md), in mil, without nets. The edges of its areas
/// are NURBS curves of several kinds, all within the room that the areas of the job take:
/// - small pads: straight sides, quarters of circles at the corners (degree 2, rational)
/// - middle pads: straight sides, corners of degree 3
/// - large pads: one closed curve of degree 3 with 16 control points
/// - planes: sides of degree 5 that wave inwards by at most 60 µm, with circles of 9 control points around vias.
/// Returns early when `progress` is cancelled.
void writeModelText(TextSink& out, const Layout& layout, const base::Progress& progress);

}  // namespace model::generate
