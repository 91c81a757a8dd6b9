#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/raster.glsl"

// Raster back end: colour and depth of the nearest small let of each pixel, so that all else is drawn against it.
layout(location = 0) out vec4 outColour;

void main() {
    frame = push.copies.at[0].frame;
    // Invocations beside the picture load too, discarded or not (docs/driver-notes.md): they must stay inside.
    const uvec2 at = min(uvec2(gl_FragCoord.xy), uvec2(FRAME.width, FRAME.height) - 1u);
    const uvec2 pixel = push.pixels.at[at.y * FRAME.width + at.x];
    if (pixel.y == 0u) {
        discard;
    }
    gl_FragDepth = uintBitsToFloat(pixel.y);
    outColour = vec4(unpackColour(pixel.x), 1.0);
}
