#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "tri/mesh.h"

namespace tri {

/// A triangle at every vertex. Kept right while corridors are rebuilt, so that missing edges can start anywhere.
using TriangleAt = std::span<std::uint32_t>;
/// In `memory`.
[[nodiscard]] TriangleAt trianglesAtVertices(const Mesh& mesh, Scratch<std::uint32_t>& memory);

inline constexpr std::uint32_t kNoVertex = 0xFFFFFFFF;

/// The next item on the straight line from vertex a to vertex b: a vertex, or an edge to cross.
struct Ahead {
    std::uint32_t vertex;
    EdgeRef edge;  ///< if vertex is kNoVertex: seen from the near side, corner+1 is right and corner+2 left of the path
};

/// What is ahead at a itself; its vertex is b if the edge a-b exists.
[[nodiscard]] Ahead lookAhead(const Mesh& mesh, TriangleAt triangleAt, std::uint32_t a, std::uint32_t b);

/// What is ahead after crossing an edge.
[[nodiscard]] Ahead lookAhead(const Mesh& mesh, EdgeRef crossed, std::uint32_t a, std::uint32_t b);

/// Vertices strictly between a and b on the segment, in order.
[[nodiscard]] std::vector<std::uint32_t> verticesBetween(const Mesh& mesh, TriangleAt triangleAt, std::uint32_t a,
                                                         std::uint32_t b);

/// The triangles that the segment from vertex a to vertex b crosses, and what borders on them.
class Corridor {
public:
    enum class Course : std::uint8_t {
        Clear,    ///< to b across triangles only
        Blocked,  ///< runs into a vertex before b, or would cross an edge that has to stay
    };

    /// Walks from a to b. `isFixed(u, v)` says which edges have to stay.
    template <class IsFixed>
    [[nodiscard]] Course explore(const Mesh& mesh, TriangleAt triangleAt, std::uint32_t a, std::uint32_t b,
                                 const IsFixed& isFixed) {
        m_blocking = kOutside;
        Ahead ahead = lookAhead(mesh, triangleAt, a, b);
        begin(mesh, ahead, a);
        while (ahead.vertex == kNoVertex) {
            const Triangle& t = mesh.triangles[ahead.edge.triangle()];
            if (isFixed(t.v[kNext[ahead.edge.corner()]], t.v[kPrevious[ahead.edge.corner()]])) {
                m_blocking = ahead.edge;
                return Course::Blocked;
            }
            const EdgeRef entered = t.across[ahead.edge.corner()];
            ahead = lookAhead(mesh, ahead.edge, a, b);
            extend(mesh, entered, ahead);
        }
        return ahead.vertex == b ? Course::Clear : Course::Blocked;
    }

    /// The edge that has to stay and stopped explore(); kOutside if it was a vertex.
    [[nodiscard]] EdgeRef blockingEdge() const { return m_blocking; }

    /// After a clear course: replaces the triangles by others that have the edge a-b, and keeps `triangleAt` right.
    /// Appends the edges of the new triangles to `dirty`. Nothing happens if the edge is there already.
    void rebuild(Mesh& mesh, TriangleAt triangleAt, std::vector<EdgeRef>& dirty);

private:
    /// One side of the corridor: the vertices from a to b, and what happens to the edges between them.
    struct Chain {
        std::vector<std::uint32_t> vertices;
        std::vector<EdgeRef> before;  ///< the edge, seen from the triangle in the corridor
        std::vector<EdgeRef> beyond;  ///< its other side
        std::vector<EdgeRef> after;   ///< the edge, seen from the triangle that replaces it
    };
    struct Open {
        std::uint32_t vertex;
        EdgeRef side;  ///< where the edge towards the vertex before is to be linked
    };

    void begin(const Mesh& mesh, const Ahead& ahead, std::uint32_t a);
    void extend(const Mesh& mesh, EdgeRef entered, const Ahead& ahead);
    static void findBeyond(Mesh& mesh, Chain& chain);
    EdgeRef fill(Mesh& mesh, Chain& chain, bool isLeft);
    static void join(Mesh& mesh, Chain& chain, EdgeRef made, EdgeRef side);
    static void connect(Mesh& mesh, const Chain& chain);

    std::vector<std::uint32_t> m_triangles;
    std::size_t m_reused = 0;
    Chain m_left;
    Chain m_right;
    std::vector<Open> m_open;
    EdgeRef m_blocking = kOutside;
};

}  // namespace tri
