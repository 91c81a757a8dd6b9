#include "model/geometry/loops/split_loops.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <deque>
#include <optional>
#include <span>

#include "model/geometry/vectors.h"

namespace model {

namespace {

/// Corners closer to a cut than this would make edges that are shorter than 1 nm, or miss one.
constexpr double kClear = 1.0;
/// A place that is as wide as this is wide enough, nm: of two such, the one nearer to the middle is taken. Where cuts
/// pass closer to corners they leave slivers, whose volume suffers from the digits of a file.
constexpr double kWideEnough = 100'000.0;

/// The line x = `at`, or y = `at`.
struct Cut {
    bool isUpright = true;
    double at = 0.0;

    [[nodiscard]] double across(PointD p) const { return isUpright ? p.x : p.y; }
    [[nodiscard]] double along(PointD p) const { return isUpright ? p.y : p.x; }
    [[nodiscard]] PointD point(double along) const { return isUpright ? PointD{at, along} : PointD{along, at}; }
    [[nodiscard]] bool isBeyond(PointD p) const { return across(p) > at; }
};

/// A run of edges on one side of the cut, from cut to cut.
struct Chain {
    std::size_t firstEdge = 0;  ///< of Halves::edges
    std::size_t edgeCount = 0;
    double from = 0.0;  ///< along the cut
    double to = 0.0;
    bool isBeyond = false;
};

bool isLarge(const EdgeLoops& region, const RegionLimits& limits) {
    bool isLong = false;
    for (std::size_t i = 0; i < region.loopCount(); ++i) {
        isLong = isLong || region.loop(i).size() > limits.edgesOfLoop;
    }
    return isLong || region.loopCount() - 1 > limits.holes;
}

/// Where an arc crosses the cut, in the order in which it runs.
std::vector<double> crossingsOf(const Edge& arc, const Cut& cut) {
    const double beside = cut.at - cut.across(arc.centre);
    std::vector<double> found;
    if (std::abs(beside) >= arc.radius) {
        return found;
    }
    const double half = std::sqrt((arc.radius - beside) * (arc.radius + beside));
    for (const double side : {-half, half}) {
        const double along = cut.along(arc.centre) + side;
        if (passes(arc, minus(cut.point(along), arc.centre))) {
            found.push_back(along);
        }
    }
    if (found.size() == 2) {
        const PointD start = minus(arc.a, arc.centre);
        const auto turned = [&](double along) {
            const PointD v = minus(cut.point(along), arc.centre);
            const double angle = std::atan2(cross(start, v), dot(start, v)) * (arc.isClockwise ? -1 : 1);
            return angle < 0 ? angle + 7.0 : angle;  // only the order counts
        };
        if (turned(found[0]) > turned(found[1])) {
            std::swap(found[0], found[1]);
        }
    }
    return found;
}

bool mayCross(const Edge& edge, const Cut& cut) {
    return edge.isArc() ? std::abs(cut.at - cut.across(edge.centre)) < edge.radius
                        : cut.isBeyond(edge.a) != cut.isBeyond(edge.b);
}

std::vector<double> crossings(const Edge& edge, const Cut& cut) {
    if (edge.isArc()) {
        return crossingsOf(edge, cut);
    }
    if (cut.isBeyond(edge.a) == cut.isBeyond(edge.b)) {
        return {};
    }
    const double t = (cut.at - cut.across(edge.a)) / (cut.across(edge.b) - cut.across(edge.a));
    return {cut.along(edge.a) + t * (cut.along(edge.b) - cut.along(edge.a))};
}

/// Takes a region apart at a cut and puts both halves together again.
class Halves {
public:
    explicit Halves(const Cut& cut) : m_cut(cut) {}

    /// Without a value if the loops do not cross the cut as those of a region do.
    std::optional<std::vector<EdgeLoops>> split(const EdgeLoops& region) {
        for (std::size_t i = 0; i < region.loopCount(); ++i) {
            if (!addLoop(region.loop(i))) {
                return std::nullopt;
            }
        }
        std::ranges::sort(m_stations);
        std::vector<EdgeLoops> pieces;
        for (const bool isBeyond : {false, true}) {
            if (!link(isBeyond)) {
                return std::nullopt;
            }
            nest(isBeyond, pieces);
        }
        return pieces;
    }

private:
    using Loop = std::vector<Edge>;

    /// The loop as edges that do not cross the cut, beginning where one leaves it.
    bool addLoop(std::span<const Edge> loop) {
        if (std::ranges::none_of(loop, [this](const Edge& edge) { return mayCross(edge, m_cut); })) {
            addWhole(loop);
            return true;
        }
        Loop pieces;
        std::vector<std::size_t> cuts;  // pieces that begin on the cut
        std::vector<double> stations;
        for (const Edge& edge : loop) {
            Edge rest = edge;
            for (const double along : crossings(edge, m_cut)) {
                Edge part = rest;
                part.b = rest.a = m_cut.point(along);
                pieces.push_back(part);
                cuts.push_back(pieces.size());
                stations.push_back(along);
            }
            pieces.push_back(rest);
        }
        if (cuts.empty()) {
            addWhole(loop);
            return true;
        }
        if (loop.size() == 1) {  // a circle: what is before the first cut goes on behind the last
            pieces.back().b = pieces.front().b;
            pieces.erase(pieces.begin());
            for (std::size_t& cut : cuts) {
                --cut;
            }
        }
        return addChains(pieces, cuts, stations);
    }

    void addWhole(std::span<const Edge> loop) { m_loops[m_cut.isBeyond(loop.front().a) ? 1 : 0].push_back(loop); }

    bool addChains(const Loop& pieces, const std::vector<std::size_t>& cuts, const std::vector<double>& stations) {
        for (std::size_t i = 0; i < cuts.size(); ++i) {
            const std::size_t next = (i + 1) % cuts.size();
            Chain chain{m_edges.size(), 0, stations[i], stations[next], false};
            for (std::size_t k = cuts[i] % pieces.size(); k != cuts[next] % pieces.size() || chain.edgeCount == 0;
                 k = (k + 1) % pieces.size()) {
                m_edges.push_back(pieces[k]);
                ++chain.edgeCount;
            }
            chain.isBeyond = m_cut.isBeyond(insideOf(m_edges[chain.firstEdge]));
            m_chains.push_back(chain);
            m_stations.push_back(stations[i]);
        }
        return cuts.size() % 2 == 0;
    }

    /// A point of the edge that is not on the cut.
    static PointD insideOf(const Edge& edge) { return pointAt(edge, lengthOf(edge) / 2); }

    /// Chains of a side are joined along the cut, from where one ends to where the region goes on.
    bool link(bool isBeyond) {
        std::vector<std::size_t> startAt(m_stations.size(), m_chains.size());
        for (std::size_t i = 0; i < m_chains.size(); ++i) {
            if (m_chains[i].isBeyond == isBeyond) {
                startAt[rankOf(m_chains[i].from)] = i;
            }
        }
        std::vector<bool> isUsed(m_chains.size());
        for (std::size_t i = 0; i < m_chains.size(); ++i) {
            if (m_chains[i].isBeyond == isBeyond && !isUsed[i] && !follow(i, isBeyond, startAt, isUsed)) {
                return false;
            }
        }
        return true;
    }

    bool follow(std::size_t first, bool isBeyond, const std::vector<std::size_t>& startAt, std::vector<bool>& isUsed) {
        Loop loop;
        for (std::size_t at = first; !isUsed[at];) {
            isUsed[at] = true;
            const Chain& chain = m_chains[at];
            const auto edges = std::span(m_edges).subspan(chain.firstEdge, chain.edgeCount);
            loop.insert(loop.end(), edges.begin(), edges.end());
            const std::size_t partner = rankOf(chain.to) ^ 1U;
            Edge along;
            along.a = m_cut.point(chain.to);
            along.b = m_cut.point(m_stations[partner]);
            loop.push_back(along);
            at = startAt[partner];
            if (at == m_chains.size() || (isUsed[at] && at != first)) {
                return false;
            }
        }
        m_loops[isBeyond ? 1 : 0].push_back(m_joined.emplace_back(std::move(loop)));
        return true;
    }

    [[nodiscard]] std::size_t rankOf(double station) const {
        return static_cast<std::size_t>(std::ranges::lower_bound(m_stations, station) - m_stations.begin());
    }

    /// The loops of a side as regions: each hole goes to the outline around it.
    void nest(bool isBeyond, std::vector<EdgeLoops>& pieces) const {
        std::vector<std::span<const Edge>> holes;
        const std::size_t first = pieces.size();
        for (const std::span<const Edge> loop : m_loops[isBeyond ? 1 : 0]) {
            if (areaOf(loop) < 0) {
                holes.push_back(loop);
                continue;
            }
            append(pieces.emplace_back(), loop);
        }
        for (const std::span<const Edge> hole : holes) {
            append(around(std::span(pieces).subspan(first), hole.front().a), hole);
        }
    }

    static double areaOf(std::span<const Edge> loop) {
        double area = 0.0;
        for (const Edge& edge : loop) {
            area += areaUnder(edge, loop.front().a);
        }
        return area;
    }

    static EdgeLoops& around(std::span<EdgeLoops> regions, PointD p) {
        for (EdgeLoops& region : regions.first(regions.size() - 1)) {
            int winding = 0;
            for (const Edge& edge : region.loop(0)) {
                winding += windingAround(edge, p);
            }
            if (winding != 0) {
                return region;
            }
        }
        return regions.back();
    }

    static void append(EdgeLoops& region, std::span<const Edge> loop) {
        for (Edge edge : loop) {
            edge.isHole = region.loopCount() > 0;
            edge.winding = edge.isHole ? -1 : 1;
            region.edges.push_back(edge);
        }
        region.loopStart.push_back(static_cast<std::uint32_t>(region.edges.size()));
    }

    Cut m_cut;
    Loop m_edges;
    std::vector<Chain> m_chains;
    std::vector<double> m_stations;                             ///< of all cuts along the line
    std::deque<Loop> m_joined;                                  ///< from chains
    std::array<std::vector<std::span<const Edge>>, 2> m_loops;  ///< of both sides: joined ones, and the region's own
};

/// In the middle of the widest place between neighbouring corners, among the middle half of all; further away only
/// where those lie on one line, as holes in rows do.
std::optional<double> placeFor(const EdgeLoops& region, bool isUpright) {
    const Cut axis{isUpright, 0.0};
    std::vector<double> corners;
    for (const Edge& edge : region.edges) {
        corners.push_back(axis.across(edge.a));
        if (edge.isArc()) {
            corners.push_back(axis.across(edge.centre) - edge.radius);
            corners.push_back(axis.across(edge.centre) + edge.radius);
        }
    }
    std::ranges::sort(corners);
    const std::size_t middle = corners.size() / 2;
    const std::size_t tried = corners.size() / 4 + 1;
    double best = 2 * kClear;
    std::optional<double> place;
    const auto offer = [&](std::size_t i) {
        if (i < 1 || i >= corners.size()) {
            return;
        }
        const double width = std::min(corners[i] - corners[i - 1], kWideEnough);
        if (width > best) {
            best = width;
            place = (corners[i] + corners[i - 1]) / 2;
        }
    };
    for (std::size_t away = 0; away <= tried || (!place && away <= middle); ++away) {
        offer(middle + away);
        offer(middle - away);  // wraps around to nothing
    }
    return place;
}

std::optional<std::vector<EdgeLoops>> halved(const EdgeLoops& region) {
    const Box box = boxOf(region);
    const bool isWide = box.width() >= box.height();
    for (const bool isUpright : {isWide, !isWide}) {
        if (const std::optional<double> at = placeFor(region, isUpright)) {
            if (auto pieces = Halves({isUpright, *at}).split(region)) {
                return pieces;
            }
        }
    }
    return std::nullopt;
}

}  // namespace

std::vector<EdgeLoops> splitLarge(EdgeLoops region, const RegionLimits& limits) {
    std::vector<EdgeLoops> done;
    std::vector<EdgeLoops> waiting;
    waiting.push_back(std::move(region));
    while (!waiting.empty()) {
        EdgeLoops next = std::move(waiting.back());
        waiting.pop_back();
        auto pieces = isLarge(next, limits) ? halved(next) : std::nullopt;
        if (!pieces || pieces->size() < 2) {
            done.push_back(std::move(next));
            continue;
        }
        std::ranges::move(*pieces, std::back_inserter(waiting));
    }
    return done;
}

}  // namespace model
