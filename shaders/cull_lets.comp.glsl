#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"
#include "lib/in_view.glsl"
#include "lib/level.glsl"

// One workgroup per cluster in view: sorts its lets into the instanced draws of their batch, topology and level. Counts in shared memory,
// so that no size of a subgroup is assumed and there is one atomic per cluster and draw.
layout(local_size_x = kClusterSize) in;

shared uint counts[kBucketCount];
shared uint starts[kBucketCount];

void sortCluster(Cluster cluster) {
    const uint thread = gl_LocalInvocationID.x;
    const LayerState layer = FRAME.layers.at[cluster.layer];
    if (thread < kBucketCount) {
        counts[thread] = 0u;
    }
    barrier();
    const uint index = cluster.firstLet + thread;
    uint bucket = kNotDrawn;
    uint slot = 0u;
    if (thread < cluster.count) {
        bucket = letBucket(FRAME.lets.at[index], layer);
    }
    if (bucket != kNotDrawn) {
        slot = atomicAdd(counts[bucket], 1u);
    }
    barrier();
    if (thread < kBucketCount && counts[thread] > 0u) {
        const uint draw = layer.batch * kBucketCount + thread;
        starts[thread] = FRAME.letDraws.at[draw].firstInstance +
                         atomicAdd(FRAME.letDraws.at[draw].instanceCount, counts[thread]);
    }
    barrier();
    if (bucket != kNotDrawn) {
        FRAME.visibleLets.at[starts[bucket] + slot] = index;
    }
    barrier();
}

void main() {
    const uint count = FRAME.visibleClusters.count;
    for (uint i = gl_WorkGroupID.x; i < count; i += gl_NumWorkGroups.x) {
        sortCluster(FRAME.clusters.at[FRAME.visibleClusters.at[i]]);
    }
}
