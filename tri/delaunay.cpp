#include "tri/delaunay.h"

#include <algorithm>
#include <array>

namespace tri {

namespace {

/// Where a point is: in a triangle, or on its edge `edge`.
struct Place {
    std::uint32_t triangle;
    std::uint32_t edge;
    static constexpr std::uint32_t kNone = 3;
};

/// Walks towards the point over edges that have it on their other side. Ends in every regular triangulation.
Place locate(const Mesh& mesh, Point p, std::uint32_t start) {
    std::uint32_t at = start;
    std::uint32_t entered = Place::kNone;  // the edge we came through has p on this side
    for (;;) {
        const Triangle& t = mesh.triangles[at];
        std::uint32_t onEdge = Place::kNone;
        EdgeRef leave = kOutside;
        for (std::uint32_t k = 0; k < 3; ++k) {
            if (k == entered) {
                continue;
            }
            const std::int64_t turn = orient(mesh.points[t.v[kNext[k]]], mesh.points[t.v[kPrevious[k]]], p);
            if (turn < 0) {
                leave = t.across[k];
                break;
            }
            onEdge = turn == 0 ? k : onEdge;
        }
        if (leave == kOutside) {
            return {at, onEdge};
        }
        at = leave.triangle();
        entered = leave.corner();
    }
}

/// One triangle becomes three around vertex q, which is their corner 0.
void splitTriangle(Mesh& mesh, std::uint32_t at, std::uint32_t q) {
    const Triangle old = mesh.triangles[at];
    const std::uint32_t second = mesh.triangleCount;
    const std::uint32_t third = second + 1;
    mesh.triangleCount += 2;
    const auto [a, b, c] = std::array{old.v[0], old.v[1], old.v[2]};
    mesh.triangles[at] = {{q, b, c}, {old.across[0], EdgeRef::of(second, 2), EdgeRef::of(third, 1)}};
    mesh.triangles[second] = {{q, c, a}, {old.across[1], EdgeRef::of(third, 2), EdgeRef::of(at, 1)}};
    mesh.triangles[third] = {{q, a, b}, {old.across[2], EdgeRef::of(at, 2), EdgeRef::of(second, 1)}};
    mesh.link(EdgeRef::of(at, 0), old.across[0]);
    mesh.link(EdgeRef::of(second, 0), old.across[1]);
    mesh.link(EdgeRef::of(third, 0), old.across[2]);
}

/// Two triangles become four around vertex q on their common edge; it is their corner 0. No vertex lies on the box.
void splitEdge(Mesh& mesh, EdgeRef edge, std::uint32_t q) {
    const std::uint32_t t = edge.triangle();
    const Triangle upper = mesh.triangles[t];
    const std::uint32_t i = edge.corner();
    const EdgeRef other = upper.across[i];
    const std::uint32_t u = other.triangle();
    const Triangle lower = mesh.triangles[u];
    const std::uint32_t j = other.corner();
    const std::uint32_t a = upper.v[i], b = upper.v[kNext[i]], c = upper.v[kPrevious[i]], d = lower.v[j];
    const std::uint32_t second = mesh.triangleCount;
    const std::uint32_t fourth = second + 1;
    mesh.triangleCount += 2;
    // Counter-clockwise around q: (c,a) (a,b) (b,d) (d,c).
    mesh.triangles[t] = {{q, c, a}, {kOutside, EdgeRef::of(second, 2), EdgeRef::of(fourth, 1)}};
    mesh.triangles[second] = {{q, a, b}, {kOutside, EdgeRef::of(u, 2), EdgeRef::of(t, 1)}};
    mesh.triangles[u] = {{q, b, d}, {kOutside, EdgeRef::of(fourth, 2), EdgeRef::of(second, 1)}};
    mesh.triangles[fourth] = {{q, d, c}, {kOutside, EdgeRef::of(t, 2), EdgeRef::of(u, 1)}};
    mesh.link(EdgeRef::of(t, 0), upper.across[kNext[i]]);
    mesh.link(EdgeRef::of(second, 0), upper.across[kPrevious[i]]);
    mesh.link(EdgeRef::of(u, 0), lower.across[kNext[j]]);
    mesh.link(EdgeRef::of(fourth, 0), lower.across[kPrevious[j]]);
}

/// Goes once around the newest vertex, corner 0 of triangle `start`, and flips the edge opposite to it as long as that
/// is not Delaunay. All flips of an insertion happen there, so no stack is needed.
void legaliseAround(Mesh& mesh, std::uint32_t start) {
    EdgeRef edge = EdgeRef::of(start, 0);
    do {
        while (mesh.isFlipNeeded(edge)) {
            mesh.flip(edge);
        }
        const EdgeRef next = mesh.triangles[edge.triangle()].across[kNext[edge.corner()]];
        edge = EdgeRef::of(next.triangle(), kNext[next.corner()]);
    } while (edge.triangle() != start);
}

}  // namespace

void startInBox(Mesh& mesh) {
    base::Box box;
    for (std::uint32_t i = 0; i < mesh.vertexCount; ++i) {
        box.include(mesh.points[i]);
    }
    box = box.grownBy(static_cast<base::Nm>(std::max(box.width(), box.height()) / 8 + 1));
    const std::uint32_t n = mesh.vertexCount;
    const std::array corners = {box.min, Point{box.max.x, box.min.y}, box.max, Point{box.min.x, box.max.y}};
    for (std::uint32_t i = 0; i < kBoxCorners; ++i) {
        mesh.points[n + i] = corners[i];
        mesh.ids[n + i] = 0xFFFFFFF0U + i;
    }
    mesh.triangleCount = 2;
    mesh.triangles[0] = {{n, n + 1, n + 2}, {kOutside, kOutside, kOutside}};
    mesh.triangles[1] = {{n, n + 2, n + 3}, {kOutside, kOutside, kOutside}};
    // The choice between the box's own two diagonals must be the perturbed one as well.
    mesh.link(EdgeRef::of(0, 1), EdgeRef::of(1, 2));
    if (mesh.isFlipNeeded(EdgeRef::of(0, 1))) {
        mesh.flip(EdgeRef::of(0, 1));
    }
}

void insertVertices(Mesh& mesh, std::uint32_t first, std::uint32_t end) {
    std::uint32_t near = mesh.triangleCount - 1;
    for (std::uint32_t q = first; q < end; ++q) {
        const Place place = locate(mesh, mesh.points[q], near);
        if (place.edge == Place::kNone) {
            splitTriangle(mesh, place.triangle, q);
        } else {
            splitEdge(mesh, EdgeRef::of(place.triangle, place.edge), q);
        }
        legaliseAround(mesh, place.triangle);
        near = place.triangle;
    }
}

}  // namespace tri
