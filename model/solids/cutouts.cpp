#include "model/solids/cutouts.h"

#include <algorithm>
#include <cmath>

#include "model/figures/element_polygons.h"
#include "model/solids/region_distance.h"

namespace model {

namespace {

/// The edge of a round pen along a straight track, counter-clockwise.
void addCapsule(ShapeSketch& sketch, Point a, Point b, Nm width) {
    if (a == b) {
        return sketch.addCircle(a, width / 2, false);
    }
    const double length = std::hypot(double(b.x) - a.x, double(b.y) - a.y);
    const PointD left{-(double(b.y) - a.y) / length * width / 2.0, (double(b.x) - a.x) / length * width / 2.0};
    const auto at = [&left](Point p, double side) {
        return Point{static_cast<Nm>(std::llround(p.x + side * left.x)),
                     static_cast<Nm>(std::llround(p.y + side * left.y))};
    };
    sketch.beginContour(false);
    sketch.addNode({at(b, -1), b, EdgeKind::ArcCounterClockwise});
    sketch.addNode(at(b, 1));
    sketch.addNode({at(a, 1), a, EdgeKind::ArcCounterClockwise});
    sketch.addNode(at(a, -1));
}

}  // namespace

void Cutouts::addRow(const PolygonSet& polygons, const Capsule& capsule) {
    if (polygons.polygons.empty()) {
        return;
    }
    m_polygons.append(polygons);
    m_firstContour.push_back(static_cast<std::uint32_t>(m_contours.contourCount()));
    m_firstPolygon.push_back(static_cast<std::uint32_t>(m_polygons.polygons.size()));
    m_boxes.push_back(boxOf(polygons.points));
    m_capsules.push_back(capsule);
}

void Cutouts::add(const Document& document, ElementId element, const Placement& placement) {
    PolygonSet polygons = discretise(document, element, {});
    if (!isIdentity(placement)) {
        polygons = placed(polygons, placement);
    }
    if (!polygons.polygons.empty()) {
        const Capsule capsule = addContours(document, element, placement);
        addRow(polygons, capsule);
    }
}

Cutouts::Capsule Cutouts::addContours(const Document& document, ElementId element, const Placement& placement) {
    const std::uint32_t row = document.elements.geometry[element.row()];
    const std::uint8_t flags = document.elements.flags[element.row()];
    switch (document.elements.kind[element.row()]) {
        case ElementKind::Circle: return addCircle(document.circles[row], (flags & kHole) != 0, placement);
        case ElementKind::Line: {
            const LineGeometry& line = document.lines[row];
            if ((flags & kSquarePen) != 0) {
                return {};
            }
            const Capsule capsule{placement.apply(line.a), placement.apply(line.b), line.width / 2.0};
            addCapsule(m_contours, capsule.a, capsule.b, line.width);
            return capsule;
        }
        case ElementKind::Area:
            m_contours.append(document.shapes, document.areas[row].shape,
                              placement.after(document.areas[row].placement));
            return {};
        case ElementKind::Arc:
        case ElementKind::Trail: return {};  // only polygons
    }
    return {};
}

Cutouts::Capsule Cutouts::addCircle(const CircleGeometry& circle, bool isHole, const Placement& placement) {
    const Point centre = placement.apply(circle.centre);
    m_contours.addCircle(centre, circle.diameter / 2, false);
    if (circle.innerDiameter > 0 && !isHole) {
        m_contours.addCircle(centre, circle.innerDiameter / 2, true);
        return {};
    }
    return {centre, centre, circle.diameter / 2.0};
}

void Cutouts::add(const ShapeTable& shapes, ShapeId shape, const Placement& placement) {
    const PolygonSet polygons = placed(discretise(shapes, shape, {}), placement);
    if (!polygons.polygons.empty()) {
        m_contours.append(shapes, shape, placement);
        addRow(polygons, {});
    }
}

void Cutouts::addInverted(std::size_t row, ShapeSketch& sketch) const {
    for (std::size_t i = m_firstContour[row]; i < m_firstContour[row + 1]; ++i) {
        sketch.beginContour(!m_contours.isHole(i));
        sketch.addNodes(m_contours.contour(i));
    }
    if (m_firstContour[row] == m_firstContour[row + 1]) {
        for (const PolygonSet::Polygon& polygon : polygonsOf(row)) {
            for (std::uint32_t i = 0; i < polygon.loopCount; ++i) {
                sketch.addPolygon(m_polygons.loop(polygon.firstLoop + i), i == 0);
            }
        }
    }
}

bool Cutouts::touch(std::size_t a, std::size_t b, double margin) const {
    const Capsule& p = m_capsules[a];
    const Capsule& q = m_capsules[b];
    if (p.radius >= 0 && q.radius >= 0) {
        return segmentDistance(p.a, p.b, q.a, q.b) < p.radius + q.radius + margin;
    }
    const auto own = [this](std::size_t row) { return polygonsOf(row); };
    return regionsTouch(m_polygons, own(a), own(b), m_boxes[a], m_boxes[b], margin);
}

bool Cutouts::covers(std::size_t outer, std::size_t inner) const {
    const Capsule& p = m_capsules[outer];
    const Capsule& q = m_capsules[inner];
    if (p.radius >= 0 && q.radius >= 0) {
        // A capsule is convex: it holds the other when it holds the discs at both ends.
        return segmentDistance(p.a, p.b, q.a, q.a) + q.radius <= p.radius &&
               segmentDistance(p.a, p.b, q.b, q.b) + q.radius <= p.radius;
    }
    const std::size_t first = m_firstContour[outer];
    const std::size_t count = m_firstContour[outer + 1] - first;
    bool isEqual = count > 0 && count == m_firstContour[inner + 1] - m_firstContour[inner];
    for (std::size_t i = 0; isEqual && i < count; ++i) {
        isEqual = std::ranges::equal(m_contours.contour(first + i), m_contours.contour(m_firstContour[inner] + i));
    }
    return isEqual;
}

}  // namespace model
