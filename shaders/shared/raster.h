// What the raster back end's shaders read beside a frame: the nearest let of every pixel, and which copy it belongs to.
#ifndef COPPERSCOPE_SHADERS_SHARED_RASTER_H
#define COPPERSCOPE_SHADERS_SHARED_RASTER_H

#include "frame.h"

#ifdef __cplusplus
namespace shader {
#endif

// Rows from the top. The upper half of a pixel is its depth (the bits of a positive float: greater is nearer), the
// lower half the let's id; 0 where nothing is. So the nearest let is the largest number, and of several at one depth
// the one with the largest id, whatever order they come in.
// When all are there, colours take the place of ids.
GPU_WRITE(RasterPixels, uvec2, 8);  // x: id or colour (lib/raster.glsl), y: depth

GPU_CONST kRasterGroupSize = 64;  // pixels of a row, by workgroup of what colours them

// The id of a let is its row plus what its copy starts at. Sorted by that.
struct RasterCopy {
    GPU_ADDRESS(Frame) frame;
    uint firstId;
    uint reserved;
};
GPU_SIZE(RasterCopy, 16);
GPU_READ(RasterCopies, RasterCopy, 8);

// Push constants.
struct RasterPush {
    GPU_ADDRESS(RasterPixels) pixels;
    GPU_ADDRESS(RasterCopies) copies;
    uint copy;  // rasterising: the one whose lets are meant
    uint copyCount;
};
GPU_SIZE(RasterPush, 24);

#ifdef __cplusplus
}  // namespace shader
#endif
#endif
