#include "model/geometry/loops/region_search.h"

#include <utility>
#include <vector>

#include "model/geometry/edges.h"
#include "model/geometry/vectors.h"

namespace model {

namespace {

/// As many are looked through sooner than a tree is made.
constexpr std::size_t kFewEdges = 16;
/// What comes as near as this touches, nm.
constexpr double kTouching = 10.0;

std::shared_ptr<const BoxIndex> indexOf(const EdgeLoops& region) {
    if (region.edges.size() <= kFewEdges) {
        return nullptr;
    }
    std::vector<Box> boxes;
    boxes.reserve(region.edges.size());
    for (const Edge& edge : region.edges) {
        boxes.push_back(boxOf(edge));
    }
    return std::make_shared<const BoxIndex>(boxes);
}

Box reachOf(const Box& box) {
    return box.grownBy(static_cast<Nm>(kTouching) + 1);
}

/// Does an edge of one come near an edge of the other? Looks at each edge of the one with fewer.
bool touch(const RegionSearch& a, const RegionSearch& b) {
    if (a.region().edges.size() > b.region().edges.size()) {
        return touch(b, a);
    }
    for (const Edge& edge : a.region().edges) {
        const Box reach = reachOf(boxOf(edge));
        bool isNear = false;
        if (reach.meets(b.box())) {
            b.visitNear(reach, [&](const Edge& other) {
                isNear = isNear || spacingBetween(edge, other).distance <= kTouching;
            });
        }
        if (isNear) {
            return true;
        }
    }
    return false;
}

/// Does the cut lie around a loop of the region? Of loops that do not touch it, one end of an edge tells.
bool isAroundLoop(const RegionSearch& cut, const RegionSearch& region) {
    bool isAround = false;
    region.visitNear(cut.box(), [&](const Edge& edge) { isAround = isAround || cut.holds(edge.a); });
    return isAround;
}

}  // namespace

RegionSearch::RegionSearch(EdgeLoops region)
    : m_region(std::make_shared<const EdgeLoops>(std::move(region))),
      m_box(boxOf(*m_region)),
      m_index(indexOf(*m_region)) {}

bool RegionSearch::holds(PointD p) const {
    const Box at = boxAround(p, 0.0);
    if (!at.meets(m_box)) {
        return false;
    }
    // What counts the winding number looks to the right.
    int winding = 0;
    visitNear({at.min, {m_box.max.x, at.max.y}}, [&](const Edge& edge) { winding += windingAround(edge, p); });
    return winding > 0;
}

void RegionSearch::visitNear(const Box& box, const std::function<void(const Edge&)>& visit) const {
    if (m_index) {
        m_index->visit(box, [&](std::uint32_t row) { visit(m_region->edges[row]); });
        return;
    }
    for (const Edge& edge : m_region->edges) {
        visit(edge);
    }
}

CutLie lieOf(const RegionSearch& cut, const RegionSearch& region) {
    if (region.region().loopCount() == 0 || cut.region().loopCount() == 0 || !reachOf(cut.box()).meets(region.box())) {
        return CutLie::Apart;
    }
    if (touch(cut, region) || isAroundLoop(cut, region)) {
        return CutLie::Across;
    }
    if (!region.holds(cut.region().edges.front().a)) {
        return CutLie::Apart;
    }
    return cut.region().loopCount() == 1 ? CutLie::Inside : CutLie::Across;
}

}  // namespace model
