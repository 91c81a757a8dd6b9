#pragma once

#include <optional>

#include "model/formats/common/pad_shape.h"
#include "model/formats/odb/features/features.h"
#include "model/geometry/shapes.h"

namespace model::odb {

using formats::PadShape;

/// A shape without outer sizes in its name (user symbols, moire), resized: the outlines of its islands move outwards by
/// half of `resize`, corners stay sharp, holes stay as they are.
[[nodiscard]] PadShape resized(const PadShape& shape, Nm resize);

/// The shape of a standard symbol. Nothing when the name does not match the grammar completely (odb-notes, Features):
/// then it is a user symbol. A resize is added to the values that are outer sizes; all others (holes, line widths,
/// radii, gaps) stay as the name says. Sizes that are negative or exceed half a metre draw nothing (odb-notes,
/// Features), except that a ring without room for its hole is a disc.
[[nodiscard]] std::optional<PadShape> standardSymbol(const SymbolRef& symbol);

}  // namespace model::odb
