#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"
#include "lib/area.glsl"
#include "lib/board_vertex.glsl"

// Walls of an area: six vertices per outline vertex make the quad to the next one, counter-clockwise from outside. A vertex that leads to itself
// makes nothing.
void main() {
    const AreaInstance instance = FRAME.instances.at[FRAME.visibleInstances.at[gl_InstanceIndex]];
    const LayerState layer = layerOf(instance);
    const uint vertex = uint(gl_VertexIndex) / 6u;
    const uint corner = uint(gl_VertexIndex) % 6u;
    // Corners (upper', upper, lower), (upper', lower, lower'): bit set = next vertex, or upper face. A mirror turns the outline round.
    const bool isNext = (((0x29u >> corner) & 1u) ^ instance.isMirrored) != 0u;
    const bool isUpper = ((0x0bu >> corner) & 1u) != 0u;
    const uint at = isNext ? FRAME.next.at[vertex] : vertex;
    const vec3 position = vec3(placed(instance, FRAME.vertices.at[at]), faceOf(instance, layer, isUpper));
    writeVertex(position, layer, instance.element, false, float(isUpper), 0.0);
}
