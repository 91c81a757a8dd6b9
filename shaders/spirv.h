#pragma once

#include <cstdint>
#include <span>

/// The compiled shaders, one for each name.stage.glsl in this folder.
namespace shader::spirv {

using Code = std::span<const std::uint32_t>;

extern const Code kAreaCapVert;
extern const Code kAreaWallVert;
extern const Code kBoardFrag;
extern const Code kCullAreasComp;
extern const Code kCullClustersComp;
extern const Code kCullLetsComp;
extern const Code kLetMeshMesh;
extern const Code kLetMeshTask;
extern const Code kLetPullVert;
extern const Code kOverlayFrag;
extern const Code kOverlayVert;

/// All of them by file name without .glsl, for tests.
struct Named {
    const char* name;
    Code code;
};
[[nodiscard]] std::span<const Named> all();

}  // namespace shader::spirv
