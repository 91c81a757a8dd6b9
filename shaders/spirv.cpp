#include "shaders/spirv.h"

namespace {
#include "area_cap_vert.h"
#include "area_outline_vert.h"
#include "area_wall_vert.h"
#include "board_frag.h"
#include "cull_areas_comp.h"
#include "cull_clusters_comp.h"
#include "cull_lets_comp.h"
#include "cut_face_frag.h"
#include "cut_face_vert.h"
#include "let_box_frag.h"
#include "let_box_vert.h"
#include "let_impostor_frag.h"
#include "let_impostor_vert.h"
#include "let_mesh_mesh.h"
#include "let_mesh_task.h"
#include "let_pull_vert.h"
#include "line_up_draws_comp.h"
#include "overlay_frag.h"
#include "overlay_vert.h"
#include "place_lets_comp.h"
#include "raster_lets_comp.h"
#include "raster_resolve_frag.h"
#include "standard_vert.h"
#include "tri/advance_comp.h"
#include "tri/claim_corridor_comp.h"
#include "tri/claim_place_comp.h"
#include "tri/count_kept_comp.h"
#include "tri/decide_comp.h"
#include "tri/fix_links_comp.h"
#include "tri/flip_comp.h"
#include "tri/init_comp.h"
#include "tri/look_for_contours_comp.h"
#include "tri/prove_comp.h"
#include "tri/rebuild_corridor_comp.h"
#include "tri/relocate_flipped_comp.h"
#include "tri/relocate_inserted_comp.h"
#include "tri/small_comp.h"
#include "tri/split_comp.h"
#include "tri/sum_kept_comp.h"
#include "tri/test_edges_comp.h"
#include "tri/vote_comp.h"
#include "tri/write_kept_comp.h"
}  // namespace

namespace shader::spirv {

const Code kAreaCapVert(area_cap_vert);
const Code kAreaOutlineVert(area_outline_vert);
const Code kAreaWallVert(area_wall_vert);
const Code kBoardFrag(board_frag);
const Code kCullAreasComp(cull_areas_comp);
const Code kCullClustersComp(cull_clusters_comp);
const Code kCullLetsComp(cull_lets_comp);
const Code kCutFaceFrag(cut_face_frag);
const Code kCutFaceVert(cut_face_vert);
const Code kLetBoxFrag(let_box_frag);
const Code kLetBoxVert(let_box_vert);
const Code kLetImpostorFrag(let_impostor_frag);
const Code kLetImpostorVert(let_impostor_vert);
const Code kLetMeshMesh(let_mesh_mesh);
const Code kLetMeshTask(let_mesh_task);
const Code kLetPullVert(let_pull_vert);
const Code kLineUpDrawsComp(line_up_draws_comp);
const Code kOverlayFrag(overlay_frag);
const Code kOverlayVert(overlay_vert);
const Code kPlaceLetsComp(place_lets_comp);
const Code kRasterLetsComp(raster_lets_comp);
const Code kRasterResolveFrag(raster_resolve_frag);
const Code kStandardVert(standard_vert);
const Code kTriAdvanceComp(tri_advance_comp);
const Code kTriClaimCorridorComp(tri_claim_corridor_comp);
const Code kTriClaimPlaceComp(tri_claim_place_comp);
const Code kTriCountKeptComp(tri_count_kept_comp);
const Code kTriDecideComp(tri_decide_comp);
const Code kTriFixLinksComp(tri_fix_links_comp);
const Code kTriFlipComp(tri_flip_comp);
const Code kTriInitComp(tri_init_comp);
const Code kTriLookForContoursComp(tri_look_for_contours_comp);
const Code kTriProveComp(tri_prove_comp);
const Code kTriRebuildCorridorComp(tri_rebuild_corridor_comp);
const Code kTriRelocateFlippedComp(tri_relocate_flipped_comp);
const Code kTriRelocateInsertedComp(tri_relocate_inserted_comp);
const Code kTriSmallComp(tri_small_comp);
const Code kTriSplitComp(tri_split_comp);
const Code kTriSumKeptComp(tri_sum_kept_comp);
const Code kTriTestEdgesComp(tri_test_edges_comp);
const Code kTriVoteComp(tri_vote_comp);
const Code kTriWriteKeptComp(tri_write_kept_comp);

std::span<const Named> all() {
    static const Named kAll[] = {
        {"area_cap.vert", area_cap_vert},
        {"area_outline.vert", area_outline_vert},
        {"area_wall.vert", area_wall_vert},
        {"board.frag", board_frag},
        {"cull_areas.comp", cull_areas_comp},
        {"cull_clusters.comp", cull_clusters_comp},
        {"cull_lets.comp", cull_lets_comp},
        {"let_box.frag", let_box_frag},
        {"let_box.vert", let_box_vert},
        {"let_impostor.frag", let_impostor_frag},
        {"let_impostor.vert", let_impostor_vert},
        {"let_mesh.mesh", let_mesh_mesh},
        {"let_mesh.task", let_mesh_task},
        {"let_pull.vert", let_pull_vert},
        {"line_up_draws.comp", line_up_draws_comp},
        {"overlay.frag", overlay_frag},
        {"overlay.vert", overlay_vert},
        {"place_lets.comp", place_lets_comp},
        {"raster_lets.comp", raster_lets_comp},
        {"raster_resolve.frag", raster_resolve_frag},
        {"standard.vert", standard_vert},
        {"tri/advance.comp", tri_advance_comp},
        {"tri/claim_corridor.comp", tri_claim_corridor_comp},
        {"tri/claim_place.comp", tri_claim_place_comp},
        {"tri/count_kept.comp", tri_count_kept_comp},
        {"tri/decide.comp", tri_decide_comp},
        {"tri/fix_links.comp", tri_fix_links_comp},
        {"tri/flip.comp", tri_flip_comp},
        {"tri/init.comp", tri_init_comp},
        {"tri/look_for_contours.comp", tri_look_for_contours_comp},
        {"tri/prove.comp", tri_prove_comp},
        {"tri/rebuild_corridor.comp", tri_rebuild_corridor_comp},
        {"tri/relocate_flipped.comp", tri_relocate_flipped_comp},
        {"tri/relocate_inserted.comp", tri_relocate_inserted_comp},
        {"tri/small.comp", tri_small_comp},
        {"tri/split.comp", tri_split_comp},
        {"tri/sum_kept.comp", tri_sum_kept_comp},
        {"tri/test_edges.comp", tri_test_edges_comp},
        {"tri/vote.comp", tri_vote_comp},
        {"tri/write_kept.comp", tri_write_kept_comp},
    };
    return kAll;
}

}  // namespace shader::spirv
