#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"
#include "lib/area.glsl"
#include "lib/surface.glsl"

// The upper or (push.face = 1) lower face of an area: the same stored triangles. Which face can be seen is known per
// layer; winding says nothing here, the mirror of an instance flips it.
layout(location = 0) out vec3 outPosition;
layout(location = 1) flat out vec4 outColour;
invariant gl_Position;

void main() {
    const AreaInstance instance = FRAME.instances.at[FRAME.visibleInstances.at[gl_InstanceIndex]];
    const LayerState layer = FRAME.layers.at[instance.layer];
    const bool isUpper = push.face == 0u;
    const vec3 position = vec3(placed(instance, FRAME.vertices.at[gl_VertexIndex]), faceOf(instance, layer, isUpper));
    outPosition = position - FRAME.centre;
    outColour = colourOf(layer, instance.element, false);
    gl_Position = clipPosition(outPosition, layer, instance.element, false, float(isUpper), 0.0);
}
