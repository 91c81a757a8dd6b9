#pragma once

#include "model/export/drawings/drawing.h"

namespace model {

/// Layers as DXF of AutoCAD 2000 (AC1015): a layer per layer of the board by its name, closed polylines with bulges for
/// arcs (LWPOLYLINE) and circles, one for each outline and each hole; millimetres, in the coordinates of the board.
/// Colours are the nearest of AutoCAD's table. `file` is left to be committed. Errors: as drawLayers.
[[nodiscard]] base::Result<DrawingReport> writeDxf(const Document& board, const DrawingOptions& options,
                                                   FileWriter& file, base::Progress& progress);

}  // namespace model
