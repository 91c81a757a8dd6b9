#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"
#include "lib/area.glsl"
#include "lib/board_vertex.glsl"

// The upper or (push.face = 1) lower face of an area: the same stored triangles. Which face can be seen is known per
// layer; winding says nothing here, the mirror of an instance flips it.
void main() {
    const AreaInstance instance = FRAME.instances.at[FRAME.visibleInstances.at[gl_InstanceIndex]];
    const LayerState layer = layerOf(instance);
    const bool isUpper = push.face == 0u;
    const vec3 position = vec3(placed(instance, FRAME.vertices.at[gl_VertexIndex]), faceOf(instance, layer, isUpper));
    writeVertex(position, layer, instance.element, false, float(isUpper), 0.0);
}
