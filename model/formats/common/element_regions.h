#pragma once

#include "model/board/document.h"
#include "model/geometry/loops/region_booleans.h"

namespace model::formats {

/// What an element covers, lines and arcs exact; of a hole what is drilled. Chords within 1 µm where its outline could
/// not be found.
[[nodiscard]] RegionBoolean regionsOf(const Document& document, ElementId element);

}  // namespace model::formats
