#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"
#include "lib/prism.glsl"
#include "lib/surface.glsl"

// Impostor back end: a rectangle around the face of a let; the fragment shader cuts the shape out. The index table is that of quads.
layout(location = 0) out vec2 outPlace;
layout(location = 1) flat out vec4 outColour;
layout(location = 2) flat out uint outLet;
invariant gl_Position;

// Corner (-1 or 1 each) of a rectangle around the let, a pixel larger than it.
vec2 boundCorner(Let let, vec2 corner) {
    const float margin = 1.0 / FRAME.pixelsPerMm;
    const vec2 p = vec2(let.p0, let.p1);
    const uint kind = let.meta & kLetKindMask;
    if (kind == kLetHole) {
        // The rectangle is the cell itself: its sides are exact.
        const vec2 along = let.p4 * vec2(let.p2, let.p3);
        return p + corner.x * along + corner.y * leftOf(along);
    }
    if (kind == kLetArc) {
        const float middle = let.p3 + 0.5 * let.p4;
        const vec2 u = vec2(cos(middle), sin(middle));
        const float reach = let.p5 + margin;
        const float low = let.p2 * cos(0.5 * let.p4) - reach;
        const float high = let.p2 + reach;
        return p + (corner.x < 0.0 ? low : high) * u + corner.y * (let.p2 * sin(0.5 * abs(let.p4)) + reach) * leftOf(u);
    }
    const vec2 q = vec2(let.p2, let.p3);
    const vec2 d = strokeDirection(p, q);
    const float reach = let.p4 * (has(let.meta, kLetSquarePen) ? 1.41421357 : 1.0) + margin;
    return (corner.x < 0.0 ? p : q) + reach * (corner.x * d + corner.y * leftOf(d));
}

void main() {
    const uint code = uint(gl_VertexIndex) & 0xffffu;
    outLet = FRAME.visibleLets.at[gl_InstanceIndex];
    const Let let = FRAME.lets.at[outLet];
    const LayerState layer = FRAME.layers.at[let.meta >> kLetLayerShift];
    const bool isBore = has(let.meta, kLetBore);
    const bool isUpper = (code & 1u) == 0u;
    const float proud = isBore ? FRAME.boreProudMm : 0.0;
    const vec2 corner = vec2((code >> 2u) == 0u ? -1.0 : 1.0, (code & 2u) == 0u ? 1.0 : -1.0);
    const vec3 position = vec3(boundCorner(let, corner), isUpper ? layer.z1 + proud : layer.z0 - proud);
    outPlace = position.xy - FRAME.centre.xy;
    outColour = colourOf(layer, let.element, isBore);
    gl_Position = clipPosition(position, layer, let.element, isBore, isUpper, slendernessOf(let));
}
