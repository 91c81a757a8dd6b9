#include "model/formats/common/plane_nets.h"

#include <algorithm>
#include <limits>
#include <map>
#include <optional>

#include "model/geometry/box_index.h"

namespace model::formats {

namespace {

/// Finds the polygon around a point.
class PieceLocator {
public:
    explicit PieceLocator(const PolygonSet& pieces) : m_pieces(pieces) {
        for (std::uint32_t p = 0; p < pieces.polygons.size(); ++p) {
            for (std::uint32_t i = 0; i < pieces.polygons[p].loopCount; ++i) {
                addLoop(p, pieces.loop(pieces.polygons[p].firstLoop + i));
            }
        }
        std::vector<Box> boxes;
        for (const Edge& edge : m_edges) {
            boxes.emplace_back().include(edge.low);
            boxes.back().include(edge.high);
            m_right = std::max(m_right, boxes.back().max.x);
        }
        m_index.emplace(boxes);
    }

    /// Number of pieces when the point lies in none.
    [[nodiscard]] std::size_t pieceAt(Point point) const {
        std::map<std::uint32_t, bool> isInside;  // by piece: crossings to the right are odd
        m_index->visit({point, {std::max(point.x, m_right), point.y}}, [&](std::uint32_t row) {
            if (crossesToTheRight(m_edges[row], point)) {
                isInside[m_edges[row].piece] ^= true;
            }
        });
        const auto found = std::ranges::find_if(isInside, [](const auto& entry) { return entry.second; });
        return found == isInside.end() ? m_pieces.polygons.size() : found->first;
    }

private:
    struct Edge {
        Point low;
        Point high;
        std::uint32_t piece;
    };

    void addLoop(std::uint32_t piece, std::span<const Point> loop) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Point a = loop[i];
            const Point b = loop[(i + 1) % loop.size()];
            m_edges.push_back(a.y < b.y ? Edge{a, b, piece} : Edge{b, a, piece});
        }
    }

    static bool crossesToTheRight(const Edge& edge, Point p) {
        if (p.y < edge.low.y || p.y >= edge.high.y) {
            return false;
        }
        // Coordinates are below 2^30, so the products stay below 2^62.
        const std::int64_t side = (std::int64_t{edge.high.x} - edge.low.x) * (std::int64_t{p.y} - edge.low.y) -
                                  (std::int64_t{edge.high.y} - edge.low.y) * (std::int64_t{p.x} - edge.low.x);
        return side > 0;
    }

    const PolygonSet& m_pieces;
    std::vector<Edge> m_edges;
    std::optional<BoxIndex> m_index;
    Nm m_right = std::numeric_limits<Nm>::min();
};

/// The first one of those with most votes.
PieceNet winner(const std::map<NetId, std::size_t>& counts) {
    const auto most = std::ranges::max_element(counts, {}, [](const auto& entry) { return entry.second; });
    return most == counts.end() ? PieceNet{} : PieceNet{most->first, counts.size() > 1};
}

}  // namespace

std::vector<NetVote> votesOn(const Document& document, LayerId layer, const Document& ownFeatures) {
    std::vector<NetVote> votes;
    for (const Layer& holes : document.layers) {
        for (std::uint32_t i = 0; holes.spans(layer) && i < holes.elements.count; ++i) {
            const std::size_t row = holes.elements.first + i;
            const NetId net = document.elements.net[row];
            if ((document.elements.flags[row] & kPlated) != 0 && net.isValid()) {
                votes.push_back({document.boxOf(ElementId{row}).middle(), net});
            }
        }
    }
    for (std::size_t row = 0; row < ownFeatures.elements.size(); ++row) {
        if ((ownFeatures.elements.flags[row] & kPad) != 0 && ownFeatures.elements.net[row].isValid()) {
            votes.push_back({ownFeatures.boxOf(ElementId{row}).middle(), ownFeatures.elements.net[row]});
        }
    }
    return votes;
}

std::vector<PieceNet> netsOf(const PolygonSet& pieces, std::span<const NetVote> votes) {
    std::vector<std::map<NetId, std::size_t>> counts(pieces.polygons.size());
    const PieceLocator locator(pieces);
    for (const NetVote& vote : votes) {
        const std::size_t piece = locator.pieceAt(vote.location);
        if (piece < counts.size()) {
            ++counts[piece][vote.net];
        }
    }
    std::vector<PieceNet> nets;
    for (const std::map<NetId, std::size_t>& count : counts) {
        nets.push_back(winner(count));
    }
    return nets;
}

}  // namespace model::formats
