#include "tri/triangulate.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "model/base/assert.h"

namespace tri {

namespace {

/// Per face: how many contours wind around it. 0 = outside, 1 = inside; anything else means regions overlap.
struct FaceInfo {
    static constexpr int kUnknown = -1000;
    int winding = kUnknown;
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;  // integer coordinates: predicates are exact
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase =
    CGAL::Constrained_triangulation_face_base_2<Kernel, CGAL::Triangulation_face_base_with_info_2<FaceInfo, Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
// No_constraint_intersection_tag: crossing constraints throw instead of growing vertices at inexact places.
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure, CGAL::No_constraint_intersection_tag>;
using FaceHandle = Triangulation::Face_handle;

/// An undirected edge with the net number of contours that run from the lower to the higher id. Opposite runs of a
/// keyhole bridge cancel.
struct NetEdge {
    std::uint32_t low;
    std::uint32_t high;
    int net;
};

/// Vertices of equal position get the lowest id among them.
std::vector<std::uint32_t> canonicalIds(std::span<const Point> points) {
    std::vector<std::uint32_t> order(points.size());
    std::iota(order.begin(), order.end(), 0U);
    std::ranges::sort(
        order, [&](std::uint32_t a, std::uint32_t b) { return std::pair(points[a], a) < std::pair(points[b], b); });
    std::vector<std::uint32_t> canonical(points.size());
    for (std::size_t i = 0; i < order.size(); ++i) {
        const bool repeats = i > 0 && points[order[i]] == points[order[i - 1]];
        canonical[order[i]] = repeats ? canonical[order[i - 1]] : order[i];
    }
    return canonical;
}

/// Adds up the runs of equal edges and drops those that cancel.
std::vector<NetEdge> addUp(std::vector<NetEdge> edges) {
    std::ranges::sort(
        edges, [](const NetEdge& a, const NetEdge& b) { return std::pair(a.low, a.high) < std::pair(b.low, b.high); });
    std::size_t kept = 0;
    for (std::size_t i = 0; i < edges.size();) {
        NetEdge sum = edges[i];
        for (++i; i < edges.size() && edges[i].low == sum.low && edges[i].high == sum.high; ++i) {
            sum.net += edges[i].net;
        }
        if (sum.net != 0) {
            edges[kept++] = sum;
        }
    }
    edges.resize(kept);
    return edges;
}

std::vector<NetEdge> netEdges(const Polygon& polygon, std::span<const std::uint32_t> canonical) {
    std::vector<NetEdge> edges;
    edges.reserve(polygon.points.size());
    for (std::size_t loop = 0; loop + 1 < polygon.loopStart.size(); ++loop) {
        const std::uint32_t first = polygon.loopStart[loop];
        const std::uint32_t end = polygon.loopStart[loop + 1];
        for (std::uint32_t i = first; i < end; ++i) {
            const std::uint32_t a = canonical[i];
            const std::uint32_t b = canonical[i + 1 < end ? i + 1 : first];
            if (a != b) {
                edges.push_back(a < b ? NetEdge{a, b, 1} : NetEdge{b, a, -1});
            }
        }
    }
    return addUp(std::move(edges));
}

int netOf(std::span<const NetEdge> edges, std::uint32_t from, std::uint32_t to) {
    const bool isForward = from < to;
    const std::pair key = isForward ? std::pair(from, to) : std::pair(to, from);
    const auto found =
        std::ranges::lower_bound(edges, key, {}, [](const NetEdge& e) { return std::pair(e.low, e.high); });
    if (found == edges.end() || found->low != key.first || found->high != key.second) {
        return 0;
    }
    return isForward ? found->net : -found->net;
}

/// Spatially sorted insertion keeps the walks short. Returns the handle per canonical id.
std::vector<Triangulation::Vertex_handle> insertVertices(const Polygon& polygon,
                                                         std::span<const std::uint32_t> canonical, Triangulation& out) {
    std::vector<std::pair<Kernel::Point_2, std::uint32_t>> vertices;
    vertices.reserve(polygon.points.size());
    for (std::uint32_t i = 0; i < canonical.size(); ++i) {
        if (canonical[i] == i) {
            vertices.emplace_back(Kernel::Point_2(polygon.points[i].x, polygon.points[i].y), i);
        }
    }
    out.insert(vertices.begin(), vertices.end());
    std::vector<Triangulation::Vertex_handle> handleOf(canonical.size());
    for (const Triangulation::Vertex_handle vertex : out.finite_vertex_handles()) {
        handleOf[vertex->info()] = vertex;
    }
    return handleOf;
}

/// CGAL splits a constraint at vertices that lie on it (T-junctions). The same split for our edges, so that every
/// constrained edge of the triangulation has its net winding.
std::vector<NetEdge> splitAtVertices(const Triangulation& triangulation,
                                     std::span<const Triangulation::Vertex_handle> handleOf,
                                     std::span<const NetEdge> edges) {
    std::vector<NetEdge> pieces;
    pieces.reserve(edges.size());
    for (const NetEdge& edge : edges) {
        Triangulation::Vertex_handle at = handleOf[edge.low];
        while (at != handleOf[edge.high]) {
            Triangulation::Vertex_handle next;
            FaceHandle face;
            int side = 0;
            const bool isThere = triangulation.includes_edge(at, handleOf[edge.high], next, face, side);
            ASSERT(isThere);
            const std::uint32_t a = at->info();
            const std::uint32_t b = next->info();
            pieces.push_back(a < b ? NetEdge{a, b, edge.net} : NetEdge{b, a, -edge.net});
            at = next;
        }
    }
    return addUp(std::move(pieces));
}

/// Erasing: walks from the infinite face over all edges and counts how often contours wind around each face. Crossing a
/// contour edge from its right to its left side enters the region once.
void labelFaces(Triangulation& triangulation, std::span<const NetEdge> edges) {
    std::vector<FaceHandle> stack{triangulation.infinite_face()};
    stack.back()->info().winding = 0;
    while (!stack.empty()) {
        const FaceHandle face = stack.back();
        stack.pop_back();
        for (int i = 0; i < 3; ++i) {
            const FaceHandle next = face->neighbor(i);
            if (next->info().winding != FaceInfo::kUnknown) {
                continue;
            }
            // A face lies to the left of its own boundary ccw(i) → cw(i), so its neighbour lies to the left of the
            // reverse.
            const std::uint32_t from = face->vertex(Triangulation::cw(i))->info();
            const std::uint32_t to = face->vertex(Triangulation::ccw(i))->info();
            next->info().winding = face->info().winding + (face->is_constrained(i) ? netOf(edges, from, to) : 0);
            stack.push_back(next);
        }
    }
}

/// Appends the inside faces; false if some face is wound around in a way a simple region cannot be.
bool collectInside(const Triangulation& triangulation, std::vector<std::uint32_t>& triangles) {
    for (const FaceHandle face : triangulation.finite_face_handles()) {
        const int winding = face->info().winding;
        if (winding != 0 && winding != 1) {
            return false;
        }
        if (winding == 1) {
            for (int corner = 0; corner < 3; ++corner) {
                triangles.push_back(face->vertex(corner)->info());
            }
        }
    }
    return true;
}

__int128 twiceArea(const Polygon& polygon) {
    __int128 sum = 0;
    for (std::size_t loop = 0; loop + 1 < polygon.loopStart.size(); ++loop) {
        const std::span<const Point> points =
            polygon.points.subspan(polygon.loopStart[loop], polygon.loopStart[loop + 1] - polygon.loopStart[loop]);
        for (std::size_t i = 0; i < points.size(); ++i) {
            const Point& a = points[i];
            const Point& b = points[i + 1 < points.size() ? i + 1 : 0];
            sum += std::int64_t{a.x} * b.y - std::int64_t{b.x} * a.y;
        }
    }
    return sum;
}

__int128 twiceArea(std::span<const Point> points, std::span<const std::uint32_t> triangles) {
    __int128 sum = 0;
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
        const Point& a = points[triangles[i]];
        const Point& b = points[triangles[i + 1]];
        const Point& c = points[triangles[i + 2]];
        sum += (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) -
               (std::int64_t{c.x} - a.x) * (std::int64_t{b.y} - a.y);
    }
    return sum;
}

}  // namespace

Outcome triangulate(const Polygon& polygon, std::vector<std::uint32_t>& triangles) {
    ASSERT(polygon.loopStart.empty() || polygon.loopStart.back() == polygon.points.size());
    const std::vector<std::uint32_t> canonical = canonicalIds(polygon.points);
    const std::vector<NetEdge> edges = netEdges(polygon, canonical);
    if (edges.empty()) {
        return Outcome::Degenerate;
    }
    const std::size_t before = triangles.size();
    try {
        Triangulation triangulation;
        const std::vector<Triangulation::Vertex_handle> handleOf = insertVertices(polygon, canonical, triangulation);
        if (triangulation.dimension() < 2) {
            return Outcome::Degenerate;
        }
        for (const NetEdge& edge : edges) {
            triangulation.insert_constraint(handleOf[edge.low], handleOf[edge.high]);
        }
        labelFaces(triangulation, splitAtVertices(triangulation, handleOf, edges));
        const bool isSimple = collectInside(triangulation, triangles);
        // The exact area is the proof: winding 0 or 1 everywhere and equal area leave nothing covered twice or missed.
        if (isSimple && twiceArea(polygon.points, std::span(triangles).subspan(before)) == twiceArea(polygon)) {
            return triangles.size() == before ? Outcome::Degenerate : Outcome::Ok;
        }
    } catch (const Triangulation::Intersection_of_constraints_exception&) {
        // Falls through: the caller repairs with integer booleans.
    }
    triangles.resize(before);
    return Outcome::Crossing;
}

}  // namespace tri
