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
    /// In nm, not rounded, also beyond the largest coordinate: the origin, and where the file does not say it the unit,
    /// are found out when it is laid on the board.
    base::PointD position;
    /// Counter-clockwise, seen from the top. A part on the bottom lies at 0 as it would on the top, flipped along the y
    /// axis: x becomes -x.
    double rotationDeg = 0.0;
    LayerSide side = LayerSide::None;
    std::uint32_t line = 0;
};

struct PlacementFile {
    std::vector<PlacedPart> parts;
    bool isOnImages = false;  ///< counts from the origin of the images (X3), not from one of its own
    bool saysUnit = true;     ///< otherwise places are as if in mm
};

/// PlacedPart::rotationDeg for a rotation that counts from the part flipped along the x axis, as KiCad and Gerber X3 do
/// (paragraph 5.6.16 of the Gerber Layer Format Specification): half a turn more on the bottom.
[[nodiscard]] constexpr double fromFlipAlongX(double degrees, LayerSide side) {
    return side == LayerSide::Bottom ? degrees + 180.0 : degrees;
}

[[nodiscard]] bool looksLikePlacements(std::string_view head);
/// Eagle's lists of parts to mount have no line that tells; their names end in MNT or MNB.
[[nodiscard]] bool looksLikeMounts(std::string_view head, std::string_view name);
/// Comma, semicolon, tab or blank separated, with a line that names the columns, or Allegro's placement file or Eagle's
/// list without one. Rows that cannot be read are reported.
[[nodiscard]] PlacementFile parsePlacements(std::string_view text, std::string_view path, Diagnostics& diagnostics);

}  // namespace model::gerber
