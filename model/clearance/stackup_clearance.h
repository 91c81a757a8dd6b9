#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/board/copies.h"
#include "model/geometry/edges.h"

/// How close copper of different nets comes to each other in space: beside each other, and through dielectric.
namespace model {

/// The smallest distance between two nets, each as it lies in one copy of a step.
struct StackupClearance {
    BoardElement a;  ///< of the net that comes first by copy and row
    BoardElement b;
    LayerId layerA;  ///< of the board, where copies have put it; of plated holes their drill layer
    LayerId layerB;
    Spacing spacing;      ///< nm; `distance` in space, `from` and `to` as seen from above, on the board
    double planar = 0.0;  ///< nm, as seen from above
    double height = 0.0;  ///< nm between the faces; 0: on one layer, or beside a plated hole
};

struct StackupClearanceRequest {
    std::size_t count = 100;                                 ///< so many of the smallest
    double below = std::numeric_limits<double>::infinity();  ///< only distances less than this, in nanometres
    std::pair<std::string, std::string> between;             ///< nets of these names in any copy; empty: any two
};

/// The smallest distances between nets of a board and of all copies of steps on it, in rising order. Copper layers and
/// walls of plated holes take part, at the heights of the stackup; copper without a net does not, nor what a net tie
/// brings together. Errors: BadInput if no copper layer of the board has a height, Cancelled. The result does not
/// depend on the number of threads.
[[nodiscard]] base::Result<std::vector<StackupClearance>> smallestThroughStackup(const Document& board,
                                                                                 const StackupClearanceRequest& request,
                                                                                 base::Progress& progress);

}  // namespace model
