#pragma once

#include <optional>
#include <span>
#include <vector>

#include "model/geometry/shapes.h"

namespace model::gerber {

/// A part as a pick-and-place file and the images have it.
struct PlacedPins {
    base::PointD place;       ///< in the file's coordinates, nm
    std::vector<Point> pins;  ///< on the board, at least one
};

/// What has to be added to the places of a file that counts from an origin of its own: the shift that lays most parts
/// within the box of their pins, none if that does as well. Nothing if half of the parts or more would lie beside them.
[[nodiscard]] std::optional<Point> placementShift(std::span<const PlacedPins> parts);

}  // namespace model::gerber
