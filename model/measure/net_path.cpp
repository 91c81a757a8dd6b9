#include "model/measure/net_path.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <queue>

#include "model/geometry/box_index.h"
#include "model/geometry/distance.h"
#include "model/measure/separation.h"

namespace model {

namespace {

constexpr std::uint32_t kNone = 0xffffffffu;

double distance(PointD a, PointD b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

/// How the way goes on inside of a piece.
enum class Carrier : std::uint8_t {
    Stroke,  ///< along its middle lines
    Hub,     ///< over its centre
    Area     ///< straight from contact to contact
};

/// A place where the way can turn: on a piece, on a layer.
struct Node {
    std::uint32_t piece = 0;
    LayerId layer;
    PointD at;
    double along = 0.0;  ///< strokes: length of the middle line up to here
};

struct Link {
    std::uint32_t to = 0;
    double length = 0.0;
    PathLeg::Kind kind = PathLeg::Kind::Stroke;
};

/// A net's copper as a graph: nodes where pieces meet, links along the pieces.
class NetGraph {
public:
    NetGraph(const BoardIndex& index, NetOfCopy net) : m_index(index), m_pieces(piecesOf(index, net)) {
        std::vector<Box> boxes;
        for (std::size_t row = 0; row < m_pieces.pieces.size(); ++row) {
            boxes.push_back(m_pieces.figures.box(row));
            m_carriers.push_back(carrierOf(row));
        }
        m_onPiece.resize(m_pieces.pieces.size());
        m_hubs.resize(m_pieces.pieces.size());
        m_boxes.emplace_back(boxes);
    }

    /// Joins what touches. False after a cancel.
    [[nodiscard]] bool join(base::Progress& progress) {
        std::vector<std::uint32_t> near;
        for (std::uint32_t i = 0; i < m_pieces.pieces.size(); ++i) {
            near.clear();
            m_boxes.front().visit(m_pieces.figures.box(i), [&](std::uint32_t j) {
                if (j > i && m_pieces.pieces[i].sharesLayerWith(m_pieces.pieces[j])) {
                    near.push_back(j);
                }
            });
            std::ranges::sort(near);
            for (const std::uint32_t j : near) {
                if (const auto gap = gapBetween(m_pieces.figures, i, m_pieces.figures, j, kTouchNm)) {
                    joinPieces(i, j, gap->from);
                }
            }
            progress.setFraction(static_cast<float>(i) / static_cast<float>(m_pieces.pieces.size()));
            if (progress.isCancelled()) {
                return false;
            }
        }
        return true;
    }

    /// Nodes that stand for an end of the way; empty if it is not on the net.
    [[nodiscard]] std::vector<std::uint32_t> endsAt(const Thing& thing) {
        if (const Place* place = std::get_if<Place>(&thing)) {
            return endsAtPlace(*place);
        }
        std::vector<std::uint32_t> nodes;
        for (const BoardElement at : elementsOf(m_index, thing)) {
            for (std::uint32_t row = 0; row < m_pieces.pieces.size(); ++row) {
                if (m_pieces.pieces[row].at == at) {
                    standFor(row, nodes);
                }
            }
        }
        return nodes;
    }

    /// Links along strokes, up and down holes. Call when all nodes are there.
    void finish() {
        for (std::uint32_t row = 0; row < m_pieces.pieces.size(); ++row) {
            if (m_carriers[row] == Carrier::Stroke) {
                linkAlong(row);
            } else if (m_carriers[row] == Carrier::Hub) {
                linkThrough(row);
            }
        }
    }

    [[nodiscard]] const std::vector<Node>& nodes() const { return m_nodes; }
    [[nodiscard]] std::span<const Link> linksOf(std::uint32_t node) const { return m_links[node]; }
    [[nodiscard]] bool isOnArea(std::uint32_t node) const { return m_carriers[m_nodes[node].piece] == Carrier::Area; }
    [[nodiscard]] std::span<const std::uint32_t> sameArea(std::uint32_t node) const {
        return m_onPiece[m_nodes[node].piece];
    }
    [[nodiscard]] const Piece& pieceOf(std::uint32_t node) const { return m_pieces.pieces[m_nodes[node].piece]; }

private:
    [[nodiscard]] const Document& stepOf(const Piece& piece) const {
        return *m_index.tree.steps[m_index.tree.copies[piece.at.copy].step];
    }

    [[nodiscard]] Carrier carrierOf(std::size_t row) const {
        const Piece& piece = m_pieces.pieces[row];
        const std::uint8_t flags = stepOf(piece).elements.flags[piece.at.element.row()];
        const ElementKind kind = stepOf(piece).elements.kind[piece.at.element.row()];
        if ((flags & (kPad | kHole)) != 0 || kind == ElementKind::Circle) {
            return Carrier::Hub;
        }
        return m_pieces.figures[row].isFilled ? Carrier::Area : Carrier::Stroke;
    }

    /// The middle of a pad or hole.
    [[nodiscard]] PointD centreOf(std::uint32_t row) const {
        const Box& box = m_pieces.figures.box(row);
        const Edge& first = m_pieces.figures.edges(row).front();
        const bool isDisc = m_pieces.figures.edges(row).size() == 1 && first.isArc();
        return isDisc ? first.centre : PointD{(double(box.min.x) + box.max.x) / 2, (double(box.min.y) + box.max.y) / 2};
    }

    std::uint32_t addNode(const Node& node) {
        m_nodes.push_back(node);
        m_links.emplace_back();
        const auto row = static_cast<std::uint32_t>(m_nodes.size() - 1);
        m_onPiece[node.piece].push_back(row);
        return row;
    }

    void link(std::uint32_t a, std::uint32_t b, double length, PathLeg::Kind kind) {
        m_links[a].push_back({b, length, kind});
        m_links[b].push_back({a, length, kind});
    }

    /// The node of a pad or hole on one layer.
    std::uint32_t hubOf(std::uint32_t row, LayerId layer) {
        const auto [place, isFirst] = m_hubs[row].try_emplace(layer, 0);
        if (isFirst) {
            place->second = addNode({row, layer, centreOf(row), 0.0});
        }
        return place->second;
    }

    /// The node of a piece that is nearest to a place both it and another piece cover.
    std::uint32_t nodeNear(std::uint32_t row, LayerId layer, PointD place) {
        if (m_carriers[row] == Carrier::Hub) {
            return hubOf(row, layer);
        }
        return m_carriers[row] == Carrier::Area ? addNode({row, layer, place, 0.0}) : nodeOnStroke(row, layer, place);
    }

    std::uint32_t nodeOnStroke(std::uint32_t row, LayerId layer, PointD place) {
        Node node{row, layer, place, 0.0};
        double least = std::numeric_limits<double>::infinity();
        double before = 0.0;
        for (const Edge& edge : m_pieces.figures.edges(row)) {
            const PointD on = nearestOn(edge, place);
            if (const double beside = distance(on, place); beside < least) {
                least = beside;
                node.at = on;
                node.along = before + lengthTo(edge, on);
            }
            before += lengthOf(edge);
        }
        return addNode(node);
    }

    /// The place at which two pieces are joined: the centre of a pad if one is a pad, an end of one of two strokes if
    /// it lies in the other's pen, else where they meet.
    [[nodiscard]] PointD jointOf(std::uint32_t i, std::uint32_t j, PointD meeting) const {
        if (m_carriers[i] == Carrier::Hub || m_carriers[j] == Carrier::Hub) {
            return centreOf(m_carriers[i] == Carrier::Hub ? i : j);
        }
        if (m_carriers[i] == Carrier::Area && m_carriers[j] == Carrier::Area) {
            return meeting;
        }
        if (m_carriers[i] == Carrier::Area || m_carriers[j] == Carrier::Area) {
            return endInside(m_carriers[i] == Carrier::Stroke ? i : j, m_carriers[i] == Carrier::Area ? i : j)
                .value_or(meeting);
        }
        return middlesMeet(i, j);
    }

    /// The end of a stroke that lies in an area.
    [[nodiscard]] std::optional<PointD> endInside(std::uint32_t stroke, std::uint32_t area) const {
        const std::span<const Edge> edges = m_pieces.figures.edges(stroke);
        for (const PointD end : {edges.front().a, edges.back().b}) {
            if (isInside(m_pieces.figures, area, end)) {
                return end;
            }
        }
        return std::nullopt;
    }

    /// Where the middle lines of two strokes are nearest to each other.
    [[nodiscard]] PointD middlesMeet(std::uint32_t i, std::uint32_t j) const {
        Gap nearest{std::numeric_limits<double>::infinity(), {}, {}};
        for (Edge e : m_pieces.figures.edges(i)) {
            for (Edge f : m_pieces.figures.edges(j)) {
                e.pen = f.pen = 0.0;
                if (const Gap gap = gapBetween(e, f); gap.distance < nearest.distance) {
                    nearest = gap;
                }
            }
        }
        return nearest.from;
    }

    void joinPieces(std::uint32_t i, std::uint32_t j, PointD meeting) {
        const Piece& a = m_pieces.pieces[i];
        const Piece& b = m_pieces.pieces[j];
        const LayerId top = std::max(a.top, b.top);
        const LayerId bottom = std::min(a.bottom, b.bottom);
        const PointD joint = jointOf(i, j, meeting);
        const bool areHoles = a.top != a.bottom && b.top != b.bottom;
        for (std::size_t row = top.row(); row <= bottom.row(); ++row) {
            const LayerId layer{row};
            if (m_index.board->layer(layer).isCopper() && (!areHoles || row == top.row())) {
                const std::uint32_t nodeA = nodeNear(i, layer, joint);
                const std::uint32_t nodeB = nodeNear(j, layer, joint);
                link(nodeA, nodeB, distance(m_nodes[nodeA].at, m_nodes[nodeB].at), PathLeg::Kind::Pad);
            }
        }
    }

    std::vector<std::uint32_t> endsAtPlace(const Place& place) {
        FigureTable dot;
        dot.addStroke(place.at, place.at, 0.0);
        std::vector<std::uint32_t> nodes;
        m_boxes.front().visit(dot.box(0), [&](std::uint32_t row) {
            const Piece& piece = m_pieces.pieces[row];
            const bool isOnLayer = !place.layer.isValid() || (piece.top <= place.layer && place.layer <= piece.bottom);
            if (isOnLayer && gapBetween(m_pieces.figures, row, dot, 0, kTouchNm)) {
                nodes.push_back(nodeNear(row, place.layer.isValid() ? place.layer : piece.top, place.at));
            }
        });
        return nodes;
    }

    void standFor(std::uint32_t row, std::vector<std::uint32_t>& nodes) {
        if (m_carriers[row] == Carrier::Hub && m_hubs[row].empty() && m_pieces.pieces[row].top.isValid()) {
            hubOf(row, m_pieces.pieces[row].top);
        }
        nodes.insert(nodes.end(), m_onPiece[row].begin(), m_onPiece[row].end());
    }

    void linkAlong(std::uint32_t row) {
        std::vector<std::uint32_t>& nodes = m_onPiece[row];
        std::ranges::stable_sort(nodes, {}, [this](std::uint32_t node) { return m_nodes[node].along; });
        for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
            link(nodes[i], nodes[i + 1], m_nodes[nodes[i + 1]].along - m_nodes[nodes[i]].along, PathLeg::Kind::Stroke);
        }
        const std::span<const Edge> edges = m_pieces.figures.edges(row);
        if (edges.size() == 1 && edges[0].isFullCircle() && nodes.size() > 1) {
            const double open = m_nodes[nodes.back()].along - m_nodes[nodes.front()].along;
            link(nodes.back(), nodes.front(), lengthOf(edges[0]) - open, PathLeg::Kind::Stroke);
        }
    }

    void linkThrough(std::uint32_t row) {
        std::optional<std::pair<LayerId, std::uint32_t>> before;
        for (const auto& [layer, node] : m_hubs[row]) {
            if (before) {
                link(before->second, node, middleOf(before->first) - middleOf(layer), PathLeg::Kind::Hole);
            }
            before = {layer, node};
        }
    }

    /// Half way through the copper of a layer.
    [[nodiscard]] double middleOf(LayerId id) const {
        const Layer& layer = m_index.board->layer(id);
        return layer.z + layer.thickness / 2.0;
    }

    const BoardIndex& m_index;
    Pieces m_pieces;
    std::vector<Carrier> m_carriers;
    std::vector<BoxIndex> m_boxes;  ///< one
    std::vector<Node> m_nodes;
    std::vector<std::vector<Link>> m_links;
    std::vector<std::vector<std::uint32_t>> m_onPiece;
    std::vector<std::map<LayerId, std::uint32_t>> m_hubs;  ///< by piece: pads and holes
};

/// Dijkstra's search. Links through an area are made as they are needed: from where it is entered to all its contacts.
class ShortestWay {
public:
    ShortestWay(const NetGraph& graph, base::Progress& progress)
        : m_graph(graph), m_progress(progress), m_reached(graph.nodes().size()) {}

    struct Reached {
        double length = std::numeric_limits<double>::infinity();
        std::uint32_t before = kNone;
        PathLeg::Kind kind = PathLeg::Kind::Pad;
        bool isDone = false;
    };

    /// The node of `to` that is reached first; none if there is no way.
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
        for (const Link& link : m_graph.linksOf(node)) {
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

NetPath pathTo(const NetGraph& graph, const ShortestWay& way, std::uint32_t end) {
    NetPath path;
    path.length = way.reached(end).length;
    for (std::uint32_t node = end; way.reached(node).before != kNone; node = way.reached(node).before) {
        const std::uint32_t before = way.reached(node).before;
        const double length = way.reached(node).length - way.reached(before).length;
        if (length > 0) {
            path.legs.push_back({way.reached(node).kind, graph.nodes()[before].layer, graph.pieceOf(before).at,
                                 graph.nodes()[before].at, graph.nodes()[node].at, length});
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
        }
    }
    path.perLayer.assign(perLayer.begin(), perLayer.end());
    if (path.areaLength > 0) {
        path.remarks.emplace_back("part of the way runs straight through areas, so its length is a guess");
    }
    const Document& board = *index.board;
    if (path.holeCount > 0 && !assumedBetween(board, 0, board.boardThickness).empty()) {
        path.remarks.emplace_back("the heights of holes rest on assumed thicknesses");
    }
}

}  // namespace

base::Result<NetPath> pathAlong(const BoardIndex& index, NetOfCopy net, const Thing& from, const Thing& to,
                                base::Progress& progress) {
    progress.beginPhase("Following the net");
    NetGraph graph(index, net);
    if (!graph.join(progress)) {
        return base::Error{base::ErrorCode::Cancelled, "cancelled"};
    }
    std::array<std::vector<std::uint32_t>, 2> ends;
    for (const Thing* thing : {&from, &to}) {
        std::vector<std::uint32_t>& nodes = ends[thing == &from ? 0 : 1];
        nodes = graph.endsAt(*thing);
        if (nodes.empty()) {
            return base::Error{base::ErrorCode::BadUsage, nameOf(index, *thing) + " has no copper of " +
                                                              nameOf(index, net) + " that anything touches"};
        }
    }
    graph.finish();
    ShortestWay way(graph, progress);
    const std::optional<std::uint32_t> end = way.find(ends[0], ends[1]);
    if (progress.isCancelled()) {
        return base::Error{base::ErrorCode::Cancelled, "cancelled"};
    }
    if (!end) {
        return base::Error{base::ErrorCode::BadUsage, "no copper of " + nameOf(index, net) + " leads from " +
                                                          nameOf(index, from) + " to " + nameOf(index, to)};
    }
    NetPath path = pathTo(graph, way, *end);
    addUp(index, path);
    return path;
}

}  // namespace model
