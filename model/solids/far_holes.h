#pragma once

#include <functional>
#include <vector>

#include "model/geometry/discretise.h"

namespace model {

/// The holes of a region that a cut does not come near. A plane has thousands of holes, of which a cut at its edge
/// meets few, and the time of booleans grows faster than the number of points: so the others are taken out before and
/// put back after.
class FarHoles {
public:
    /// Takes those holes out of `region` whose box `isFar`: it lies within what the cut leaves, and touches no edge
    /// that the cut makes.
    FarHoles(PolygonSet& region, const std::function<bool(const Box&)>& isFar);

    /// What the cut left of the region, with the holes that were taken out.
    [[nodiscard]] PolygonSet putBack(PolygonSet rest) const;

private:
    PolygonSet m_holes;  ///< a polygon each
};

}  // namespace model
