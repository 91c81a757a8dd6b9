#pragma once

#include <functional>
#include <vector>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/export/meshes/solid_mesh.h"
#include "model/export/solids/solid_plan.h"

namespace model {

/// A solid that is placed, not written out.
struct PlacedMesh {
    std::uint32_t shape = 0;  ///< row of StepMeshes::shapes
    Placement placement;
    ElementId element;
};

/// What a SolidGroup becomes.
struct GroupMesh {
    SolidMesh own;  ///< all that is not shared
    std::vector<PlacedMesh> placed;
};

/// The meshes of one step of a plan.
struct StepMeshes {
    std::vector<SolidMesh> shapes;  ///< what is placed more than once
    std::vector<GroupMesh> groups;  ///< as StepSolids::groups
    std::vector<MissingSolid> missing;
};

/// Triangulates a step of a plan over all cores; the same with 1 and N threads. The tracks of a group that are equally
/// high are united, with SolidChoice::isMerged all of it, and then nothing is shared. Errors: Cancelled.
[[nodiscard]] base::Result<StepMeshes> meshesOf(const SolidPlan& plan, std::uint32_t step, const Discretisation& how,
                                                base::Progress& progress);

/// Who takes the meshes of a step one by one.
struct MeshTaker {
    /// What is left to do with GroupMesh::own, by the thread that made it.
    std::function<void(SolidMesh& own)> finish;
    /// What became of a row of StepSolids::groups, in rising order; `shapes` as StepMeshes::shapes. An error ends it
    /// all.
    std::function<base::Status(std::size_t row, GroupMesh mesh, const std::vector<SolidMesh>& shapes)> take;
};

/// meshesOf, with only as many groups in memory as keep all cores busy: StepMeshes::groups stays empty. Errors:
/// Cancelled; what `taker` returns.
[[nodiscard]] base::Result<StepMeshes> passMeshes(const SolidPlan& plan, std::uint32_t step, const Discretisation& how,
                                                  const MeshTaker& taker, base::Progress& progress);

}  // namespace model
