#pragma once

#include <functional>
#include <memory>

#include "model/geometry/box_index.h"
#include "model/geometry/loops/edge_loops.h"

namespace model {

/// A region that is asked often where its edges are and which points it holds. A few edges are looked through, many are
/// found by a tree. Reading is safe from every thread; copies share everything.
class RegionSearch {
public:
    explicit RegionSearch(EdgeLoops region);

    [[nodiscard]] const EdgeLoops& region() const { return *m_region; }
    [[nodiscard]] const Box& box() const { return m_box; }
    /// Is the point in the region, not in one of its holes?
    [[nodiscard]] bool holds(PointD p) const;
    /// Calls `visit` for the edges whose boxes share a point with `box`; where there are few, for others too.
    void visitNear(const Box& box, const std::function<void(const Edge&)>& visit) const;

private:
    std::shared_ptr<const EdgeLoops> m_region;
    Box m_box;
    std::shared_ptr<const BoxIndex> m_index;  ///< of many edges
};

/// How a cut lies to a region.
enum class CutLie : std::uint8_t {
    Apart,   ///< it takes nothing away
    Inside,  ///< it is one more hole of the region
    Across   ///< it reaches an edge of the region, comes within 10 nm of one, or is around one
};
[[nodiscard]] CutLie lieOf(const RegionSearch& cut, const RegionSearch& region);

}  // namespace model
