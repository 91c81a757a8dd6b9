#pragma once

#include <limits>
#include <optional>
#include <vector>

#include "model/board/document.h"
#include "model/clearance/layer_geometry.h"
#include "model/geometry/box_index.h"
#include "model/geometry/discretise.h"

namespace model {

/// The shortest ways along a face of a board: around what is not there, the outside of its outline, its cut-outs and
/// NPTHs. Curves of openings are chords of at most 2 µm height, so that a way is too short by less than that, never too
/// long. A way bends only at corners of openings, so it is a shortest path in the graph of corners that see each other.
class SurfacePaths {
public:
    /// Openings narrower than `leastOpening` nm are no obstacles. Slots that are open to the outside always are.
    SurfacePaths(const Document& document, Nm leastOpening);

    /// Between two figures of one layer; nothing if it is `limit` nm or longer. Copper that reaches out of the board
    /// counts as if nothing lay between. `from` and `to` are the ends of the way, `distance` its length.
    [[nodiscard]] std::optional<Spacing> between(const FigureTable& figures, std::uint32_t a, std::uint32_t b,
                                                 double limit) const;
    /// Is nothing missing along a straight line?
    [[nodiscard]] bool isClear(PointD from, PointD to) const;

private:
    struct Opening {
        std::uint32_t first = 0;  ///< corner
        std::uint32_t count = 0;
        bool isOutline = false;  ///< what lies outside is missing, else what lies inside
        Box box;
    };
    struct Corner {
        PointD at;
        double fromA = std::numeric_limits<double>::infinity();  ///< shortest way so far
        PointD start{};                                          ///< on the first figure
        double toB = std::numeric_limits<double>::infinity();    ///< straight, if nothing lies between
        PointD end{};                                            ///< on the second figure
        bool isDone = false;
    };

    void add(const PolygonSet& polygons, Nm leastOpening);
    void addLoop(std::span<const Point> loop, bool isOutline);
    /// Not on an edge.
    [[nodiscard]] bool isMissing(PointD p) const;
    [[nodiscard]] bool isOnEdge(PointD p) const;
    [[nodiscard]] bool isInside(const Opening& opening, PointD p) const;
    /// The shortest clear line from a corner to a figure.
    [[nodiscard]] std::optional<Spacing> straight(const FigureTable& figures, std::uint32_t row, PointD p,
                                                  double limit) const;
    /// The shortest clear line between two figures.
    [[nodiscard]] std::optional<Spacing> straight(const FigureTable& figures, std::uint32_t a, std::uint32_t b,
                                                  double limit) const;
    [[nodiscard]] std::vector<Corner> cornersBetween(const FigureTable& figures, std::uint32_t a, std::uint32_t b,
                                                     double limit) const;
    [[nodiscard]] std::optional<Spacing> shortest(std::vector<Corner>& corners, double limit) const;

    std::vector<PointD> m_corners;
    std::vector<std::uint32_t> m_next;  ///< by corner: the end of its edge
    std::vector<Opening> m_openings;
    std::optional<BoxIndex> m_edges;   ///< by corner, the edge that it begins
    std::optional<BoxIndex> m_points;  ///< by corner
};

}  // namespace model
