#pragma once

#include <compare>
#include <cstddef>
#include <optional>
#include <vector>

#include "model/solids/shells/element_shells.h"

namespace model {

/// What equal tracks, pads, discs and barrels have in common: written once, placed often. Two elements with equal keys
/// have equal solids in the coordinates of SharedShape::placement.
struct ShapeKey {
    ElementKind kind = ElementKind::Circle;  ///< Circle, Area or Line
    std::int64_t first = 0;                  ///< the diameter, the row of the shape, or the square of the length
    std::int64_t second = 0;                 ///< the inner diameter, 1 for a mirrored shape, or the width
    Nm bottom = 0;                           ///< heights of the solid
    Nm top = 0;
    /// What is drilled through it, as those number it who cut it; 0: nothing. outlinesOf() knows only the whole shape.
    std::uint32_t drilled = 0;
    auto operator<=>(const ShapeKey&) const = default;
};

struct ShapeKeyHash {
    [[nodiscard]] std::size_t operator()(const ShapeKey& key) const;
};

struct SharedShape {
    ShapeKey key;
    Placement placement;  ///< of the solid of that key; never mirrored
};

/// Without a value for arcs and trails, of which hardly two are equal, for lines with a square pen or of a slot, and
/// for what has no height. More than half of the tracks of large boards are as long and as wide as another.
[[nodiscard]] std::optional<SharedShape> sharedShapeOf(const Document& document, ElementId element);
/// The regions of such a shape where `SharedShape::placement` is none.
[[nodiscard]] ElementOutlines outlinesOf(const Document& document, const ShapeKey& key);

}  // namespace model
