// What the overlay's two shaders read: a picture laid over the finished board, pixel by pixel.
#ifndef COPPERSCOPE_SHADERS_SHARED_OVERLAY_H
#define COPPERSCOPE_SHADERS_SHARED_OVERLAY_H

#include "frame.h"

#ifdef __cplusplus
namespace shader {
#endif

// Push constants. `pixels`: rows from the top, 0xAABBGGRR, sRGB multiplied by alpha. A picture in a plane of the board
// is hidden where the board is nearer than the plane there, plane.x * column + plane.y * row + plane.z: `depths` has
// the board's depth for each of the pixels, as bits of floats.
struct OverlayPush {
    GPU_ADDRESS(Words) pixels;
    GPU_ADDRESS(Words) depths;
    vec3 plane;
    uint width;
    uint height;
    uint isInPlane;  // 0: it lies over everything
};
GPU_SIZE(OverlayPush, 40);

#ifdef __cplusplus
}  // namespace shader
#endif
#endif
