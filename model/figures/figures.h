#pragma once

#include <span>
#include <vector>

#include "model/board/document.h"
#include "model/geometry/edges.h"

namespace model {

/// What elements cover, in a form that can be measured exactly: arcs stay arcs, pens stay pens,
/// NURBS curves are rows of arcs within a quarter nanometre (geometry/curve_edges.h). A figure is one
/// connected piece: a track (edges with a pen), or an island of an area with its holes (boundary edges around a filled
/// inside). An area of several islands gives one figure each; holes count as filled, as far as the drill reaches.
///
/// The edges of a figure are grouped in eights, those in eights again and so on up to one box, so that a figure of
/// 100,000 edges is searched as quickly as a small one. Neighbours in one contour lie close together as they are; edges
/// of a figure with holes are sorted along a space-filling curve first.
class FigureTable {
public:
    struct Figure {
        ElementId element;
        std::uint32_t firstEdge = 0;
        std::uint32_t edgeCount = 0;
        std::uint32_t firstBox = 0;  ///< level by level, the finest first, the last box holds the whole figure
        std::uint32_t boxCount = 0;
        bool isFilled = false;
        PointD anchor;  ///< a point on its outline, or on the middle of its track
    };

    static constexpr std::uint32_t kBranch = 8;

    /// Adds the figures of an element, laid on the board by `placement`. Tracks without width cover nothing and add
    /// none.
    void add(const Document& document, ElementId element, const Placement& placement = {});
    /// The same where each edge of a track is a figure of its own, so that edges can be measured with each other.
    void addEdgewise(const Document& document, ElementId element);
    /// Adds the contours of a shape as lines without width, a figure each: an outline that covers nothing.
    void addOutline(const ShapeTable& shapes, ShapeId shape);
    /// Adds one figure of an element, a track along these middle lines, which have pens.
    void addTrack(ElementId element, std::span<const Edge> edges, const Placement& placement = {});
    /// Adds a disc that belongs to no element; radius 0 is a point.
    void addDisc(Point centre, double radius);
    /// The same for a straight track; pen radius 0 is a line without width.
    void addTrack(PointD a, PointD b, double radius);

    [[nodiscard]] std::size_t size() const { return m_figures.size(); }
    [[nodiscard]] const Figure& operator[](std::size_t row) const { return m_figures[row]; }
    [[nodiscard]] const Box& box(std::size_t row) const {
        return m_boxes[m_figures[row].firstBox + m_figures[row].boxCount - 1];
    }
    /// Of all figures, by row.
    [[nodiscard]] std::vector<Box> outerBoxes() const;
    [[nodiscard]] std::span<const Edge> edges(std::size_t row) const {
        return std::span(m_edges).subspan(m_figures[row].firstEdge, m_figures[row].edgeCount);
    }
    [[nodiscard]] std::span<const Box> boxes(std::size_t row) const {
        return std::span(m_boxes).subspan(m_figures[row].firstBox, m_figures[row].boxCount);
    }

private:
    void addElement(const Document& document, ElementId element);
    void addSquareTrack(const LineGeometry& line);
    void addRing(const CircleGeometry& circle);
    void addArea(const Document& document, ElementId element);
    void addContour(const PathNodes& path, bool isHole, const Placement& placement);
    void addTrack(Edge edge, double width);
    void begin(ElementId element, bool isFilled);
    void finish();

    std::vector<Figure> m_figures;
    std::vector<Edge> m_edges;
    std::vector<Box> m_boxes;
    Placement m_placement;  ///< of what is being added
};

}  // namespace model
