#pragma once

#include <string>
#include <vector>

#include "app/common/exit_code.h"
#include "model/base/progress.h"
#include "model/board/document.h"

namespace app {

struct ClearanceMapArguments {
    std::string file;  ///< .png or .csv; empty: no map
    std::string reach = "0.5mm";
    std::string resolution;      ///< side of a cell, a length; empty: as many cells as are easy to look at
    std::vector<double> window;  ///< x0, y0, x1, y1 in millimetres of the job's coordinates; empty: the board
};

/// `copperscope clearance BOARD --map FILE --layer NAME`: the spacing between nets at every location of a layer, as a
/// picture with a legend or as a table. Errors: BadUsage for wrong arguments, BadInput if there are no two nets,
/// OutputFailed.
[[nodiscard]] Outcome runClearanceMap(const ClearanceMapArguments& arguments, const model::Document& board,
                                      const std::string& layer, base::Progress& progress);

}  // namespace app
