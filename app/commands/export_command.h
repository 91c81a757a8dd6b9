#pragma once

#include <string>
#include <vector>

#include "app/common/exit_code.h"
#include "app/common/open_board.h"

namespace app {

struct ExportArguments {
    BoardArguments board;
    std::string output;               ///< what it ends with is the format
    std::vector<std::string> layers;  ///< names; empty: all that the format shows
    std::vector<std::string> nets;
    std::vector<double> window;  ///< x0, y0, x1, y1 in millimetres of the job's coordinates; empty: the board
    std::string minHole;         ///< a length; empty: all holes
    bool isOuterOnly = false;
    bool hasFittedArcs = false;
    bool isMerged = false;
    bool isOnePart = false;
    bool isAsDesigned = false;
    bool isWrittenOut = false;
    bool hasPolylines = false;
    bool isOnePage = false;
    bool isMirrored = false;
    bool isInstanced = false;
    bool isCompressed = false;
};

/// `copperscope export BOARD -o FILE`: the board as solids, or its layers as drawings (model/export/files). How large
/// the file will be, what was written and what is missing with its reason go to stderr. Errors: BadUsage for names and
/// choices that do not exist, BadInput, OutputFailed when the file cannot be written or nothing could be built; nothing
/// is left of the file then.
[[nodiscard]] Outcome runExport(const ExportArguments& arguments);

}  // namespace app
