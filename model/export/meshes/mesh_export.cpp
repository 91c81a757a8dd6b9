#include "model/export/meshes/mesh_export.h"

namespace model {

base::Result<std::vector<StepMeshes>> allMeshes(const SolidPlan& plan, const Discretisation& how,
                                                base::Progress& progress, MeshReport& report) {
    progress.beginPhase("Triangulating solids");
    std::vector<StepMeshes> all;
    for (std::uint32_t step = 0; step < plan.steps.size(); ++step) {
        ASSIGN_OR_RETURN(StepMeshes meshes, meshesOf(plan, step, how, progress));
        report.missing.insert(report.missing.end(), meshes.missing.begin(), meshes.missing.end());
        all.push_back(std::move(meshes));
    }
    return all;
}

SolidLook lookOf(const StepSolids& step, LayerId layer, const std::vector<SolidLook>& looks) {
    const std::size_t row = step.document->layerOfCopy(layer, step.isFlipped).row();
    return row < looks.size() ? looks[row] : SolidLook{};
}

SolidMesh writtenOut(const StepMeshes& meshes, const GroupMesh& group) {
    SolidMesh all = group.own;
    for (const PlacedMesh& placed : group.placed) {
        all.append(meshes.shapes[placed.shape], placed.placement);
    }
    return all;
}

}  // namespace model
