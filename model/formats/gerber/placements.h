#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/board/diagnostics.h"
#include "model/board/document.h"

namespace model::gerber {

/// A row of a pick-and-place file, in its own coordinates.
struct PlacedPart {
    std::string refdes;
    std::string value;
    std::string package;
    Point position;
    double rotationDeg = 0.0;  ///< counter-clockwise
    LayerSide side = LayerSide::None;
    std::uint32_t line = 0;
};

struct PlacementFile {
    std::vector<PlacedPart> parts;
};

[[nodiscard]] bool looksLikePlacements(std::string_view head);
/// Comma, semicolon, tab or blank separated, with a line that names the columns. Rows that cannot be read are reported.
[[nodiscard]] PlacementFile parsePlacements(std::string_view text, std::string_view path, Diagnostics& diagnostics);

}  // namespace model::gerber
