#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/base/units.h"
#include "model/diagnostics.h"
#include "model/odb/lengths.h"

namespace model::odb {

/// A TOOLS block of a drill layer. Sizes are 0 where the job does not know them.
struct Tool {
    int number = 0;
    std::string type;  ///< PLATED, NON_PLATED, VIA as written
    base::Nm finishedSize = 0;
    base::Nm drillSize = 0;
};

/// Sizes are mil or µm by the file's own UNITS; a file without UNITS means mil, whatever the features are in (facts
/// §3).
[[nodiscard]] std::vector<Tool> parseTools(std::string_view text, std::string_view path, Diagnostics& diagnostics);

}  // namespace model::odb
