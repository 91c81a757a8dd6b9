#pragma once

#include <span>
#include <vector>

#include "model/document_builder.h"
#include "model/geometry/discretise.h"

namespace model::odb {

/// Paint order: later features lie over earlier ones, and a negative one takes away what is below it (odb-notes,
/// Features). So what remains of a positive element is its region minus all negative elements after it. `negatives` has
/// one entry per element of the document.

/// Copies the positive elements of `painted` to the builder's current layer. Those that no later negative touches stay
/// as they are; what is left of the others becomes an Area with the same net, symbol and feature, straight-edged within
/// 1 µm.
void addPainted(DocumentBuilder& builder, const Document& painted, std::span<const std::uint8_t> negatives);

/// Adds base minus everything that `painted` leaves visible, one Area per connected piece: the copper of a negative
/// layer.
void addInverse(DocumentBuilder& builder, const PolygonSet& base, const Document& painted,
                std::span<const std::uint8_t> negatives);

/// The region that all elements together leave visible. Exact when there is no negative and no two elements come near
/// each other, else straight-edged within 1 µm.
[[nodiscard]] ShapeSketch regionOf(const Document& painted, std::span<const std::uint8_t> negatives);

}  // namespace model::odb
