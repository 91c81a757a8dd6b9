#include "model/measure/net_graph.h"

#include <algorithm>
#include <numeric>

#include "model/figures/distance.h"
#include "model/geometry/vectors.h"

namespace model {

bool isClosed(std::span<const Edge> track) {
    return distance(track.front().a, track.back().b) < 1.0;
}

NetGraph::NetGraph(const BoardIndex& index, NetOfCopy net) : m_index(index), m_pieces(connectedPiecesOf(index, net)) {
    for (std::size_t row = 0; row < m_pieces.pieces.size(); ++row) {
        m_carriers.push_back(carrierOf(row));
    }
    m_onPiece.resize(m_pieces.pieces.size());
    m_hubs.resize(m_pieces.pieces.size());
    m_boxes.emplace_back(m_pieces.figures.outerBoxes());
}

bool NetGraph::join(base::Progress& progress) {
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
            if (const auto spacing = spacingBetween(m_pieces.figures, i, m_pieces.figures, j, kTouchNm)) {
                joinPieces(i, j, spacing->from);
            }
        }
        progress.setFraction(static_cast<float>(i) / static_cast<float>(m_pieces.pieces.size()));
        if (progress.isCancelled()) {
            return false;
        }
    }
    return true;
}

std::vector<std::uint32_t> NetGraph::endsAt(const MeasureItem& item) {
    if (const Location* location = std::get_if<Location>(&item)) {
        return endsAtLocation(*location);
    }
    std::vector<std::uint32_t> nodes;
    for (const BoardElement at : elementsOf(m_index, item)) {
        for (std::uint32_t row = 0; row < m_pieces.pieces.size(); ++row) {
            if (m_pieces.pieces[row].at == at) {
                addNodesOf(row, nodes);
            }
        }
    }
    return nodes;
}

void NetGraph::finish() {
    for (std::uint32_t row = 0; row < m_pieces.pieces.size(); ++row) {
        if (m_carriers[row] == Carrier::Track) {
            linkAlong(row);
        } else if (m_carriers[row] == Carrier::Hub) {
            linkThrough(row);
        }
    }
}

std::span<const std::uint32_t> NetGraph::sameArea(std::uint32_t node) const {
    return m_onPiece[m_nodes[node].piece];
}

Carrier NetGraph::carrierOf(std::size_t row) const {
    const BoardElement at = m_pieces.pieces[row].at;
    const ElementTable& elements = m_index.stepOf(at.copy).elements;
    const std::uint8_t flags = elements.flags[at.element.row()];
    const ElementKind kind = elements.kind[at.element.row()];
    if ((flags & (kPad | kHole)) != 0 || kind == ElementKind::Circle) {
        return Carrier::Hub;
    }
    return m_pieces.figures[row].isFilled ? Carrier::Area : Carrier::Track;
}

PointD NetGraph::centreOf(std::uint32_t row) const {
    const Box& box = m_pieces.figures.box(row);
    const Edge& first = m_pieces.figures.edges(row).front();
    const bool isDisc = m_pieces.figures.edges(row).size() == 1 && first.isArc();
    return isDisc ? first.centre : PointD{(double(box.min.x) + box.max.x) / 2, (double(box.min.y) + box.max.y) / 2};
}

std::uint32_t NetGraph::addNode(const NetNode& node) {
    m_nodes.push_back(node);
    m_links.emplace_back();
    const auto row = static_cast<std::uint32_t>(m_nodes.size() - 1);
    m_onPiece[node.piece].push_back(row);
    return row;
}

void NetGraph::link(std::uint32_t a, std::uint32_t b, double length, PathLeg::Kind kind) {
    m_links[a].push_back({b, length, kind});
    m_links[b].push_back({a, length, kind});
}

std::uint32_t NetGraph::hubOf(std::uint32_t row, LayerId layer) {
    const auto [location, isFirst] = m_hubs[row].try_emplace(layer, 0);
    if (isFirst) {
        location->second = addNode({row, layer, centreOf(row), 0.0});
    }
    return location->second;
}

std::uint32_t NetGraph::nodeNear(std::uint32_t row, LayerId layer, PointD location) {
    if (m_carriers[row] == Carrier::Hub) {
        return hubOf(row, layer);
    }
    return m_carriers[row] == Carrier::Area ? addNode({row, layer, location, 0.0}) : nodeOnTrack(row, layer, location);
}

std::uint32_t NetGraph::nodeOnTrack(std::uint32_t row, LayerId layer, PointD location) {
    NetNode node{row, layer, location, 0.0};
    double least = std::numeric_limits<double>::infinity();
    double before = 0.0;
    for (const Edge& edge : m_pieces.figures.edges(row)) {
        const PointD on = nearestOn(edge, location);
        if (const double beside = distance(on, location); beside < least) {
            least = beside;
            node.at = on;
            node.along = before + lengthTo(edge, on);
        }
        before += lengthOf(edge);
    }
    return addNode(node);
}

PointD NetGraph::jointOf(std::uint32_t i, std::uint32_t j, PointD meeting) const {
    if (m_carriers[i] == Carrier::Hub || m_carriers[j] == Carrier::Hub) {
        return centreOf(m_carriers[i] == Carrier::Hub ? i : j);
    }
    if (m_carriers[i] == Carrier::Area && m_carriers[j] == Carrier::Area) {
        return meeting;
    }
    if (m_carriers[i] == Carrier::Area || m_carriers[j] == Carrier::Area) {
        return endInside(m_carriers[i] == Carrier::Track ? i : j, m_carriers[i] == Carrier::Area ? i : j)
            .value_or(meeting);
    }
    return middlesMeet(i, j);
}

std::optional<PointD> NetGraph::endInside(std::uint32_t track, std::uint32_t area) const {
    const std::span<const Edge> edges = m_pieces.figures.edges(track);
    for (const PointD end : {edges.front().a, edges.back().b}) {
        if (isInside(m_pieces.figures, area, end)) {
            return end;
        }
    }
    return std::nullopt;
}

PointD NetGraph::middlesMeet(std::uint32_t i, std::uint32_t j) const {
    Spacing nearest{std::numeric_limits<double>::infinity(), {}, {}};
    for (Edge e : m_pieces.figures.edges(i)) {
        for (Edge f : m_pieces.figures.edges(j)) {
            e.pen = f.pen = 0.0;
            if (const Spacing spacing = spacingBetween(e, f); spacing.distance < nearest.distance) {
                nearest = spacing;
            }
        }
    }
    return nearest.from;
}

void NetGraph::joinPieces(std::uint32_t i, std::uint32_t j, PointD meeting) {
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

std::vector<std::uint32_t> NetGraph::endsAtLocation(const Location& location) {
    FigureTable dot;
    dot.addTrack(location.at, location.at, 0.0);
    std::vector<std::uint32_t> nodes;
    m_boxes.front().visit(dot.box(0), [&](std::uint32_t row) {
        const Piece& piece = m_pieces.pieces[row];
        const bool isOnLayer =
            !location.layer.isValid() || (piece.top <= location.layer && location.layer <= piece.bottom);
        if (isOnLayer && spacingBetween(m_pieces.figures, row, dot, 0, kTouchNm)) {
            nodes.push_back(nodeNear(row, location.layer.isValid() ? location.layer : piece.top, location.at));
        }
    });
    return nodes;
}

void NetGraph::addNodesOf(std::uint32_t row, std::vector<std::uint32_t>& nodes) {
    if (m_carriers[row] == Carrier::Hub && m_hubs[row].empty() && m_pieces.pieces[row].top.isValid()) {
        hubOf(row, m_pieces.pieces[row].top);
    }
    nodes.insert(nodes.end(), m_onPiece[row].begin(), m_onPiece[row].end());
}

void NetGraph::linkAlong(std::uint32_t row) {
    std::vector<std::uint32_t>& nodes = m_onPiece[row];
    std::ranges::stable_sort(nodes, {}, [this](std::uint32_t node) { return m_nodes[node].along; });
    for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
        link(nodes[i], nodes[i + 1], m_nodes[nodes[i + 1]].along - m_nodes[nodes[i]].along, PathLeg::Kind::Track);
    }
    const std::span<const Edge> edges = m_pieces.figures.edges(row);
    if (isClosed(edges) && nodes.size() > 1) {
        const double open = m_nodes[nodes.back()].along - m_nodes[nodes.front()].along;
        const double around = std::accumulate(edges.begin(), edges.end(), 0.0,
                                              [](double sum, const Edge& edge) { return sum + lengthOf(edge); });
        link(nodes.back(), nodes.front(), around - open, PathLeg::Kind::Track);
    }
}

void NetGraph::linkThrough(std::uint32_t row) {
    std::optional<std::pair<LayerId, std::uint32_t>> before;
    for (const auto& [layer, node] : m_hubs[row]) {
        if (before) {
            link(before->second, node, middleOf(before->first) - middleOf(layer), PathLeg::Kind::Hole);
        }
        before = {layer, node};
    }
}

double NetGraph::middleOf(LayerId id) const {
    const Layer& layer = m_index.board->layer(id);
    return layer.z + layer.thickness / 2.0;
}

}  // namespace model
