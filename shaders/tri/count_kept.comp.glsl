#version 460
#extension GL_GOOGLE_include_directive : require
#include "whole_forest.glsl"

shared uint sum;

// One workgroup per block of slots: how many of its triangles stay.
void main() {
    sum = 0u;
    barrier();
    const uint block = groupIndex();
    for (uint i = gl_LocalInvocationID.x; i < kBlockSize; i += kGroupSize) {
        if (isKept(block * kBlockSize + i)) {
            atomicAdd(sum, 1u);
        }
    }
    barrier();
    if (gl_LocalInvocationID.x == 0u && block < blockCount()) {
        FOREST.sums.at[block] = sum;
    }
}
