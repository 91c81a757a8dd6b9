#include "model/measure/net_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <optional>
#include <queue>

#include "model/board/board_heights.h"
#include "model/geometry/vectors.h"
#include "model/measure/net_graph.h"
#include "model/measure/separation.h"
#include "model/text/formatting.h"

namespace model {

namespace {

constexpr std::uint32_t kNone = 0xffffffffu;
constexpr double kPadLengthToSay = 1'000.0;  ///< less is how ends of tracks were rounded

/// Dijkstra's search. Links through an area are made as they are needed: from where it is entered to all its contacts.
class ShortestPath {
public:
    ShortestPath(const NetGraph& graph, base::Progress& progress)
        : m_graph(graph), m_progress(progress), m_reached(graph.nodes().size()) {}

    struct Reached {
        double length = std::numeric_limits<double>::infinity();
        std::uint32_t before = kNone;
        PathLeg::Kind kind = PathLeg::Kind::Pad;
        bool isDone = false;
    };

    /// The node of `to` that is reached first; none if there is no path.
    [[nodiscard]] std::optional<std::uint32_t> find(std::span<const std::uint32_t> from,
                                                    std::span<const std::uint32_t> to) {
        std::vector<bool> isEnd(m_reached.size());
        std::ranges::for_each(to, [&](std::uint32_t node) { isEnd[node] = true; });
        std::ranges::for_each(from, [&](std::uint32_t node) { reach(node, 0.0, kNone, PathLeg::Kind::Pad); });
        while (!m_queue.empty() && !m_progress.isCancelled()) {
            const std::uint32_t node = m_queue.top().second;
            m_queue.pop();
            if (m_reached[node].isDone) {
                continue;
            }
            m_reached[node].isDone = true;
            if (isEnd[node]) {
                return node;
            }
            leave(node);
        }
        return std::nullopt;
    }

    [[nodiscard]] const Reached& reached(std::uint32_t node) const { return m_reached[node]; }

private:
    void reach(std::uint32_t node, double length, std::uint32_t before, PathLeg::Kind kind) {
        if (length < m_reached[node].length) {
            m_reached[node] = {length, before, kind, false};
            m_queue.emplace(length, node);
        }
    }

    void leave(std::uint32_t node) {
        const Reached& here = m_reached[node];
        const double length = here.length;
        for (const NetLink& link : m_graph.linksOf(node)) {
            reach(link.to, length + link.length, node, link.kind);
        }
        // Going on straight through the area it was reached through is never shorter.
        if (m_graph.isOnArea(node) && m_reached[node].kind != PathLeg::Kind::Area) {
            const PointD at = m_graph.nodes()[node].at;
            for (const std::uint32_t other : m_graph.sameArea(node)) {
                reach(other, length + distance(at, m_graph.nodes()[other].at), node, PathLeg::Kind::Area);
            }
        }
    }

    using Entry = std::pair<double, std::uint32_t>;
    const NetGraph& m_graph;
    base::Progress& m_progress;
    std::vector<Reached> m_reached;
    std::priority_queue<Entry, std::vector<Entry>, std::greater<>> m_queue;
};

NetPath pathTo(const NetGraph& graph, const ShortestPath& search, std::uint32_t end) {
    NetPath path;
    path.length = search.reached(end).length;
    for (std::uint32_t node = end; search.reached(node).before != kNone; node = search.reached(node).before) {
        const std::uint32_t before = search.reached(node).before;
        const double length = search.reached(node).length - search.reached(before).length;
        if (length > 0) {
            path.legs.push_back({search.reached(node).kind, graph.nodes()[before].layer, graph.pieceOf(before).at,
                                 graph.nodes()[before].at, graph.nodes()[node].at, length, graph.nodes()[before].along,
                                 graph.nodes()[node].along});
        }
    }
    std::ranges::reverse(path.legs);
    return path;
}

void addUp(const BoardIndex& index, NetPath& path) {
    std::map<LayerId, double> perLayer;
    BoardElement hole;
    for (const PathLeg& leg : path.legs) {
        if (leg.kind == PathLeg::Kind::Hole) {
            path.holeHeight += leg.length;
            path.holeCount += leg.element != hole ? 1 : 0;
            hole = leg.element;
        } else {
            perLayer[leg.layer] += leg.length;
            path.areaLength += leg.kind == PathLeg::Kind::Area ? leg.length : 0.0;
            path.padLength += leg.kind == PathLeg::Kind::Pad ? leg.length : 0.0;
        }
    }
    path.perLayer.assign(perLayer.begin(), perLayer.end());
    if (path.areaLength > 0) {
        path.notes.emplace_back("part of the path runs straight through areas, so its length is an estimate");
    }
    if (path.padLength > kPadLengthToSay) {
        path.notes.push_back(
            formatted("%.6f mm of the path leave the middle lines of tracks, straight through pads or to "
                      "the next track, so its length is an estimate",
                      base::toMm(path.padLength)));
    }
    if (std::string note = noteOnHoles(*index.board); path.holeCount > 0 && !note.empty()) {
        path.notes.push_back(std::move(note));
    }
}

/// Corners of a track, and points of its arcs, whose length along its middle line is between `low` and `high`.
void addBetween(std::span<const Edge> track, double low, double high, std::vector<PointD>& course) {
    constexpr double kStep = std::numbers::pi / 30.0;
    double before = 0.0;
    for (const Edge& edge : track) {
        const double length = lengthOf(edge);
        const auto parts = edge.isArc() ? std::ceil(length / edge.radius / kStep) : 1.0;
        for (double part = 1.0; part <= parts; ++part) {
            const double along = before + length * part / parts;
            if (along > low && along < high) {
                course.push_back(pointAt(edge, length * part / parts));
            }
        }
        before += length;
    }
}

/// What lies between the ends of a leg along a track.
std::vector<PointD> between(std::span<const Edge> track, const PathLeg& leg) {
    const double low = std::min(leg.fromAlong, leg.toAlong);
    const double high = std::max(leg.fromAlong, leg.toAlong);
    std::vector<PointD> course;
    bool isBackwards = leg.toAlong < leg.fromAlong;
    if (isClosed(track) && leg.length < high - low - 1.0) {  // the other way round
        addBetween(track, high, std::numeric_limits<double>::infinity(), course);
        addBetween(track, 0.0, low, course);
        isBackwards = !isBackwards;
    } else {
        addBetween(track, low, high, course);
    }
    if (isBackwards) {
        std::ranges::reverse(course);
    }
    return course;
}

}  // namespace

std::string noteOnHoles(const Document& board) {
    const ZRange heights = boardHeights(board);
    return assumedBetween(board, heights.bottom, heights.top).empty() ? "" : kHolesAreAssumed;
}

std::vector<PointD> courseOf(const BoardIndex& index, const PathLeg& leg) {
    std::vector<PointD> course;
    if (leg.kind == PathLeg::Kind::Track) {
        const Pieces pieces = piecesOf(index, std::array{leg.element});
        course = between(pieces.figures.edges(0), leg);
    }
    course.insert(course.begin(), leg.from);
    course.push_back(leg.to);
    return course;
}

base::Result<NetPath> pathAlong(const BoardIndex& index, NetOfCopy net, const MeasureItem& from, const MeasureItem& to,
                                base::Progress& progress) {
    progress.beginPhase("Following the net");
    NetGraph graph(index, net);
    if (!graph.join(progress)) {
        return base::Error{base::ErrorCode::Cancelled, "cancelled"};
    }
    std::array<std::vector<std::uint32_t>, 2> ends;
    for (const MeasureItem* item : {&from, &to}) {
        std::vector<std::uint32_t>& nodes = ends[item == &from ? 0 : 1];
        nodes = graph.endsAt(*item);
        if (nodes.empty()) {
            return base::Error{base::ErrorCode::BadUsage, nameOf(index, *item) + " has no copper of " +
                                                              nameOf(index, net) + " that an item touches"};
        }
    }
    graph.finish();
    ShortestPath search(graph, progress);
    const std::optional<std::uint32_t> end = search.find(ends[0], ends[1]);
    if (progress.isCancelled()) {
        return base::Error{base::ErrorCode::Cancelled, "cancelled"};
    }
    if (!end) {
        return base::Error{base::ErrorCode::BadUsage, "no copper of " + nameOf(index, net) + " leads from " +
                                                          nameOf(index, from) + " to " + nameOf(index, to)};
    }
    NetPath path = pathTo(graph, search, *end);
    addUp(index, path);
    for (const MeasureItem* item : {&from, &to}) {
        if (std::string note = noteOnName(index, *item); !note.empty()) {
            path.notes.push_back(std::move(note));
        }
    }
    return path;
}

}  // namespace model
