#pragma once

#include <string>

#include "app/common/exit_code.h"
#include "app/common/open_board.h"

namespace app {

struct VerifyArguments {
    BoardArguments board;
    std::string step;  ///< a file written by `copperscope export` with the same choices; empty: one is written
    std::vector<std::string> layers;
    std::size_t sample = 0;  ///< at most about so many elements, spread over all shapes; 0: all
    std::uint64_t points = 20'000;
    bool hasPolylines = false;  ///< writes StepOptions::hasPolylines
    bool isStrict = false;      ///< reads without the repairs of the reader
    bool asJson = false;
    bool noPictures = false;
};

/// `copperscope verify BOARD`: proves that what leaves Copperscope is the board (the paper's accuracy experiment).
/// Reads the STEP file back with OpenCASCADE, checks every solid, compares its volume with the formula, and random
/// points and pictures of both pipelines. Exit code 4 if a solid is not valid, not closed, wrong by more than 1e-6 of
/// its volume, or if fewer than 99.99 % of the points agree, or a picture differs by a grey MSE of more than 0.001.
/// Errors: DeviceFailed, without the module that reads STEP too; OutputFailed without a folder for temporary files;
/// Cancelled, by a signal; BadInput; BadUsage.
///
/// JSON: {"solids", "expected", "shapes": [{"shape", "solids", "invalid", "open", "volume_error", "tolerance_nm"}],
/// "points": {"count", "agreeing", "inside", "share"}, "pictures": [{"view", "grey_mse"}], "passed"}
[[nodiscard]] Outcome runVerify(const VerifyArguments& arguments);

}  // namespace app
