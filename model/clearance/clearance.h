#pragma once

#include <limits>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/board/document.h"
#include "model/geometry/edges.h"

/// How close copper of different nets comes to each other.
namespace model {

/// The smallest spacing between two nets on one layer.
struct Clearance {
    LayerId layer;
    /// The lower row; copper that has no net and touches none counts as one more net behind all others ("none").
    NetId netA;
    NetId netB;
    ElementId a;  ///< of netA: copper of the layer, or a plated hole through it
    ElementId b;
    Spacing spacing;  ///< in nanometres; `from` lies on a, `to` on b; distance 0: they touch or overlap
};

/// Which clearances are requested. Two nets are one result per layer, however long they run side by side.
struct ClearanceRequest {
    std::size_t count = 100;                                 ///< so many of the smallest
    double below = std::numeric_limits<double>::infinity();  ///< only clearances less than this, in nanometres
    LayerId layer;                                           ///< only here; none: on all copper layers
    std::pair<NetId, NetId> between;                         ///< only between these; none: any two
    std::optional<Box> within;  ///< only elements whose smallest spacing has an end in here
};

/// The smallest clearances in the plane of a layer, in rising order. What takes part is the copper of the layer and the
/// walls of plated holes that reach it after back-drilling (Document::platedSpanOf), exact arcs and areas included.
/// Copper that an NPTH takes away counts as there. Copper without a net belongs to the net that it touches, on any
/// layer (CopperOwners). Left out: pairs of one net, copper without a net among itself, and what a net tie brings
/// together (NetTies). Copies of other steps are not part of it: they have a document of their own.
///
/// Neighbours are searched for within a distance that doubles until there are enough, so the cost follows the number of
/// elements and of results, not the number of pairs. The result does not depend on the number of threads.
/// Errors: Cancelled.
[[nodiscard]] base::Result<std::vector<Clearance>> smallestClearances(const Document& document,
                                                                      const ClearanceRequest& request,
                                                                      base::Progress& progress);

/// Does a step have copper, but no nets to distinguish it by? Nothing can be measured there.
[[nodiscard]] bool isCopperWithoutNets(const Document& step);
/// A sentence for each such step of a board.
[[nodiscard]] std::vector<std::string> unmeasuredSteps(const Document& board);

}  // namespace model
