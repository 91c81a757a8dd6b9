#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/geometry/edges.h"
#include "model/geometry/nurbs.h"

namespace model {

/// A connected region of the plane: closed loops of edges, the outline first, counter-clockwise, then its holes,
/// clockwise. Unlike PathNodes the corners need not lie on the grid of 1 nm, so that the side of a slanted track is
/// where it is. The end of each edge is the start of the next one of its loop, bit for bit; a circle is a loop of one
/// edge. Arcs are true circles: both ends lie `radius` from `centre`, but for the rounding of doubles.
///
/// A NURBS curve is there twice: as the arcs that it is measured by (curve_edges.h), a run of edges like any other,
/// and, for those who can write one, as itself (`curves`). What cuts or unites regions works on the arcs and drops
/// `curves`.
struct EdgeLoops {
    /// A run of edges of one loop that is one curve.
    struct CurveRun {
        std::uint32_t firstEdge = 0;
        std::uint32_t edgeCount = 0;
        Nurbs curve;  ///< from the start of the first edge to the end of the last
    };

    std::vector<Edge> edges;
    std::vector<std::uint32_t> loopStart{0};  ///< loop i: edges[loopStart[i] .. loopStart[i + 1])

    std::vector<CurveRun> curves;  ///< by edge, rising

    [[nodiscard]] std::size_t loopCount() const { return loopStart.size() - 1; }
    [[nodiscard]] std::span<const Edge> loop(std::size_t index) const {
        return std::span(edges).subspan(loopStart[index], loopStart[index + 1] - loopStart[index]);
    }
    void clear();
    /// Adds an edge to the loop that is being built. Edges without length are left out.
    void addLine(PointD a, PointD b);
    /// The centre moves onto the perpendicular bisector of the ends, about as far as the two radii of the job differ. A
    /// nearly full circle, where that would be far, ends by a short radial line instead. Not for full circles.
    void addArc(PointD a, PointD b, PointD centre, bool isClockwise);
    void addCurve(const NurbsView& curve);
    /// Ends the loop: turns it round where it does not wind as its place demands (the first one counter-clockwise, all
    /// others clockwise). A loop without area is left out: false.
    bool endLoop();
    /// A whole loop that is a circle.
    void addCircle(PointD centre, double radius);
    /// A whole loop that is the outline of a round pen along a straight track; a circle where the track has no length.
    void addCapsule(PointD a, PointD b, double radius);
};

/// In nm², exact but for the rounding of doubles.
[[nodiscard]] double areaOf(const EdgeLoops& loops);
/// Laid elsewhere; mirrored loops are turned round, so that they wind as they must.
[[nodiscard]] EdgeLoops placed(const EdgeLoops& loops, const Placement& placement);
[[nodiscard]] Box boxOf(const EdgeLoops& loops);
/// The curve that the edge `row` begins; nullptr if it begins none.
[[nodiscard]] const EdgeLoops::CurveRun* curveAt(const EdgeLoops& loops, std::size_t row);
/// The same edge from its end to its start.
[[nodiscard]] Edge reversed(const Edge& edge);

}  // namespace model
