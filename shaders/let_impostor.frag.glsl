#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"
#include "lib/cut.glsl"
#include "lib/outline.glsl"

// Impostor back end: which samples of a pixel lie in the let, from its true outline. The face looks straight at the viewer.
layout(location = 0) in vec2 inPlace;
layout(location = 1) flat in vec4 inColour;
layout(location = 2) flat in uint inLet;
layout(location = 0) out vec4 outColour;

// Vulkan's standard places of four samples, from the middle of the pixel.
const vec2 kSamples[4] = vec2[](vec2(-0.125, -0.375), vec2(0.375, -0.125), vec2(-0.375, 0.125), vec2(0.125, 0.375));

void main() {
    const Let let = FRAME.lets.at[inLet];
    const vec2 right = dFdx(inPlace);
    const vec2 down = dFdy(inPlace);
    // Samples on an outline belong to the shape on their right and below, as rasterisers have it.
    const vec2 place = inPlace + FRAME.centre.xy + 1e-3 * (right + down);
    int mask = 0;
    if (has(FRAME.flags, kFrameSmoothed)) {
        for (int i = 0; i < 4; ++i) {
            mask |= isDrawn(let, place + kSamples[i].x * right + kSamples[i].y * down) ? 1 << i : 0;
        }
    } else {
        mask = isDrawn(let, place) ? 1 : 0;
    }
    if (mask == 0 || isCutAway(vec3(inPlace, 0.0))) {
        discard;
    }
    gl_SampleMask[0] = mask;
    outColour = inColour;
}
