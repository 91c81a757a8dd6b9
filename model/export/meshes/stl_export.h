#pragma once

#include "model/export/meshes/mesh_export.h"

namespace model {

/// Writes the plan as binary STL, in millimetres: triangles alone, with neither names nor colours. All of the file or
/// nothing. Errors: OutputFailed, also for more than 2^32 triangles; Cancelled.
[[nodiscard]] base::Result<MeshReport> exportStl(const SolidPlan& plan, const MeshOptions& options,
                                                 const std::filesystem::path& path, base::Progress& progress);

}  // namespace model
