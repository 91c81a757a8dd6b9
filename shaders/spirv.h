#pragma once

#include <cstdint>
#include <span>

/// The compiled shaders, one for each name.stage.glsl in this folder and below.
namespace shader::spirv {

using Code = std::span<const std::uint32_t>;

/// SHADER(name here, name that CMakeLists.txt gives its words): a row per shader.
#define COPPERSCOPE_SHADERS(SHADER)                              \
    SHADER(kAreaCapVert, area_cap_vert)                          \
    SHADER(kAreaOutlineVert, area_outline_vert)                  \
    SHADER(kAreaWallVert, area_wall_vert)                        \
    SHADER(kBoardFrag, board_frag)                               \
    SHADER(kCullAreasComp, cull_areas_comp)                      \
    SHADER(kCullClustersComp, cull_clusters_comp)                \
    SHADER(kCullLetsComp, cull_lets_comp)                        \
    SHADER(kSectionFaceFrag, section_face_frag)                  \
    SHADER(kSectionFaceVert, section_face_vert)                  \
    SHADER(kLetBoxFrag, let_box_frag)                            \
    SHADER(kLetBoxVert, let_box_vert)                            \
    SHADER(kLetImpostorFrag, let_impostor_frag)                  \
    SHADER(kLetImpostorVert, let_impostor_vert)                  \
    SHADER(kLetMeshMesh, let_mesh_mesh)                          \
    SHADER(kLetMeshTask, let_mesh_task)                          \
    SHADER(kLetPullVert, let_pull_vert)                          \
    SHADER(kLineUpDrawsComp, line_up_draws_comp)                 \
    SHADER(kOverlayFrag, overlay_frag)                           \
    SHADER(kOverlayVert, overlay_vert)                           \
    SHADER(kPlaceLetsComp, place_lets_comp)                      \
    SHADER(kRasterLetsComp, raster_lets_comp)                    \
    SHADER(kRasterResolveFrag, raster_resolve_frag)              \
    SHADER(kStandardVert, standard_vert)                         \
    SHADER(kTriAdvanceComp, tri_advance_comp)                    \
    SHADER(kTriClaimCorridorComp, tri_claim_corridor_comp)       \
    SHADER(kTriClaimPlaceComp, tri_claim_place_comp)             \
    SHADER(kTriCountKeptComp, tri_count_kept_comp)               \
    SHADER(kTriDecideComp, tri_decide_comp)                      \
    SHADER(kTriFixLinksComp, tri_fix_links_comp)                 \
    SHADER(kTriFlipComp, tri_flip_comp)                          \
    SHADER(kTriInitComp, tri_init_comp)                          \
    SHADER(kTriLookForContoursComp, tri_look_for_contours_comp)  \
    SHADER(kTriProveComp, tri_prove_comp)                        \
    SHADER(kTriRebuildCorridorComp, tri_rebuild_corridor_comp)   \
    SHADER(kTriRelocateFlippedComp, tri_relocate_flipped_comp)   \
    SHADER(kTriRelocateInsertedComp, tri_relocate_inserted_comp) \
    SHADER(kTriSmallComp, tri_small_comp)                        \
    SHADER(kTriSplitComp, tri_split_comp)                        \
    SHADER(kTriSumKeptComp, tri_sum_kept_comp)                   \
    SHADER(kTriTestEdgesComp, tri_test_edges_comp)               \
    SHADER(kTriVoteComp, tri_vote_comp)                          \
    SHADER(kTriWriteKeptComp, tri_write_kept_comp)

#define COPPERSCOPE_DECLARE(name, words) extern const Code name;
COPPERSCOPE_SHADERS(COPPERSCOPE_DECLARE)
#undef COPPERSCOPE_DECLARE

}  // namespace shader::spirv
