#include "tri/constraints.h"

#include <algorithm>
#include <vector>

#include "model/base/assert.h"
#include "tri/corridor.h"
#include "tri/delaunay.h"

namespace tri {

namespace {

/// How many contour edges are edges of the mesh: every one is a directed edge of the triangle to its left.
std::size_t countPresent(const Mesh& mesh, const Contours& contours) {
    std::size_t count = 0;
    for (std::uint32_t t = 0; t < mesh.triangleCount; ++t) {
        const auto& v = mesh.triangles[t].v;
        count += std::size_t{contours.has(v[0], v[1])} + contours.has(v[1], v[2]) + contours.has(v[2], v[0]);
    }
    return count;
}

/// Edges that flips and corridors leave alone.
struct IsContour {
    const Contours& contours;
    bool operator()(std::uint32_t a, std::uint32_t b) const { return contours.hasEither(a, b); }
};

class Inserter {
public:
    Inserter(Mesh& mesh, Contours& contours)
        : m_mesh(mesh), m_contours(contours), m_triangleAt(trianglesAtVertices(mesh)) {}

    Status run() {
        // First whatever can be inserted as it is. What is blocked may run through vertices, and what blocks it may
        // cancel once it is split there; so crossings count only the second time.
        const std::vector<DirectedEdge> blocked = insert(missing(m_contours.edges(m_mesh)));
        const std::vector<DirectedEdge> pieces = blocked.empty() ? blocked : split(blocked);
        if (m_contours.overlap().outcome != Outcome::Ok) {
            return m_contours.overlap();
        }
        if (!insert(missing(pieces)).empty()) {
            return m_crossing;
        }
        restoreDelaunay(m_mesh, m_dirty, IsContour{m_contours});
        return {};
    }

private:
    /// Those that are contours and not yet edges.
    [[nodiscard]] std::vector<DirectedEdge> missing(std::vector<DirectedEdge> edges) const {
        if (edges.empty()) {
            return edges;
        }
        std::vector<bool> starts(m_mesh.vertexCount, false);
        for (std::uint32_t t = 0; t < m_mesh.triangleCount; ++t) {
            const auto& v = m_mesh.triangles[t].v;
            for (std::uint32_t i = 0; i < 3; ++i) {
                if (m_contours.has(v[i], v[kNext[i]])) {
                    starts[v[i]] = true;
                }
            }
        }
        std::erase_if(edges, [&](const DirectedEdge& edge) {
            const bool isPresent =
                starts[edge.from] && (!m_contours.isBusy(edge.from) ||
                                      lookAhead(m_mesh, m_triangleAt, edge.from, edge.to).vertex == edge.to);
            return isPresent || !m_contours.has(edge.from, edge.to);
        });
        return edges;
    }

    /// Returns those that are blocked; m_crossing tells about the last of them.
    std::vector<DirectedEdge> insert(const std::vector<DirectedEdge>& edges) {
        std::vector<DirectedEdge> blocked;
        for (const DirectedEdge& edge : edges) {
            if (m_corridor.explore(m_mesh, m_triangleAt, edge.from, edge.to, IsContour{m_contours}) ==
                Corridor::Way::Clear) {
                m_corridor.rebuild(m_mesh, m_triangleAt, m_dirty);
            } else {
                blocked.push_back(edge);
                m_crossing = {Outcome::Crossing, edge.edge, nameOf(m_corridor.blockingEdge())};
            }
        }
        return blocked;
    }

    [[nodiscard]] std::uint32_t nameOf(EdgeRef edge) const {
        if (edge == kOutside) {
            return kNoEdge;
        }
        const Triangle& t = m_mesh.triangles[edge.triangle()];
        const std::uint32_t a = t.v[kNext[edge.corner()]];
        const std::uint32_t b = t.v[kPrevious[edge.corner()]];
        return m_contours.has(a, b) ? m_contours.inputEdge(m_mesh, a, b) : m_contours.inputEdge(m_mesh, b, a);
    }

    /// Cuts the edges at the vertices they run through, and adds all contours up again. Returns the pieces.
    std::vector<DirectedEdge> split(std::vector<DirectedEdge> blocked) {
        std::vector<DirectedEdge> pieces;
        std::vector<std::uint32_t> touched;
        for (const DirectedEdge& edge : blocked) {
            std::uint32_t from = edge.from;
            for (const std::uint32_t vertex : verticesBetween(m_mesh, m_triangleAt, edge.from, edge.to)) {
                pieces.push_back({from, vertex, edge.edge});
                touched.push_back(vertex);
                from = vertex;
            }
            pieces.push_back({from, edge.to, edge.edge});
        }
        std::vector<DirectedEdge> all = m_contours.edges(m_mesh);
        std::ranges::sort(blocked, {}, &DirectedEdge::edge);
        std::erase_if(all, [&](const DirectedEdge& edge) {
            return std::ranges::binary_search(blocked, edge.edge, {}, &DirectedEdge::edge);
        });
        all.insert(all.end(), pieces.begin(), pieces.end());
        m_contours.rebuild(m_mesh, all, touched);
        return pieces;
    }

    Mesh& m_mesh;
    Contours& m_contours;
    TriangleAt m_triangleAt;
    Corridor m_corridor;
    std::vector<EdgeRef> m_dirty;
    Status m_crossing;
};

}  // namespace

Status insertContours(Mesh& mesh, Contours& contours) {
    if (countPresent(mesh, contours) == contours.edgeCount()) {
        return {};
    }
    return Inserter(mesh, contours).run();
}

}  // namespace tri
