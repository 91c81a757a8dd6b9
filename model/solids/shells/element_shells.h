#pragma once

#include <string_view>
#include <vector>

#include "model/solids/shells/shell.h"

namespace model {

/// The solids of one element.
struct ElementShells {
    std::vector<Shell> shells;  ///< in the document's coordinates
    /// Why there is no solid, or not of all of it; empty where all is well, and where there is nothing solid: an NPTH,
    /// or a hole whose plating was drilled away.
    std::string_view problem;
};

/// The regions of an element in the plane; see ElementShells.
struct ElementOutlines {
    std::vector<EdgeLoops> regions;
    std::string_view problem;
};

[[nodiscard]] ElementOutlines outlinesOf(const Document& document, ElementId element);
/// Those of a shape where no placement lays it.
[[nodiscard]] ElementOutlines outlinesOf(const Document& document, ShapeId shape);
/// From where to where the element is solid: its layer, its body, or what is left of the plating of its hole; empty
/// (equal heights) when that is nothing. A laser via ends on the near face of its target. `isFlipped`: in copies of the
/// document that lie upside down (heightsInCopy).
[[nodiscard]] ZRange solidHeightsOf(const Document& document, ElementId element, bool isFlipped = false);
[[nodiscard]] ElementShells shellsOf(const Document& document, ElementId element);

}  // namespace model
