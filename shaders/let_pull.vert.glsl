#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"
#include "lib/prism.glsl"
#include "lib/surface.glsl"

// Pull back end: the index table hands out vertex codes, the instance is a let that cull_lets listed.
layout(location = 0) out vec3 outPosition;
layout(location = 1) flat out vec4 outColour;
invariant gl_Position;

void main() {
    // The level travels above the code in the index tables.
    const uint code = uint(gl_VertexIndex) & 0xffffu;
    const uint level = uint(gl_VertexIndex) >> 16u;
    const Let let = FRAME.lets.at[FRAME.visibleLets.at[gl_InstanceIndex]];
    const LayerState layer = FRAME.layers.at[let.meta >> kLetLayerShift];
    const vec3 position = letPosition(let, layer, level, code);
    outPosition = position - FRAME.centre;
    const bool isBore = has(let.meta, kLetBore);
    outColour = colourOf(layer, let.element, isBore);
    gl_Position = clipPosition(outPosition, layer, let.element, isBore, float((code & 1u) == 0u), slendernessOf(let));
}
