#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_mesh_shader : require
#include "lib/frame.glsl"
#include "lib/in_view.glsl"
#include "lib/level.glsl"
#include "lib/count.glsl"
#include "lib/payload.glsl"

// Mesh back end, first half (paper, "Procedural"): one workgroup per cluster leaves out what is not in view, picks the level of
// detail of the rest and requests the mesh workgroups that will make it.
layout(local_size_x = kClusterSize) in;

// Position of the first let of a bucket in the payload.
uint startOf(uint bucket) {
    uint start = 0u;
    for (uint i = 0u; i < bucket; ++i) {
        start += payload.counts[i];
    }
    return start;
}

uint groupsForAll() {
    uint groups = 0u;
    for (uint i = 0u; i < kBucketCount; ++i) {
        groups += groupsFor(i, payload.counts[i]);
    }
    return groups;
}

void main() {
    const uint thread = gl_LocalInvocationID.x;
    const Cluster cluster = FRAME.clusters.at[push.first + gl_WorkGroupID.x];
    const LayerState layer = FRAME.layers.at[cluster.layer];
    const uvec2 place = countLet(cluster, layer, isClusterInView(cluster, layer));
    if (thread < kBucketCount) {
        payload.counts[thread] = counts[thread];
    }
    barrier();
    if (place.x != kNotDrawn) {
        payload.lets[startOf(place.x) + place.y] = cluster.firstLet + thread;
    }
    EmitMeshTasksEXT(groupsForAll(), 1, 1);
}
