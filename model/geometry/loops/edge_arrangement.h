#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "model/geometry/loops/edge_loops.h"

namespace model {

/// The edges of many regions, cut where they meet: fragments that have nothing but vertices in common. Vertices are at
/// least kSnapNm apart and no fragment passes a vertex nearer than 5/8 of that, so edges move by up to kSnapNm where
/// they run past each other that closely. Arcs are cut at the four extremes of their circle too, so that none is longer
/// than a quarter. Fragments that cover each other are one, with the sum of their windings; those whose sum is 0 are
/// left out.
class EdgeArrangement {
public:
    static constexpr double kSnapNm = 2.0;
    /// Another distance than kSnapNm; all others follow in proportion.
    explicit EdgeArrangement(double snapNm = kSnapNm) : m_snapNm(snapNm) {}

    static constexpr std::int32_t kLine = -1;

    struct Circle {
        PointD centre;
        double radius = 0.0;
    };
    struct Fragment {
        std::uint32_t a = 0;  ///< vertices
        std::uint32_t b = 0;
        std::int32_t circle = kLine;  ///< the circle it is part of
        bool isClockwise = false;     ///< from a to b
        bool isNew = true;            ///< not yet compared with the others
        int count = 1;                ///< winding number on its left, from a to b, less that on its right
    };

    /// `count`: 1 adds what the region covers, -1 takes it away.
    void add(const EdgeLoops& region, int count = 1);
    /// A line or arc of a drawing, which is part of no region: lines that cover each other become one whatever their
    /// direction is. Of use where counts do not matter (outerBoundaryOf).
    void addEdge(const Edge& edge);
    /// Cuts until nothing is left to cut: false if that comes to no end.
    [[nodiscard]] bool settle();

    [[nodiscard]] std::span<const PointD> vertices() const { return m_vertices; }
    [[nodiscard]] std::span<const Fragment> fragments() const { return m_fragments; }
    [[nodiscard]] const Circle& circle(std::int32_t row) const { return m_circles[static_cast<std::size_t>(row)]; }
    /// Where it lies: a fragment of a circle goes through its vertices, which may lie beside it.
    [[nodiscard]] Edge edgeOf(const Fragment& fragment) const;

private:
    struct Cut {
        std::uint32_t fragment = 0;
        double along = 0.0;
        std::uint32_t vertex = 0;
    };

    void addLoop(std::span<const Edge> loop, int count);
    void addArc(const Edge& arc, std::uint32_t from, std::uint32_t to, int count);
    void addFragment(std::uint32_t a, std::uint32_t b, std::int32_t circle, int count);
    std::uint32_t vertexAt(PointD p);
    void mergeEqual();
    void findCuts();
    void compare(std::uint32_t i, std::uint32_t j);
    void cutWhereClosest(std::uint32_t i, std::uint32_t j);
    void cutWhereNear(std::uint32_t fragment, std::uint32_t vertex);
    void cutAt(std::uint32_t fragment, std::uint32_t vertex);
    void applyCuts();
    [[nodiscard]] double bulgeOf(const Fragment& fragment) const;

    double m_snapNm;
    std::vector<PointD> m_vertices;
    std::unordered_map<std::uint64_t, std::uint32_t> m_cells;  ///< the last vertex in a cell of the plane
    std::vector<std::uint32_t> m_before;                       ///< the one before it in the same cell
    std::vector<Circle> m_circles;
    std::vector<Fragment> m_fragments;
    std::vector<Edge> m_edges;  ///< of the fragments, while they are compared
    std::vector<Cut> m_cuts;
};

/// An arc of up to half a circle through two points beside it: the centre moves onto their perpendicular bisector. A
/// line where the arc is within 0.1 nm of it.
[[nodiscard]] Edge arcThrough(PointD a, PointD b, const EdgeArrangement::Circle& circle, bool isClockwise);

}  // namespace model
