#pragma once

#include <span>
#include <vector>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/board/document.h"
#include "model/geometry/edges.h"

/// What lies near something: the clearance lens.
namespace model {

/// Copper of another net, at its smallest spacing on any layer.
struct Nearby {
    ElementId element;
    LayerId layer;
    Spacing spacing;  ///< from the element to what it is near to, nm
};

/// Copper and plated holes that come within `reach` (nm) of any of the targets on a copper layer, once each, the
/// nearest first. Left out: the targets themselves, what is of the same net as one of them, copper without a net that
/// touches it included (CopperOwners), and what a net tie brings together with them (NetTies). Targets that lie on no
/// copper layer have nothing near them. Over all cores, the same with any number of threads. Errors: Cancelled.
[[nodiscard]] base::Result<std::vector<Nearby>> copperNear(const Document& document, std::span<const ElementId> targets,
                                                           double reach, base::Progress& progress);

}  // namespace model
