#include "tri/corridor.h"

#include "model/base/assert.h"
#include "tri/delaunay.h"

namespace tri {

namespace {

/// Corner 3 does not exist: it marks a reference to edge number `triangle()` of a chain instead of one to a triangle.
constexpr std::uint32_t kChainMark = 3;

bool isForward(const Mesh& mesh, std::uint32_t a, std::uint32_t b, std::uint32_t collinear) {
    const Point from = mesh.points[a];
    const Point p = mesh.points[b];
    const Point q = mesh.points[collinear];
    return (p.x > from.x) == (q.x > from.x) && (p.y > from.y) == (q.y > from.y);
}

}  // namespace

TriangleAt trianglesAtVertices(const Mesh& mesh, Scratch<std::uint32_t>& memory) {
    const std::size_t count = std::size_t{mesh.vertexCount} + kBoxCorners;
    const TriangleAt triangleAt(memory.room(count), count);
    for (std::uint32_t t = 0; t < mesh.triangleCount; ++t) {
        for (const std::uint32_t vertex : mesh.triangles[t].v) {
            triangleAt[vertex] = t;
        }
    }
    return triangleAt;
}

Ahead lookAhead(const Mesh& mesh, TriangleAt triangleAt, std::uint32_t a, std::uint32_t b) {
    std::uint32_t at = triangleAt[a];
    for (;;) {
        const Triangle& t = mesh.triangles[at];
        const std::uint32_t corner = t.v[0] == a ? 0 : (t.v[1] == a ? 1 : 2);
        const std::uint32_t right = t.v[kNext[corner]];
        const std::int64_t orientation = mesh.orientation(a, b, right);
        if (orientation == 0 && isForward(mesh, a, b, right)) {
            return {right, kOutside};
        }
        if (orientation < 0 && mesh.orientation(a, b, t.v[kPrevious[corner]]) > 0) {
            return {kNoVertex, EdgeRef::of(at, corner)};
        }
        at = t.across[kNext[corner]].triangle();
    }
}

Ahead lookAhead(const Mesh& mesh, EdgeRef crossed, std::uint32_t a, std::uint32_t b) {
    const EdgeRef entered = mesh.triangles[crossed.triangle()].across[crossed.corner()];
    const std::uint32_t apex = mesh.triangles[entered.triangle()].v[entered.corner()];
    const std::int64_t orientation = mesh.orientation(a, b, apex);
    if (orientation == 0) {
        return {apex, kOutside};
    }
    // Seen from here, corner+1 is the left end of the crossed edge and corner+2 the right one.
    const std::uint32_t corner = orientation > 0 ? kNext[entered.corner()] : kPrevious[entered.corner()];
    return {kNoVertex, EdgeRef::of(entered.triangle(), corner)};
}

std::vector<std::uint32_t> verticesBetween(const Mesh& mesh, TriangleAt triangleAt, std::uint32_t a, std::uint32_t b) {
    std::vector<std::uint32_t> between;
    for (std::uint32_t at = a; at != b; between.push_back(at)) {
        Ahead ahead = lookAhead(mesh, triangleAt, at, b);
        while (ahead.vertex == kNoVertex) {
            ahead = lookAhead(mesh, ahead.edge, at, b);
        }
        at = ahead.vertex;
    }
    if (!between.empty()) {
        between.pop_back();
    }
    return between;
}

void Corridor::begin(const Mesh& mesh, const Ahead& ahead, std::uint32_t a) {
    m_triangles.clear();
    for (Chain* chain : {&m_left, &m_right}) {
        chain->vertices.assign(1, a);
        chain->before.clear();
    }
    if (ahead.vertex != kNoVertex) {
        return;
    }
    const std::uint32_t first = ahead.edge.triangle();
    const std::uint32_t corner = ahead.edge.corner();
    m_triangles.push_back(first);
    m_right.vertices.push_back(mesh.triangles[first].v[kNext[corner]]);
    m_right.before.push_back(EdgeRef::of(first, kPrevious[corner]));
    m_left.vertices.push_back(mesh.triangles[first].v[kPrevious[corner]]);
    m_left.before.push_back(EdgeRef::of(first, kNext[corner]));
}

/// The triangle behind the crossed edge has one more edge on the left or on the right; the last one has both.
void Corridor::extend(const Mesh& mesh, EdgeRef entered, const Ahead& ahead) {
    const std::uint32_t t = entered.triangle();
    const std::uint32_t apex = mesh.triangles[t].v[entered.corner()];
    const std::uint32_t left = kPrevious[entered.corner()];  // edge from the left end of the crossed edge to the apex
    const std::uint32_t right = kNext[entered.corner()];
    const bool isLast = ahead.vertex != kNoVertex;
    m_triangles.push_back(t);
    if (isLast || ahead.edge.corner() == right) {
        m_left.vertices.push_back(apex);
        m_left.before.push_back(EdgeRef::of(t, left));
    }
    if (isLast || ahead.edge.corner() == left) {
        m_right.vertices.push_back(apex);
        m_right.before.push_back(EdgeRef::of(t, right));
    }
}

/// An edge that ends in the open has the corridor on both sides: its other side is an edge of the same chain.
void Corridor::findBeyond(Mesh& mesh, Chain& chain) {
    chain.beyond.clear();
    for (const EdgeRef edge : chain.before) {
        chain.beyond.push_back(mesh.triangles[edge.triangle()].across[edge.corner()]);
    }
    for (std::uint32_t k = 0; k < chain.before.size(); ++k) {
        const EdgeRef edge = chain.before[k];
        mesh.triangles[edge.triangle()].across[edge.corner()] = EdgeRef::of(k, kChainMark);
    }
    for (EdgeRef& beyond : chain.beyond) {
        if (beyond != kOutside) {
            const EdgeRef seenFromThere = mesh.triangles[beyond.triangle()].across[beyond.corner()];
            beyond = seenFromThere.corner() == kChainMark ? seenFromThere : beyond;
        }
    }
}

void Corridor::join(Mesh& mesh, Chain& chain, EdgeRef made, EdgeRef side) {
    if (side.corner() == kChainMark) {
        chain.after[side.triangle()] = made;
    } else {
        mesh.link(made, side);
    }
}

/// Triangulates the area between the chain and the segment like a Graham scan: every vertex of the chain can be seen
/// from the segment, so a corner that turns the right way is an ear. Returns the edge a-b, seen from inside.
EdgeRef Corridor::fill(Mesh& mesh, Chain& chain, bool isLeft) {
    chain.after.resize(chain.before.size());
    m_open.assign(1, {chain.vertices[0], kOutside});
    for (std::uint32_t k = 1; k < chain.vertices.size(); ++k) {
        const std::uint32_t vertex = chain.vertices[k];
        EdgeRef side = EdgeRef::of(k - 1, kChainMark);
        for (; m_open.size() > 1; m_open.pop_back()) {
            const std::uint32_t ear = m_open.back().vertex;
            const std::uint32_t before = m_open[m_open.size() - 2].vertex;
            const std::int64_t orientation = mesh.orientation(before, ear, vertex);
            if (isLeft ? orientation >= 0 : orientation <= 0) {
                break;
            }
            const std::uint32_t made = m_triangles[m_reused++];
            mesh.triangles[made] = {{before, isLeft ? vertex : ear, isLeft ? ear : vertex},
                                    {kOutside, kOutside, kOutside}};
            join(mesh, chain, EdgeRef::of(made, 0), side);
            join(mesh, chain, EdgeRef::of(made, isLeft ? 1 : 2), m_open.back().side);
            side = EdgeRef::of(made, isLeft ? 2 : 1);
        }
        m_open.push_back({vertex, side});
    }
    ASSERT(m_open.size() == 2);
    return m_open.back().side;
}

void Corridor::connect(Mesh& mesh, const Chain& chain) {
    for (std::size_t k = 0; k < chain.after.size(); ++k) {
        const EdgeRef beyond = chain.beyond[k];
        const bool isTwin = beyond != kOutside && beyond.corner() == kChainMark;
        mesh.link(chain.after[k], isTwin ? chain.after[beyond.triangle()] : beyond);
    }
}

void Corridor::rebuild(Mesh& mesh, TriangleAt triangleAt, std::vector<EdgeRef>& dirty) {
    if (m_triangles.empty()) {
        return;
    }
    m_reused = 0;
    findBeyond(mesh, m_left);
    findBeyond(mesh, m_right);
    const EdgeRef left = fill(mesh, m_left, true);
    const EdgeRef right = fill(mesh, m_right, false);
    ASSERT(m_reused == m_triangles.size());
    mesh.link(left, right);
    connect(mesh, m_left);
    connect(mesh, m_right);
    for (const std::uint32_t t : m_triangles) {
        for (std::uint32_t corner = 0; corner < 3; ++corner) {
            triangleAt[mesh.triangles[t].v[corner]] = t;
            dirty.push_back(EdgeRef::of(t, corner));
        }
    }
}

}  // namespace tri
