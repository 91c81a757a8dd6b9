#pragma once

#include <optional>

#include "model/geometry/shapes.h"

namespace model::ipc2581 {

/// What a round cutter leaves that moves from `a` to `b`.
struct Stadium {
    Point a;
    Point b;
    Nm width = 0;
};

/// The stadium that a region is, with arcs or with polygons of at least 16 chords a circle for its ends (writers have
/// slots as outlines); nothing for discs and all other shapes.
[[nodiscard]] std::optional<Stadium> stadiumOf(const ShapeSketch& region);

}  // namespace model::ipc2581
