#pragma once

#include "model/export/drawings/drawing.h"

namespace model {

enum class PdfPages : std::uint8_t {
    OnePerLayer,  ///< with a bookmark each
    AllOnOne      ///< the lowest layer first; viewers can switch each on and off
};

/// Layers as PDF 1.5 with filled paths. Pages are as large as the board; a region is a path, arcs are curves that are
/// nowhere 10 nm off. `file` is left to be committed. Errors: as drawLayers.
[[nodiscard]] base::Result<DrawingReport> writePdf(const Document& board, const DrawingOptions& options, PdfPages pages,
                                                   FileWriter& file, base::Progress& progress);

}  // namespace model
