#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"
#include "lib/section.glsl"
#include "lib/outline.glsl"
#include "lib/shading.glsl"

// Impostor back end: which samples of a pixel lie in the let, from its true outline. The face looks straight at the viewer.
layout(location = 0) in vec2 inLocation;
layout(location = 1) flat in vec4 inColour;
layout(location = 2) flat in uint inLet;
layout(location = 3) flat in uint inMaterial;
layout(location = 0) out vec4 outColour;

// Vulkan's standard places of four samples, from the middle of the pixel.
const vec2 kSamples[4] = vec2[](vec2(-0.125, -0.375), vec2(0.375, -0.125), vec2(-0.375, 0.125), vec2(0.125, 0.375));

void main() {
    const Let let = FRAME.lets.at[inLet];
    const vec2 right = dFdx(inLocation);
    const vec2 down = dFdy(inLocation);
    // Samples on an outline belong to the shape on their right and below, as rasterisers have it.
    const vec2 location = inLocation + FRAME.centre.xy + 1e-3 * (right + down);
    int mask = 0;
    if (has(FRAME.flags, kFrameSmoothed)) {
        for (int i = 0; i < 4; ++i) {
            mask |= isDrawn(let, location + kSamples[i].x * right + kSamples[i].y * down) ? 1 << i : 0;
        }
    } else {
        mask = isDrawn(let, location) ? 1 : 0;
    }
    if (mask == 0 || isClipped(vec3(inLocation, 0.0))) {
        discard;
    }
    gl_SampleMask[0] = mask;
    const vec3 normal = vec3(0.0, 0.0, FRAME.quadFace == 0u ? 1.0 : -1.0);
    outColour = isShaded() ? shaded(inColour, inMaterial, normal, FRAME.eye.xyz, inLocation) : unshaded(inColour);
}
