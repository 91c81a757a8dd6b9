#include "tri/cdt.h"

#include <algorithm>
#include <atomic>
#include <bit>
#include <thread>

#include "model/base/parallel.h"
#include "tri/delaunay.h"
#include "tri/insertion.h"
#include "tri/insertion_order.h"
#include "tri/workspace.h"

namespace tri {

namespace {

/// Below this many vertices a round is not worth cutting: the parts would be all border.
constexpr std::uint32_t kMinRound = 16384;
constexpr std::uint32_t kMinPart = 2048;
constexpr std::uint32_t kMaxParts = 64;

/// Inserts vertices one after the other.
void insertRun(Mesh& mesh, std::uint32_t first, std::uint32_t end) {
    Insertion insertion(mesh, Everywhere{}, 0);
    for (std::uint32_t q = first; q < end; ++q, mesh.triangleCount += 2) {
        insertion.insert(q, mesh.triangleCount);
    }
}

/// A triangle of the mesh near every stretch of the Hilbert curve, to start walks at: entries are triangle numbers.
class Homes {
public:
    static constexpr std::uint32_t kNone = 0xFFFFFFFF;

    explicit Homes(std::uint32_t triangleCount)
        : m_shift(32 - std::clamp(static_cast<int>(std::bit_width(triangleCount / kTrianglesPerHome)), 1, 24)),
          m_triangles(std::size_t{1} << (32 - m_shift), kNone) {}

    /// Any of the triangles that are added for a stretch stays; tasks may add at the same time.
    void add(std::uint32_t key, std::uint32_t triangle) {
        std::atomic_ref(m_triangles[key >> m_shift]).store(triangle, std::memory_order_relaxed);
    }
    /// kNone if no triangle starts on this stretch.
    [[nodiscard]] std::uint32_t near(std::uint32_t key) const { return m_triangles[key >> m_shift]; }

private:
    static constexpr std::uint32_t kTrianglesPerHome = 16;
    int m_shift;
    std::vector<std::uint32_t> m_triangles;
};

/// One round of the insertion order, cut into parts.
class Round {
public:
    Round(Mesh& mesh, const HilbertGrid& grid, Scratch<std::uint8_t>& partOf, std::uint32_t first, std::uint32_t end)
        : m_mesh(mesh), m_grid(grid), m_partOf(partOf), m_homes(mesh.triangleCount), m_first(first), m_end(end) {
        const std::uint32_t wanted = 4 * std::max(1U, std::thread::hardware_concurrency());
        m_parts = std::clamp(std::min(wanted, (end - first) / kMinPart), 1U, kMaxParts);
        for (std::uint32_t part = 0; part < m_parts; ++part) {
            m_firstKey.push_back(m_grid.keyOf(m_mesh.points[firstOf(part)]));
        }
    }

    void run() {
        cutMesh();
        std::vector<std::vector<std::uint32_t>> left(m_parts);
        std::vector<std::uint32_t> used(m_parts);
        base::parallelFor(
            m_parts, [&](std::size_t part) { used[part] = insertPart(static_cast<std::uint32_t>(part), left[part]); });
        insertLeft(left, used);
        m_mesh.triangleCount += 2 * (m_end - m_first);
    }

private:
    [[nodiscard]] std::uint32_t firstOf(std::uint32_t part) const {
        return m_first + static_cast<std::uint32_t>(std::uint64_t{m_end - m_first} * part / m_parts);
    }
    /// Two triangle slots per vertex, after those of the rounds before.
    [[nodiscard]] std::uint32_t slotOf(std::uint32_t vertex) const {
        return m_mesh.triangleCount + 2 * (vertex - m_first);
    }
    [[nodiscard]] std::uint8_t partOfKey(std::uint32_t key) const {
        const auto above = std::upper_bound(m_firstKey.begin() + 1, m_firstKey.end(), key);
        return static_cast<std::uint8_t>(above - m_firstKey.begin() - 1);
    }

    /// A triangle belongs to the part on whose stretch of the curve its first corner lies.
    void cutMesh() {
        const std::uint64_t pieces = piecesFor(Cores::All);
        base::parallelFor(pieces, [&](std::size_t piece) {
            const std::size_t end = m_mesh.triangleCount * (piece + 1) / pieces;
            for (std::size_t t = m_mesh.triangleCount * piece / pieces; t < end; ++t) {
                const std::uint32_t key = m_grid.keyOf(m_mesh.points[m_mesh.triangles[t].v[0]]);
                m_partOf[t] = partOfKey(key);
                m_homes.add(key, static_cast<std::uint32_t>(t));
            }
        });
    }

    /// Inserts what can be inserted within the part; `left` gets the others. Returns how many slots were used.
    std::uint32_t insertPart(std::uint32_t part, std::vector<std::uint32_t>& left) {
        const std::uint32_t first = firstOf(part);
        const std::uint32_t end = firstOf(part + 1);
        std::uint32_t slot = slotOf(first);
        const Within area{m_partOf.data(), static_cast<std::uint8_t>(part)};
        Insertion insertion(m_mesh, area, Homes::kNone);
        bool isLost = true;  // a walk that ended at the border would start the next one there, maybe in a nook
        for (std::uint32_t q = first; q < end; ++q) {
            isLost = (isLost && !goHome(insertion, area, q)) || !insertion.insert(q, slot);
            if (isLost) {
                left.push_back(q);
            } else {
                slot += 2;
            }
        }
        return slot - slotOf(first);
    }

    /// Finds the vertex from a triangle of the area near it; false if there is none.
    bool goHome(Insertion<Within>& insertion, const Within& area, std::uint32_t vertex) const {
        const std::uint32_t home = m_homes.near(m_grid.keyOf(m_mesh.points[vertex]));
        if (home == Homes::kNone || !area.has(home)) {
            return false;
        }
        insertion.restart(home);
        return true;
    }

    /// The vertices that were left fill the slots that were left.
    void insertLeft(const std::vector<std::vector<std::uint32_t>>& left, const std::vector<std::uint32_t>& used) {
        Insertion insertion(m_mesh, Everywhere{}, 0);
        for (std::uint32_t part = 0; part < m_parts; ++part) {
            std::uint32_t slot = slotOf(firstOf(part)) + used[part];
            for (const std::uint32_t q : left[part]) {
                insertion.insert(q, slot);
                slot += 2;
            }
        }
    }

    Mesh& m_mesh;
    const HilbertGrid& m_grid;
    Scratch<std::uint8_t>& m_partOf;
    Homes m_homes;
    std::uint32_t m_first;
    std::uint32_t m_end;
    std::uint32_t m_parts = 1;
    std::vector<std::uint32_t> m_firstKey;
};

void insertRounds(Workspace& workspace) {
    Mesh& mesh = workspace.mesh;
    base::Box box;
    for (std::uint32_t i = 0; i < mesh.vertexCount; ++i) {
        box.include(mesh.points[i]);
    }
    const HilbertGrid grid(box);
    workspace.states.room(2 * (std::size_t{mesh.vertexCount} + 1));
    for (std::size_t round = 0; round + 1 < workspace.roundStart.size(); ++round) {
        const std::uint32_t first = workspace.roundStart[round];
        const std::uint32_t end = workspace.roundStart[round + 1];
        if (end - first >= kMinRound) {
            Round(mesh, grid, workspace.states, first, end).run();
        } else {
            insertRun(mesh, first, end);
        }
    }
}

}  // namespace

Status triangulateCpu(const Polygon& polygon, std::vector<std::uint32_t>& triangles) {
    thread_local Workspace workspace;
    Status status = workspace.start(polygon, Cores::One);
    if (status.outcome == Outcome::Ok) {
        startInBox(workspace.mesh);
        insertRun(workspace.mesh, 0, workspace.mesh.vertexCount);
        status = workspace.finish(Cores::One, triangles);
    }
    workspace.trim();
    return status;
}

Status triangulateParallel(const Polygon& polygon, std::vector<std::uint32_t>& triangles) {
    // Not kept by the thread: while it waits for others it may be given another large polygon to work on.
    Workspace workspace;
    Status status = workspace.start(polygon, Cores::All);
    if (status.outcome == Outcome::Ok) {
        startInBox(workspace.mesh);
        insertRounds(workspace);
        status = workspace.finish(Cores::All, triangles);
    }
    return status;
}

}  // namespace tri
