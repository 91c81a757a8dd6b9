#include "model/geometry/shapes.h"

#include <cmath>
#include <numbers>

#include "model/base/assert.h"
#include "model/geometry/curve_queries.h"
#include "model/geometry/vectors.h"

namespace model {

void ShapeSketch::beginContour(bool isHole) {
    m_starts.push_back(static_cast<std::uint32_t>(m_nodes.size()));
    m_holes.push_back(isHole ? 1 : 0);
}

void ShapeSketch::addNode(const PathNode& node) {
    ASSERT(node.edge != EdgeKind::Curve);
    m_nodes.push_back(node);
}

void ShapeSketch::addCurve(Point point, const NurbsView& curve, Point end) {
    Nurbs own{curve.degree, {curve.knots.begin(), curve.knots.end()}, {curve.controls.begin(), curve.controls.end()}};
    own.controls.front().at = toDouble(point);
    own.controls.back().at = toDouble(end);
    m_nodes.push_back(PathNode::along(point, m_curves.add(own.view())));
}

void ShapeSketch::addNode(const PathNodes& path, std::size_t node) {
    if (path[node].edge == EdgeKind::Curve) {
        addCurve(path[node].point, path.curveAt(node), path.endOf(node));
    } else {
        m_nodes.push_back(path[node]);
    }
}

void ShapeSketch::addNodes(const PathNodes& path) {
    for (std::size_t i = 0; i < path.size(); ++i) {
        addNode(path, i);
    }
}

void ShapeSketch::addCircle(Point centre, Nm radius, bool isHole) {
    beginContour(isHole);
    addNode({{centre.x + radius, centre.y}, centre, EdgeKind::ArcCounterClockwise});
}

void ShapeSketch::addPolygon(std::span<const Point> points, bool isHole) {
    beginContour(isHole);
    for (const Point& point : points) {
        addNode(point);
    }
}

void ShapeSketch::append(const ShapeSketch& other, const Placement& placement) {
    for (std::size_t i = 0; i < other.contourCount(); ++i) {
        beginContour(other.isHole(i));
        append(other.contour(i), placement);
    }
}

void ShapeSketch::append(const ShapeTable& table, ShapeId shape, const Placement& placement) {
    for (const Contour& contour : table.contoursOf(shape)) {
        beginContour(contour.isHole);
        append(table.nodesOf(contour), placement);
    }
}

void ShapeSketch::append(const PathNodes& path, const Placement& placement) {
    if (isIdentity(placement)) {
        return addNodes(path);
    }
    for (std::size_t i = 0; i < path.size(); ++i) {
        if (path[i].edge != EdgeKind::Curve) {
            m_nodes.push_back(placed(path[i], placement));
            continue;
        }
        // Weights and knots stay as they are where control points are placed.
        std::vector<ControlPoint> controls(path.curveAt(i).controls.begin(), path.curveAt(i).controls.end());
        for (ControlPoint& control : controls) {
            control.at = placement.apply(control.at);
        }
        addCurve(placement.apply(path[i].point), {path.curveAt(i).degree, path.curveAt(i).knots, controls},
                 placement.apply(path.endOf(i)));
    }
}

PathNodes ShapeSketch::contour(std::size_t index) const {
    ASSERT(index < m_starts.size());
    const std::size_t end = index + 1 < m_starts.size() ? m_starts[index + 1] : m_nodes.size();
    return {std::span(m_nodes).subspan(m_starts[index], end - m_starts[index]), &m_curves};
}

ShapeId ShapeTable::add(const ShapeSketch& sketch) {
    Shape shape{static_cast<std::uint32_t>(contours.size()), static_cast<std::uint32_t>(sketch.contourCount()), {}};
    for (std::size_t i = 0; i < sketch.contourCount(); ++i) {
        const PathNodes added = sketch.contour(i);
        contours.push_back(
            {static_cast<std::uint32_t>(nodes.size()), static_cast<std::uint32_t>(added.size()), sketch.isHole(i)});
        std::vector<PathNode>& all = nodes.edit();
        for (std::size_t node = 0; node < added.size(); ++node) {
            all.push_back(added[node].edge == EdgeKind::Curve
                              ? PathNode::along(added[node].point, curves.add(added.curveAt(node)))
                              : added[node]);
        }
        shape.box.include(boxOfPath(added, true));
    }
    shapes.push_back(shape);
    return ShapeId{shapes.size() - 1};
}

namespace {

struct Rotation {
    double cosine;
    double sine;
};

/// Cosine and sine of a clockwise angle; quarter turns are exact, so that pads at 90° stay on the grid.
Rotation rotationOf(double clockwiseDeg) {
    const double quarters = std::fmod(clockwiseDeg / 90.0, 4.0);  // files may say any number
    if (quarters == std::floor(quarters)) {
        constexpr Rotation kExact[4] = {{1, 0}, {0, 1}, {-1, 0}, {0, -1}};
        return kExact[(static_cast<int>(quarters) + 4) % 4];
    }
    const double radians = clockwiseDeg * std::numbers::pi / 180.0;
    return {std::cos(radians), std::sin(radians)};
}

}  // namespace

PointD Placement::apply(PointD p) const {
    const Rotation rotation = rotationOf(clockwiseDeg);
    const double x = rotation.cosine * p.x + rotation.sine * p.y;
    const double y = -rotation.sine * p.x + rotation.cosine * p.y;
    return {origin.x + (isMirrored ? -x : x), origin.y + y};
}

Point Placement::apply(Point p) const {
    const PointD moved = apply(toDouble(p));
    return {toNm(moved.x), toNm(moved.y)};
}

Box Placement::boxOf(const Box& box) const {
    Box placed;
    for (const Point corner : {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}) {
        if (!box.isEmpty()) {
            placed.include(apply(corner));
        }
    }
    return placed;
}

Placement Placement::after(const Placement& inner) const {
    // M R(a) M' R(b): a mirror inside reverses the sense of the outer rotation, R(a) M = M R(-a).
    Placement both;
    both.origin = apply(inner.origin);
    both.isMirrored = isMirrored != inner.isMirrored;
    both.clockwiseDeg = inner.clockwiseDeg + (inner.isMirrored ? -clockwiseDeg : clockwiseDeg);
    return both;
}

namespace {

/// Is the direction `angle` (rad) passed on the line from `start` over `sweep`?
bool isWithinSweep(double angle, double start, double sweep) {
    constexpr double kFullCircle = 2.0 * std::numbers::pi;
    double ahead = sweep >= 0 ? angle - start : start - angle;
    ahead -= kFullCircle * std::floor(ahead / kFullCircle);
    return ahead <= std::abs(sweep);
}

}  // namespace

bool isIdentity(const Placement& placement) {
    return placement.origin == Point{} && placement.clockwiseDeg == 0.0 && !placement.isMirrored;
}

PathNode placed(const PathNode& node, const Placement& placement) {
    ASSERT(node.edge != EdgeKind::Curve);
    PathNode moved = node;
    moved.point = placement.apply(node.point);
    if (node.edge != EdgeKind::Line) {
        moved.centre = placement.apply(node.centre);
        const bool isClockwise = (node.edge == EdgeKind::ArcClockwise) != placement.isMirrored;
        moved.edge = isClockwise ? EdgeKind::ArcClockwise : EdgeKind::ArcCounterClockwise;
    }
    return moved;
}

Box boxOfEdge(const PathNode& from, Point to) {
    ASSERT(from.edge != EdgeKind::Curve);
    Box box;
    box.include(from.point);
    box.include(to);
    if (from.edge == EdgeKind::Line) {
        return box;
    }
    const PointD c = toDouble(from.centre);
    const double start = std::atan2(from.point.y - c.y, from.point.x - c.x);
    const double end = std::atan2(to.y - c.y, to.x - c.x);
    constexpr double kFullCircle = 2.0 * std::numbers::pi;
    double sweep = from.edge == EdgeKind::ArcCounterClockwise ? end - start : start - end;
    sweep -= kFullCircle * std::floor(sweep / kFullCircle);
    if (from.point == to) {
        sweep = kFullCircle;
    }
    if (from.edge == EdgeKind::ArcClockwise) {
        sweep = -sweep;
    }
    const double radius =
        std::max(std::hypot(from.point.x - c.x, from.point.y - c.y), std::hypot(to.x - c.x, to.y - c.y));
    for (int quarter = 0; quarter < 4; ++quarter) {
        constexpr int kDx[4] = {1, 0, -1, 0};
        constexpr int kDy[4] = {0, 1, 0, -1};
        if (isWithinSweep(quarter * std::numbers::pi / 2.0, start, sweep)) {
            box.include(Point{toNm(c.x + kDx[quarter] * radius), toNm(c.y + kDy[quarter] * radius)});
        }
    }
    return box;
}

Box boxOfPath(const PathNodes& nodes, bool isClosed) {
    Box box;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        const bool isLast = i + 1 == nodes.size();
        if (isLast && !isClosed) {
            box.include(nodes[i].point);
        } else if (nodes[i].edge == EdgeKind::Curve) {
            box.include(boxOf(bezierPieces(nodes.curveAt(i))));
        } else {
            box.include(boxOfEdge(nodes[i], nodes.endOf(i)));
        }
    }
    return box;
}

}  // namespace model
