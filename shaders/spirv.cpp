#include "shaders/spirv.h"

namespace {
#include "area_cap_vert.h"
#include "area_wall_vert.h"
#include "board_frag.h"
#include "cull_areas_comp.h"
#include "cull_clusters_comp.h"
#include "cull_lets_comp.h"
#include "let_mesh_mesh.h"
#include "let_mesh_task.h"
#include "let_pull_vert.h"
#include "overlay_frag.h"
#include "overlay_vert.h"
}  // namespace

namespace shader::spirv {

const Code kAreaCapVert(area_cap_vert);
const Code kAreaWallVert(area_wall_vert);
const Code kBoardFrag(board_frag);
const Code kCullAreasComp(cull_areas_comp);
const Code kCullClustersComp(cull_clusters_comp);
const Code kCullLetsComp(cull_lets_comp);
const Code kLetMeshMesh(let_mesh_mesh);
const Code kLetMeshTask(let_mesh_task);
const Code kLetPullVert(let_pull_vert);
const Code kOverlayFrag(overlay_frag);
const Code kOverlayVert(overlay_vert);

std::span<const Named> all() {
    static const Named kAll[] = {
        {"area_cap.vert", area_cap_vert},
        {"area_wall.vert", area_wall_vert},
        {"board.frag", board_frag},
        {"cull_areas.comp", cull_areas_comp},
        {"cull_clusters.comp", cull_clusters_comp},
        {"cull_lets.comp", cull_lets_comp},
        {"let_mesh.mesh", let_mesh_mesh},
        {"let_mesh.task", let_mesh_task},
        {"let_pull.vert", let_pull_vert},
        {"overlay.frag", overlay_frag},
        {"overlay.vert", overlay_vert},
    };
    return kAll;
}

}  // namespace shader::spirv
