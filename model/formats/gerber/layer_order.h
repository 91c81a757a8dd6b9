#pragma once

#include <string>
#include <vector>

#include "model/formats/drawing/drawn_job.h"
#include "model/formats/gerber/board_groups.h"

namespace model::gerber {

/// The layers of a board in physical order, and which file each comes from.
struct OrderedLayers {
    std::vector<formats::DrawnLayer> layers;
    std::vector<std::int32_t> files;   ///< by layer: row of the read files; none for dielectrics
    std::vector<std::int32_t> copper;  ///< rows of `layers`, from the top
};

/// Orders copper by what is told, numbers and names, and puts the dielectrics of the job file between. Files that claim
/// one layer, and guesses, are reported.
[[nodiscard]] OrderedLayers orderedLayers(const std::vector<ReadFile>& files, const BoardFiles& board,
                                          const JobFileFacts& job, Diagnostics& diagnostics);

}  // namespace model::gerber
