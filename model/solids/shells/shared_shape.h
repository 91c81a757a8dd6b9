#pragma once

#include <compare>
#include <cstddef>
#include <optional>
#include <vector>

#include "model/solids/shells/element_shells.h"

namespace model {

/// What equal pads, discs and barrels have in common: written once, placed often. Two elements with equal keys have
/// equal solids in the coordinates of SharedShape::placement.
struct ShapeKey {
    ElementKind kind = ElementKind::Circle;  ///< Circle or Area
    std::int64_t first = 0;                  ///< the diameter, or the row of the shape
    std::int64_t second = 0;                 ///< the inner diameter, or 1 for a mirrored shape
    Nm bottom = 0;                           ///< heights of the solid
    Nm top = 0;
    auto operator<=>(const ShapeKey&) const = default;
};

struct ShapeKeyHash {
    [[nodiscard]] std::size_t operator()(const ShapeKey& key) const;
};

struct SharedShape {
    ShapeKey key;
    Placement placement;  ///< of the solid of that key; never mirrored
};

/// Without a value for lines, arcs and trails, of which hardly two are equal, and for what has no height.
[[nodiscard]] std::optional<SharedShape> sharedShapeOf(const Document& document, ElementId element);
/// The regions of such a shape where `SharedShape::placement` is none.
[[nodiscard]] ElementOutlines outlinesOf(const Document& document, const ShapeKey& key);

}  // namespace model
