#pragma once

#include "model/export/drawings/drawing.h"

namespace model {

enum class PdfPages : std::uint8_t {
    OnePerLayer,     ///< with a bookmark each
    BottomMirrored,  ///< the same, and layers of the bottom as they are seen from below
    AllOnOne         ///< the lowest layer first; viewers can switch each on and off
};

/// Layers as PDF 1.5 with filled paths. Pages are as large as the board; a region is a path, arcs are curves that are
/// nowhere 10 nm off. A page of one layer has the outline of the board, too, and below it a line that says which layer
/// of which job it is, and in which scale. Colours that would hardly be seen on paper are darker. `file` is left to be
/// committed. Errors: as drawLayers.
[[nodiscard]] base::Result<DrawingReport> writePdf(const Document& board, const DrawingOptions& options, PdfPages pages,
                                                   FileWriter& file, base::Progress& progress);

}  // namespace model
