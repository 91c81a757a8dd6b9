#pragma once

#include "model/board/document.h"
#include "model/geometry/discretise.h"

namespace model {

/// The region an element covers on the board. The wall of a hole counts as filled: a hole is what the drill removes. A
/// trail is one polygon per track (they overlap); a track along a full circle has a hole.
[[nodiscard]] PolygonSet discretise(const Document& document, ElementId element, const Discretisation& how);

/// The empty inside of a drilled or routed hole (innerDiameter, innerWidth); empty for everything else. A trail is one
/// polygon per track.
[[nodiscard]] PolygonSet discretiseOpening(const Document& document, ElementId element, const Discretisation& how);

}  // namespace model
