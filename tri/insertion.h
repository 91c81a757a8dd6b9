#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "tri/mesh.h"

namespace tri {

/// The whole mesh is ours to change.
struct Everywhere {
    static constexpr bool kIsLimited = false;
    [[nodiscard]] constexpr bool has(std::uint32_t /*triangle*/) const { return true; }
    constexpr void add(std::uint32_t /*triangle*/) const {}
};

/// Only the triangles of one part of the mesh are; others may be changing those of other parts at the same time. The
/// corners of a triangle next to one of another part are never changed by anyone, so they may be read from there. What
/// it links to of its own part may be changed.
struct Within {
    static constexpr bool kIsLimited = true;
    std::uint8_t* partOf;  ///< per triangle
    std::uint8_t part;
    [[nodiscard]] bool has(std::uint32_t triangle) const { return partOf[triangle] == part; }
    void add(std::uint32_t triangle) const { partOf[triangle] = part; }
};

/// Inserts vertices, one by one, into a mesh whose triangles are the perturbed Delaunay triangulation of a box and the
/// vertices so far, and keeps it that. Vertices that follow each other should be near each other.
template <class Area>
class Insertion {
public:
    /// Starts searching for the first vertex at triangle `near`, which is in the area.
    Insertion(Mesh& mesh, Area area, std::uint32_t near) : m_mesh(mesh), m_area(area), m_near(near) {}

    /// Finds the next vertex from triangle `near` on, which is in the area.
    void restart(std::uint32_t near) { m_near = near; }

    /// Inserts vertex q, whose position is new; it takes the triangle slots `slot` and `slot` + 1. False, and the mesh
    /// is as before, if that would change triangles outside the area.
    bool insert(std::uint32_t q, std::uint32_t slot) {
        const Location place = locate(m_mesh.points[q]);
        if constexpr (Area::kIsLimited) {
            if (place.triangle == kLost) {
                return false;
            }
            m_flips.clear();
        }
        const bool isSplit = place.edge == kNone ? splitTriangle(place.triangle, q, slot)
                                                 : splitEdge(EdgeRef::of(place.triangle, place.edge), q, slot);
        return isSplit && legaliseAround(place.triangle);
    }

private:
    /// Where a point is: in a triangle, or on its edge `edge`.
    struct Location {
        std::uint32_t triangle;
        std::uint32_t edge;
    };
    static constexpr std::uint32_t kNone = 3;
    static constexpr std::uint32_t kLost = 0xFFFFFFFF;

    /// Walks towards the point over edges that have it on their other side. Ends in every Delaunay triangulation.
    Location locate(Point p) {
        std::uint32_t entered = kNone;  // the edge we came through has p on this side
        for (;;) {
            const Triangle& t = m_mesh.triangles[m_near];
            std::uint32_t onEdge = kNone;
            EdgeRef leave = kOutside;
            for (std::uint32_t k = 0; k < 3; ++k) {
                if (k == entered) {
                    continue;
                }
                const std::int64_t orientation =
                    orient(m_mesh.points[t.v[kNext[k]]], m_mesh.points[t.v[kPrevious[k]]], p);
                if (orientation < 0) {
                    leave = t.across[k];
                    break;
                }
                onEdge = orientation == 0 ? k : onEdge;
            }
            if (leave == kOutside) {
                return {m_near, onEdge};
            }
            if (!m_area.has(leave.triangle())) {
                return {kLost, kNone};
            }
            m_near = leave.triangle();
            entered = leave.corner();
        }
    }

    /// Are the triangles around this one in the area, so that their links may be changed?
    [[nodiscard]] bool isSurrounded(const Triangle& t) const {
        const auto isOurs = [&](EdgeRef across) { return across == kOutside || m_area.has(across.triangle()); };
        return isOurs(t.across[0]) && isOurs(t.across[1]) && isOurs(t.across[2]);
    }

    /// One triangle becomes three around vertex q, which is their corner 0.
    bool splitTriangle(std::uint32_t at, std::uint32_t q, std::uint32_t slot) {
        const Triangle old = m_mesh.triangles[at];
        if constexpr (Area::kIsLimited) {
            if (!isSurrounded(old)) {
                return false;
            }
            m_before = {std::pair{at, old}, std::pair{at, old}};
        }
        const std::uint32_t second = slot;
        const std::uint32_t third = slot + 1;
        m_area.add(second);
        m_area.add(third);
        const auto [a, b, c] = std::array{old.v[0], old.v[1], old.v[2]};
        m_mesh.triangles[at] = {{q, b, c}, {kOutside, EdgeRef::of(second, 2), EdgeRef::of(third, 1)}};
        m_mesh.triangles[second] = {{q, c, a}, {kOutside, EdgeRef::of(third, 2), EdgeRef::of(at, 1)}};
        m_mesh.triangles[third] = {{q, a, b}, {kOutside, EdgeRef::of(at, 2), EdgeRef::of(second, 1)}};
        m_mesh.link(EdgeRef::of(at, 0), old.across[0]);
        m_mesh.link(EdgeRef::of(second, 0), old.across[1]);
        m_mesh.link(EdgeRef::of(third, 0), old.across[2]);
        return true;
    }

    /// Two triangles become four around vertex q on their common edge; it is their corner 0. No vertex is on the box.
    bool splitEdge(EdgeRef edge, std::uint32_t q, std::uint32_t slot) {
        const std::uint32_t t = edge.triangle();
        const Triangle upper = m_mesh.triangles[t];
        const std::uint32_t i = edge.corner();
        const EdgeRef other = upper.across[i];
        const std::uint32_t u = other.triangle();
        if (!m_area.has(u)) {
            return false;
        }
        const Triangle lower = m_mesh.triangles[u];
        if constexpr (Area::kIsLimited) {
            if (!isSurrounded(upper) || !isSurrounded(lower)) {
                return false;
            }
            m_before = {std::pair{t, upper}, std::pair{u, lower}};
        }
        const std::uint32_t j = other.corner();
        const std::uint32_t a = upper.v[i], b = upper.v[kNext[i]], c = upper.v[kPrevious[i]], d = lower.v[j];
        const std::uint32_t second = slot;
        const std::uint32_t fourth = slot + 1;
        m_area.add(second);
        m_area.add(fourth);
        // Counter-clockwise around q: (c,a) (a,b) (b,d) (d,c).
        m_mesh.triangles[t] = {{q, c, a}, {kOutside, EdgeRef::of(second, 2), EdgeRef::of(fourth, 1)}};
        m_mesh.triangles[second] = {{q, a, b}, {kOutside, EdgeRef::of(u, 2), EdgeRef::of(t, 1)}};
        m_mesh.triangles[u] = {{q, b, d}, {kOutside, EdgeRef::of(fourth, 2), EdgeRef::of(second, 1)}};
        m_mesh.triangles[fourth] = {{q, d, c}, {kOutside, EdgeRef::of(t, 2), EdgeRef::of(u, 1)}};
        m_mesh.link(EdgeRef::of(t, 0), upper.across[kNext[i]]);
        m_mesh.link(EdgeRef::of(second, 0), upper.across[kPrevious[i]]);
        m_mesh.link(EdgeRef::of(u, 0), lower.across[kNext[j]]);
        m_mesh.link(EdgeRef::of(fourth, 0), lower.across[kPrevious[j]]);
        return true;
    }

    /// Goes once around the newest vertex, corner 0 of triangle `start`, and flips the edge opposite to it as long as
    /// that is not Delaunay. All flips of an insertion happen there, so no stack is needed; and every test is made
    /// from there, so of its four points only the one beyond the edge is new.
    template <class Lift>
    bool legaliseAround(std::uint32_t start) {
        const Point eye = m_mesh.points[m_mesh.triangles[start].v[0]];
        const auto seen = [&](std::uint32_t vertex) { return Seen<Lift>::from(eye, m_mesh.points[vertex]); };
        EdgeRef edge = EdgeRef::of(start, 0);
        Seen<Lift> a = seen(m_mesh.triangles[start].v[1]);
        do {
            Seen<Lift> b = seen(m_mesh.triangles[edge.triangle()].v[kPrevious[edge.corner()]]);
            std::int64_t turnAB = orientation(a, b);
            for (EdgeRef other = beyond(edge); other != kOutside; other = beyond(edge)) {
                const Seen<Lift> d = seen(m_mesh.triangles[other.triangle()].v[other.corner()]);
                const std::int64_t turnAD = orientation(a, d);
                const Int128 outside = outsideCircleOfEye(a, b, d, turnAB, orientation(b, d), turnAD);
                if (outside > 0 || (outside == 0 && !m_mesh.isFlipNeededOnCircle(edge))) [[likely]] {
                    break;
                }
                if (!flip(edge, other)) {
                    return false;
                }
                b = d;
                turnAB = turnAD;
            }
            a = b;
            const EdgeRef next = m_mesh.triangles[edge.triangle()].across[kNext[edge.corner()]];
            edge = EdgeRef::of(next.triangle(), kNext[next.corner()]);
        } while (edge.triangle() != start);
        return true;
    }

    bool legaliseAround(std::uint32_t start) {
        return m_mesh.isCompact ? legaliseAround<std::int64_t>(start) : legaliseAround<std::uint64_t>(start);
    }

    [[nodiscard]] EdgeRef beyond(EdgeRef edge) const { return m_mesh.triangles[edge.triangle()].across[edge.corner()]; }
    /// False, and everything is taken back, if that would change triangles outside the area.
    bool flip(EdgeRef edge, EdgeRef other) {
        if constexpr (Area::kIsLimited) {
            if (!m_area.has(other.triangle()) || !isSurrounded(m_mesh.triangles[other.triangle()])) {
                undo();
                return false;
            }
            m_flips.emplace_back(edge, other);
        }
        m_mesh.flip(edge);
        return true;
    }

    /// Takes back the flips and the split.
    void undo() {
        for (; !m_flips.empty(); m_flips.pop_back()) {
            m_mesh.unflip(m_flips.back().first, m_flips.back().second);
        }
        for (const auto& [at, old] : m_before) {
            m_mesh.triangles[at] = old;
        }
        for (const auto& [at, old] : m_before) {
            for (std::uint32_t corner = 0; corner < 3; ++corner) {
                m_mesh.link(EdgeRef::of(at, corner), old.across[corner]);
            }
        }
    }

    Mesh& m_mesh;
    Area m_area;
    std::uint32_t m_near;
    std::vector<std::pair<EdgeRef, EdgeRef>> m_flips;
    std::array<std::pair<std::uint32_t, Triangle>, 2> m_before{};
};

}  // namespace tri
