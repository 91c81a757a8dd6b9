#include "model/formats/ipc2581/canvas.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/geometry/outlines.h"

namespace model::ipc2581 {

namespace {

using formats::DrawnFeature;
using formats::DrawnKind;
using formats::PadShape;

constexpr Nm kHairline = 10'000;
constexpr double kWidestPen = base::kMaxCoordinate / 2.0;

std::string millimetres(Nm nm) {
    std::string text = std::to_string(nm / 1'000'000) + '.' + std::to_string(1'000'000 + nm % 1'000'000).substr(1);
    text.erase(text.find_last_not_of('0') + 1);
    text.erase(text.find_last_not_of('.') + 1);
    return text;
}

}  // namespace

DrawnFeature& Canvas::add(DrawnKind kind) {
    m_features->push_back(m_ink);
    m_features->back().kind = kind;
    return m_features->back();
}

void Canvas::addPad(std::int32_t symbol, const Turn& turn) {
    DrawnFeature& feature = add(DrawnKind::Pad);
    feature.symbol = symbol;
    feature.a = m_reading.rounded(turn.origin, m_ink.line);
    feature.clockwiseDeg = normalDegrees(-turn.ccwDeg);
    feature.isMirrored = turn.isMirrored;
}

Nm Canvas::penWidth(double width) {
    const Nm pen = static_cast<Nm>(std::llround(std::min(width, kWidestPen)));
    if (pen > 0) {
        return pen;
    }
    m_reading.report(Severity::Info, m_ink.line,
                     m_hasHairlines ? "lines without width are drawn 10 µm wide" : "lines without width draw nothing");
    return m_hasHairlines ? kHairline : 0;
}

void Canvas::stroke(const Path& path, const Turn& turn, const LineStyle& pen) {
    if (pen.property == LineProperty::Erasing) {
        return clear([&] { strokeEdges(path, turn, pen); });
    }
    if (pen.property == LineProperty::Broken) {
        m_reading.report(Severity::Info, m_ink.line, "dashed and dotted lines are drawn as solid ones");
    }
    strokeEdges(path, turn, pen);
}

void Canvas::strokeEdges(const Path& path, const Turn& turn, const LineStyle& pen) {
    const Nm width = penWidth(pen.width * turn.scale);
    for (std::size_t i = 1; i < path.size() && width > 0; ++i) {
        strokeEdge(laidEdge(path, i, turn), {static_cast<double>(width), pen.end});
        const bool isJoint = pen.end != LineEnd::Round && i + 1 < path.size();
        if (isJoint) {
            addPad(roundSymbol(width), {turn.apply(path[i].point), 0.0, false, 1.0});
        }
    }
}

void Canvas::strokeEdge(const LaidEdge& edge, const LineStyle& pen) {
    const Nm width = static_cast<Nm>(pen.width);
    const bool isAxial = edge.a.x == edge.b.x || edge.a.y == edge.b.y;
    if (pen.end == LineEnd::Round || edge.edge != EdgeKind::Line) {
        if (pen.end != LineEnd::Round) {
            m_reading.report(Severity::Info, m_ink.line, "the ends of an arc without round ends are drawn round");
        }
        return addLine(edge, roundSymbol(width));
    }
    if (pen.end == LineEnd::Square && isAxial) {
        return addLine(edge, squareSymbol(width));
    }
    addBar(edge, pen.width, pen.end == LineEnd::Square ? pen.width / 2 : 0.0);
}

void Canvas::addLine(const LaidEdge& edge, std::int32_t symbol) {
    const Point a = m_reading.rounded(edge.a, m_ink.line);
    const Point b = m_reading.rounded(edge.b, m_ink.line);
    const bool isDot = isArc(edge.edge) && a == b && !edge.isFullCircle;  // too short for the grid
    DrawnFeature& feature = add(isArc(edge.edge) && !isDot ? DrawnKind::Arc : DrawnKind::Line);
    feature.symbol = symbol;
    feature.a = a;
    feature.b = b;
    if (feature.kind == DrawnKind::Arc) {
        feature.centre = m_reading.rounded(edge.centre, m_ink.line);
        feature.isClockwise = edge.edge == EdgeKind::ArcClockwise;
    }
}

/// A straight line with flat ends, `beyond` its end points.
void Canvas::addBar(const LaidEdge& edge, double width, double beyond) {
    const double length = std::hypot(edge.b.x - edge.a.x, edge.b.y - edge.a.y);
    if (length == 0.0) {
        return;
    }
    const PointD along = {(edge.b.x - edge.a.x) / length, (edge.b.y - edge.a.y) / length};
    const PointD aside = {-along.y * width / 2, along.x * width / 2};
    const PointD a = {edge.a.x - along.x * beyond, edge.a.y - along.y * beyond};
    const PointD b = {edge.b.x + along.x * beyond, edge.b.y + along.y * beyond};
    const std::array<PointD, 4> corners = {{{a.x - aside.x, a.y - aside.y},
                                            {b.x - aside.x, b.y - aside.y},
                                            {b.x + aside.x, b.y + aside.y},
                                            {a.x + aside.x, a.y + aside.y}}};
    std::array<Point, 4> whole;
    std::ranges::transform(corners, whole.begin(), [&](PointD p) { return m_reading.rounded(p, m_ink.line); });
    ShapeSketch sketch;
    sketch.addPolygon(whole, false);
    addRegion(std::move(sketch));
}

void Canvas::strokeSymbol(std::int32_t symbol, const Turn& turn, const LineStyle& pen) {
    const Turn unscaled{turn.origin, turn.ccwDeg, turn.isMirrored, 1.0};  // symbols have their scale in their sizes
    const ShapeSketch outline = formats::outlineOf(this->symbol(symbol));
    for (std::size_t i = 0; i < outline.contourCount(); ++i) {
        const PathNodes nodes = outline.contour(i);
        Path path;
        for (std::size_t n = 0; n <= nodes.size(); ++n) {
            const PathNode& node = nodes[n % nodes.size()];
            const PathNode& before = nodes[(n + nodes.size() - 1) % nodes.size()];
            path.push_back(
                {base::toDouble(node.point), base::toDouble(before.centre), n == 0 ? EdgeKind::Line : before.edge});
        }
        stroke(path, unscaled, pen);
    }
}

/// False if the path has no area.
bool Canvas::addContour(ShapeSketch& sketch, const Path& path, const Turn& turn, bool isHole) {
    m_nodes.clear();
    bool isCurved = false;
    for (std::size_t i = 1; i < path.size(); ++i) {
        const LaidEdge edge = laidEdge(path, i, turn);
        const Point a = m_reading.rounded(edge.a, m_ink.line);
        const Point b = m_reading.rounded(edge.b, m_ink.line);
        const bool isArcHere = isArc(edge.edge) && (a != b || edge.isFullCircle);
        if (a != b || isArcHere) {
            m_nodes.push_back({a, isArcHere ? m_reading.rounded(edge.centre, m_ink.line) : Point{},
                               isArcHere ? edge.edge : EdgeKind::Line});
            isCurved = isCurved || isArcHere;
        }
        if (i + 1 == path.size() && !m_nodes.empty() && b != m_nodes.front().point) {
            m_nodes.push_back({b, {}, EdgeKind::Line});  // an open polygon: its last edge is added
        }
    }
    if (m_nodes.size() < 3 && !isCurved) {
        return false;
    }
    sketch.beginContour(isHole);
    for (const PathNode& node : m_nodes) {
        sketch.addNode(node);
    }
    return true;
}

ShapeSketch Canvas::sketchOf(const Region& region, const Turn& turn) {
    ShapeSketch sketch;
    if (!addContour(sketch, region.outline, turn, false)) {
        m_reading.report(Severity::Info, m_ink.line, "polygons without area draw nothing");
        return sketch;
    }
    for (const Path& cutout : region.cutouts) {
        if (!addContour(sketch, cutout, turn, true)) {
            m_reading.report(Severity::Info, m_ink.line, "cutouts without area cut nothing out");
        }
    }
    return sketch;
}

void Canvas::fill(const Region& region, const Turn& turn) {
    ShapeSketch sketch = sketchOf(region, turn);
    if (!sketch.isEmpty()) {
        addRegion(std::move(sketch));
    }
}

void Canvas::addRegion(ShapeSketch sketch) {
    add(DrawnKind::Region).region = static_cast<std::int32_t>(m_step.regions.size());
    m_step.regions.push_back(std::move(sketch));
}

std::int32_t Canvas::findSymbol(const std::string& name) const {
    const auto found = m_symbols.find(name);
    return found == m_symbols.end() ? formats::kNoRow : found->second;
}

std::int32_t Canvas::addSymbol(std::string name, PadShape shape) {
    const auto row = static_cast<std::int32_t>(m_step.symbols.size());
    m_symbols.emplace(name, row);
    m_step.symbols.push_back({std::move(name), std::move(shape)});
    return row;
}

std::int32_t Canvas::roundSymbol(Nm diameter) {
    const auto [found, isNew] = m_rounds.try_emplace(diameter, formats::kNoRow);
    if (isNew) {
        const std::string name = "Circle " + millimetres(diameter);
        PadShape shape;
        shape.kind = PadShape::Kind::Round;
        shape.width = diameter;
        const std::int32_t same = findSymbol(name);
        found->second = same >= 0 ? same : addSymbol(name, std::move(shape));
    }
    return found->second;
}

std::int32_t Canvas::squareSymbol(Nm side) {
    const auto [found, isNew] = m_squares.try_emplace(side, formats::kNoRow);
    if (isNew) {
        PadShape shape;
        shape.kind = PadShape::Kind::Region;
        shape.width = side;
        shape.height = side;
        shape.isSquarePen = true;
        addBox(shape.region, side, side, false);
        found->second = addSymbol("Square pen " + millimetres(side), std::move(shape));
    }
    return found->second;
}

}  // namespace model::ipc2581
