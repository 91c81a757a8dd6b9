// First lines of the raster back end's shaders after #version, in place of frame.glsl: the frame is that of a copy, taken from a table.
#include "../shared/raster.h"

layout(push_constant, scalar) uniform PushBlock {
    RasterPush push;
};
Frame frame;  // set before anything else
#define FRAME frame.data
#define SHADOWS frame.data.shadows
