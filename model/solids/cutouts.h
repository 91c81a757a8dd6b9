#pragma once

#include <vector>

#include "model/base/progress.h"
#include "model/board/document.h"
#include "model/geometry/discretise.h"

namespace model {

/// What is to be taken out of a region: holes, mask openings, the boards of a panel. Each is kept as exact contours,
/// where it has them, and as polygons for everything that needs booleans. One row per cutout.
class Cutouts {
public:
    /// The region an element covers, laid down by `placement`; of a hole, what the drill removes.
    void add(const Document& document, ElementId element, const Placement& placement = {});
    void add(const ShapeTable& shapes, ShapeId shape, const Placement& placement);

    [[nodiscard]] std::size_t size() const { return m_boxes.size(); }
    [[nodiscard]] const Box& box(std::size_t row) const { return m_boxes[row]; }
    /// Its polygons as rows of `polygons().polygons`.
    [[nodiscard]] std::span<const PolygonSet::Polygon> polygonsOf(std::size_t row) const {
        return std::span(m_polygons.polygons)
            .subspan(m_firstPolygon[row], m_firstPolygon[row + 1] - m_firstPolygon[row]);
    }
    [[nodiscard]] const PolygonSet& polygons() const { return m_polygons; }
    /// Has it contours that do not overlap, so that it needs no boolean as long as it stays alone?
    [[nodiscard]] bool isSimple(std::size_t row) const {
        return m_firstContour[row] < m_firstContour[row + 1] || polygonsOf(row).size() == 1;
    }
    /// Adds these contours to a sketch with holes and islands swapped: exact ones, or else the polygon.
    void addInverted(std::size_t row, ShapeSketch& sketch) const;

    /// Do the two overlap, or come closer than `margin` nm? Exact for round holes and straight slots, to the chord
    /// tolerance for others.
    [[nodiscard]] bool touch(std::size_t a, std::size_t b, double margin) const;
    /// Is `inner` known to lie in `outer` altogether? Only for round holes, straight slots and equal outlines.
    [[nodiscard]] bool covers(std::size_t outer, std::size_t inner) const;

private:
    /// A round hole or straight slot: all points closer than `radius` to the line from `a` to `b`. Negative: another
    /// shape.
    struct Capsule {
        Point a;
        Point b;
        double radius = -1.0;
    };

    /// The exact contours, if the element has any; they show whether it is a capsule.
    Capsule addContours(const Document& document, ElementId element, const Placement& placement);
    Capsule addCircle(const CircleGeometry& circle, bool isHole, const Placement& placement);
    void addRow(const PolygonSet& polygons, const Capsule& capsule);

    ShapeSketch m_contours;
    PolygonSet m_polygons;
    std::vector<std::uint32_t> m_firstContour{0};  ///< one more entry than rows, as m_firstPolygon
    std::vector<std::uint32_t> m_firstPolygon{0};
    std::vector<Box> m_boxes;
    std::vector<Capsule> m_capsules;
};

/// The shape without the cutouts. Where cutouts neither touch each other nor the outline, everything stays exact: a
/// round hole is a circle. Only those that overlap are united as polygons, and only if one reaches the outline does the
/// outline become a polygon (5 µm chords). Empty when nothing is left, or when cancelled.
[[nodiscard]] ShapeSketch subtract(const ShapeTable& shapes, ShapeId from, const Cutouts& cutouts,
                                   const base::Progress& progress);

}  // namespace model
