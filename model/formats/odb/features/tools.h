#pragma once

#include <string_view>
#include <vector>

#include "model/board/document.h"
#include "model/formats/odb/text/records.h"

namespace model::odb {

/// The TOOLS blocks of a drill layer; DrillTool::layer is left open. Sizes are mil or µm by the file's own UNITS; a
/// file without UNITS means mil, whatever the features are in (odb-notes, Units).
[[nodiscard]] std::vector<DrillTool> parseTools(std::string_view text, std::string_view path, Diagnostics& diagnostics);

}  // namespace model::odb
