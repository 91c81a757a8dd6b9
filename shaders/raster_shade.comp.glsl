#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/raster.glsl"
#include "lib/prism.glsl"
#include "lib/surface.glsl"
#include "lib/shading.glsl"
#include "lib/outline.glsl"
#include "lib/sight.glsl"

// Raster back end, one thread per pixel: the id of its nearest small let becomes that let's colour there. In a compute shader, because cards have more
// of those than of what shades fragments.
layout(local_size_x = kRasterGroupSize) in;

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

vec4 colourOfPixel(uint id, vec2 pixel) {
    RasterCopy copy = copyOf(id);
    frame = copy.frame;
    const Let let = FRAME.lets.at[id - copy.firstId];
    const LayerState layer = FRAME.layers.at[let.meta >> kLetLayerShift];
    const bool isBore = has(let.meta, kLetBore);
    const vec4 colour = colourOf(layer, let.element, isBore);
    if (!isShaded()) {
        return unshaded(colour);
    }
    const Sight sight = sightAt(pixel);
    const Seen seen = seenOf(let, layer, sight);
    const vec3 normal = seen.isHit ? seen.normal : vec3(0.0, 0.0, sight.along.z < 0.0 ? 1.0 : -1.0);
    return shaded(colour, materialOf(layer, let.element, isBore), normal, -sight.along, seen.position.xy);
}

void main() {
    frame = push.copies.at[0].frame;
    const uvec2 at = gl_GlobalInvocationID.xy;
    if (at.x >= FRAME.width) {
        return;
    }
    const uint index = at.y * FRAME.width + at.x;
    const uvec2 nearest = push.pixels.at[index];
    if (nearest.y == 0u) {
        return;
    }
    push.pixels.at[index].x = packColour(colourOfPixel(nearest.x, vec2(at) + 0.5).rgb);
}
