#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"
#include "lib/prism.glsl"
#include "lib/surface.glsl"
#include "lib/let_index.glsl"

// Impostor back end, tilted views: a box around a let, whose front faces cover all that is seen of it. The index table is that of quads with walls.
layout(location = 0) flat out uint outLet;
invariant gl_Position;

void main() {
    const uint code = codeOfIndex();
    outLet = letOfIndex();
    const Let let = FRAME.lets.at[outLet];
    const LayerState layer = FRAME.layers.at[let.meta >> kLetLayerShift];
    const float protrusion = has(let.meta, kLetBore) ? FRAME.boreProtrusionMm : 0.0;
    const vec2 corner = quadCorner(code);
    const bool isUpper = (code & 1u) == 0u;
    const vec3 middle = vec3(let.p0, let.p1, isUpper ? layer.z1 : layer.z0) - FRAME.centre;
    const float margin = kSnapPx * abs((FRAME.clipFromBoard * vec4(middle, 1.0)).w) / FRAME.pixelsPerMm;
    const float z = isUpper ? layer.z1 + protrusion + margin : layer.z0 - protrusion - margin;
    const vec3 position = vec3(boundCorner(let, corner, margin), z) - FRAME.centre;
    // Nearer than all that its fragments find in it, which they promise (depth_less): what is hidden can be left out before they run.
    const uint top = (layer.flags >> kLayerTopRankShift) & 0xffu;
    const uint bottom = (layer.flags >> kLayerBottomRankShift) & 0xffu;
    gl_Position = nudged(FRAME.clipFromBoard * vec4(position, 1.0), 3.0 * float(max(top, bottom)) + 2.0, slendernessOf(let));
}
