#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/export/meshes/plan_meshes.h"
#include "model/export/solids/step_export.h"

/// Boards as triangles: what glb_export.h, stl_export.h and obj_export.h have in common. None writes a file without
/// triangles (checkAnyWritten).
namespace model {

struct MeshOptions {
    std::vector<SolidLook> looks;  ///< by row of the board's layers; empty: grey
    std::string name;              ///< of the whole: the board's
    Discretisation how;            ///< of curves: 5 µm at most between chord and arc
};

/// What became of an export.
struct MeshReport {
    std::uint64_t bytes = 0;
    std::uint64_t triangles = 0;  ///< written out
    std::uint64_t copies = 0;     ///< placed
    std::vector<MissingSolid> missing;
};

/// The meshes of all steps of a plan. Errors: Cancelled.
[[nodiscard]] base::Result<std::vector<StepMeshes>> allMeshes(const SolidPlan& plan, const Discretisation& how,
                                                              base::Progress& progress, MeshReport& report);

/// How what a step has on a layer looks.
[[nodiscard]] SolidLook lookOf(const StepSolids& step, LayerId layer, const std::vector<SolidLook>& looks);

/// Everything of a group where it lies in its step: for files in which nothing is placed.
[[nodiscard]] SolidMesh writtenOut(const StepMeshes& meshes, const GroupMesh& group);

}  // namespace model
