#include "model/section/line_cut.h"

#include <algorithm>
#include <cmath>

#include "model/figures/figures.h"
#include "model/figures/tracks.h"
#include "model/geometry/curve_edges.h"

namespace model {

namespace {

/// Lines this little apart in direction do not meet on a board.
constexpr double kParallel = 1e-14;

/// Where a line passes a contour, and how that changes how often the contour winds around the line's points.
struct Crossing {
    double at = 0.0;
    int winding = 0;
};

/// Adds the locations where a line passes the edges of one contour. What decides is on which side of the line vertices
/// lie, so that the turns of a closed contour add up to nothing, whatever rounding does to the locations.
class ContourCrossings {
public:
    explicit ContourCrossings(const CutLine& line) : m_line(line) {}

    void add(const Edge& edge) {
        const double from = m_line.beside(edge.a);
        const double to = m_line.beside(edge.b);
        edge.isArc() ? addArc(edge, from >= 0, to >= 0) : addLine(edge.a, edge.b, from, to);
    }

    /// All edges of a contour. Of most their ends, and of arcs their circles, tell that the line does not pass them.
    void add(const PathNodes& contour) {
        double from = contour.empty() ? 0.0 : m_line.beside(base::toDouble(contour.front().point));
        for (std::size_t i = 0; i < contour.size(); ++i) {
            const PathNode& node = contour[i];
            const PointD end = base::toDouble(contour.endOf(i));
            const double to = m_line.beside(end);
            if (node.edge == EdgeKind::Line) {
                addLine(base::toDouble(node.point), end, from, to);
            } else if (node.edge != EdgeKind::Curve) {
                if (!isClearOf(node, end, from, to)) {
                    addArc(edgeOf(node, contour.endOf(i)), from >= 0, to >= 0);
                }
            } else {
                std::ranges::for_each(edgesOf(contour.curveAt(i)), [&](const Edge& edge) { add(edge); });
            }
            from = to;
        }
    }

    /// The locations inside of the contour; forgets it.
    [[nodiscard]] Intervals take() {
        std::ranges::sort(m_crossings, {}, &Crossing::at);
        std::vector<Interval> inside;
        int winding = 0;
        for (std::size_t i = 0; i + 1 < m_crossings.size(); ++i) {
            winding += m_crossings[i].winding;
            if (winding != 0) {
                inside.push_back({m_crossings[i].at, m_crossings[i + 1].at});
            }
        }
        m_crossings.clear();
        return united(std::move(inside));
    }

private:
    void addLine(PointD start, PointD end, double from, double to) {
        if ((from >= 0) == (to >= 0)) {
            return;
        }
        const double a = m_line.along(start);
        const double b = m_line.along(end);
        m_crossings.push_back({a + (b - a) * (from / (from - to)), to >= 0 ? 1 : -1});
    }

    /// Whether the circle of an arc lies on one side of the line, with both ends of the arc.
    [[nodiscard]] bool isClearOf(const PathNode& arc, PointD end, double from, double to) const {
        const PointD start = base::toDouble(arc.point);
        const PointD centre = base::toDouble(arc.centre);
        const auto squared = [&](PointD p) {
            return (p.x - centre.x) * (p.x - centre.x) + (p.y - centre.y) * (p.y - centre.y);
        };
        const double height = m_line.beside(centre);
        const bool isOneSide = (from >= 0) == (to >= 0) && (from >= 0) == (height >= 0);
        return isOneSide && height * height > std::max(squared(start), squared(end));
    }

    /// An arc is followed over the points where it is farthest from the line; between those it passes the line once at
    /// most.
    void addArc(const Edge& arc, bool isFromLeft, bool isToLeft) {
        const double height = m_line.beside(arc.centre);
        const PointD left = {-m_line.unit.y, m_line.unit.x};
        const bool startsAhead = m_line.along(arc.a) >= m_line.along(arc.centre);
        const bool isTopFirst = startsAhead != arc.isClockwise;
        bool side = isFromLeft;
        for (const bool isTop : {isTopFirst, !isTopFirst}) {
            if (passes(arc, isTop ? left : PointD{-left.x, -left.y})) {
                side = step(arc, height, side, (isTop ? height + arc.radius : height - arc.radius) >= 0);
            }
        }
        step(arc, height, side, isToLeft);
    }

    bool step(const Edge& arc, double height, bool isFromLeft, bool isToLeft) {
        if (isFromLeft != isToLeft) {
            const double half = std::sqrt(std::max((arc.radius - height) * (arc.radius + height), 0.0));
            const double foot = m_line.along(arc.centre);
            m_crossings.push_back({isToLeft != arc.isClockwise ? foot + half : foot - half, isToLeft ? 1 : -1});
        }
        return isToLeft;
    }

    const CutLine& m_line;
    std::vector<Crossing> m_crossings;
};

/// Where a line enters or leaves a circle.
void addCircle(const CutLine& line, PointD centre, double radius, std::vector<double>& breaks) {
    const double height = line.beside(centre);
    if (std::abs(height) < radius) {
        const double half = std::sqrt((radius - height) * (radius + height));
        breaks.push_back(line.along(centre) - half);
        breaks.push_back(line.along(centre) + half);
    }
}

/// Where a line passes the two straight sides of a track.
void addSides(const CutLine& line, const Edge& track, std::vector<double>& breaks) {
    const CutLine middle = CutLine::through(track.a, track.b);
    const double slope = middle.unit.x * line.unit.y - middle.unit.y * line.unit.x;
    if (std::abs(slope) > kParallel) {
        const double start = middle.beside(line.origin);
        breaks.push_back((track.pen - start) / slope);
        breaks.push_back((-track.pen - start) / slope);
    }
}

bool isDot(const Edge& track) {
    return !track.isArc() && track.a.x == track.b.x && track.a.y == track.b.y;
}

/// The locations that a round pen covers. Its outline is made of pieces of the circles around its ends and of its two
/// sides: between two of the locations where the line meets those, all is covered or nothing.
void addTrack(const CutLine& line, Edge track, double width, std::vector<Interval>& covered) {
    if (width <= 0) {
        return;
    }
    track.pen = width / 2;
    std::vector<double> breaks;
    addCircle(line, track.a, track.pen, breaks);
    addCircle(line, track.b, track.pen, breaks);
    if (track.isArc()) {
        addCircle(line, track.centre, track.radius + track.pen, breaks);
        addCircle(line, track.centre, track.radius - track.pen, breaks);
    } else if (!isDot(track)) {
        addSides(line, track, breaks);
    }
    std::ranges::sort(breaks);
    for (std::size_t i = 0; i + 1 < breaks.size(); ++i) {
        const double middle = (breaks[i] + breaks[i + 1]) / 2;
        Edge location;
        location.a = location.b = {line.origin.x + line.unit.x * middle, line.origin.y + line.unit.y * middle};
        if (spacingBetween(location, track).distance <= 0) {
            covered.push_back({breaks[i], breaks[i + 1]});
        }
    }
}

/// What round pens draw: with the outer ones the element's outside, with the inner ones its inside.
ElementCut cutTracks(const Document& document, ElementId element, const CutLine& line) {
    std::vector<Interval> covered;
    std::vector<Interval> opening;
    forEachTrack(document, element, [&](const PathNode& node, Point end, Nm width, Nm innerWidth) {
        addTrack(line, edgeOf(node, end), width, covered);
        addTrack(line, edgeOf(node, end), innerWidth, opening);
    });
    return {united(std::move(covered)), united(std::move(opening))};
}

ElementCut cutSquarePen(const Document& document, ElementId element, const CutLine& line) {
    FigureTable figures;
    figures.add(document, element);
    ContourCrossings crossings(line);
    for (std::size_t row = 0; row < figures.size(); ++row) {
        for (const Edge& side : figures.edges(row)) {
            crossings.add(side);
        }
    }
    return {crossings.take(), {}};
}

ElementCut cutArea(const Document& document, ElementId element, const CutLine& line) {
    const AreaGeometry& area = document.areas[document.elements.geometry[element.row()]];
    const Intervals all = cutShape(document.shapes, area.shape, line.seenFrom(area.placement));
    const bool isHole = (document.elements.flags[element.row()] & kHole) != 0;
    return {all, isHole ? all : Intervals{}};
}

}  // namespace

CutLine CutLine::through(PointD a, PointD b) {
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    return {a, {(b.x - a.x) / length, (b.y - a.y) / length}};
}

CutLine CutLine::seenFrom(const Placement& placement) const {
    const Placement rotationOnly = {Point{}, placement.clockwiseDeg, placement.isMirrored};
    return {unplaced(origin, placement), unplaced(unit, rotationOnly)};
}

bool CutLine::meets(const Box& box) const {
    const PointD middle = {(double{1} * box.min.x + box.max.x) / 2, (double{1} * box.min.y + box.max.y) / 2};
    const double reach =
        (static_cast<double>(box.width()) * std::abs(unit.y) + static_cast<double>(box.height()) * std::abs(unit.x)) /
        2;
    return !box.isEmpty() && std::abs(beside(middle)) <= reach + 1.0;
}

ElementCut cutElement(const Document& document, ElementId element, const CutLine& line) {
    if (document.elements.kind[element.row()] == ElementKind::Area) {
        return cutArea(document, element, line);
    }
    const bool isSquare = (document.elements.flags[element.row()] & kSquarePen) != 0;
    return isSquare ? cutSquarePen(document, element, line) : cutTracks(document, element, line);
}

/// Islands, each without the holes behind it.
Intervals cutShape(const ShapeTable& shapes, ShapeId shape, const CutLine& line) {
    ContourCrossings crossings(line);
    std::vector<Interval> covered;
    Intervals island;
    std::vector<Interval> holes;
    const auto finishIsland = [&] {
        const Intervals left = subtracted(island, united(std::move(holes)));
        covered.insert(covered.end(), left.begin(), left.end());
        holes.clear();
    };
    for (const Contour& contour : shapes.contoursOf(shape)) {
        crossings.add(shapes.nodesOf(contour));
        const Intervals inside = crossings.take();
        if (contour.isHole) {
            holes.insert(holes.end(), inside.begin(), inside.end());
        } else {
            finishIsland();
            island = inside;
        }
    }
    finishIsland();
    return united(std::move(covered));
}

Intervals cutHolesOf(const ShapeTable& shapes, ShapeId shape, const CutLine& line) {
    ContourCrossings crossings(line);
    std::vector<Interval> islands;
    for (const Contour& contour : shapes.contoursOf(shape)) {
        if (!contour.isHole) {
            crossings.add(shapes.nodesOf(contour));
            const Intervals inside = crossings.take();
            islands.insert(islands.end(), inside.begin(), inside.end());
        }
    }
    return subtracted(united(std::move(islands)), cutShape(shapes, shape, line));
}

Intervals cutPolygons(const PolygonSet& polygons, const CutLine& line) {
    ContourCrossings crossings(line);
    std::vector<Interval> covered;
    for (const PolygonSet::Polygon& polygon : polygons.polygons) {
        for (std::uint32_t i = 0; i < polygon.loopCount; ++i) {
            const std::span<const Point> loop = polygons.loop(polygon.firstLoop + i);
            for (std::size_t corner = 0; corner < loop.size(); ++corner) {
                Edge side;
                side.a = base::toDouble(loop[corner]);
                side.b = base::toDouble(loop[corner + 1 < loop.size() ? corner + 1 : 0]);
                crossings.add(side);
            }
        }
        const Intervals inside = crossings.take();
        covered.insert(covered.end(), inside.begin(), inside.end());
    }
    return united(std::move(covered));
}

}  // namespace model
