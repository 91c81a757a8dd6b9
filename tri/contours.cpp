#include "tri/contours.h"

#include <algorithm>
#include <tuple>
#include <utility>

namespace tri {

namespace {

std::pair<std::uint32_t, std::uint32_t> undirected(const DirectedEdge& edge) {
    return std::minmax(edge.from, edge.to);
}

}  // namespace

void Contours::start(const Mesh& mesh, std::span<const std::uint32_t> busy) {
    std::fill_n(m_next.data(), mesh.vertexCount, kFree);
    std::fill_n(m_previous.data(), mesh.vertexCount, kFree);
    for (const std::uint32_t vertex : busy) {
        m_next[vertex] = kBusy;
        m_previous[vertex] = kBusy;
    }
    m_edgeCount = 0;
    m_shared.clear();
    m_rays.clear();
    m_overlap = {};
}

void Contours::add(const DirectedEdge& edge) {
    const bool isFromBusy = m_next[edge.from] == kBusy;
    const bool isToBusy = m_next[edge.to] == kBusy;
    if (!isFromBusy) {
        m_next[edge.from] = edge.to;
    }
    if (!isToBusy) {
        m_previous[edge.to] = edge.from;
    }
    if (isFromBusy || isToBusy) {
        m_shared.push_back(edge);
    } else {
        ++m_edgeCount;
    }
}

void Contours::settle() {
    addUp();
    m_edgeCount += m_shared.size();
    makeRays();
}

/// Drops runs along the same edge that cancel; what is left over of one edge has one direction.
void Contours::addUp() {
    std::ranges::sort(m_shared, {}, [](const DirectedEdge& e) {
        const auto [low, high] = undirected(e);
        return std::tuple(low, high, e.from, e.edge);
    });
    std::size_t kept = 0;
    for (std::size_t i = 0, end = 0; i < m_shared.size(); i = end) {
        std::size_t forward = 0;  // the run is sorted: edges from the lower vertex come first
        for (end = i; end < m_shared.size() && undirected(m_shared[end]) == undirected(m_shared[i]); ++end) {
            forward += m_shared[end].from < m_shared[end].to ? 1 : 0;
        }
        const std::size_t cancelled = std::min(forward, end - i - forward);
        for (std::size_t k = 0; k < cancelled; ++k) {
            free(m_shared[i + k]);
            free(m_shared[end - 1 - k]);
        }
        if (end - i - 2 * cancelled > 1 && m_overlap.outcome == Outcome::Ok) {
            m_overlap = {Outcome::Crossing, m_shared[i + cancelled].edge, m_shared[i + cancelled + 1].edge};
        }
        for (std::size_t k = i + cancelled; k < end - cancelled; ++k) {
            m_shared[kept++] = m_shared[k];
        }
    }
    m_shared.resize(kept);
}

void Contours::free(const DirectedEdge& edge) {
    m_next[edge.from] = m_next[edge.from] == kBusy ? kBusy : kFree;
    m_previous[edge.to] = m_previous[edge.to] == kBusy ? kBusy : kFree;
}

void Contours::makeRays() {
    for (const DirectedEdge& edge : m_shared) {
        if (m_next[edge.from] == kBusy) {
            m_rays.push_back({edge.from, edge.to, true, edge.edge});
        }
        if (m_next[edge.to] == kBusy) {
            m_rays.push_back({edge.to, edge.from, false, edge.edge});
        }
    }
    std::ranges::sort(m_rays, {}, [](const Ray& ray) { return std::pair(ray.at, ray.other); });
}

void Contours::build(const Polygon& polygon, const Mesh& mesh, const std::uint32_t* vertexOf,
                     std::span<const std::uint32_t> busy) {
    m_next.room(mesh.vertexCount + 4);
    m_previous.room(mesh.vertexCount + 4);
    start(mesh, busy);
    std::fill_n(m_next.data() + mesh.vertexCount, 4, kFree);
    for (std::size_t loop = 0; loop + 1 < polygon.loopStart.size(); ++loop) {
        const std::uint32_t first = polygon.loopStart[loop];
        const std::uint32_t end = polygon.loopStart[loop + 1];
        if (end - first <= 2) {
            continue;  // nothing, a point, or there and back
        }
        std::uint32_t from = vertexOf[end - 1];
        std::uint32_t edge = end - 1;
        for (std::uint32_t i = first; i < end; edge = i++) {
            const std::uint32_t to = vertexOf[i];
            if (from != to) {
                add({from, to, edge});
            }
            from = to;
        }
    }
    settle();
}

void Contours::rebuild(const Mesh& mesh, std::span<const DirectedEdge> edges, std::span<const std::uint32_t> busy) {
    std::vector<std::uint32_t> allBusy(busy.begin(), busy.end());
    for (std::uint32_t vertex = 0; vertex < mesh.vertexCount; ++vertex) {
        if (m_next[vertex] == kBusy) {
            allBusy.push_back(vertex);
        }
    }
    start(mesh, allBusy);
    for (const DirectedEdge& edge : edges) {
        add(edge);
    }
    settle();
}

std::span<const Contours::Ray> Contours::raysAt(std::uint32_t vertex) const {
    const auto first = std::ranges::lower_bound(m_rays, vertex, {}, &Ray::at);
    const auto last = std::ranges::upper_bound(m_rays, vertex, {}, &Ray::at);
    return {first, last};
}

bool Contours::hasRay(std::uint32_t from, std::uint32_t to) const {
    return std::ranges::any_of(raysAt(from), [&](const Ray& ray) { return ray.other == to && ray.isOutgoing; });
}

std::uint32_t Contours::inputEdge(const Mesh& mesh, std::uint32_t from, std::uint32_t to) const {
    if (m_next[from] == to) {
        return mesh.ids[from];
    }
    const std::span<const Ray> rays = raysAt(from);
    const auto found = std::ranges::find_if(rays, [&](const Ray& r) { return r.other == to && r.isOutgoing; });
    return found == rays.end() ? kNoEdge : found->edge;
}

std::uint32_t Contours::anyEdgeAt(const Mesh& mesh, std::uint32_t vertex) const {
    const std::uint32_t next = m_next[vertex];
    if (next == kBusy) {
        const std::span<const Ray> rays = raysAt(vertex);
        return rays.empty() ? kNoEdge : rays.front().edge;
    }
    return next == kFree ? kNoEdge : mesh.ids[vertex];
}

Contours::Side Contours::sideAt(const Mesh& mesh, std::uint32_t a, std::uint32_t b) const {
    const std::uint32_t next = m_next[a];
    if (next == kFree) {
        return Side::Unknown;
    }
    if (next == kBusy) {
        return sideAtBusy(mesh, a, b);
    }
    // The interior is the sector from next counter-clockwise to previous.
    const std::uint32_t previous = m_previous[a];
    if (b == next || b == previous) {
        return b == next ? Side::Inside : Side::Outside;
    }
    const bool isLeftOfNext = mesh.orientation(a, next, b) > 0;
    const bool isRightOfPrevious = mesh.orientation(a, previous, b) < 0;
    const bool isConvex = mesh.orientation(a, next, previous) > 0;
    const bool isInside = isConvex ? isLeftOfNext && isRightOfPrevious : isLeftOfNext || isRightOfPrevious;
    return isInside ? Side::Inside : Side::Outside;
}

Contours::Side Contours::sideAtBusy(const Mesh& mesh, std::uint32_t a, std::uint32_t b) const {
    const Point origin = mesh.points[a];
    // Less than half a turn clockwise from the direction of b?
    const auto isNear = [&](std::uint32_t other) {
        const std::int64_t orientation = mesh.orientation(a, b, other);
        if (orientation != 0) {
            return orientation < 0;
        }
        const Point p = mesh.points[b];
        const Point q = mesh.points[other];
        return (p.x > origin.x) == (q.x > origin.x) && (p.y > origin.y) == (q.y > origin.y);
    };
    const std::span<const Ray> rays = raysAt(a);
    const auto first = std::ranges::min_element(rays, [&](const Ray& r, const Ray& s) {
        const bool isRNear = isNear(r.other);
        return isRNear != isNear(s.other) ? isRNear : mesh.orientation(a, r.other, s.other) < 0;
    });
    if (first == rays.end()) {
        return Side::Unknown;
    }
    return first->isOutgoing ? Side::Inside : Side::Outside;
}

}  // namespace tri
