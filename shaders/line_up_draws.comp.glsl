#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"

// The instances of all draws of lets lie one behind the other. There are few draws: one thread adds them up.
layout(local_size_x = 1) in;

// Quads become groups, which begin at multiples of their size, and a rest. Returns where the first is.
uint groupQuads(uint batch, uint first) {
    const uint quads = batch + kLevelQuad;
    const uint rest = batch + kDrawOfRest;
    const uint count = FRAME.letDraws.at[quads].instanceCount;
    const uint firstGroup = (first + kQuadGroup - 1u) / kQuadGroup;
    const uint groups = count / kQuadGroup;
    FRAME.letDraws.at[quads].firstInstance = firstGroup;
    FRAME.letDraws.at[quads].instanceCount = groups;
    FRAME.letDraws.at[rest].firstInstance = (firstGroup + groups) * kQuadGroup;
    FRAME.letDraws.at[rest].instanceCount = count % kQuadGroup;
    return firstGroup * kQuadGroup;
}

void main() {
    uint first = 0u;
    for (uint batch = 0u; batch < FRAME.letDrawCount; batch += kDrawCount) {
        for (uint bucket = 0u; bucket < kBucketCount; ++bucket) {
            const uint draw = batch + bucket;
            const uint count = FRAME.letDraws.at[draw].instanceCount;
            if (bucket == kLevelQuad) {
                first = groupQuads(batch, first);
            } else {
                FRAME.letDraws.at[draw].firstInstance = first;
            }
            first += count;
        }
    }
}
