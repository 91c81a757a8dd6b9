#pragma once

#include <map>
#include <span>
#include <unordered_map>
#include <vector>

#include "model/export/solids/step_text.h"
#include "model/solids/shells/shell.h"

namespace model {

/// How the straight edges of a region become edges of a solid.
enum class StepEdges : std::uint8_t {
    Single,     ///< each an edge, with a wall that is a plane
    Polylines,  ///< chords that follow each other around a bend are one edge, a polyline, with one wall that has its
                ///< bends
};

/// Writes shells as MANIFOLD_SOLID_BREP entities: planes, cylinders, extruded B-splines, lines and circles, no curves
/// in the parameters of surfaces (a reader makes those), a circle as one edge with a seam. A prism of n edges in k
/// loops takes at most 24 n + 14 + 4 (k - 1) entities; the planes of faces, directions and vectors are shared by all
/// solids.
class StepSolidText {
public:
    StepSolidText(StepText& text, StepEdges edges);

    /// The number of the solid.
    StepId add(const Shell& shell);
    /// The placement at the origin, in the usual directions.
    [[nodiscard]] StepId origin() const { return m_origin; }
    /// The same moved and turned about the vertical; `placement` is not mirrored.
    StepId placementOf(const Placement& placement);

private:
    enum Face : std::uint8_t { Bottom, Top };

    /// An edge of the region as the solid has it: twice, with the upright edge at its start.
    struct Rim {
        StepId point[2];
        StepId vertex[2];
        StepId edge[2];
        StepId used[2];  ///< the edge as both its wall and its lid run along it
        StepId upright;
        StepId surface;  ///< of its wall
        bool isInward;   ///< the surface's own normal points into the solid
    };
    /// Edges of the region, one after the other, that are one edge of the solid.
    struct Run {
        std::uint32_t first;
        std::uint32_t end;
    };
    struct Direction {
        StepId direction;
        StepId vector;
    };

    Direction directionOf(double x, double y);
    StepId planeAt(Nm z);
    StepId axisAt(StepId point);
    void addCorner(Rim& rim, base::PointD corner, const ZRange& z);
    void addLine(Rim& rim, const Rim& next, const Edge& line);
    void addCurve(Rim& rim, const Rim& next, const NurbsView& curve, const ZRange& z);
    StepId curveAt(const NurbsView& curve, Nm z);
    void addPolyline(Rim& rim, const Rim& next, std::span<const Edge> chords, const ZRange& z);
    void addEdge(const EdgeLoops& outline, const Run& run, Rim& rim, const Rim& next, const ZRange& z);
    void addArc(Rim& rim, const Rim& next, const Edge& arc, const ZRange& z);
    StepId addWall(Rim& rim, const Rim& next);
    void addRims(const EdgeLoops& outline, std::size_t loop);
    StepId addLid(const Shell& shell, Face face);
    StepId oriented(StepId edge, bool isForward);

    StepText& m_text;
    StepEdges m_edges;
    StepId m_up = 0;
    StepId m_right = 0;
    StepId m_upwards = 0;
    StepId m_origin = 0;
    std::map<Nm, StepId> m_planes;
    std::unordered_map<std::uint64_t, Direction> m_directions;
    // Of the shell that is being written.
    std::vector<Rim> m_rims;
    std::vector<Run> m_runs;                 ///< the edges of each rim
    std::vector<std::uint32_t> m_loopStart;  ///< as EdgeLoops::loopStart, of m_rims
    std::vector<StepId> m_faces;
    std::vector<StepId> m_bounds;
    std::vector<StepId> m_loop;
};

}  // namespace model
