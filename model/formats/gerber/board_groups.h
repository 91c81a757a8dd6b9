#pragma once

#include <string>
#include <vector>

#include "model/formats/gerber/job_files.h"

namespace model::gerber {

/// The files of one of the boards that lie in a job.
struct BoardFiles {
    std::string name;
    std::vector<std::size_t> files;  ///< rows of the read files, in their order
    std::size_t copperLayers = 0;
};

/// Tells the boards of a job apart: files that claim the same copper layer are of different boards, which folders or
/// the names in front of their roles tell. The one with most copper layers (then most objects) comes first. Files that
/// could be of any board are in all of them.
[[nodiscard]] std::vector<BoardFiles> boardsOf(const std::vector<ReadFile>& files);

}  // namespace model::gerber
