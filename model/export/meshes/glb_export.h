#pragma once

#include "model/export/meshes/gltf_scene.h"
#include "model/export/meshes/mesh_export.h"

namespace model {

struct GlbOptions : MeshOptions {
    GlbPacking packing = GlbPacking::Plain;
    /// Equal pads and barrels of a net as one node (EXT_mesh_gpu_instancing): far fewer nodes, none of which names its
    /// pad, and not all viewers show them.
    bool isInstanced = false;
};

/// Writes the plan as glTF 2.0 in one binary file: metres, y up. Nodes as a tree: the board or a step, its layers (all
/// copies of a step share meshes, not nodes), their nets or components; in a net one mesh for all that is drawn once,
/// and a node for each pad and barrel whose mesh others have too. `extras` of nets have `net`, `layer` and `z` (lower
/// and upper face, metres), of bodies and pads `refdes`. Meshes are closed and have no normals: viewers shade them
/// flat. With SolidChoice::isOnePart there is one node for each layer. All of the file or nothing. Errors:
/// OutputFailed, also for more than 4 GiB; Cancelled.
[[nodiscard]] base::Result<MeshReport> exportGlb(const SolidPlan& plan, const GlbOptions& options,
                                                 const std::filesystem::path& path, base::Progress& progress);

}  // namespace model
