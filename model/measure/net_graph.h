#pragma once

#include <map>
#include <optional>
#include <span>
#include <vector>

#include "model/base/progress.h"
#include "model/geometry/box_index.h"
#include "model/measure/net_path.h"

namespace model {

/// How the path continues inside of a piece.
enum class Carrier : std::uint8_t {
    Track,  ///< along its middle lines
    Hub,    ///< over its centre
    Area    ///< straight from contact to contact
};

/// A location where the path can change direction: on a piece, on a layer.
struct NetNode {
    std::uint32_t piece = 0;
    LayerId layer;
    PointD at;
    double along = 0.0;  ///< tracks: length of the middle line up to here
};

struct NetLink {
    std::uint32_t to = 0;
    double length = 0.0;
    PathLeg::Kind kind = PathLeg::Kind::Track;
};

/// Does a track end where it begins, as a full circle or a ring of several edges does?
[[nodiscard]] bool isClosed(std::span<const Edge> track);

/// A net's copper as a graph: nodes where pieces meet, links along the pieces. Join, ask for the ends, finish; then
/// read.
class NetGraph {
public:
    NetGraph(const BoardIndex& index, NetOfCopy net);

    /// Joins what touches. False after a cancel.
    [[nodiscard]] bool join(base::Progress& progress);

    /// Nodes of an end of the path; empty if it is not on the net.
    [[nodiscard]] std::vector<std::uint32_t> endsAt(const MeasureItem& item);

    /// Links along tracks, up and down holes. Call when all nodes are there.
    void finish();
    [[nodiscard]] const std::vector<NetNode>& nodes() const { return m_nodes; }
    [[nodiscard]] std::span<const NetLink> linksOf(std::uint32_t node) const { return m_links[node]; }
    [[nodiscard]] bool isOnArea(std::uint32_t node) const { return m_carriers[m_nodes[node].piece] == Carrier::Area; }
    [[nodiscard]] std::span<const std::uint32_t> sameArea(std::uint32_t node) const;
    [[nodiscard]] const Piece& pieceOf(std::uint32_t node) const { return m_pieces.pieces[m_nodes[node].piece]; }

private:
    [[nodiscard]] Carrier carrierOf(std::size_t row) const;

    /// The middle of a pad or hole.
    [[nodiscard]] PointD centreOf(std::uint32_t row) const;
    std::uint32_t addNode(const NetNode& node);
    void link(std::uint32_t a, std::uint32_t b, double length, PathLeg::Kind kind);

    /// The node of a pad or hole on one layer.
    std::uint32_t hubOf(std::uint32_t row, LayerId layer);

    /// The node of a piece that is nearest to a location both it and another piece cover.
    std::uint32_t nodeNear(std::uint32_t row, LayerId layer, PointD location);
    std::uint32_t nodeOnTrack(std::uint32_t row, LayerId layer, PointD location);

    /// The location at which two pieces are joined: the centre of a pad if one is a pad, the end of a track that lies
    /// in an area, else where middle lines are nearest or copper meets.
    [[nodiscard]] PointD jointOf(std::uint32_t i, std::uint32_t j, PointD meeting) const;

    /// The end of a track that lies in an area.
    [[nodiscard]] std::optional<PointD> endInside(std::uint32_t track, std::uint32_t area) const;

    /// Where the middle lines of two tracks are nearest to each other.
    [[nodiscard]] PointD middlesMeet(std::uint32_t i, std::uint32_t j) const;
    void joinPieces(std::uint32_t i, std::uint32_t j, PointD meeting);
    std::vector<std::uint32_t> endsAtLocation(const Location& location);
    void addNodesOf(std::uint32_t row, std::vector<std::uint32_t>& nodes);
    void linkAlong(std::uint32_t row);
    void linkThrough(std::uint32_t row);

    /// Half way through the copper of a layer.
    [[nodiscard]] double middleOf(LayerId id) const;

    const BoardIndex& m_index;
    Pieces m_pieces;
    std::vector<Carrier> m_carriers;
    std::vector<BoxIndex> m_boxes;  ///< one
    std::vector<NetNode> m_nodes;
    std::vector<std::vector<NetLink>> m_links;
    std::vector<std::vector<std::uint32_t>> m_onPiece;
    std::vector<std::map<LayerId, std::uint32_t>> m_hubs;  ///< by piece: pads and holes
};

}  // namespace model
