#include "tri/constraints.h"

#include <algorithm>
#include <bit>
#include <numeric>
#include <vector>

#include "model/base/assert.h"
#include "tri/corridor.h"
#include "tri/delaunay.h"

namespace tri {

namespace {

/// Counts the contour edges that are edges of the mesh: every one is a directed edge of the triangle to its left. Marks
/// the vertices where they start; not the busy ones, where several may start.
std::size_t markPresent(const Mesh& mesh, const Contours& contours, Cores cores, std::uint8_t* isStart) {
    std::fill_n(isStart, mesh.vertexCount + kBoxCorners, std::uint8_t{0});
    const std::uint64_t pieces = piecesFor(cores);
    std::vector<std::size_t> counts(pieces, 0);
    forEach(cores, pieces, [&](std::size_t piece) {
        std::size_t count = 0;
        const std::size_t end = mesh.triangleCount * (piece + 1) / pieces;
        for (std::size_t t = mesh.triangleCount * piece / pieces; t < end; ++t) {
            const auto& v = mesh.triangles[t].v;
            for (std::uint32_t i = 0; i < 3; ++i) {
                if (contours.has(v[i], v[kNext[i]])) {
                    ++count;
                    if (!contours.isBusy(v[i])) {
                        isStart[v[i]] = 1;
                    }
                }
            }
        }
        counts[piece] = count;
    });
    return std::accumulate(counts.begin(), counts.end(), std::size_t{0});
}

/// Edges that flips and corridors leave alone.
struct IsContour {
    const Contours& contours;
    bool operator()(std::uint32_t a, std::uint32_t b) const { return contours.hasEither(a, b); }
};

class Inserter {
public:
    Inserter(Mesh& mesh, Contours& contours, Scratch<std::uint32_t>& memory)
        : m_mesh(mesh), m_contours(contours), m_triangleAt(trianglesAtVertices(mesh, memory)) {}

    /// `isStart`: from which vertices, of those that are not busy, the contour edge is there.
    Status run(const std::uint8_t* isStart) {
        // First whatever can be inserted as it is. What is blocked may run through vertices, and what blocks it may
        // cancel once it is split there; so crossings count only the second time.
        std::vector<DirectedEdge> edges;
        m_contours.forEachEdge(m_mesh, [&](const DirectedEdge& edge) {
            if (isStart[edge.from] == 0) {
                edges.push_back(edge);
            }
        });
        const std::vector<DirectedEdge> blocked = insert(edges);
        if (m_isCertain) {
            return m_crossing;
        }
        const std::vector<DirectedEdge> pieces = blocked.empty() ? blocked : split(blocked);
        if (m_contours.overlap().outcome != Outcome::Ok) {
            return m_contours.overlap();
        }
        if (!insert(pieces).empty()) {
            return m_crossing;
        }
        restoreDelaunay(m_mesh, m_dirty, IsContour{m_contours});
        return {};
    }

private:
    /// Inserts the edges that are (still) contours and not there yet. Returns those that are blocked; m_crossing says
    /// about the last of them. Stops at a crossing that is certain.
    std::vector<DirectedEdge> insert(const std::vector<DirectedEdge>& edges) {
        std::vector<DirectedEdge> blocked;
        for (const DirectedEdge& edge : edges) {
            if (!m_contours.has(edge.from, edge.to)) {
                continue;
            }
            if (m_corridor.explore(m_mesh, m_triangleAt, edge.from, edge.to, IsContour{m_contours}) ==
                Corridor::Course::Clear) {
                m_corridor.rebuild(m_mesh, m_triangleAt, m_dirty);
            } else {
                blocked.push_back(edge);
                m_crossing = {Outcome::Crossing, edge.edge, nameOf(m_corridor.blockingEdge())};
                if (isCertainlyCrossing(edge, m_corridor.blockingEdge())) {
                    m_isCertain = true;
                    break;
                }
            }
        }
        return blocked;
    }

    /// What two edges do that meet between their ends is a crossing, unless another run along one of them cancels it
    /// there. Looking for one takes a pass over all contours, so only the 1st, 2nd, 4th, 8th, ... meeting is tested:
    /// enough to stop soon where everything crosses everything.
    bool isCertainlyCrossing(const DirectedEdge& edge, EdgeRef blocking) {
        if (blocking == kOutside || !std::has_single_bit(++m_meetings)) {
            return false;
        }
        const Triangle& t = m_mesh.triangles[blocking.triangle()];
        return !hasCompany(edge.from, edge.to) &&
               !hasCompany(t.v[kNext[blocking.corner()]], t.v[kPrevious[blocking.corner()]]);
    }

    /// Does any other contour run along a part of this one?
    [[nodiscard]] bool hasCompany(std::uint32_t from, std::uint32_t to) const {
        const Point low = std::min(m_mesh.points[from], m_mesh.points[to]);
        const Point high = std::max(m_mesh.points[from], m_mesh.points[to]);
        bool found = false;
        m_contours.forEachEdge(m_mesh, [&](const DirectedEdge& other) {
            const auto [otherLow, otherHigh] = std::minmax(m_mesh.points[other.from], m_mesh.points[other.to]);
            const bool isSame = otherLow == low && otherHigh == high;
            found = found || (!isSame && m_mesh.orientation(from, to, other.from) == 0 &&
                              m_mesh.orientation(from, to, other.to) == 0 &&
                              std::max(low, otherLow) < std::min(high, otherHigh));
        });
        return found;
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
        std::vector<DirectedEdge> all = pieces;
        std::ranges::sort(blocked, {}, &DirectedEdge::edge);
        m_contours.forEachEdge(m_mesh, [&](const DirectedEdge& edge) {
            if (!std::ranges::binary_search(blocked, edge.edge, {}, &DirectedEdge::edge)) {
                all.push_back(edge);
            }
        });
        m_contours.rebuild(m_mesh, all, touched);
        return pieces;
    }

    Mesh& m_mesh;
    Contours& m_contours;
    TriangleAt m_triangleAt;
    Corridor m_corridor;
    std::vector<EdgeRef> m_dirty;
    Status m_crossing;
    std::uint64_t m_meetings = 0;  ///< of an edge with one that has to stay
    bool m_isCertain = false;
};

}  // namespace

Status insertContours(Mesh& mesh, Contours& contours, Cores cores, Scratch<std::uint8_t>& scratch,
                      Scratch<std::uint32_t>& vertexScratch) {
    std::uint8_t* isStart = scratch.room(mesh.vertexCount + kBoxCorners);
    if (markPresent(mesh, contours, cores, isStart) == contours.edgeCount()) {
        return {};
    }
    return Inserter(mesh, contours, vertexScratch).run(isStart);
}

}  // namespace tri
