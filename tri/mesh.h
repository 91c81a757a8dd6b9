#pragma once

#include <array>
#include <cstdint>

#include "tri/predicates.h"
#include "tri/scratch.h"

namespace tri {

/// Corner after / before corner i of a triangle, counter-clockwise.
inline constexpr std::array<std::uint32_t, 3> kNext = {1, 2, 0};
inline constexpr std::array<std::uint32_t, 3> kPrevious = {2, 0, 1};

/// Which edge of which triangle: the edge opposite corner `corner`. In one word: triangle << 2 | corner.
struct EdgeRef {
    std::uint32_t word;

    static constexpr EdgeRef of(std::uint32_t triangle, std::uint32_t corner) { return {triangle << 2 | corner}; }
    [[nodiscard]] constexpr std::uint32_t triangle() const { return word >> 2; }
    [[nodiscard]] constexpr std::uint32_t corner() const { return word & 3; }
    constexpr bool operator==(const EdgeRef&) const = default;
};

/// There is no triangle on the other side.
inline constexpr EdgeRef kOutside = {0xFFFFFFFF};

/// Corners counter-clockwise; across[i] is the same edge seen from the triangle on the other side of edge i.
struct Triangle {
    std::uint32_t v[3];
    EdgeRef across[3];
};

/// A triangulated area as arrays. Vertices are numbered 0..vertexCount, in any order; their ids break ties.
/// Invariant: triangles are counter-clockwise, and across(across(e)) == e.
struct Mesh {
    Scratch<Triangle> triangles;
    Scratch<Point> points;
    Scratch<std::uint32_t> ids;
    std::uint32_t triangleCount = 0;
    std::uint32_t vertexCount = 0;
    bool isCompact = false;  ///< all points lie within kCompactExtent

    [[nodiscard]] Site site(std::uint32_t vertex) const { return {points[vertex], ids[vertex]}; }
    [[nodiscard]] std::int64_t orientation(std::uint32_t a, std::uint32_t b, std::uint32_t c) const {
        return orient(points[a], points[b], points[c]);
    }

    /// Makes both sides of an edge know each other; `other` may be kOutside.
    void link(EdgeRef edge, EdgeRef other) {
        triangles[edge.triangle()].across[edge.corner()] = other;
        if (other != kOutside) {
            triangles[other.triangle()].across[other.corner()] = edge;
        }
    }

    /// Does the triangle on the other side of the edge have its apex inside this triangle's circle?
    [[nodiscard]] bool isFlipNeeded(EdgeRef edge) const {
        const Triangle& t = triangles[edge.triangle()];
        const EdgeRef other = t.across[edge.corner()];
        if (other == kOutside) {
            return false;
        }
        const std::uint32_t apex = triangles[other.triangle()].v[other.corner()];
        const Point a = points[t.v[0]], b = points[t.v[1]], c = points[t.v[2]], d = points[apex];
        const Int128 exact = isCompact ? inCircle<std::int64_t>(a, b, c, d) : inCircle(a, b, c, d);
        if (exact != 0) [[likely]] {
            return exact > 0;  // ids are not even loaded
        }
        return isFlipNeededOnCircle(edge);
    }

    /// The same, for an apex that lies on the circle.
    [[nodiscard]] bool isFlipNeededOnCircle(EdgeRef edge) const {
        const Triangle& t = triangles[edge.triangle()];
        const EdgeRef other = t.across[edge.corner()];
        const std::uint32_t apex = triangles[other.triangle()].v[other.corner()];
        return isInPerturbedCircleOnCircle(site(t.v[0]), site(t.v[1]), site(t.v[2]), site(apex));
    }

    /// Replaces the diagonal of the quadrangle around the edge:
    ///     t = (q, a, b), u = (d, b, a)  →  t = (q, a, d), u = (d, b, q)
    /// where q is corner i of t and d corner j of u; both stay at their locations. Afterwards edge i of t and edge j+2
    /// of u are the border that was u's, edge i+2 of t and edge j of u the one that was t's.
    void flip(EdgeRef edge) {
        const std::uint32_t i = edge.corner();
        Triangle& t = triangles[edge.triangle()];
        const EdgeRef other = t.across[i];
        const std::uint32_t j = other.corner();
        Triangle& u = triangles[other.triangle()];
        const EdgeRef outerOfU = u.across[kNext[j]];
        const EdgeRef outerOfT = t.across[kNext[i]];
        t.v[kPrevious[i]] = u.v[j];
        u.v[kPrevious[j]] = t.v[i];
        link(edge, outerOfU);
        link(other, outerOfT);
        link(EdgeRef::of(edge.triangle(), kNext[i]), EdgeRef::of(other.triangle(), kNext[j]));
    }

    /// Takes back flip(edge), where `other` was the other side of the edge.
    void unflip(EdgeRef edge, EdgeRef other) {
        const std::uint32_t i = edge.corner();
        const std::uint32_t j = other.corner();
        Triangle& t = triangles[edge.triangle()];
        Triangle& u = triangles[other.triangle()];
        const EdgeRef outerOfU = t.across[i];
        const EdgeRef outerOfT = u.across[j];
        t.v[kPrevious[i]] = u.v[kNext[j]];
        u.v[kPrevious[j]] = t.v[kNext[i]];
        link(EdgeRef::of(other.triangle(), kNext[j]), outerOfU);
        link(EdgeRef::of(edge.triangle(), kNext[i]), outerOfT);
        link(edge, other);
    }
};

}  // namespace tri
