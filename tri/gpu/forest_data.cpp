#include "tri/gpu/forest_data.h"

#include <algorithm>
#include <numeric>

#include "model/base/assert.h"
#include "model/base/parallel.h"
#include "tri/delaunay.h"
#include "tri/workspace.h"

namespace tri::gpu {

namespace kernel = shader::tri;

namespace {

static_assert(kernel::kFree == Contours::kFree && kernel::kBusy == Contours::kBusy);

/// Words of scratch memory per vertex, for the corridors that are rebuilt in one step.
constexpr std::size_t kScratchPerVertex = 8;
constexpr std::size_t kMinScratch = 1U << 16;

/// What one polygon needs besides its places in the columns.
struct Sapling {
    std::size_t polygon = 0;
    std::uint32_t firstVertex = 0;
    std::uint32_t vertexCount = 0;  ///< 0: it is no tree
    std::vector<Contours::Ray> rays;
};

class Planter {
public:
    Planter(std::span<const Polygon> polygons, Eraser eraser) : m_polygons(polygons) { m_data.eraser = eraser; }

    ForestData run() {
        order();
        base::parallelFor(m_saplings.size(), [&](std::size_t i) { plantOne(m_saplings[i], i); });
        for (std::size_t i = 0; i < m_saplings.size(); ++i) {
            addTree(m_saplings[i]);
        }
        return std::move(m_data);
    }

private:
    /// Saplings of all polygons with so many points. Returns how many those are.
    std::uint32_t addSaplings(std::size_t least, std::size_t most, std::uint32_t& vertices) {
        const std::size_t before = m_saplings.size();
        for (std::size_t i = 0; i < m_polygons.size(); ++i) {
            const std::size_t count = m_polygons[i].points.size();
            if (count >= least && count <= most) {
                m_saplings.push_back({i, vertices, 0, {}});
                vertices += static_cast<std::uint32_t>(count + kBoxCorners);
            }
        }
        return static_cast<std::uint32_t>(m_saplings.size() - before);
    }

    /// By size, as each has its kernel.
    void order() {
        std::uint32_t vertices = 0;
        m_data.tinyTrees = addSaplings(0, kernel::kTinyVertices, vertices);
        m_data.smallTrees = addSaplings(kernel::kTinyVertices + 1, kernel::kSmallVertices, vertices);
        static_cast<void>(addSaplings(kernel::kSmallVertices + 1, kMaxForestVertices, vertices));
        m_data.points.resize(vertices);
        m_data.ids.assign(vertices, kernel::kBoxIds);
        m_data.treeOf.resize(vertices);
        m_data.loops.resize(vertices);
        m_data.next.assign(vertices, kernel::kFree);
        m_data.previous.assign(vertices, kernel::kFree);
    }

    void plantOne(Sapling& sapling, std::size_t tree) {
        thread_local Workspace kept;
        const Polygon& polygon = m_polygons[sapling.polygon];
        std::fill_n(m_data.treeOf.begin() + sapling.firstVertex, polygon.points.size() + kBoxCorners,
                    static_cast<std::uint32_t>(tree));
        // Contours that run along each other may still cancel with others: the sequential triangulator finds out.
        const Cores cores = coresFor(polygon.points.size());
        Workspace own;  // while a thread waits for others it may be given another polygon
        Workspace& workspace = cores == Cores::One ? kept : own;
        if (workspace.start(polygon, cores).outcome == Outcome::Ok &&
            workspace.contours.overlap().outcome == Outcome::Ok) {
            startInBox(workspace.mesh);
            takeOver(workspace, sapling, polygon);
        }
        workspace.trim();
    }

    void takeOver(const Workspace& workspace, Sapling& sapling, const Polygon& polygon) {
        const Mesh& mesh = workspace.mesh;
        const std::uint32_t first = sapling.firstVertex;
        const auto numbered = [&](std::uint32_t vertex) { return vertex < kernel::kBusy ? first + vertex : vertex; };
        sapling.vertexCount = mesh.vertexCount;
        for (std::uint32_t v = 0; v < mesh.vertexCount + kBoxCorners; ++v) {
            m_data.points[first + v] = {mesh.points[v].x, mesh.points[v].y};
            m_data.ids[first + v] = mesh.ids[v];
            m_data.next[first + v] = numbered(workspace.contours.nextOf(v));
        }
        for (std::uint32_t v = 0; v < mesh.vertexCount; ++v) {
            m_data.previous[first + v] = numbered(workspace.contours.previousOf(v));
        }
        for (std::uint32_t loop = 0; loop + 1 < polygon.loopStart.size(); ++loop) {
            for (std::uint32_t i = polygon.loopStart[loop]; i < polygon.loopStart[loop + 1]; ++i) {
                m_data.loops[first + workspace.vertexOf[i]] = loop;
            }
        }
        sapling.rays.assign(workspace.contours.rays().begin(), workspace.contours.rays().end());
    }

    /// Rays are few: one after the other.
    void addTree(const Sapling& sapling) {
        const std::uint32_t firstRay = m_data.rayCount();
        for (const Contours::Ray& ray : sapling.rays) {
            std::uint32_t& previous = m_data.previous[sapling.firstVertex + ray.at];
            previous = previous == kernel::kBusy ? m_data.rayCount() : previous;
            m_data.rays.insert(m_data.rays.end(), {sapling.firstVertex + ray.at, sapling.firstVertex + ray.other,
                                                   ray.isOutgoing ? 1U : 0U});
        }
        m_data.trees.push_back({sapling.firstVertex, sapling.vertexCount, firstRay,
                                static_cast<std::uint32_t>(sapling.rays.size()),
                                sapling.vertexCount == 0 ? kernel::kFlagNoTree : 0, 0});
        m_data.polygonOf.push_back(sapling.polygon);
        m_data.control.total += sapling.vertexCount;
    }

    std::span<const Polygon> m_polygons;
    std::vector<Sapling> m_saplings;
    ForestData m_data;
};

}  // namespace

std::size_t forestVertices(std::span<const Polygon> polygons) {
    return std::accumulate(polygons.begin(), polygons.end(), std::size_t{0},
                           [](std::size_t sum, const Polygon& p) { return sum + p.points.size() + kBoxCorners; });
}

ForestData plant(std::span<const Polygon> polygons, Eraser eraser) {
    ASSERT(forestVertices(polygons) < kMaxForestVertices);
    return Planter(polygons, eraser).run();
}

kernel::Forest recordOf(const ForestData& data) {
    kernel::Forest forest{};
    forest.vertexCount = data.vertexCount();
    forest.treeCount = static_cast<std::uint32_t>(data.trees.size());
    forest.rayCount = data.rayCount();
    forest.scratchSize = static_cast<std::uint32_t>(std::max(kMinScratch, kScratchPerVertex * data.points.size()));
    forest.eraser = data.eraser == Eraser::Loop ? kernel::kEraseByLoop : kernel::kEraseBySector;
    forest.tinyTrees = data.tinyTrees;
    forest.smallTrees = data.smallTrees;
    return forest;
}

std::vector<Column> columnsOf(const ForestData& data) {
    const kernel::Forest record = recordOf(data);
    const std::size_t perVertex = sizeof(std::uint32_t) * record.vertexCount;
    const std::size_t perTriangle = 2 * perVertex;
    const std::size_t perEdge = perVertex + sizeof(std::uint32_t) * record.rayCount;
    const std::size_t blocks = (2 * std::size_t{record.vertexCount} + kernel::kBlockSize - 1) / kernel::kBlockSize;
    using kernel::Forest;
    return {
        {"control", offsetof(Forest, control), sizeof(kernel::Control), &data.control},
        {"trees", offsetof(Forest, trees), sizeof(kernel::Tree) * data.trees.size(), data.trees.data()},
        {"points", offsetof(Forest, points), 2 * perVertex, data.points.data()},
        {"ids", offsetof(Forest, ids), perVertex, data.ids.data()},
        {"trees of vertices", offsetof(Forest, treeOf), perVertex, data.treeOf.data()},
        {"loops", offsetof(Forest, loops), perVertex, data.loops.data()},
        {"next", offsetof(Forest, next), perVertex, data.next.data()},
        {"previous", offsetof(Forest, previous), perVertex, data.previous.data()},
        {"where", offsetof(Forest, where), perVertex, nullptr},
        {"note", offsetof(Forest, note), perVertex, nullptr},
        {"triangles", offsetof(Forest, triangles), 2 * sizeof(kernel::Triangle) * record.vertexCount, nullptr},
        {"moved", offsetof(Forest, moved), 3 * perTriangle, nullptr},
        {"best", offsetof(Forest, best), perTriangle, nullptr},
        {"claim", offsetof(Forest, claim), perTriangle, nullptr},
        {"state", offsetof(Forest, state), perTriangle, nullptr},
        {"rays", offsetof(Forest, rays), sizeof(std::uint32_t) * data.rays.size(), data.rays.data()},
        {"found", offsetof(Forest, found), perEdge, nullptr},
        {"corridor", offsetof(Forest, corridor), perEdge, nullptr},
        {"scratch", offsetof(Forest, scratch), sizeof(std::uint32_t) * record.scratchSize, nullptr},
        {"sums", offsetof(Forest, sums), sizeof(std::uint32_t) * blocks, nullptr},
        {"kept", offsetof(Forest, kept), 3 * perTriangle, nullptr},
    };
}

}  // namespace tri::gpu
