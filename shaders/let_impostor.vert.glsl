#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"
#include "lib/prism.glsl"
#include "lib/surface.glsl"
#include "lib/let_index.glsl"

// Impostor back end: a rectangle around the face of a let; the fragment shader cuts the shape out. The index table is that of quads.
layout(location = 0) out vec2 outLocation;
layout(location = 1) flat out vec4 outColour;
layout(location = 2) flat out uint outLet;
layout(location = 3) flat out uint outMaterial;
invariant gl_Position;

void main() {
    const uint code = codeOfIndex();
    outLet = letOfIndex();
    const Let let = FRAME.lets.at[outLet];
    const LayerState layer = FRAME.layers.at[let.meta >> kLetLayerShift];
    const bool isBore = has(let.meta, kLetBore);
    const bool isUpper = (code & 1u) == 0u;
    const float protrusion = isBore ? FRAME.boreProtrusionMm : 0.0;
    const vec2 corner = quadCorner(code);
    const float z = isUpper ? layer.z1 + protrusion : layer.z0 - protrusion;
    const vec3 position = vec3(boundCorner(let, corner, 1.0 / FRAME.pixelsPerMm), z) - FRAME.centre;
    outLocation = position.xy;
    outColour = colourOf(layer, let.element, isBore);
    outMaterial = materialOf(layer, let.element, isBore);
    gl_Position = clipPosition(position, layer, let.element, isBore, float(isUpper), slendernessOf(let));
}
