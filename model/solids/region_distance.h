#pragma once

#include <span>
#include <vector>

#include "model/geometry/discretise.h"

namespace model {

/// Smallest distance in nm between two straight stretches; 0 if they cross. The ends of one may be equal.
[[nodiscard]] double segmentDistance(Point a, Point b, Point c, Point d);

/// Do two groups of polygons of one set overlap, or come closer than `margin` nm? The boxes are theirs.
[[nodiscard]] bool regionsTouch(const PolygonSet& set, std::span<const PolygonSet::Polygon> a,
                                std::span<const PolygonSet::Polygon> b, const Box& boxA, const Box& boxB,
                                double margin);

[[nodiscard]] Box boxOf(std::span<const Point> points);

/// Is the point in one of these polygons?
[[nodiscard]] bool contains(const PolygonSet& set, std::span<const PolygonSet::Polygon> polygons, Point p);

/// The edges of a region in horizontal strips, so that a search near a location visits few of them.
class EdgeStrips {
public:
    explicit EdgeStrips(const PolygonSet& region);

    /// Is the point in the region (even-odd)?
    [[nodiscard]] bool contains(Point p) const;
    /// Does an edge of the region share a point with the box?
    [[nodiscard]] bool meets(const Box& box) const;
    /// Does an edge of the region come closer than `margin` nm to one of these polygons, whose box is `box`?
    [[nodiscard]] bool comesNear(const PolygonSet& set, std::span<const PolygonSet::Polygon> polygons, const Box& box,
                                 double margin) const;

private:
    struct Edge {
        Point a;
        Point b;
    };

    [[nodiscard]] static bool comesNear(const Edge& edge, const PolygonSet& set,
                                        std::span<const PolygonSet::Polygon> polygons, double margin);
    [[nodiscard]] std::size_t stripOf(std::int64_t y) const;
    [[nodiscard]] std::span<const Edge> edgesIn(std::size_t strip) const {
        return std::span(m_edges).subspan(m_first[strip], m_first[strip + 1] - m_first[strip]);
    }

    Box m_box;
    std::vector<Edge> m_edges;         ///< strip by strip; in each that it passes through
    std::vector<std::size_t> m_first;  ///< by strip, of m_edges; and the end
};

}  // namespace model
