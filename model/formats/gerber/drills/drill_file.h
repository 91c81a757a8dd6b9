#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/formats/gerber/image/coordinates.h"
#include "model/formats/gerber/image/image.h"

/// Excellon and XNC drill files. In Excellon LZ means that leading zeros are kept and trailing ones left out, TZ the
/// opposite, unlike L and T of Gerber.
namespace model::gerber {

/// What a drill file says of its coordinates, and what can be seen of them.
struct DrillHead {
    std::optional<bool> isInch;
    std::optional<bool> isTrailingOmitted;
    std::optional<int> integers;
    std::optional<int> decimals;
    bool areAllWithPoint = true;     ///< every coordinate has a decimal point
    bool areAllOfOneLength = false;  ///< those without a point
    bool hasHeader = false;          ///< M48
    bool hasHits = false;
    bool looksLikeDrills = false;  ///< enough of it reads as Excellon
};

[[nodiscard]] DrillHead readDrillHead(std::string_view text);

/// How the coordinates may be meant: first as the file says or, where it is silent, as is usual; then all other ways in
/// which programs write them.
[[nodiscard]] std::vector<CoordinateFormat> likelyFormats(const DrillHead& head);

/// What two formats differ in, for messages: "inch 2.4, leading zeros kept".
[[nodiscard]] std::string describe(const CoordinateFormat& format);

/// Reads a drill file: hits as pads, slots and routed paths as lines and arcs, with a round symbol for every tool.
[[nodiscard]] Image parseDrills(std::string_view text, std::string_view path, const CoordinateFormat& format);

}  // namespace model::gerber
