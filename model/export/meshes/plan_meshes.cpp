#include "model/export/meshes/plan_meshes.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <unordered_map>

#include "model/base/parallel.h"
#include "model/export/meshes/united.h"

namespace model {

namespace {

/// Of tracks that are united. Fields of hatched copper have thousands that all hang together.
constexpr std::size_t kTracksAtOnce = 256;
/// Of groups that are made at once: what takes some hundred megabytes.
constexpr std::size_t kCornersAtOnce = 1'000'000;
/// A track, a pad or a hole in a plane has about so many for each node that a job has of it.
constexpr std::size_t kCornersPerNode = 16;
constexpr std::string_view kNoTriangles = "it has no area, or cannot be triangulated";

/// Makes the meshes of one step.
class Mesher {
public:
    Mesher(const SolidPlan& plan, std::uint32_t step, const Discretisation& how, base::Progress& progress)
        : m_plan(plan), m_row(step), m_step(plan.steps[step]), m_how(how), m_progress(progress) {}

    base::Result<StepMeshes> pass(const MeshTaker& taker) {
        StepMeshes meshes;
        meshes.shapes = makeShapes();
        for (std::size_t first = 0; first < m_step.groups.size();) {
            const std::size_t end = endOfBatch(first);
            std::vector<Made> batch(end - first);
            base::parallelFor(batch.size(), [&](std::size_t i) {
                if (!m_progress.isCancelled()) {
                    batch[i].mesh = meshOf(m_step.groups[first + i], meshes.shapes, batch[i].missing);
                    taker.finish(batch[i].mesh.own);
                    m_progress.setFraction(static_cast<float>(++m_done) / static_cast<float>(m_step.groups.size()));
                }
            });
            for (Made& made : batch) {
                if (m_progress.isCancelled()) {
                    return base::Error{base::ErrorCode::Cancelled, "the export was cancelled"};
                }
                meshes.missing.insert(meshes.missing.end(), made.missing.begin(), made.missing.end());
                RETURN_IF_ERROR(taker.take(first++, std::move(made.mesh), meshes.shapes));
            }
        }
        return meshes;
    }

private:
    /// What became of a group.
    struct Made {
        GroupMesh mesh;
        std::vector<MissingSolid> missing;
    };

    /// Groups are made at once up to about kCornersAtOnce; a larger one alone.
    [[nodiscard]] std::size_t endOfBatch(std::size_t first) const {
        std::size_t end = first;
        std::size_t corners = 0;
        do {
            corners += cornersOf(m_step.groups[end++]);
        } while (end < m_step.groups.size() && corners + cornersOf(m_step.groups[end]) <= kCornersAtOnce);
        return end;
    }

    /// About as many as its mesh has on one of its faces.
    [[nodiscard]] std::size_t cornersOf(const SolidGroup& group) const {
        const Document& document = *m_step.document;
        std::size_t nodes = group.elements.count;
        for (std::uint32_t i = group.elements.first; i < group.elements.first + group.elements.count; ++i) {
            const ElementId element = m_step.elements[i];
            if (document.elements.kind[element.row()] == ElementKind::Area) {
                const ShapeId shape = document.areas[document.elements.geometry[element.row()]].shape;
                for (const Contour& contour : document.shapes.contoursOf(shape)) {
                    nodes += contour.nodeCount;
                }
            }
        }
        return nodes * kCornersPerNode;
    }

    std::vector<SolidMesh> makeShapes() {
        if (!m_plan.choice.isMerged) {
            findShapes();
        }
        std::vector<SolidMesh> shapes(m_keys.size());
        m_isDrilledAway.assign(m_keys.size(), 0);
        base::parallelFor(m_keys.size(), [&](std::size_t i) {
            const ElementShells made = m_plan.shellsOf(m_step, m_keys[i]);
            m_isDrilledAway[i] = made.shells.empty() && made.problem.empty() ? 1 : 0;
            for (const Shell& shell : made.shells) {
                static_cast<void>(appendPrisms(polygonsOf(shell.outline, m_how), shell.z, shapes[i]));
            }
        });
        return shapes;
    }

    void findShapes() {
        for (const ElementId element : m_step.elements) {
            const auto shared = sharedShapeOf(element);
            if (shared && m_rows.try_emplace(shared->key, static_cast<std::uint32_t>(m_keys.size())).second) {
                m_keys.push_back(shared->key);
            }
        }
    }

    /// Regions that become one, by their heights.
    using United = std::map<std::pair<Nm, Nm>, PolygonSet>;

    /// Tracks are united always: most of their corners lie within the next one.
    [[nodiscard]] bool isUnited(ElementId element) const {
        const ElementKind kind = m_step.document->elements.kind[element.row()];
        return m_plan.choice.isMerged || kind == ElementKind::Line || kind == ElementKind::Arc ||
               kind == ElementKind::Trail;
    }

    /// Of what is placed.
    [[nodiscard]] std::optional<SharedShape> sharedShapeOf(ElementId element) const {
        return isUnited(element) ? std::nullopt : m_plan.sharedShapeOf(m_step, element);
    }

    GroupMesh meshOf(const SolidGroup& group, const std::vector<SolidMesh>& shapes,
                     std::vector<MissingSolid>& missing) const {
        GroupMesh mesh;
        United united;
        for (std::uint32_t i = group.elements.first; i < group.elements.first + group.elements.count; ++i) {
            if (m_progress.isCancelled()) {
                return mesh;
            }
            const ElementId element = m_step.elements[i];
            const auto shared = sharedShapeOf(element);
            const auto row = shared ? m_rows.find(shared->key) : m_rows.end();
            if (row != m_rows.end()) {
                place({row->second, shared->placement, element}, shapes, mesh, missing);
            } else {
                add(element, mesh, united, missing);
            }
        }
        const std::size_t most = m_plan.choice.isMerged ? 0 : kTracksAtOnce;
        for (const auto& [z, polygons] : united) {
            for (const LoopSet& loops : uniteNear(polygons, most)) {
                static_cast<void>(appendPrism(drilled(loops, group.layer), {z.first, z.second}, mesh.own));
            }
        }
        return mesh;
    }

    void place(const PlacedMesh& placed, const std::vector<SolidMesh>& shapes, GroupMesh& mesh,
               std::vector<MissingSolid>& missing) const {
        if (m_isDrilledAway[placed.shape] != 0) {
            return;
        }
        if (shapes[placed.shape].triangles.empty()) {
            missing.push_back({m_row, placed.element, kNoTriangles});
        } else {
            mesh.placed.push_back(placed);
        }
    }

    void add(ElementId element, GroupMesh& mesh, United& united, std::vector<MissingSolid>& missing) const {
        // What is united is drilled then: else each track that ends in a via would need a boolean of its own.
        const ElementShells made =
            isUnited(element) ? m_plan.undrilledShellsOf(m_step, element) : m_plan.shellsOf(m_step, element);
        // Regions that overlap or cross themselves are complete all the same: triangles do not mind.
        std::string_view problem = made.shells.empty() ? made.problem : std::string_view{};
        for (const Shell& shell : made.shells) {
            const PolygonSet polygons = polygonsOf(shell.outline, m_how);
            if (isUnited(element) && !polygons.polygons.empty()) {
                united[{shell.z.bottom, shell.z.top}].append(polygons);
            } else if (!appendPrisms(polygons, shell.z, mesh.own)) {
                problem = kNoTriangles;
            }
        }
        if (!problem.empty()) {
            missing.push_back({m_row, element, problem});
        }
    }

    /// Loops that were united, without what is drilled out of them.
    [[nodiscard]] LoopSet drilled(LoopSet loops, LayerId layer) const {
        Box box;
        std::ranges::for_each(loops.points, [&](Point corner) { box.include(corner); });
        const std::vector<EdgeLoops> holes = m_plan.holesNear(m_step, layer, box);
        for (const EdgeLoops& hole : holes) {
            addReversed(polygonsOf(hole, m_how), loops);
        }
        return holes.empty() ? std::move(loops) : unitedLoops(loops);
    }

    /// Wound the other way, so that the loops cover nothing there.
    static void addReversed(const PolygonSet& polygons, LoopSet& loops) {
        for (std::size_t i = 0; i < polygons.loopCount(); ++i) {
            const std::span<const Point> loop = polygons.loop(i);
            loops.points.insert(loops.points.end(), loop.rbegin(), loop.rend());
            loops.loopStart.push_back(static_cast<std::uint32_t>(loops.points.size()));
        }
    }

    const SolidPlan& m_plan;
    std::uint32_t m_row;
    const StepSolids& m_step;
    const Discretisation& m_how;
    base::Progress& m_progress;
    std::unordered_map<ShapeKey, std::uint32_t, ShapeKeyHash> m_rows;
    std::vector<ShapeKey> m_keys;
    std::vector<std::uint8_t> m_isDrilledAway;  ///< by shape
    std::atomic<std::size_t> m_done{0};
};

}  // namespace

base::Result<StepMeshes> passMeshes(const SolidPlan& plan, std::uint32_t step, const Discretisation& how,
                                    const MeshTaker& taker, base::Progress& progress) {
    return Mesher(plan, step, how, progress).pass(taker);
}

base::Result<StepMeshes> meshesOf(const SolidPlan& plan, std::uint32_t step, const Discretisation& how,
                                  base::Progress& progress) {
    std::vector<GroupMesh> groups;
    const auto take = [&groups](std::size_t /*row*/, GroupMesh mesh, const auto& /*shapes*/) {
        groups.push_back(std::move(mesh));
        return base::Status(base::Done{});
    };
    ASSIGN_OR_RETURN(StepMeshes meshes, passMeshes(plan, step, how, {[](SolidMesh& /*own*/) {}, take}, progress));
    meshes.groups = std::move(groups);
    return meshes;
}

}  // namespace model
