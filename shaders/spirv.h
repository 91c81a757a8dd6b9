#pragma once

#include <cstdint>
#include <span>

/// The compiled shaders, one for each name.stage.glsl in this folder and below.
namespace shader::spirv {

using Code = std::span<const std::uint32_t>;

extern const Code kAreaCapVert;
extern const Code kAreaOutlineVert;
extern const Code kAreaWallVert;
extern const Code kBoardFrag;
extern const Code kCullAreasComp;
extern const Code kCullClustersComp;
extern const Code kCullLetsComp;
extern const Code kCutFaceFrag;
extern const Code kCutFaceVert;
extern const Code kLetBoxFrag;
extern const Code kLetBoxVert;
extern const Code kLetImpostorFrag;
extern const Code kLetImpostorVert;
extern const Code kLetMeshMesh;
extern const Code kLetMeshTask;
extern const Code kLetPullVert;
extern const Code kLineUpDrawsComp;
extern const Code kOverlayFrag;
extern const Code kOverlayVert;
extern const Code kPlaceLetsComp;
extern const Code kRasterLetsComp;
extern const Code kRasterResolveFrag;
extern const Code kStandardVert;
extern const Code kTriAdvanceComp;
extern const Code kTriClaimCorridorComp;
extern const Code kTriClaimPlaceComp;
extern const Code kTriCountKeptComp;
extern const Code kTriDecideComp;
extern const Code kTriFixLinksComp;
extern const Code kTriFlipComp;
extern const Code kTriInitComp;
extern const Code kTriLookForContoursComp;
extern const Code kTriProveComp;
extern const Code kTriRebuildCorridorComp;
extern const Code kTriRelocateFlippedComp;
extern const Code kTriRelocateInsertedComp;
extern const Code kTriSmallComp;
extern const Code kTriSplitComp;
extern const Code kTriSumKeptComp;
extern const Code kTriTestEdgesComp;
extern const Code kTriVoteComp;
extern const Code kTriWriteKeptComp;

/// All of them by file name without .glsl, for tests.
struct Named {
    const char* name;
    Code code;
};
[[nodiscard]] std::span<const Named> all();

}  // namespace shader::spirv
