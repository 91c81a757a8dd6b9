#pragma once

#include <span>
#include <string_view>
#include <vector>

#include "model/board/document.h"
#include "model/geometry/loops/region_booleans.h"
#include "model/geometry/loops/region_search.h"

/// What drills and routers leave of copper. Of a plated hole they take all that is drilled: its barrel stands in it
/// with its outer wall.
namespace model {

/// The holes whose drill passes a layer of copper, plated or not, by element. A laser via does not pass its target.
[[nodiscard]] std::vector<ElementId> holesThrough(const Document& document, LayerId copper);

/// Holes that are ready to be cut out of copper; those that overlap are one. Reading is safe from every thread.
class HoleRegions {
public:
    /// Of holes that are drilled, as they lie in the document.
    HoleRegions(const Document& document, std::span<const ElementId> holes);

    /// Those whose boxes meet this one, in an order that depends on the holes only.
    [[nodiscard]] std::vector<RegionSearch> near(const Box& box) const;
    /// How many those are.
    [[nodiscard]] std::size_t countNear(const Box& box) const;

private:
    std::vector<RegionSearch> m_regions;
    BoxIndex m_index;
};

/// What holes that do not overlap each other leave of a region. A hole within it is one more loop, whatever the region
/// is like, and does not touch what else there is; only holes across its edges need booleans, and then those parts of
/// the region that they reach.
[[nodiscard]] RegionBoolean drilled(EdgeLoops region, std::span<const RegionSearch> holes);

}  // namespace model
