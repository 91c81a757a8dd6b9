#pragma once

#include "model/export/meshes/mesh_export.h"

namespace model {

/// Writes the plan as Wavefront OBJ, in millimetres: an object per layer, a group per net or component, a material per
/// layer in a file of the same name that ends in .mtl. All of both files or nothing of them but for a failure to give
/// the second one its name. Errors: OutputFailed; Cancelled.
[[nodiscard]] base::Result<MeshReport> exportObj(const SolidPlan& plan, const MeshOptions& options,
                                                 const std::filesystem::path& path, base::Progress& progress);

}  // namespace model
