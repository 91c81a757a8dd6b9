#include "model/export/solids/step_solid_text.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "model/geometry/vectors.h"

namespace model {

namespace {

/// More different directions than this are not remembered, so that memory stays small.
constexpr std::size_t kMostDirections = 200'000;

/// Polylines have at most so many chords: the time of readers grows faster than with their number.
constexpr std::uint32_t kMostChords = 100;
/// A loop has at least so many edges: readers tell which way it runs from few points of each.
constexpr std::uint32_t kFewestEdges = 3;
/// The longest chord of a polyline is at most so many times as long as the shortest: with 7 mm beside 1 um, readers
/// lost its wall by 63 um.
constexpr double kMostRatio = 100.0;
/// Chords of an arc turn less than this from one to the next; what turns more is a corner, and stays one.
constexpr double kCosineOfBend = 0.64;  // 50 degrees

bool isStraight(const EdgeLoops& outline, std::size_t row) {
    return !outline.edges[row].isArc() && curveAt(outline, row) == nullptr;
}

/// Chords of one bend.
class Bend {
public:
    explicit Bend(const Edge& first)
        : m_along(minus(first.b, first.a)), m_shortest(length(m_along)), m_longest(m_shortest) {}

    /// Does the next chord belong to it? If so, it is the last of it from now on.
    bool takes(const Edge& next) {
        const base::PointD along = minus(next.b, next.a);
        const double size = length(along);
        m_shortest = std::min(m_shortest, size);
        m_longest = std::max(m_longest, size);
        if (m_longest > kMostRatio * m_shortest || dot(m_along, along) < kCosineOfBend * length(m_along) * size) {
            return false;
        }
        m_along = along;
        return true;
    }

private:
    base::PointD m_along;
    double m_shortest;
    double m_longest;
};

/// Where the polyline that begins at `row` of a loop ends: the row after its last chord.
std::uint32_t endOfPolyline(const EdgeLoops& outline, std::uint32_t row, std::uint32_t end) {
    Bend bend(outline.edges[row]);
    std::uint32_t next = row + 1;
    while (next < end && isStraight(outline, next) && bend.takes(outline.edges[next])) {
        ++next;
    }
    return next;
}

std::uint64_t keyOf(double x, double y) {
    const auto part = [](double v) { return static_cast<std::uint64_t>(std::llround(v * 1e9) + 1'000'000'000); };
    return part(x) << 32U | part(y);
}

}  // namespace

StepSolidText::StepSolidText(StepText& text, StepEdges edges) : m_text(text), m_edges(edges) {
    m_up = m_text.direction(0, 0, 1);
    m_right = m_text.direction(1, 0, 0);
    m_upwards = m_text.add("VECTOR('',", m_up, ",1.)");
    m_origin = m_text.add("AXIS2_PLACEMENT_3D('',", m_text.point({}, 0), ",", m_up, ",", m_right, ")");
}

StepSolidText::Direction StepSolidText::directionOf(double x, double y) {
    if (m_directions.size() > kMostDirections) {
        m_directions.clear();
    }
    Direction& known = m_directions[keyOf(x, y)];
    if (known.direction == 0) {
        known.direction = m_text.direction(x, y, 0);
    }
    return known;
}

StepId StepSolidText::axisAt(StepId point) {
    return m_text.add("AXIS2_PLACEMENT_3D('',", point, ",", m_up, ",", m_right, ")");
}

StepId StepSolidText::placementOf(const Placement& placement) {
    if (isIdentity(placement)) {
        return m_origin;
    }
    const double angle = -placement.clockwiseDeg * std::numbers::pi / 180.0;
    const StepId right =
        placement.clockwiseDeg == 0.0 ? m_right : directionOf(std::cos(angle), std::sin(angle)).direction;
    return m_text.add("AXIS2_PLACEMENT_3D('',", m_text.point(toDouble(placement.origin), 0), ",", m_up, ",", right,
                      ")");
}

StepId StepSolidText::planeAt(Nm z) {
    StepId& plane = m_planes[z];
    if (plane == 0) {
        plane = m_text.add("PLANE('',", axisAt(m_text.point({}, z)), ")");
    }
    return plane;
}

StepId StepSolidText::oriented(StepId edge, bool isForward) {
    return m_text.add("ORIENTED_EDGE('',*,*,", edge, isForward ? ",.T.)" : ",.F.)");
}

void StepSolidText::addCorner(Rim& rim, base::PointD corner, const ZRange& z) {
    for (const Face face : {Bottom, Top}) {
        rim.point[face] = m_text.point(corner, face == Top ? z.top : z.bottom);
        rim.vertex[face] = m_text.add("VERTEX_POINT('',", rim.point[face], ")");
    }
    const StepId line = m_text.add("LINE('',", rim.point[Bottom], ",", m_upwards, ")");
    rim.upright = m_text.add("EDGE_CURVE('',", rim.vertex[Bottom], ",", rim.vertex[Top], ",", line, ",.T.)");
}

void StepSolidText::addLine(Rim& rim, const Rim& next, const Edge& line) {
    const double length = distance(line.a, line.b);
    const double x = (line.b.x - line.a.x) / length;
    const double y = (line.b.y - line.a.y) / length;
    const StepId along = directionOf(x, y).direction;
    StepId& vector = m_directions[keyOf(x, y)].vector;
    if (vector == 0) {
        vector = m_text.add("VECTOR('',", along, ",1.)");
    }
    for (const Face face : {Bottom, Top}) {
        const StepId curve = m_text.add("LINE('',", rim.point[face], ",", vector, ")");
        rim.edge[face] = m_text.add("EDGE_CURVE('',", rim.vertex[face], ",", next.vertex[face], ",", curve, ",.T.)");
    }
    const StepId outwards = directionOf(y, -x).direction;
    const StepId axis = m_text.add("AXIS2_PLACEMENT_3D('',", rim.point[Bottom], ",", outwards, ",", m_up, ")");
    rim.surface = m_text.add("PLANE('',", axis, ")");
}

void StepSolidText::addArc(Rim& rim, const Rim& next, const Edge& arc, const ZRange& z) {
    StepId axis[2];
    for (const Face face : {Bottom, Top}) {
        axis[face] = axisAt(m_text.point(arc.centre, face == Top ? z.top : z.bottom));
        const StepId curve = m_text.add("CIRCLE('',", axis[face], ",", StepText::Ratio{base::toMm(arc.radius)}, ")");
        rim.edge[face] = m_text.add("EDGE_CURVE('',", rim.vertex[face], ",", next.vertex[face], ",", curve,
                                    arc.isClockwise ? ",.F.)" : ",.T.)");
    }
    rim.isInward = arc.isClockwise;
    rim.surface =
        m_text.add("CYLINDRICAL_SURFACE('',", axis[Bottom], ",", StepText::Ratio{base::toMm(arc.radius)}, ")");
}

StepId StepSolidText::curveAt(const NurbsView& curve, Nm z) {
    m_loop.clear();
    bool isRational = false;
    for (const ControlPoint& control : curve.controls) {
        m_loop.push_back(m_text.point(control.at, z));
        isRational = isRational || control.weight != curve.controls.front().weight;
    }
    std::vector<StepText::Ratio> knots;
    std::vector<int> multiplicities;
    for (const double knot : curve.knots) {
        if (knots.empty() || knot != knots.back().value) {
            knots.push_back({knot});
            multiplicities.push_back(0);
        }
        ++multiplicities.back();
    }
    if (!isRational) {
        return m_text.add("B_SPLINE_CURVE_WITH_KNOTS('',", curve.degree, ",", m_loop, ",.UNSPECIFIED.,.F.,.F.,",
                          multiplicities, ",", knots, ",.UNSPECIFIED.)");
    }
    std::vector<StepText::Ratio> weights;
    for (const ControlPoint& control : curve.controls) {
        weights.push_back({control.weight});
    }
    return m_text.add("(BOUNDED_CURVE()B_SPLINE_CURVE(", curve.degree, ",", m_loop,
                      ",.UNSPECIFIED.,.F.,.F.)B_SPLINE_CURVE_WITH_KNOTS(", multiplicities, ",", knots,
                      ",.UNSPECIFIED.)CURVE()GEOMETRIC_REPRESENTATION_ITEM()RATIONAL_B_SPLINE_CURVE(", weights,
                      ")REPRESENTATION_ITEM(''))");
}

void StepSolidText::addCurve(Rim& rim, const Rim& next, const NurbsView& curve, const ZRange& z) {
    for (const Face face : {Bottom, Top}) {
        const StepId made = curveAt(curve, face == Top ? z.top : z.bottom);
        rim.edge[face] = m_text.add("EDGE_CURVE('',", rim.vertex[face], ",", next.vertex[face], ",", made, ",.T.)");
        rim.surface =
            face == Bottom ? m_text.add("SURFACE_OF_LINEAR_EXTRUSION('',", made, ",", m_upwards, ")") : rim.surface;
    }
}

void StepSolidText::addPolyline(Rim& rim, const Rim& next, std::span<const Edge> chords, const ZRange& z) {
    StepId curve[2];
    for (const Face face : {Bottom, Top}) {
        m_loop.assign(1, rim.point[face]);
        for (const Edge& chord : chords.subspan(1)) {
            m_loop.push_back(m_text.point(chord.a, face == Top ? z.top : z.bottom));
        }
        m_loop.push_back(next.point[face]);
        curve[face] = m_text.add("POLYLINE('',", m_loop, ")");
        rim.edge[face] =
            m_text.add("EDGE_CURVE('',", rim.vertex[face], ",", next.vertex[face], ",", curve[face], ",.T.)");
    }
    rim.surface = m_text.add("SURFACE_OF_LINEAR_EXTRUSION('',", curve[Bottom], ",", m_upwards, ")");
}

StepId StepSolidText::addWall(Rim& rim, const Rim& next) {
    rim.used[Bottom] = oriented(rim.edge[Bottom], false);
    rim.used[Top] = oriented(rim.edge[Top], true);
    m_loop = {oriented(rim.upright, true), rim.used[Top], oriented(next.upright, false), rim.used[Bottom]};
    const StepId loop = m_text.add("EDGE_LOOP('',", m_loop, ")");
    const StepId bound = m_text.add("FACE_OUTER_BOUND('',", loop, ",.F.)");
    return m_text.add("ADVANCED_FACE('',(", bound, "),", rim.surface, rim.isInward ? ",.F.)" : ",.T.)");
}

StepId StepSolidText::addLid(const Shell& shell, Face face) {
    m_bounds.clear();
    for (std::size_t i = 0; i + 1 < m_loopStart.size(); ++i) {
        const std::uint32_t first = m_loopStart[i];
        const std::uint32_t end = m_loopStart[i + 1];
        m_loop.clear();
        for (std::uint32_t k = first; k < end; ++k) {
            m_loop.push_back(m_rims[face == Top ? k : end - 1 - (k - first)].used[face]);
        }
        const StepId loop = m_text.add("EDGE_LOOP('',", m_loop, ")");
        m_bounds.push_back(m_text.add(i == 0 ? "FACE_OUTER_BOUND(''," : "FACE_BOUND('',", loop, ",.T.)"));
    }
    const StepId plane = planeAt(face == Top ? shell.z.top : shell.z.bottom);
    return m_text.add("ADVANCED_FACE('',", m_bounds, ",", plane, face == Top ? ",.T.)" : ",.F.)");
}

void StepSolidText::addEdge(const EdgeLoops& outline, const Run& run, Rim& rim, const Rim& next, const ZRange& z) {
    const Edge& edge = outline.edges[run.first];
    if (const EdgeLoops::CurveRun* curve = model::curveAt(outline, run.first)) {
        addCurve(rim, next, curve->curve.view(), z);
    } else if (edge.isArc()) {
        addArc(rim, next, edge, z);
    } else if (run.end - run.first == 1) {
        addLine(rim, next, edge);
    } else {
        addPolyline(rim, next, std::span(outline.edges).subspan(run.first, run.end - run.first), z);
    }
}

/// Takes the edges of a loop as rims: one for each, but one for all edges of a curve or a polyline.
void StepSolidText::addRims(const EdgeLoops& outline, std::size_t loop) {
    const std::uint32_t first = outline.loopStart[loop];
    const std::uint32_t end = outline.loopStart[loop + 1];
    const std::uint32_t most = std::clamp((end - first) / kFewestEdges, 1U, kMostChords);
    for (std::uint32_t row = first; row < end;) {
        std::uint32_t next = row + 1;
        if (const EdgeLoops::CurveRun* curve = model::curveAt(outline, row)) {
            next = row + curve->edgeCount;
        } else if (m_edges == StepEdges::Polylines && isStraight(outline, row)) {
            next = endOfPolyline(outline, row, std::min(end, row + most));
        }
        m_runs.push_back({row, next});
        row = next;
    }
    m_loopStart.push_back(static_cast<std::uint32_t>(m_runs.size()));
}

StepId StepSolidText::add(const Shell& shell) {
    const EdgeLoops& outline = shell.outline;
    m_runs.clear();
    m_loopStart.assign(1, 0);
    m_faces.clear();
    for (std::size_t i = 0; i < outline.loopCount(); ++i) {
        addRims(outline, i);
    }
    m_rims.assign(m_runs.size(), {});
    for (std::size_t i = 0; i + 1 < m_loopStart.size(); ++i) {
        const std::uint32_t first = m_loopStart[i];
        const std::uint32_t end = m_loopStart[i + 1];
        for (std::uint32_t k = first; k < end; ++k) {
            addCorner(m_rims[k], outline.edges[m_runs[k].first].a, shell.z);
        }
        for (std::uint32_t k = first; k < end; ++k) {
            const Rim& next = m_rims[k + 1 < end ? k + 1 : first];
            addEdge(outline, m_runs[k], m_rims[k], next, shell.z);
            m_faces.push_back(addWall(m_rims[k], next));
        }
    }
    m_faces.push_back(addLid(shell, Top));
    m_faces.push_back(addLid(shell, Bottom));
    const StepId closed = m_text.add("CLOSED_SHELL('',", m_faces, ")");
    return m_text.add("MANIFOLD_SOLID_BREP('',", closed, ")");
}

}  // namespace model
