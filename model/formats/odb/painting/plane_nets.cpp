#include "model/formats/odb/painting/plane_nets.h"

#include <algorithm>
#include <map>

namespace model::odb {

namespace {

Point middleOf(const Document& document, std::size_t row) {
    const Box box = document.boxOf(ElementId{row});
    return {static_cast<Nm>((std::int64_t{box.min.x} + box.max.x) / 2),
            static_cast<Nm>((std::int64_t{box.min.y} + box.max.y) / 2)};
}

/// Finds the polygon around a point. Edges are sorted into rows of y, so a point asks only those at its height.
class PieceLocator {
public:
    explicit PieceLocator(const PolygonSet& pieces) : m_pieces(pieces), m_rows(kRows) {
        for (const Point point : pieces.points) {
            m_extent.include(point);
        }
        for (std::uint32_t p = 0; p < pieces.polygons.size(); ++p) {
            for (std::uint32_t i = 0; i < pieces.polygons[p].loopCount; ++i) {
                addLoop(p, pieces.loop(pieces.polygons[p].firstLoop + i));
            }
        }
    }

    /// Number of pieces when the point lies in none.
    [[nodiscard]] std::size_t pieceAt(Point point) const {
        if (m_extent.isEmpty() || point.y < m_extent.min.y || point.y > m_extent.max.y) {
            return m_pieces.polygons.size();
        }
        std::map<std::uint32_t, bool> isInside;  // by piece: crossings to the right are odd
        for (const Edge& edge : m_rows[rowOf(point.y)]) {
            if (crossesToTheRight(edge, point)) {
                isInside[edge.piece] ^= true;
            }
        }
        const auto found = std::ranges::find_if(isInside, [](const auto& entry) { return entry.second; });
        return found == isInside.end() ? m_pieces.polygons.size() : found->first;
    }

private:
    struct Edge {
        Point low;
        Point high;
        std::uint32_t piece;
    };
    static constexpr std::size_t kRows = 2048;

    void addLoop(std::uint32_t piece, std::span<const Point> loop) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const Point a = loop[i];
            const Point b = loop[(i + 1) % loop.size()];
            if (a.y == b.y) {
                continue;
            }
            const Edge edge = a.y < b.y ? Edge{a, b, piece} : Edge{b, a, piece};
            for (std::size_t row = rowOf(edge.low.y); row <= rowOf(edge.high.y); ++row) {
                m_rows[row].push_back(edge);
            }
        }
    }

    [[nodiscard]] std::size_t rowOf(Nm y) const {
        const std::int64_t offset = std::int64_t{y} - m_extent.min.y;
        return static_cast<std::size_t>(offset * static_cast<std::int64_t>(kRows - 1) /
                                        std::max<std::int64_t>(m_extent.height(), 1));
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
    Box m_extent;
    std::vector<std::vector<Edge>> m_rows;
};

PieceNet winner(const std::map<NetId, std::size_t>& counts) {
    PieceNet result;
    std::size_t most = 0;
    for (const auto& [net, count] : counts) {
        if (count > most) {
            most = count;
            result.net = net;
        }
    }
    result.hasOtherVotes = counts.size() > 1;
    return result;
}

}  // namespace

std::vector<NetVote> votesOn(const Document& document, LayerId layer, const Document& ownFeatures) {
    std::vector<NetVote> votes;
    for (const Layer& holes : document.layers) {
        for (std::uint32_t i = 0; holes.spans(layer) && i < holes.elements.count; ++i) {
            const std::size_t row = holes.elements.first + i;
            const NetId net = document.elements.net[row];
            if ((document.elements.flags[row] & kPlated) != 0 && net.isValid()) {
                votes.push_back({middleOf(document, row), net});
            }
        }
    }
    for (std::size_t row = 0; row < ownFeatures.elements.size(); ++row) {
        if ((ownFeatures.elements.flags[row] & kPad) != 0 && ownFeatures.elements.net[row].isValid()) {
            votes.push_back({middleOf(ownFeatures, row), ownFeatures.elements.net[row]});
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

}  // namespace model::odb
