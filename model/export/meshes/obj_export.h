#pragma once

#include "model/export/meshes/mesh_export.h"

namespace model {

/// Writes the plan as Wavefront OBJ, in millimetres: an object per layer, a group per net or component, a material per
/// layer in the file materialsBeside. All of both files or nothing of them: none is replaced before both are whole on
/// the disk. Errors: OutputFailed; Cancelled.
[[nodiscard]] base::Result<MeshReport> exportObj(const SolidPlan& plan, const MeshOptions& options,
                                                 const std::filesystem::path& path, base::Progress& progress);
/// The second file: of the same name, but it ends in .mtl.
[[nodiscard]] std::filesystem::path materialsBeside(std::filesystem::path path);

}  // namespace model
