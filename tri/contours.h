#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "tri/mesh.h"
#include "tri/triangulate.h"

namespace tri {

/// A contour edge between two vertices of a mesh, with the input edge it is (part of).
struct DirectedEdge {
    std::uint32_t from;
    std::uint32_t to;
    std::uint32_t edge;

    bool operator==(const DirectedEdge&) const = default;
};

/// The contours of one polygon as edges between the vertices of a mesh, after runs along the same edge were added up.
///
/// Nearly every vertex has one contour through it: next and previous vertex in two arrays. The few at which contours
/// touch (repeated positions, vertices inside an edge) are "busy": next is kBusy, and their edges are rays in a sorted
/// list. A vertex whose edges all cancelled has kFree and lies inside or outside like any point.
class Contours {
public:
    static constexpr std::uint32_t kFree = 0xFFFFFFFF;
    static constexpr std::uint32_t kBusy = 0xFFFFFFFE;

    /// An end of a contour edge at a busy vertex.
    struct Ray {
        std::uint32_t at;
        std::uint32_t other;
        bool isOutgoing;
        std::uint32_t edge;
    };

    /// Takes over the loops. `vertexOf` gives the vertex per index; `busy` are the vertices that several indices share.
    void build(const Polygon& polygon, const Mesh& mesh, const std::uint32_t* vertexOf,
               std::span<const std::uint32_t> busy);

    /// Replaces everything by `edges` and adds them up again; `busy` vertices become so in addition to those that are.
    void rebuild(const Mesh& mesh, std::span<const DirectedEdge> edges, std::span<const std::uint32_t> busy);

    /// How many edges are left after adding up.
    [[nodiscard]] std::size_t edgeCount() const { return m_edgeCount; }
    template <class Visit>
    void forEachEdge(const Mesh& mesh, const Visit& visit) const {
        std::ranges::for_each(m_shared, visit);
        for (std::uint32_t from = 0; from < mesh.vertexCount; ++from) {
            const std::uint32_t to = m_next[from];
            if (to != kFree && to != kBusy && m_next[to] != kBusy) {
                visit(DirectedEdge{from, to, mesh.ids[from]});
            }
        }
    }
    /// Crossing if two edges that are left run along each other in the same direction. They may still cancel with the
    /// piece of a third one that is not yet split at its vertices.
    [[nodiscard]] const Status& overlap() const { return m_overlap; }
    /// The contours as they are kept: the vertices after and before this one, or kFree or kBusy; and the ends of edges
    /// at busy vertices, sorted by vertex.
    [[nodiscard]] std::uint32_t nextOf(std::uint32_t vertex) const { return m_next[vertex]; }
    [[nodiscard]] std::uint32_t previousOf(std::uint32_t vertex) const { return m_previous[vertex]; }
    [[nodiscard]] std::span<const Ray> rays() const { return m_rays; }

    /// Do several contours touch at this vertex, or did they?
    [[nodiscard]] bool isBusy(std::uint32_t vertex) const { return m_next[vertex] == kBusy; }

    /// Does a contour run from `from` to `to`? Vertices beyond the polygon's (bounding corners) are free.
    [[nodiscard]] bool has(std::uint32_t from, std::uint32_t to) const {
        const std::uint32_t next = m_next[from];
        return next == to || (next == kBusy && hasRay(from, to));
    }
    [[nodiscard]] bool hasEither(std::uint32_t a, std::uint32_t b) const { return has(a, b) || has(b, a); }
    /// The input edge of a contour edge that is there.
    [[nodiscard]] std::uint32_t inputEdge(const Mesh& mesh, std::uint32_t from, std::uint32_t to) const;
    /// Any contour edge at a vertex; kNoEdge if it is free.
    [[nodiscard]] std::uint32_t anyEdgeAt(const Mesh& mesh, std::uint32_t vertex) const;

    /// Is the location right beside a, in the direction of b, inside? Finds the first contour clockwise from a→b:
    /// if it leaves a, the location lies to its left. For contours that are edges of the triangulation and a triangle
    /// to the left of its edge a→b.
    enum class Side : std::uint8_t { Outside, Inside, Unknown };
    [[nodiscard]] Side sideAt(const Mesh& mesh, std::uint32_t a, std::uint32_t b) const;

    /// Bytes of working memory.
    [[nodiscard]] std::size_t bytes() const { return m_next.bytes() + m_previous.bytes(); }

private:
    void start(const Mesh& mesh, std::span<const std::uint32_t> busy);
    void add(const DirectedEdge& edge);
    void settle();
    void addUp();
    void free(const DirectedEdge& edge);
    void makeRays();
    [[nodiscard]] std::span<const Ray> raysAt(std::uint32_t vertex) const;
    [[nodiscard]] bool hasRay(std::uint32_t from, std::uint32_t to) const;
    [[nodiscard]] Side sideAtBusy(const Mesh& mesh, std::uint32_t a, std::uint32_t b) const;

    Scratch<std::uint32_t> m_next;
    Scratch<std::uint32_t> m_previous;
    std::size_t m_edgeCount = 0;
    std::vector<DirectedEdge> m_shared;  ///< edges with a busy end
    std::vector<Ray> m_rays;             ///< their ends at busy vertices, sorted by vertex
    Status m_overlap;
};

}  // namespace tri
