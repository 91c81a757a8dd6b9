#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"

// The instances of all draws of lets lie one behind the other. There are few draws: one thread adds them up.
layout(local_size_x = 1) in;

void main() {
    uint first = 0u;
    for (uint i = 0u; i < FRAME.letDrawCount; ++i) {
        FRAME.letDraws.at[i].firstInstance = first;
        first += FRAME.letDraws.at[i].instanceCount;
    }
}
