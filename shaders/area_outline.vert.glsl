#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"
#include "lib/area.glsl"
#include "lib/board_vertex.glsl"
#include "lib/outline.glsl"

// Outlines of an area in flat views: six vertices per outline vertex make a line to the next one. A vertex that leads to itself makes nothing.
void main() {
    const AreaInstance instance = FRAME.instances.at[FRAME.visibleInstances.at[gl_InstanceIndex]];
    const LayerState layer = layerOf(instance);
    const uint vertex = uint(gl_VertexIndex) / 6u;
    const uint corner = uint(gl_VertexIndex) % 6u;
    // Corners (left', left, right), (left', right, right'): bit set = next vertex, or left side.
    const bool isNext = ((0x29u >> corner) & 1u) != 0u;
    const float side = ((0x0bu >> corner) & 1u) != 0u ? 0.5 : -0.5;
    const vec2 from = placed(instance, FRAME.vertices.at[vertex]);
    const vec2 to = placed(instance, FRAME.vertices.at[FRAME.next.at[vertex]]);
    const vec2 delta = to - from;
    const float len = length(delta);
    const vec2 across = len > 0.0 ? vec2(-delta.y, delta.x) * (side * kOutlinePx / FRAME.pixelsPerMm / len) : vec2(0.0);
    const bool isUpper = FRAME.quadFace == 0u;
    const vec3 position = vec3((isNext ? to : from) + across, faceOf(instance, layer, isUpper));
    writeVertex(position, layer, instance.element, false, float(isUpper), 0.0);
}
