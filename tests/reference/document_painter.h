#pragma once

#include "model/board/document.h"
#include "tests/reference/raster.h"

namespace reference {

/// Paints elements of a document from its tables, curves as they are: what Copperscope says is there.
void paint(const model::Document& document, model::ElementId element, Raster& raster);
/// The region of a shape where it was drawn.
void paint(const model::Document& document, model::ShapeId shape, Raster& raster);

}  // namespace reference
