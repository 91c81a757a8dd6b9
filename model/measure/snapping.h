#pragma once

#include <span>

#include "model/index/picking.h"
#include "model/measure/items.h"

namespace model {

/// What a pointer can snap to, the most wanted first.
enum class SnapKind : std::uint8_t {
    Centre,     ///< of a pad, a disc or a hole
    End,        ///< of a track, a corner of an outline
    ArcCentre,  ///< of an arc, track or outline
    Middle,     ///< of a track or a side
    Crossing,   ///< where middle lines of tracks or sides of outlines of one layer cross
    Edge,       ///< the nearest point on an edge of what is drawn
    Free        ///< nothing near
};
[[nodiscard]] const char* toString(SnapKind kind);  ///< "centre", "end", "arc centre", …

struct SnapPoint {
    SnapKind kind = SnapKind::Free;
    PointD at;              ///< nm of the board
    BoardElement element;   ///< whose point it is; none: of the board's edge, or of nothing
    LayerId layer;          ///< of the board; of a hole: its drill layer; none: of the board's edge
    double missedBy = 0.0;  ///< nm from the location requested
};

/// A location moved onto the nearest line through `from` whose direction is a multiple of `stepDeg`.
[[nodiscard]] PointD straightened(PointD from, PointD location, double stepDeg);

/// Finds what is near a pointer.
class Snapper {
public:
    explicit Snapper(std::shared_ptr<const BoardIndex> index)
        : m_index(std::move(index)), m_outline(boardEdgeOf(*m_index->board)) {}

    /// The best point within `reach` nm that is seen: the kind decides, then how near it is; of points as near that of
    /// a net, then that of the layer nearer to the viewer, then the lower element. Only visible layers count (`layers`
    /// has one entry per layer of the board); what copper nearer to the viewer covers is not seen. Edges are those of
    /// all copper of a layer together: the edge of a track within a pad is none. The board's edge counts with its
    /// cut-outs, whether or not a layer draws it; where one does, the sides of its pen are none.
    ///
    /// `skip`: that many points are passed over, those that are covered coming after all that are seen, and then the
    /// first again. A Free point where nothing is near, or nothing that is seen with `skip` 0: the location itself.
    [[nodiscard]] SnapPoint at(PointD location, double reach, std::span<const PickLayer> layers,
                               bool isFromBelow = false, std::size_t skip = 0) const;
    /// The lowest element of visible layers within `reach` nm that covers nothing, so that nothing else finds it.
    [[nodiscard]] std::optional<BoardElement> emptyAt(PointD location, double reach,
                                                      std::span<const PickLayer> layers) const;

private:
    std::shared_ptr<const BoardIndex> m_index;
    FigureTable m_outline;  ///< the board's edge
};

}  // namespace model
