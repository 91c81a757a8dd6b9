// What the overlay's two shaders read: a picture laid over the finished board, pixel by pixel.
#ifndef COPPERSCOPE_SHADERS_SHARED_OVERLAY_H
#define COPPERSCOPE_SHADERS_SHARED_OVERLAY_H

#include "frame.h"

#ifdef __cplusplus
namespace shader {
#endif

// Push constants. `pixels`: rows from the top, 0xAABBGGRR, sRGB multiplied by alpha.
struct OverlayPush {
    GPU_ADDRESS(Words) pixels;
    uint width;
    uint height;
};
GPU_SIZE(OverlayPush, 16);

#ifdef __cplusplus
}  // namespace shader
#endif
#endif
