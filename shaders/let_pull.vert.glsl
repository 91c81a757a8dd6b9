#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"
#include "lib/prism.glsl"
#include "lib/board_vertex.glsl"

// Pull back end: the index table hands out vertex codes, the instance is a let that cull_lets listed.
void main() {
    // The level travels above the code in the index tables.
    const uint code = uint(gl_VertexIndex) & 0xffffu;
    const uint level = uint(gl_VertexIndex) >> 16u;
    const Let let = FRAME.lets.at[FRAME.visibleLets.at[gl_InstanceIndex]];
    const LayerState layer = FRAME.layers.at[let.meta >> kLetLayerShift];
    const vec3 position = letPosition(let, layer, level, code);
    writeVertex(position, layer, let.element, has(let.meta, kLetBore), float((code & 1u) == 0u), slendernessOf(let));
}
