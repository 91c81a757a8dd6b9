#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "model/board/diagnostics.h"
#include "model/board/document.h"
#include "model/formats/odb/text/lengths.h"

namespace model::odb {

/// A point of a netlist, in the netlist's own coordinates.
struct NetlistPoint {
    std::int32_t net = -1;  ///< number of its name
    Point position;
    Nm radius = 0;  ///< of the hole or pad; 0: `width` × `height`
    Nm width = 0;
    Nm height = 0;
    LayerSide side = LayerSide::None;  ///< T top, D bottom ("down"), B both: Through, I inner
    bool isEnd = true;                 ///< e: an end of its net; m: on the way
    char exposure = 0;                 ///< e exposed, c covered by solder mask, p or s: covered on one side
    bool isVia = false;
    std::uint32_t line = 0;
};

/// A `netlists/<type>/netlist` file.
struct Netlist {
    std::vector<std::string> names;  ///< by number
    std::vector<NetlistPoint> points;
};

/// Reads `$number name` and points; what cannot be read is reported.
[[nodiscard]] Netlist parseNetlist(std::string_view text, std::string_view path, Unit defaultUnit,
                                   Diagnostics& diagnostics);

}  // namespace model::odb
