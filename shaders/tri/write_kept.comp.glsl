#version 460
#extension GL_GOOGLE_include_directive : require
#include "whole_forest.glsl"

shared uint counts[kGroupSize];

// One workgroup per block of slots: writes its triangles that stay, in their order. Every thread takes a run of slots.
void main() {
    const uint kRun = kBlockSize / kGroupSize;
    const uint lane = gl_LocalInvocationID.x;
    const uint block = groupIndex();
    const uint first = block * kBlockSize + lane * kRun;
    uint count = 0u;
    for (uint i = 0u; i < kRun; ++i) {
        count += isKept(first + i) ? 1u : 0u;
    }
    counts[lane] = count;
    barrier();
    if (block >= blockCount()) {
        return;
    }
    uint slot = FOREST.sums.at[block];
    for (uint i = 0u; i < lane; ++i) {
        slot += counts[i];
    }
    for (uint i = 0u; i < kRun; ++i) {
        writeKept(first + i, slot);
        slot += isKept(first + i) ? 1u : 0u;
    }
}
