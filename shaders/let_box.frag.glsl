#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"
#include "lib/prism.glsl"
#include "lib/surface.glsl"
#include "lib/shading.glsl"
#include "lib/outline.glsl"
#include "lib/sight.glsl"

// Impostor back end, tilted views: what this sample sees of the let itself.
layout(location = 0) flat in uint inLet;
layout(location = 0) out vec4 outColour;
layout(depth_less) out float gl_FragDepth;

void main() {
    const Let let = FRAME.lets.at[inLet];
    const LayerState layer = FRAME.layers.at[let.meta >> kLetLayerShift];
    const Sight sight = sightAt(gl_FragCoord.xy);
    const Seen seen = seenOf(let, layer, sight);
    if (!seen.isHit) {
        discard;
    }
    const bool isBore = has(let.meta, kLetBore);
    const vec4 clip = clipPosition(seen.position, layer, let.element, isBore, seen.height, slendernessOf(let));
    gl_FragDepth = clip.z / clip.w;
    const vec4 colour = colourOf(layer, let.element, isBore);
    outColour = isShaded() ? shaded(colour, materialOf(layer, let.element, isBore), seen.normal, -sight.along, seen.position.xy) : unshaded(colour);
}
