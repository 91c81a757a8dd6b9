#include "model/export/solids/step_solid_text.h"

#include <cmath>
#include <numbers>

#include "model/geometry/vectors.h"

namespace model {

namespace {

/// More different directions than this are not remembered, so that memory stays small.
constexpr std::size_t kMostDirections = 200'000;

std::uint64_t keyOf(double x, double y) {
    const auto part = [](double v) { return static_cast<std::uint64_t>(std::llround(v * 1e9) + 1'000'000'000); };
    return part(x) << 32U | part(y);
}

}  // namespace

StepSolidText::StepSolidText(StepText& text) : m_text(text) {
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

void StepSolidText::addEdge(const EdgeLoops& outline, std::size_t row, Rim& rim, const Rim& next, const ZRange& z) {
    if (const EdgeLoops::CurveRun* run = model::curveAt(outline, row)) {
        addCurve(rim, next, run->curve.view(), z);
    } else if (outline.edges[row].isArc()) {
        addArc(rim, next, outline.edges[row], z);
    } else {
        addLine(rim, next, outline.edges[row]);
    }
}

/// Takes the edges of a loop as rims: one for each, but one for all edges of a curve.
void StepSolidText::addRims(const EdgeLoops& outline, std::size_t loop) {
    for (std::uint32_t row = outline.loopStart[loop]; row < outline.loopStart[loop + 1];) {
        m_rows.push_back(row);
        const EdgeLoops::CurveRun* run = model::curveAt(outline, row);
        row += run != nullptr ? run->edgeCount : 1;
    }
    m_loopStart.push_back(static_cast<std::uint32_t>(m_rows.size()));
}

StepId StepSolidText::add(const Shell& shell) {
    const EdgeLoops& outline = shell.outline;
    m_rows.clear();
    m_loopStart.assign(1, 0);
    m_faces.clear();
    for (std::size_t i = 0; i < outline.loopCount(); ++i) {
        addRims(outline, i);
    }
    m_rims.assign(m_rows.size(), {});
    for (std::size_t i = 0; i + 1 < m_loopStart.size(); ++i) {
        const std::uint32_t first = m_loopStart[i];
        const std::uint32_t end = m_loopStart[i + 1];
        for (std::uint32_t k = first; k < end; ++k) {
            addCorner(m_rims[k], outline.edges[m_rows[k]].a, shell.z);
        }
        for (std::uint32_t k = first; k < end; ++k) {
            const Rim& next = m_rims[k + 1 < end ? k + 1 : first];
            addEdge(outline, m_rows[k], m_rims[k], next, shell.z);
            m_faces.push_back(addWall(m_rims[k], next));
        }
    }
    m_faces.push_back(addLid(shell, Top));
    m_faces.push_back(addLid(shell, Bottom));
    const StepId closed = m_text.add("CLOSED_SHELL('',", m_faces, ")");
    return m_text.add("MANIFOLD_SOLID_BREP('',", closed, ")");
}

}  // namespace model
