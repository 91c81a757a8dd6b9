#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"
#include "lib/board_vertex.glsl"

// Standard pipeline: a stored vertex and nothing else.
void main() {
    const StandardVertex vertex = FRAME.standardParts.at[push.first].vertices.at[gl_VertexIndex];
    const LayerState layer = FRAME.layers.at[FRAME.standardParts.at[push.first].layer];
    const bool isBore = has(vertex.owner, kStandardBore);
    const bool isUpper = vertex.face > 0.5;
    const uint element = vertex.owner & ~kStandardBore;
    const float protrusion = isBore ? FRAME.boreProtrusionMm : 0.0;
    const vec3 position = vec3(vertex.x, vertex.y, mix(layer.z0 - protrusion, layer.z1 + protrusion, vertex.face));
    writeVertex(position, layer, element, isBore, float(isUpper), 0.0);
    if (isHidden(element)) {
        gl_Position = vec4(0.0, 0.0, -1.0, 1.0);  // behind the far end
    }
}
