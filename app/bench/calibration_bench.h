#pragma once

#include "app/common/exit_code.h"

namespace app {

struct CalibrationBenchArguments {
    bool asJson = false;
};

/// `copperscope bench --calibrate`: how long each back end takes for tilted views of a made-up board on this device,
/// and which one `auto` takes from now on; a table or JSON on stdout. The answer is saved for this user.
/// Errors: DeviceFailed; OutputFailed once the times are printed.
[[nodiscard]] Outcome runCalibrationBench(const CalibrationBenchArguments& arguments);

}  // namespace app
