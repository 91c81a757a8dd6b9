// What vertex shaders hand to board.frag.
#include "surface.glsl"

layout(location = 0) out vec3 outPosition;
layout(location = 1) flat out vec4 outColour;
layout(location = 2) flat out uint outMaterial;
invariant gl_Position;

// A vertex at a location of the board, `height` from 0 on the lower to 1 on the upper face of its layer.
void writeVertex(vec3 location, LayerState layer, uint element, bool isBore, float height, float slenderness) {
    outPosition = location - FRAME.centre;
    outColour = colourOf(layer, element, isBore);
    outMaterial = materialOf(layer, element, isBore);
    gl_Position = clipPosition(outPosition, layer, element, isBore, height, slenderness);
}
