// First lines of the raster back end's shaders after #version, in place of frame.glsl: the frame is that of a copy, taken from a table.
#include "../shared/raster.h"

layout(push_constant, scalar) uniform PushBlock {
    RasterPush push;
};
Frame frame;  // set before anything else
#define FRAME frame.data
#define SHADOWS frame.data.shadows

// A linear colour in one word: ten bits of the square root of each component are finer than what is shown.
uint packColour(vec3 colour) {
    const uvec3 roots = uvec3(sqrt(clamp(colour, 0.0, 1.0)) * 1023.0 + 0.5);
    return roots.r | roots.g << 10u | roots.b << 20u;
}

vec3 unpackColour(uint word) {
    const vec3 root = vec3(uvec3(word, word >> 10u, word >> 20u) & 1023u) / 1023.0;
    return root * root;
}
