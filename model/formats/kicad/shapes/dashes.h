#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "model/formats/kicad/shapes/chains.h"

namespace model::kicad {

enum class LineStyle : std::uint8_t { Solid, Dash, Dot, DashDot, DashDotDot };

/// What (type …) of a stroke says: "dash_dot"; solid where it is nothing of the kind.
[[nodiscard]] LineStyle lineStyleOf(std::string_view type);

/// How long dashes and gaps of a board are, in widths of the pen.
struct DashRatios {
    double dash = 12.0;  ///< with both round ends
    double gap = 3.0;    ///< between round ends
};

/// The strokes that KiCad breaks a line or arc into, by their middle lines. They begin anew at every edge; on arcs they
/// run clockwise, on whole circles from the right. The edge itself where it is solid, or would have too many.
[[nodiscard]] std::vector<ChainEdge> dashesOf(const ChainEdge& edge, double pen, LineStyle style,
                                              const DashRatios& ratios);

}  // namespace model::kicad
