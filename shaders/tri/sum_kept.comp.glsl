#version 460
#extension GL_GOOGLE_include_directive : require
#include "whole_forest.glsl"

shared uint sums[kGroupSize];

// One workgroup: the numbers of all blocks become where their triangles start. Every thread adds up a run of blocks.
void main() {
    const uint lane = gl_LocalInvocationID.x;
    const uint run = (blockCount() + kGroupSize - 1u) / kGroupSize;
    const uint first = min(lane * run, blockCount());
    const uint end = min(first + run, blockCount());
    uint sum = 0u;
    for (uint i = first; i < end; ++i) {
        sum += FOREST.sums.at[i];
    }
    sums[lane] = sum;
    barrier();
    uint start = 0u;
    for (uint i = 0u; i < lane; ++i) {
        start += sums[i];
    }
    for (uint i = first; i < end; ++i) {
        const uint count = FOREST.sums.at[i];
        FOREST.sums.at[i] = start;
        start += count;
    }
    if (lane == kGroupSize - 1u) {
        CONTROL.kept = start;
    }
}
