#include "model/geometry/loops/edge_union.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <tuple>

#include "model/geometry/box_index.h"
#include "model/geometry/loops/boundary_edges.h"
#include "model/geometry/loops/edge_faults.h"
#include "model/geometry/vectors.h"

namespace model {

namespace {

using Regions = std::vector<EdgeLoops>;
constexpr int kMostPasses = 3;
/// What fails with one distance for vertices that are one hardly ever fails with all.
constexpr std::array<double, 3> kSnapsNm = {EdgeArrangement::kSnapNm, 3.1, 4.7};

struct Loop {
    std::vector<Edge> edges;
    double area = 0.0;
};

double signedArea(std::span<const Edge> edges) {
    double area = 0.0;
    for (const Edge& edge : edges) {
        area += areaUnder(edge, edges.front().a);
    }
    return area;
}

std::vector<std::uint8_t> pinchedVertices(const EdgeArrangement& arrangement,
                                          const std::vector<std::vector<Side>>& loops) {
    std::vector<std::uint8_t> passes(arrangement.vertices().size(), 0);
    for (const std::vector<Side>& loop : loops) {
        for (const Side side : loop) {
            const EdgeArrangement::Fragment& fragment = arrangement.fragments()[side / 2];
            std::uint8_t& count = passes[side % 2 == 0 ? fragment.a : fragment.b];
            count = static_cast<std::uint8_t>(std::min(count + 1, 2));
        }
    }
    for (std::uint8_t& count : passes) {
        count = count > 1 ? 1 : 0;
    }
    return passes;
}

std::vector<Loop> loopsOf(const EdgeArrangement& arrangement, const std::vector<std::vector<Side>>& boundary) {
    const std::vector<std::uint8_t> isPinched = pinchedVertices(arrangement, boundary);
    std::vector<Loop> loops;
    for (const std::vector<Side>& sides : boundary) {
        Loop loop{edgesOf(arrangement, sides, isPinched), 0.0};
        loop.area = signedArea(loop.edges);
        if (loop.area != 0.0) {
            loops.push_back(std::move(loop));
        }
    }
    return loops;
}

void append(EdgeLoops& region, const Loop& loop, bool isHole) {
    for (Edge edge : loop.edges) {
        edge.isHole = isHole;
        edge.winding = isHole ? -1 : 1;
        region.edges.push_back(edge);
    }
    region.loopStart.push_back(static_cast<std::uint32_t>(region.edges.size()));
}

/// Finds the smallest outline around a hole.
class Nesting {
public:
    explicit Nesting(std::span<const Loop> outlines) : m_outlines(outlines), m_winding(outlines.size(), 0) {
        std::vector<Box> boxes;
        for (std::uint32_t i = 0; i < outlines.size(); ++i) {
            for (const Edge& edge : outlines[i].edges) {
                boxes.push_back(boxOf(edge));
                m_edges.push_back(&edge);
                m_outlineOf.push_back(i);
            }
        }
        m_index.emplace(boxes);
    }

    [[nodiscard]] std::optional<std::uint32_t> around(PointD p) {
        Box ray = boxAround(p, 1.0);
        ray.max.x = std::numeric_limits<Nm>::max();
        m_hit.clear();
        m_index->visit(ray, [&](std::uint32_t row) {
            m_winding[m_outlineOf[row]] += windingAround(*m_edges[row], p);
            m_hit.push_back(m_outlineOf[row]);
        });
        std::optional<std::uint32_t> best;
        for (const std::uint32_t outline : m_hit) {
            if (m_winding[outline] != 0 && (!best || m_outlines[outline].area < m_outlines[*best].area)) {
                best = outline;
            }
        }
        for (const std::uint32_t outline : m_hit) {
            m_winding[outline] = 0;
        }
        return best;
    }

private:
    std::span<const Loop> m_outlines;
    std::vector<int> m_winding;
    std::vector<const Edge*> m_edges;
    std::vector<std::uint32_t> m_outlineOf;
    std::vector<std::uint32_t> m_hit;
    std::optional<BoxIndex> m_index;
};

/// No value when a hole lies in no outline.
std::optional<Regions> nested(std::vector<Loop> loops) {
    const auto firstHole =
        std::stable_partition(loops.begin(), loops.end(), [](const Loop& loop) { return loop.area > 0.0; });
    const std::span<const Loop> outlines(loops.begin(), firstHole);
    const std::span<const Loop> holes(firstHole, loops.end());
    Regions regions(outlines.size());
    for (std::size_t i = 0; i < outlines.size(); ++i) {
        append(regions[i], outlines[i], false);
    }
    std::optional<Nesting> nesting;
    for (const Loop& hole : holes) {
        std::optional<std::uint32_t> around = 0;
        if (outlines.size() != 1) {
            if (!nesting) {
                nesting.emplace(outlines);
            }
            around = nesting->around(hole.edges.front().a);
        }
        if (!around || regions.empty()) {
            return std::nullopt;
        }
        append(regions[*around], hole, true);
    }
    return regions;
}

/// A region and what it counts for where it is: 1, or -1 for what is taken away.
struct Term {
    const EdgeLoops* region = nullptr;
    int count = 1;
};

std::optional<Regions> combinedOnce(std::span<const Term> terms, double snapNm) {
    EdgeArrangement arrangement(snapNm);
    for (const Term& term : terms) {
        arrangement.add(*term.region, term.count);
    }
    if (!arrangement.settle()) {
        return std::nullopt;
    }
    const std::optional<std::vector<std::vector<Side>>> boundary = boundaryOf(arrangement);
    return boundary ? nested(loopsOf(arrangement, *boundary)) : std::nullopt;
}

bool hasFault(const EdgeLoops& region) {
    return findFault(region).has_value();
}

/// Once more as long as something is left that touches.
std::optional<Regions> combinedWithin(std::vector<Term> terms, double snapNm) {
    Regions before;
    for (int pass = 0; pass < kMostPasses; ++pass) {
        std::optional<Regions> regions = combinedOnce(terms, snapNm);
        if (!regions || std::ranges::none_of(*regions, hasFault)) {
            return regions;
        }
        before = std::move(*regions);
        terms.clear();
        for (const EdgeLoops& region : before) {
            terms.push_back({&region, 1});
        }
    }
    return std::nullopt;
}

/// Numbers, and within what boxes can hold.
bool isOnBoard(const EdgeLoops& region) {
    constexpr double kFar = 1.5 * base::kMaxCoordinate;
    constexpr PointD kAxes[] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
    const auto isNear = [](PointD p) { return std::abs(p.x) <= kFar && std::abs(p.y) <= kFar; };
    return std::ranges::all_of(region.edges, [&](const Edge& edge) {
        return isNear(edge.a) && isNear(edge.b) && (!edge.isArc() || std::ranges::all_of(kAxes, [&](PointD axis) {
                   return !passes(edge, axis) ||
                          isNear({edge.centre.x + axis.x * edge.radius, edge.centre.y + axis.y * edge.radius});
               }));
    });
}

std::optional<Regions> combined(const std::vector<Term>& terms) {
    if (!std::ranges::all_of(terms, isOnBoard, [](const Term& term) -> const EdgeLoops& { return *term.region; })) {
        return std::nullopt;
    }
    for (const double snapNm : kSnapsNm) {
        if (std::optional<Regions> regions = combinedWithin(terms, snapNm)) {
            return regions;
        }
    }
    return std::nullopt;
}

double sumOfAreas(std::span<const EdgeLoops> regions) {
    double sum = 0.0;
    for (const EdgeLoops& region : regions) {
        sum += areaOf(region);
    }
    return sum;
}

double sumOfLengths(std::span<const EdgeLoops> regions) {
    double sum = 0.0;
    for (const EdgeLoops& region : regions) {
        for (const Edge& edge : region.edges) {
            sum += lengthOf(edge);
        }
    }
    return sum;
}

/// A union is no smaller than any of the regions and no larger than all of them.
bool isPlausible(std::span<const EdgeLoops> regions, std::span<const EdgeLoops> united) {
    const double tolerance = 2 * EdgeArrangement::kSnapNm * sumOfLengths(regions);
    double largest = 0.0;
    for (const EdgeLoops& region : regions) {
        largest = std::max(largest, areaOf(region));
    }
    const double area = sumOfAreas(united);
    return area > largest - tolerance && area < sumOfAreas(regions) + tolerance;
}

std::tuple<double, double, double, double, double, double, double, bool> keyOf(const Edge& edge) {
    return {edge.a.x, edge.a.y, edge.b.x, edge.b.y, edge.centre.x, edge.centre.y, edge.radius, edge.isClockwise};
}

/// An order that does not depend on that of the regions.
std::vector<const EdgeLoops*> inOrder(std::span<const EdgeLoops> regions) {
    std::vector<const EdgeLoops*> sorted;
    for (const EdgeLoops& region : regions) {
        if (!region.edges.empty()) {
            sorted.push_back(&region);
        }
    }
    std::ranges::sort(sorted, [](const EdgeLoops* a, const EdgeLoops* b) {
        return std::ranges::lexicographical_compare(a->edges, b->edges, {}, keyOf, keyOf);
    });
    return sorted;
}

/// Faulty ones are replaced by what is left when they are cleaned, empty ones left out.
std::optional<Regions> soundOnes(std::span<const EdgeLoops> regions) {
    Regions sound;
    for (const EdgeLoops& region : regions) {
        if (region.edges.empty()) {
            continue;
        }
        if (!hasFault(region)) {
            sound.push_back(region);
            continue;
        }
        std::optional<Regions> clean = cleaned(region);
        if (!clean) {
            return std::nullopt;
        }
        std::ranges::move(*clean, std::back_inserter(sound));
    }
    return sound;
}

std::optional<Regions> enclosedWithin(std::span<const Edge> drawing, double snapNm) {
    EdgeArrangement arrangement(snapNm);
    for (const Edge& edge : drawing) {
        arrangement.addEdge(edge);
    }
    if (!arrangement.settle()) {
        return std::nullopt;
    }
    const std::optional<std::vector<std::vector<Side>>> boundary = outerBoundaryOf(arrangement);
    if (!boundary) {
        return std::nullopt;
    }
    Regions regions;
    for (const Loop& loop : loopsOf(arrangement, *boundary)) {
        append(regions.emplace_back(), loop, false);
    }
    return regions;
}

}  // namespace

std::optional<std::vector<EdgeLoops>> cleaned(const EdgeLoops& region) {
    return combined({{&region, 1}});
}

std::optional<std::vector<EdgeLoops>> unite(std::span<const EdgeLoops> regions) {
    const std::optional<Regions> sound = soundOnes(regions);
    if (!sound || sound->size() < 2) {
        return sound;
    }
    std::vector<Term> terms;
    for (const EdgeLoops* region : inOrder(*sound)) {
        terms.push_back({region, 1});
    }
    std::optional<Regions> united = combined(terms);
    return united && isPlausible(*sound, *united) ? std::move(united) : std::nullopt;
}

std::optional<std::vector<EdgeLoops>> subtract(std::span<const EdgeLoops> from, std::span<const EdgeLoops> what) {
    std::vector<Term> terms;
    for (const EdgeLoops* region : inOrder(from)) {
        terms.push_back({region, 1});
    }
    for (const EdgeLoops* region : inOrder(what)) {
        terms.push_back({region, -1});
    }
    return combined(terms);
}

std::optional<std::vector<EdgeLoops>> enclosedBy(std::span<const Edge> drawing) {
    EdgeLoops all;
    all.edges.assign(drawing.begin(), drawing.end());
    if (!isOnBoard(all)) {
        return std::nullopt;
    }
    std::ranges::sort(all.edges, {}, [](const Edge& edge) { return std::min(keyOf(edge), keyOf(reversed(edge))); });
    for (const double snapNm : kSnapsNm) {
        if (std::optional<Regions> regions = enclosedWithin(all.edges, snapNm)) {
            return regions;
        }
    }
    return std::nullopt;
}

}  // namespace model
