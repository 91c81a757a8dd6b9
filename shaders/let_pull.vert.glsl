#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"
#include "lib/prism.glsl"
#include "lib/board_vertex.glsl"
#include "lib/let_index.glsl"

// Pull back end: the index table hands out vertex codes, the instance is a let that cull_lets listed, or a group of them.
void main() {
    const uint code = codeOfIndex();
    const Let let = FRAME.lets.at[letOfIndex()];
    const LayerState layer = FRAME.layers.at[let.meta >> kLetLayerShift];
    const vec3 position = letPosition(let, layer, levelOfIndex(), code);
    writeVertex(position, layer, let.element, has(let.meta, kLetBore), float((code & 1u) == 0u), slendernessOf(let));
}
