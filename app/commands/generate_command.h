#pragma once

#include <cstdint>
#include <string>

#include "app/common/exit_code.h"

namespace app {

struct GenerateArguments {
    std::string like;  ///< a row of the paper's Table 3: "t1" to "t9"
    double scale = 1.0;
    std::uint64_t seed = 1;
    bool isNurbs = false;  ///< as a text model whose areas have NURBS edges
    std::string output;
};

/// `copperscope generate --like t3 -o job.tgz`: a made-up board with exactly the row's element counts times the scale.
/// Returns an exit code.
[[nodiscard]] Outcome runGenerate(const GenerateArguments& arguments);

}  // namespace app
