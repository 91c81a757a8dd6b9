#version 460
#extension GL_GOOGLE_include_directive : require
// A kernel that does RUN for every index below THREADS (CMakeLists.txt).
#include "whole_forest.glsl"

void main() {
    const uint index = groupIndex() * kGroupSize + gl_LocalInvocationID.x;
    if (index < THREADS) {
        RUN;
    }
}
