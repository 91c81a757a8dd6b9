#include "model/geometry/slits.h"

#include <algorithm>
#include <array>
#include <numeric>
#include <tuple>
#include <utility>

#include "model/base/edge_slots.h"
#include "model/geometry/discretise.h"

namespace model {

namespace {

using Loops = std::vector<std::vector<PathNode>>;

/// A contour by its edges: edge i leaves node i.
class SlitContour {
public:
    /// `slots` is room to work in.
    SlitContour(std::span<const PathNode> nodes, base::EdgeSlots& slots) : m_nodes(nodes), m_twin(nodes.size(), kNone) {
        slots.reset(nodes.size());
        for (std::uint32_t edge = 0; edge < nodes.size(); ++edge) {
            m_hasSlits = (isStraight(edge) && pair(edge, slots)) || m_hasSlits;
        }
    }

    /// Whether edges are run along both ways.
    [[nodiscard]] bool hasSlits() const { return m_hasSlits; }

    /// Node ranges from which no slit leads on: [first, last] where the edge before `first` is run back by the one that
    /// leaves `last`.
    [[nodiscard]] std::vector<std::pair<std::uint32_t, std::uint32_t>> ends() const {
        std::vector<std::pair<std::uint32_t, std::uint32_t>> ends;
        std::uint32_t before = kNone;
        for (std::uint32_t edge = 0; edge < m_twin.size(); ++edge) {
            if (m_twin[edge] == kNone) {
                continue;
            }
            if (before != kNone && m_twin[edge] == before && edge > before + 1) {
                ends.emplace_back(before + 1, edge);
            }
            before = edge;
        }
        return ends;
    }

    /// What is left without them, in the order of the contour; it may be a few nodes without area.
    [[nodiscard]] Loops loops() const {
        Loops loops;
        std::vector<bool> isTaken(m_nodes.size());
        for (std::uint32_t first = 0; first < m_nodes.size(); ++first) {
            if (m_twin[first] != kNone || isTaken[first]) {
                continue;
            }
            std::vector<PathNode>& loop = loops.emplace_back();
            for (std::uint32_t edge = first; !isTaken[edge]; edge = edgeAfter(edge)) {
                isTaken[edge] = true;
                loop.push_back(m_nodes[edge]);
            }
        }
        return loops;
    }

private:
    static constexpr std::uint32_t kNone = base::EdgeSlots::kNone;

    [[nodiscard]] std::uint32_t next(std::uint32_t edge) const { return edge + 1 < m_nodes.size() ? edge + 1 : 0; }
    [[nodiscard]] Point start(std::uint32_t edge) const { return m_nodes[edge].point; }
    [[nodiscard]] Point end(std::uint32_t edge) const { return m_nodes[next(edge)].point; }
    [[nodiscard]] bool isStraight(std::uint32_t edge) const {
        return m_nodes[edge].edge == EdgeKind::Line && start(edge) != end(edge);
    }

    /// Joins the edge with one that runs back along it, or keeps it for such a one to come.
    bool pair(std::uint32_t edge, base::EdgeSlots& slots) {
        const std::uint32_t twin = slots.findOrKeep(start(edge), end(edge), edge, [&](std::uint32_t other) {
            return m_twin[other] == kNone && start(other) == end(edge) && end(other) == start(edge);
        });
        if (twin == kNone) {
            return false;
        }
        m_twin[edge] = twin;
        m_twin[twin] = edge;
        return true;
    }

    /// The edge that leaves where this one ends. Where a slit begins, that is the one behind the slit's way back.
    /// Every edge has one successor and one predecessor, so that a walk ends where it began.
    [[nodiscard]] std::uint32_t edgeAfter(std::uint32_t edge) const {
        for (edge = next(edge); m_twin[edge] != kNone; edge = next(m_twin[edge])) {
        }
        return edge;
    }

    std::span<const PathNode> m_nodes;
    std::vector<std::uint32_t> m_twin;  ///< by edge: the one that runs back along it
    bool m_hasSlits = false;
};

/// Twice the area of a closed path, by the polygon that it is drawn as.
__int128 twiceAreaOf(const PathNodes& path) {
    std::vector<Point> points;
    for (std::size_t i = 0; i < path.size(); ++i) {
        discretiseEdge(path, i, {}, points);
    }
    return twiceArea(points);
}

__int128 twiceAreaOfStraight(std::span<const PathNode> nodes) {
    std::vector<Point> points;
    std::ranges::transform(nodes, std::back_inserter(points), &PathNode::point);
    return twiceArea(points);
}

/// Is the point within the contour without the nodes from `first` to `last`?
bool isWithinRest(Point p, std::span<const PathNode> contour, std::size_t first, std::size_t last) {
    bool isWithin = false;
    const std::size_t size = contour.size() - (last - first + 1);
    const auto node = [&](std::size_t i) { return contour[i < first ? i : i + (last - first + 1)].point; };
    for (std::size_t i = 0; i < size; ++i) {
        const Point a = node(i);
        const Point b = node(i + 1 < size ? i + 1 : 0);
        const bool isCrossed = (a.y <= p.y) != (b.y <= p.y);
        const __int128 side = twiceArea(std::array{a, b, p});
        isWithin = isWithin != (isCrossed && ((b.y > a.y) == (side > 0)));
    }
    return isWithin;
}

bool isStraight(const PathNode& node) {
    return node.edge == EdgeKind::Line;
}

/// Straight there and back, with other nodes on one way than on the other: covers nothing.
bool isFlat(std::span<const PathNode> nodes) {
    const PathNode& first = nodes.front();
    const auto isElsewhere = [&](const PathNode& node) { return node.point != first.point; };
    const auto elsewhere = std::ranges::find_if(nodes, isElsewhere);
    return std::ranges::all_of(nodes, [&](const PathNode& node) {
        return node.edge == EdgeKind::Line &&
               (elsewhere == nodes.end() || twiceArea(std::array{first.point, elsewhere->point, node.point}) == 0);
    });
}

void addLoop(ShapeSketch& sketch, const PathNodes& path, bool isHole) {
    sketch.beginContour(isHole);
    sketch.addNodes(path);
}

/// Adds the loops of a contour, first those that wind as it does, then the others. False, and none added, where areas
/// do not tell which those are: figures of eight whose halves cancel.
bool addLoops(ShapeSketch& sketch, Loops loops, const CurveTable& curves, bool isHole) {
    std::erase_if(loops, isFlat);
    std::vector<__int128> areas;
    std::ranges::transform(loops, std::back_inserter(areas), [&](const std::vector<PathNode>& loop) {
        return twiceAreaOf({loop, &curves});
    });
    const __int128 sum = std::accumulate(areas.begin(), areas.end(), __int128{0});
    if (sum == 0 || std::ranges::find(areas, 0) != areas.end()) {
        return false;
    }
    for (const bool isAgainst : {false, true}) {
        for (std::size_t i = 0; i < loops.size(); ++i) {
            if (((areas[i] > 0) != (sum > 0)) == isAgainst) {
                addLoop(sketch, {loops[i], &curves}, isHole != isAgainst);
            }
        }
    }
    return true;
}

/// A straight edge on the line through the points with the same offset from the origin across the same direction.
struct OnLine {
    std::int64_t dx = 0;  ///< the line's direction: no common divisor, to the right or straight up
    std::int64_t dy = 0;
    __int128 offset = 0;
    std::int64_t low = 0;  ///< along the line: x, or y where it runs straight up
    std::int64_t high = 0;
    std::uint32_t edge = 0;
    bool isBack = false;  ///< the edge runs against the line

    [[nodiscard]] bool isOnSameLine(const OnLine& other) const {
        return dx == other.dx && dy == other.dy && offset == other.offset;
    }
    bool operator<(const OnLine& other) const {
        return std::tie(dx, dy, offset, low) < std::tie(other.dx, other.dy, other.offset, other.low);
    }
};

OnLine onLine(Point a, Point b, std::uint32_t edge) {
    OnLine line;
    line.edge = edge;
    line.dx = std::int64_t{b.x} - a.x;
    line.dy = std::int64_t{b.y} - a.y;
    const std::int64_t divisor = std::gcd(line.dx, line.dy);
    line.isBack = line.dx < 0 || (line.dx == 0 && line.dy < 0);
    line.dx /= line.isBack ? -divisor : divisor;
    line.dy /= line.isBack ? -divisor : divisor;
    line.offset = static_cast<__int128>(line.dx) * a.y - static_cast<__int128>(line.dy) * a.x;
    const auto [low, high] = line.dx == 0 ? std::minmax(a.y, b.y) : std::minmax(a.x, b.x);
    line.low = low;
    line.high = high;
    return line;
}

/// A node to repeat on an edge.
struct Stop {
    std::uint32_t edge = 0;
    std::int64_t along = 0;
    Point point;
};

/// Finds where ends of straight edges lie on such as run the other way.
class StopFinder {
public:
    explicit StopFinder(const PathNodes& contour) : m_contour(contour), m_pairsLeft(kPairsPerEdge * contour.size()) {}

    /// By edge, then along its line; none where too many edges lie upon each other.
    std::vector<Stop> find() {
        std::vector<OnLine> edges = straightEdges();
        std::ranges::sort(edges, std::less{});
        for (auto first = edges.begin(); first != edges.end();) {
            const auto end =
                std::find_if(first, edges.end(), [&](const OnLine& edge) { return !edge.isOnSameLine(*first); });
            findOn({first, end});
            first = end;
        }
        if (m_pairsLeft == 0) {
            return {};
        }
        std::ranges::sort(m_stops, {}, [](const Stop& stop) { return std::pair(stop.edge, stop.along); });
        return std::move(m_stops);
    }

private:
    static constexpr std::size_t kPairsPerEdge = 16;

    [[nodiscard]] std::vector<OnLine> straightEdges() const {
        std::vector<OnLine> edges;
        for (std::uint32_t edge = 0; edge < m_contour.size(); ++edge) {
            const Point a = m_contour[edge].point;
            const Point b = m_contour.endOf(edge);
            if (m_contour[edge].edge == EdgeKind::Line && a != b) {
                edges.push_back(onLine(a, b, edge));
            }
        }
        return edges;
    }

    /// The edges of one line, in the order in which they begin.
    void findOn(std::span<const OnLine> edges) {
        for (std::size_t i = 0; i < edges.size(); ++i) {
            for (std::size_t j = i + 1; j < edges.size() && edges[j].low < edges[i].high && m_pairsLeft > 0; ++j) {
                --m_pairsLeft;
                if (edges[i].isBack != edges[j].isBack) {
                    add(edges[i], edges[j], edges[j].low);
                    add(edges[i], edges[j], edges[j].high);
                    add(edges[j], edges[i], edges[i].high);
                }
            }
        }
    }

    /// The end of `other` at `along` is a stop on `edge` if it lies on it.
    void add(const OnLine& edge, const OnLine& other, std::int64_t along) {
        if (edge.low < along && along < edge.high) {
            const bool isStart = (along == other.low) != other.isBack;
            m_stops.push_back({edge.edge, along, isStart ? m_contour[other.edge].point : m_contour.endOf(other.edge)});
        }
    }

    PathNodes m_contour;
    std::size_t m_pairsLeft;
    std::vector<Stop> m_stops;
};

}  // namespace

std::vector<PathNode> withOpeningsAgainst(std::vector<PathNode> contour) {
    base::EdgeSlots slots;
    if (!SlitContour(contour, slots).hasSlits() || !std::ranges::all_of(contour, isStraight)) {
        return contour;
    }
    std::rotate(contour.begin(), std::ranges::min_element(contour, {}, &PathNode::point),
                contour.end());  // a node of the outside
    const __int128 area = twiceAreaOfStraight(contour);
    for (const auto& [first, last] : SlitContour(contour, slots).ends()) {
        const std::span<PathNode> loop = std::span(contour).subspan(first, last - first + 1);
        const __int128 own = twiceAreaOfStraight(loop);
        const __int128 rest = area - own;
        const bool windsAlike = own != 0 && (own > 0) == (rest > 0) && (own > 0 ? own < rest : own > rest);
        if (windsAlike && isWithinRest(loop[loop.size() / 2].point, contour, first, last)) {
            std::ranges::reverse(loop);
        }
    }
    return contour;
}

std::optional<ShapeSketch> healSlits(const ShapeSketch& sketch) {
    std::vector<SlitContour> contours;
    base::EdgeSlots slots;
    for (std::size_t i = 0; i < sketch.contourCount(); ++i) {
        contours.emplace_back(sketch.contour(i), slots);
    }
    if (std::ranges::none_of(contours, &SlitContour::hasSlits)) {
        return std::nullopt;
    }
    ShapeSketch healed;
    bool isHealed = false;
    for (std::size_t i = 0; i < contours.size(); ++i) {
        if (contours[i].hasSlits() && addLoops(healed, contours[i].loops(), sketch.curves(), sketch.isHole(i))) {
            isHealed = true;
        } else {
            addLoop(healed, sketch.contour(i), sketch.isHole(i));
        }
    }
    return isHealed ? std::optional(std::move(healed)) : std::nullopt;
}

std::vector<PathNode> withNodesWhereRunBack(std::vector<PathNode> contour) {
    const std::vector<Stop> stops = StopFinder(contour).find();
    if (stops.empty()) {
        return contour;
    }
    std::vector<PathNode> result;
    auto stop = stops.begin();
    for (std::uint32_t edge = 0; edge < contour.size(); ++edge) {
        std::vector<Point> points;
        for (; stop != stops.end() && stop->edge == edge; ++stop) {
            points.push_back(stop->point);
        }
        points.erase(std::unique(points.begin(), points.end()), points.end());
        if (!points.empty() && onLine(contour[edge].point, PathNodes(contour).endOf(edge), edge).isBack) {
            std::ranges::reverse(points);
        }
        result.push_back(contour[edge]);
        for (const Point point : points) {
            result.push_back({point, {}, EdgeKind::Line});
        }
    }
    return result;
}

}  // namespace model
