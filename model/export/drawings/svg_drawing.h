#pragma once

#include "model/export/drawings/drawing.h"

namespace model {

/// Layers as SVG 1.1 in UTF-8: a group per layer with its name as title, the lowest layer first; a path per region,
/// filled by the rule "evenodd", with arcs as arcs. The picture is as large as the board in millimetres, and so is a
/// unit of its viewBox; y runs down from the upper edge. `file` is left to be committed. Errors: as drawLayers.
[[nodiscard]] base::Result<DrawingReport> writeSvg(const Document& board, const DrawingOptions& options,
                                                   FileWriter& file, base::Progress& progress);

}  // namespace model
