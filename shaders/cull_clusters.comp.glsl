#version 460
#extension GL_GOOGLE_include_directive : require
#include "lib/frame.glsl"
#include "lib/cull_thread.glsl"
#include "lib/in_view.glsl"
#include "lib/level.glsl"

// One thread per cluster: lists those in view and sizes the dispatch of cull_lets.
layout(local_size_x = kCullGroupSize) in;

void main() {
    const uint index = cullThread();
    if (index >= FRAME.clusterCount) {
        return;
    }
    const Cluster cluster = FRAME.clusters.at[index];
    if (!isClusterInView(cluster, FRAME.layers.at[cluster.layer])) {
        return;
    }
    const uint slot = atomicAdd(FRAME.visibleClusters.count, 1u);
    FRAME.visibleClusters.at[slot] = index;
    if (slot < FRAME.maxDispatch) {
        atomicAdd(FRAME.visibleClusters.groupsX, 1u);
    }
}
