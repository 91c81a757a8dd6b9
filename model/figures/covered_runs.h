#pragma once

#include <vector>

#include "model/figures/figures.h"

namespace model {

/// A piece of a row of points, open to the right.
struct CoveredRun {
    double from = 0.0;
    double to = 0.0;  ///< may be infinite where `toX` ends the row
};

/// Adds to `runs` where the row at height `y` lies inside of a filled figure, from its left end up to `toX` at least:
/// isInside for all points of the row at once, at the cost of the edges that the row meets. Never for tracks.
void addCoveredRuns(const FigureTable& table, std::size_t row, double y, double toX, std::vector<CoveredRun>& runs);

}  // namespace model
