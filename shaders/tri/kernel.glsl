#version 460
#extension GL_GOOGLE_include_directive : require
// A kernel that does RUN for every index below THREADS (CMakeLists.txt); a thread does several where the groups are
// fewer than that.
#include "whole_forest.glsl"

void main() {
    const uint all = gl_NumWorkGroups.x * gl_NumWorkGroups.y * kGroupSize;
    for (uint index = groupIndex() * kGroupSize + gl_LocalInvocationID.x; index < THREADS; index += all) {
        RUN;
    }
}
