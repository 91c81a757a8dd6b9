#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"
#include "lib/section.glsl"
#include "lib/shading.glsl"

layout(location = 0) in vec3 inPosition;
layout(location = 1) flat in vec4 inColour;
layout(location = 2) flat in uint inMaterial;
layout(location = 0) out vec4 outColour;

// Faces are flat: their normal is that of the surface through the neighbouring pixels, turned to the viewer. Caps and walls are exactly
// horizontal and vertical, which takes the noise of differences out.
vec3 faceNormal(vec3 toEye) {
    const vec3 n = cross(dFdx(inPosition), dFdy(inPosition));
    const vec3 snapped = abs(n.z) > length(n.xy) ? vec3(0.0, 0.0, 1.0) : normalize(vec3(n.xy, 0.0) + vec3(0.0, 1e-30, 0.0));
    return dot(snapped, toEye) < 0.0 ? -snapped : snapped;
}

void main() {
    outColour = unshaded(inColour);
    if (isShaded()) {
        const vec3 toEye = FRAME.eye.xyz - inPosition * FRAME.eye.w;
        outColour = shaded(inColour, inMaterial, faceNormal(toEye), toEye, inPosition.xy);
    }
    if (isClipped(inPosition)) {
        discard;
    }
}
