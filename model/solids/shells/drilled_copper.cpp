#include "model/solids/shells/drilled_copper.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numeric>
#include <utility>

#include "model/base/disjoint_sets.h"
#include "model/board/holes.h"
#include "model/board/laser_via.h"
#include "model/geometry/loops/edge_union.h"
#include "model/geometry/vectors.h"
#include "model/solids/shells/drawn_outlines.h"

namespace model {

namespace {

using Regions = std::vector<EdgeLoops>;

/// A tool whose size the job does not say is drawn as a point (decision 0156): nobody knows what it takes away.
constexpr std::int64_t kLeastHole = 1'000;
/// Nearer to each other than that, holes are one, nm.
constexpr Nm kJoining = 20;

/// Joins `loop` to a region as one more hole.
void addHole(EdgeLoops& region, std::span<const Edge> loop) {
    const auto addEdge = [&region](Edge edge) {
        edge.isHole = true;
        edge.winding = -1;
        region.edges.push_back(edge);
    };
    const double area = std::accumulate(loop.begin(), loop.end(), 0.0, [&](double sum, const Edge& edge) {
        return sum + areaUnder(edge, loop.front().a);
    });
    if (area > 0.0) {
        std::for_each(loop.rbegin(), loop.rend(), [&](const Edge& edge) { addEdge(reversed(edge)); });
    } else {
        std::ranges::for_each(loop, addEdge);
    }
    region.loopStart.push_back(static_cast<std::uint32_t>(region.edges.size()));
}

/// Puts holes back into those regions that they lie in.
void addHoles(Regions& regions, std::span<const std::vector<Edge>> loops) {
    if (loops.empty() || regions.empty()) {
        return;
    }
    if (regions.size() == 1) {
        std::ranges::for_each(loops, [&](const auto& loop) { addHole(regions.front(), loop); });
        return;
    }
    std::vector<RegionSearch> searches;
    std::vector<Box> boxes;
    for (const EdgeLoops& region : regions) {
        searches.emplace_back(region);
        boxes.push_back(searches.back().box());
    }
    const BoxIndex index(boxes);
    for (const std::vector<Edge>& loop : loops) {
        const PointD at = loop.front().a;
        index.visit(boxAround(at, 0.0), [&](std::uint32_t row) {
            if (searches[row].holds(at)) {
                addHole(regions[row], loop);
            }
        });
    }
}

/// What lies across a region, and what is one more hole of it.
struct SortedHoles {
    Regions across;
    std::vector<std::vector<Edge>> inside;
};

SortedHoles sortedHoles(const RegionSearch& region, std::span<const RegionSearch> holes) {
    SortedHoles sorted;
    for (const RegionSearch& hole : holes) {
        const CutLie lie = lieOf(hole, region);
        if (lie == CutLie::Across) {
            sorted.across.push_back(hole.region());
        } else if (lie == CutLie::Inside) {
            sorted.inside.push_back(hole.region().edges);
        }
    }
    return sorted;
}

/// Moves the holes of a region that no cut comes near out of it: a plane has thousands, and a cut reaches few.
EdgeLoops withoutFarHoles(const EdgeLoops& region, std::span<const EdgeLoops> cuts,
                          std::vector<std::vector<Edge>>& far) {
    std::vector<Box> boxes;
    std::ranges::transform(cuts, std::back_inserter(boxes),
                           [](const EdgeLoops& cut) { return boxOf(cut).grownBy(kJoining); });
    const BoxIndex index(boxes);
    EdgeLoops rest;
    for (std::size_t i = 0; i < region.loopCount(); ++i) {
        const std::span<const Edge> loop = region.loop(i);
        Box box;
        std::ranges::for_each(loop, [&](const Edge& edge) { box.include(boxOf(edge)); });
        bool isNear = i == 0;
        index.visit(box, [&](std::uint32_t) { isNear = true; });
        if (isNear) {
            rest.edges.insert(rest.edges.end(), loop.begin(), loop.end());
            rest.loopStart.push_back(static_cast<std::uint32_t>(rest.edges.size()));
        } else {
            far.emplace_back(loop.begin(), loop.end());
        }
    }
    return rest;
}

bool isCircle(const EdgeLoops& region) {
    return region.edges.size() == 1 && region.edges.front().isFullCircle();
}

bool isOneCircle(std::span<const EdgeLoops> group, std::size_t outer) {
    return isCircle(group[outer]) && std::ranges::all_of(group, [&](const EdgeLoops& other) {
               const Edge& a = group[outer].edges.front();
               const Edge& b = other.edges.front();
               return isCircle(other) && distance(a.centre, b.centre) + b.radius <= a.radius;
           });
}

/// Regions that touch or overlap as few that do not. Circles within a larger one, as of a hole that is drilled twice,
/// stay that circle.
Regions joined(Regions group) {
    for (std::size_t i = 0; i < group.size(); ++i) {
        if (isOneCircle(group, i)) {
            return {std::move(group[i])};
        }
    }
    return unionOf(group).regions;
}

std::vector<Box> boxesOf(std::span<const RegionSearch> regions) {
    std::vector<Box> boxes;
    std::ranges::transform(regions, std::back_inserter(boxes), &RegionSearch::box);
    return boxes;
}

bool isRoundHole(const RegionSearch& region) {
    return isCircle(region.region());
}

bool areOne(const RegionSearch& a, const RegionSearch& b) {
    if (isRoundHole(a) && isRoundHole(b)) {
        const Edge& p = a.region().edges.front();
        const Edge& q = b.region().edges.front();
        return distance(p.centre, q.centre) <= p.radius + q.radius + kJoining;
    }
    return lieOf(a, b) != CutLie::Apart || lieOf(b, a) != CutLie::Apart;
}

std::vector<RegionSearch> withoutOverlaps(std::vector<RegionSearch> holes) {
    const BoxIndex index(boxesOf(holes));
    DisjointSets groups(holes.size());
    for (std::uint32_t row = 0; row < holes.size(); ++row) {
        index.visit(holes[row].box().grownBy(kJoining), [&](std::uint32_t other) {
            if (other > row && groups.find(row) != groups.find(other) && areOne(holes[row], holes[other])) {
                groups.join(row, other);
            }
        });
    }
    std::vector<std::vector<std::uint32_t>> members(holes.size());
    for (std::uint32_t row = 0; row < holes.size(); ++row) {
        members[groups.find(row)].push_back(row);
    }
    std::vector<RegionSearch> apart;
    for (const std::vector<std::uint32_t>& group : members) {
        if (group.size() == 1) {
            apart.push_back(holes[group.front()]);
        } else if (group.size() > 1) {
            Regions regions;
            std::ranges::transform(group, std::back_inserter(regions),
                                   [&](std::uint32_t row) { return holes[row].region(); });
            for (EdgeLoops& region : joined(std::move(regions))) {
                apart.emplace_back(std::move(region));
            }
        }
    }
    return apart;
}

std::vector<RegionSearch> searchesOf(const Document& document, std::span<const ElementId> holes) {
    std::vector<RegionSearch> regions;
    for (const ElementId hole : holes) {
        for (EdgeLoops& region : drawnOutlinesOf(document, hole).regions) {
            RegionSearch search(std::move(region));
            if (std::max(search.box().width(), search.box().height()) >= kLeastHole) {
                regions.push_back(std::move(search));
            }
        }
    }
    return withoutOverlaps(std::move(regions));
}

}  // namespace

std::vector<ElementId> holesThrough(const Document& document, LayerId copper) {
    std::vector<ElementId> holes;
    for (const Layer& layer : document.layers) {
        if (!isHoles(layer.type) || !layer.spans(copper)) {
            continue;
        }
        for (std::uint32_t i = 0; i < layer.elements.count; ++i) {
            const ElementId element{layer.elements.first + i};
            const bool isHole = (document.elements.flags[element.row()] & kHole) != 0;
            const bool isAtEnd = layer.spanTop == copper || layer.spanBottom == copper;
            if (isHole && !(isAtEnd && targetOf(document, element) == copper)) {
                holes.push_back(element);
            }
        }
    }
    return holes;
}

HoleRegions::HoleRegions(const Document& document, std::span<const ElementId> holes)
    : m_regions(searchesOf(document, holes)), m_index(boxesOf(m_regions)) {}

std::vector<RegionSearch> HoleRegions::near(const Box& box) const {
    std::vector<std::uint32_t> rows;
    m_index.visit(box, [&](std::uint32_t row) { rows.push_back(row); });
    std::ranges::sort(rows);
    std::vector<RegionSearch> found;
    found.reserve(rows.size());
    std::ranges::transform(rows, std::back_inserter(found), [this](std::uint32_t row) { return m_regions[row]; });
    return found;
}

std::size_t HoleRegions::countNear(const Box& box) const {
    std::size_t count = 0;
    m_index.visit(box, [&](std::uint32_t) { ++count; });
    return count;
}

RegionBoolean drilled(EdgeLoops region, std::span<const RegionSearch> holes) {
    if (holes.empty() || region.loopCount() == 0) {
        return {{std::move(region)}, true};
    }
    const RegionSearch search(std::move(region));
    SortedHoles sorted = sortedHoles(search, holes);
    if (sorted.across.empty()) {
        Regions whole{search.region()};
        addHoles(whole, sorted.inside);
        return {std::move(whole), true};
    }
    const EdgeLoops near = withoutFarHoles(search.region(), sorted.across, sorted.inside);
    if (std::optional<Regions> rest = subtract(std::span(&near, 1), sorted.across)) {
        addHoles(*rest, sorted.inside);
        return {std::move(*rest), true};
    }
    Regions all;
    std::ranges::transform(holes, std::back_inserter(all), &RegionSearch::region);
    return differenceOf(std::span(&search.region(), 1), all);
}

}  // namespace model
