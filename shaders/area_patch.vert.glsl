#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"
#include "lib/area.glsl"
#include "lib/board_vertex.glsl"

// An area too small for its outline to be seen: its box, on the face that is seen. All of a layer are one instance, whose number is where their list
// begins.
void main() {
    const uint nth = uint(gl_VertexIndex) / kPatchVertices;
    const uint corner = uint(gl_VertexIndex) % kPatchVertices;
    const AreaInstance instance = FRAME.instances.at[FRAME.visiblePatches.at[uint(gl_InstanceIndex) + nth]];
    const ShapeBound bound = FRAME.bounds.at[instance.shape];
    // Corners (left, lower), (right, lower), (right, upper), and (left, lower), (right, upper), (left, upper).
    const vec2 side = vec2((0x16u >> corner) & 1u, (0x34u >> corner) & 1u) * 2.0 - 1.0;
    const LayerState layer = layerOf(instance);
    const bool isUpper = FRAME.quadFace == 0u;
    const vec3 position = vec3(placed(instance, bound.centre + side * bound.extent), faceOf(instance, layer, isUpper));
    writeVertex(position, layer, instance.element, false, float(isUpper), 0.0);
}
