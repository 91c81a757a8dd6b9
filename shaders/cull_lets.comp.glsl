#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"
#include "lib/in_view.glsl"
#include "lib/level.glsl"
#include "lib/count.glsl"

// One workgroup per cluster in view: finds the draw of each let (batch, topology and level) and its place among that draw's instances, with one
// atomic per cluster and draw. place_lets makes the lists.
layout(local_size_x = kClusterSize) in;

shared uint starts[kBucketCount];

void countCluster(Cluster cluster) {
    const uint thread = gl_LocalInvocationID.x;
    const LayerState layer = FRAME.layers.at[cluster.layer];
    const uvec2 place = countLet(cluster, layer, true);
    if (thread < kBucketCount && counts[thread] > 0u) {
        starts[thread] = atomicAdd(FRAME.letDraws.at[layer.batch * kDrawCount + thread].instanceCount, counts[thread]);
    }
    barrier();
    if (thread < cluster.count) {
        FRAME.letSlots.at[cluster.firstLet + thread] =
            place.x != kNotDrawn ? place.x << kSlotBits | (starts[place.x] + place.y) : kNotDrawn;
    }
    barrier();
}

void main() {
    const uint count = FRAME.visibleClusters.count;
    for (uint i = gl_WorkGroupID.x; i < count; i += gl_NumWorkGroups.x) {
        countCluster(FRAME.clusters.at[FRAME.visibleClusters.at[i]]);
    }
}
