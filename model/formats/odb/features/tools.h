#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "model/board/document.h"
#include "model/formats/odb/text/records.h"

namespace model::odb {

/// In what the sizes of a tools file are.
enum class ToolUnit : std::uint8_t {
    Stated,  ///< mil or µm by the file's own UNITS; without these mil, whatever the features are in (odb-notes, Units)
    Mil,
    Micrometre,
    Inch,
    Millimetre
};

/// The TOOLS blocks of a drill layer; DrillTool::layer is left open. A unit that is not the stated one is reported.
[[nodiscard]] std::vector<DrillTool> parseTools(std::string_view text, std::string_view path, Diagnostics& diagnostics,
                                                ToolUnit unit = ToolUnit::Stated);

}  // namespace model::odb
