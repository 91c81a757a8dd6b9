#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"
#include "lib/in_view.glsl"
#include "lib/level.glsl"

// One workgroup per cluster in view: writes its lets to the slots that cull_lets found.
layout(local_size_x = kClusterSize) in;

void main() {
    const uint count = FRAME.visibleClusters.count;
    for (uint i = gl_WorkGroupID.x; i < count; i += gl_NumWorkGroups.x) {
        const Cluster cluster = FRAME.clusters.at[FRAME.visibleClusters.at[i]];
        const uint index = cluster.firstLet + gl_LocalInvocationID.x;
        if (gl_LocalInvocationID.x < cluster.count && FRAME.letSlots.at[index] != kNotDrawn) {
            const uint slot = FRAME.letSlots.at[index];
            const uint bucket = slot >> kSlotBits;
            const uint instance = FRAME.letDraws.at[FRAME.layers.at[cluster.layer].batch * kDrawCount + bucket].firstInstance;
            const uint first = bucket == kLevelQuad ? instance * kQuadGroup : instance;
            FRAME.visibleLets.at[first + (slot & ((1u << kSlotBits) - 1u))] = index;
        }
    }
}
