#include "tri/cdt_cgal.h"

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <numeric>
#include <utility>

#include "model/base/assert.h"
#include "tri/delaunay.h"

namespace tri {

namespace {

/// Per face: how many contours wind around it. 0 = outside, 1 = inside; anything else means regions overlap. Inside
/// faces have a number.
struct FaceInfo {
    static constexpr int kUnknown = -1000;
    int winding = kUnknown;
    std::uint32_t triangle = 0;
};

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;  // integer coordinates: predicates are exact
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<std::uint32_t, Kernel>;
using FaceBase =
    CGAL::Constrained_triangulation_face_base_2<Kernel, CGAL::Triangulation_face_base_with_info_2<FaceInfo, Kernel>>;
using Structure = CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>;
// Crossing constraints throw instead of growing vertices at inexact locations; those that overlap along an edge may.
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel, Structure,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;
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

/// Numbers the inside faces; false if some face is wound around in a way a simple region cannot be.
bool numberInside(const Triangulation& triangulation, std::uint32_t& count) {
    for (const FaceHandle face : triangulation.finite_face_handles()) {
        const int winding = face->info().winding;
        if (winding != 0 && winding != 1) {
            return false;
        }
        if (winding == 1) {
            face->info().triangle = count++;
        }
    }
    return true;
}

/// The inside faces as a mesh; its borders are the contours.
void takeOver(const Polygon& polygon, const Triangulation& triangulation, Mesh& mesh) {
    mesh.vertexCount = static_cast<std::uint32_t>(polygon.points.size());
    std::ranges::copy(polygon.points, mesh.points.room(mesh.vertexCount));
    std::uint32_t* ids = mesh.ids.room(mesh.vertexCount);
    std::iota(ids, ids + mesh.vertexCount, 0U);
    mesh.triangles.room(mesh.triangleCount);
    for (const FaceHandle face : triangulation.finite_face_handles()) {
        if (face->info().winding != 1) {
            continue;
        }
        Triangle& triangle = mesh.triangles[face->info().triangle];
        for (int i = 0; i < 3; ++i) {
            const FaceHandle next = face->neighbor(i);
            triangle.v[i] = face->vertex(i)->info();
            triangle.across[i] = next->info().winding == 1
                                     ? EdgeRef::of(next->info().triangle, static_cast<std::uint32_t>(next->index(face)))
                                     : kOutside;
        }
    }
}

/// Breaks the ties between points on one circle as the contract says.
void makeUnique(Mesh& mesh) {
    std::vector<EdgeRef> edges;
    for (std::uint32_t t = 0; t < mesh.triangleCount; ++t) {
        for (std::uint32_t i = 0; i < 3; ++i) {
            // Once per edge; those at the border cannot flip.
            if (mesh.triangles[t].across[i] != kOutside && mesh.triangles[t].across[i].triangle() < t) {
                edges.push_back(EdgeRef::of(t, i));
            }
        }
    }
    restoreDelaunay(mesh, edges, [](std::uint32_t, std::uint32_t) { return false; });
}

/// Fills the mesh with the triangles inside.
Outcome fill(const Polygon& polygon, Mesh& mesh) {
    const std::vector<std::uint32_t> canonical = canonicalIds(polygon.points);
    const std::vector<NetEdge> edges = netEdges(polygon, canonical);
    if (edges.empty()) {
        return Outcome::Degenerate;
    }
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
        // Winding 0 or 1 everywhere: nothing is covered twice or missed.
        if (!numberInside(triangulation, mesh.triangleCount)) {
            return Outcome::Crossing;
        }
        takeOver(polygon, triangulation, mesh);
        return mesh.triangleCount == 0 ? Outcome::Degenerate : Outcome::Ok;
    } catch (const Triangulation::Intersection_of_constraints_exception&) {
        return Outcome::Crossing;
    }
}

}  // namespace

Status triangulateCgal(const Polygon& polygon, std::vector<std::uint32_t>& triangles) {
    ASSERT(polygon.loopStart.empty() || polygon.loopStart.back() == polygon.points.size());
    Mesh mesh;
    const Outcome outcome = fill(polygon, mesh);
    if (outcome == Outcome::Ok) {
        makeUnique(mesh);
        for (std::uint32_t t = 0; t < mesh.triangleCount; ++t) {
            triangles.insert(triangles.end(), std::begin(mesh.triangles[t].v), std::end(mesh.triangles[t].v));
        }
    }
    return {outcome, kNoEdge, kNoEdge};
}

}  // namespace tri
