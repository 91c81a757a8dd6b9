#pragma once

#include <string>
#include <vector>

#include "model/formats/drawing/drawn_job.h"
#include "model/formats/gerber/board_groups.h"

namespace model::gerber {

/// What was found out about a board on the way, for whoever goes on with it.
struct MadeBoard {
    formats::DrawnJob job;
    bool hasNets = false;  ///< the images name nets (X2)
};

/// Makes a drawn job of the files of one board; drill files may be read again in another format for it. `jobName` names
/// a board that does not name itself.
[[nodiscard]] MadeBoard makeBoard(std::vector<ReadFile>& files, const BoardFiles& board, const std::string& jobName);

}  // namespace model::gerber
