#pragma once

#include <string_view>

#include "model/board/diagnostics.h"
#include "model/formats/common/net_points.h"
#include "model/formats/odb/text/records.h"

namespace model::odb {

/// The `netlists/<type>/netlist` file. Reads `$number name` and points; what cannot be read is reported.
[[nodiscard]] formats::Netlist parseNetlist(std::string_view text, std::string_view path, Unit defaultUnit,
                                            Diagnostics& diagnostics);

}  // namespace model::odb
