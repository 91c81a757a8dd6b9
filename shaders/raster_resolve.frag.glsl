#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/raster.glsl"
#include "lib/prism.glsl"
#include "lib/surface.glsl"
#include "lib/shading.glsl"
#include "lib/outline.glsl"
#include "lib/sight.glsl"

// Raster back end: colour and depth of the nearest small let of each pixel, so that all else is drawn against it.
layout(location = 0) out vec4 outColour;

// The copy an id belongs to: the last one that starts at it or before.
RasterCopy copyOf(uint id) {
    uint first = 0u;
    for (uint count = push.copyCount; count > 1u;) {
        const uint step = count / 2u;
        const bool isLater = push.copies.at[first + step].firstId <= id;
        first += isLater ? step : 0u;
        count = isLater ? count - step : step;
    }
    return push.copies.at[first];
}

vec4 colourOfPixel(uint id) {
    RasterCopy copy = copyOf(id);
    frame = copy.frame;
    const Let let = FRAME.lets.at[id - copy.firstId];
    const LayerState layer = FRAME.layers.at[let.meta >> kLetLayerShift];
    const bool isBore = has(let.meta, kLetBore);
    const vec4 colour = colourOf(layer, let.element, isBore);
    if (!isShaded()) {
        return unshaded(colour);
    }
    const Sight sight = sightAt(gl_FragCoord.xy);
    const Seen seen = seenOf(let, layer, sight);
    const vec3 normal = seen.isHit ? seen.normal : vec3(0.0, 0.0, sight.along.z < 0.0 ? 1.0 : -1.0);
    return shaded(colour, materialOf(layer, let.element, isBore), normal, -sight.along, seen.position.xy);
}

void main() {
    frame = push.copies.at[0].frame;
    // Invocations beside the picture load too, discarded or not (docs/driver-notes.md): they must stay inside.
    const uvec2 at = min(uvec2(gl_FragCoord.xy), uvec2(FRAME.width, FRAME.height) - 1u);
    const uvec2 pixel = push.pixels.at[at.y * FRAME.width + at.x];
    if (pixel.y == 0u) {
        discard;
    }
    gl_FragDepth = uintBitsToFloat(pixel.y);
    // A loop and no condition: software devices leave out loops that none of a block's pixels enters, but run what is conditional for all of them.
    for (uint rest = min(pixel.y, 1u); rest > 0u; --rest) {
        outColour = colourOfPixel(pixel.x);
    }
}
