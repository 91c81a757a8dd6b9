#include "model/export/meshes/plan_meshes.h"

#include <algorithm>
#include <atomic>
#include <map>

#include "model/base/parallel.h"
#include "model/export/meshes/united.h"

namespace model {

namespace {

/// Of tracks that are united. Fields of hatched copper have thousands that all hang together.
constexpr std::size_t kTracksAtOnce = 256;
constexpr std::string_view kNoTriangles = "it has no area, or cannot be triangulated";

/// Makes the meshes of one step.
class Mesher {
public:
    Mesher(const SolidPlan& plan, std::uint32_t step, const Discretisation& how, base::Progress& progress)
        : m_plan(plan), m_row(step), m_step(plan.steps[step]), m_how(how), m_progress(progress) {}

    StepMeshes make() {
        StepMeshes meshes;
        if (!m_plan.choice.isMerged) {
            findShapes();
        }
        meshes.shapes.resize(m_keys.size());
        base::parallelFor(m_keys.size(), [&](std::size_t i) {
            for (const Shell& shell : m_plan.shellsOf(m_step, m_keys[i]).shells) {
                static_cast<void>(appendPrisms(polygonsOf(shell.outline, m_how), shell.z, meshes.shapes[i]));
            }
        });
        meshes.groups.resize(m_step.groups.size());
        std::vector<std::vector<MissingSolid>> missing(m_step.groups.size());
        base::parallelFor(m_step.groups.size(), [&](std::size_t i) {
            if (!m_progress.isCancelled()) {
                meshes.groups[i] = meshOf(m_step.groups[i], meshes.shapes, missing[i]);
                m_progress.setFraction(static_cast<float>(++m_done) / static_cast<float>(m_step.groups.size()));
            }
        });
        for (const auto& some : missing) {
            meshes.missing.insert(meshes.missing.end(), some.begin(), some.end());
        }
        return meshes;
    }

private:
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
                static_cast<void>(appendPrism(loops, {z.first, z.second}, mesh.own));
            }
        }
        return mesh;
    }

    void place(const PlacedMesh& placed, const std::vector<SolidMesh>& shapes, GroupMesh& mesh,
               std::vector<MissingSolid>& missing) const {
        if (shapes[placed.shape].triangles.empty()) {
            missing.push_back({m_row, placed.element, kNoTriangles});
        } else {
            mesh.placed.push_back(placed);
        }
    }

    void add(ElementId element, GroupMesh& mesh, United& united, std::vector<MissingSolid>& missing) const {
        const ElementShells made = m_plan.shellsOf(m_step, element);
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

    const SolidPlan& m_plan;
    std::uint32_t m_row;
    const StepSolids& m_step;
    const Discretisation& m_how;
    base::Progress& m_progress;
    std::unordered_map<ShapeKey, std::uint32_t, ShapeKeyHash> m_rows;
    std::vector<ShapeKey> m_keys;
    std::atomic<std::size_t> m_done{0};
};

}  // namespace

base::Result<StepMeshes> meshesOf(const SolidPlan& plan, std::uint32_t step, const Discretisation& how,
                                  base::Progress& progress) {
    StepMeshes meshes = Mesher(plan, step, how, progress).make();
    if (progress.isCancelled()) {
        return base::Error{base::ErrorCode::Cancelled, "the export was cancelled"};
    }
    return meshes;
}

}  // namespace model
