#version 460
#extension GL_GOOGLE_include_directive : require
#include "shared/section.h"

// Trapezoids in the cut, six vertices each.
layout(push_constant, scalar) uniform PushBlock {
    SectionPush push;
};
layout(location = 0) flat out vec3 outColour;

// Steps of tie-break between ranks: they are up to thousands of times as long as high, and depths of slivers stray.
const float kStepsPerRank = 8.0;

void main() {
    const SectionTrapezoid face = push.trapezoids.at[gl_VertexIndex / 6];
    const uint corner = gl_VertexIndex % 6;
    const bool isAtEnd = ((0x0eu >> corner) & 1u) != 0u;
    const bool isUpper = ((0x1cu >> corner) & 1u) != 0u;
    const vec2 location = isAtEnd ? (isUpper ? face.upperTo : face.to) : (isUpper ? face.upperFrom : face.from);
    const vec3 position = vec3(location, isUpper ? face.top : face.bottom);
    vec4 clip = push.frame.data.clipFromBoard * vec4(position - push.frame.data.centre, 1.0);
    clip.z += kStepsPerRank * float(face.rank) * (push.frame.data.nudgeZ * clip.z + push.frame.data.nudgeW * clip.w);
    outColour = face.colour;
    gl_Position = clip;
}
