// Sorts the lets of a cluster by topology and level: one workgroup per cluster, a thread per let. Needs level.glsl.
// Counts in shared memory, so that no size of a subgroup is assumed.
shared uint counts[kBucketCount];

// The bucket of this thread's let, or kNotDrawn, and its place among the lets of that bucket; all counts are there then.
uvec2 countLet(Cluster cluster, LayerState layer, bool isDrawn) {
    const uint thread = gl_LocalInvocationID.x;
    if (thread < kBucketCount) {
        counts[thread] = 0u;
    }
    barrier();
    uvec2 place = uvec2(kNotDrawn, 0u);
    if (isDrawn && thread < cluster.count) {
        place.x = letBucket(FRAME.lets.at[cluster.firstLet + thread], layer);
    }
    if (place.x != kNotDrawn) {
        place.y = atomicAdd(counts[place.x], 1u);
    }
    barrier();
    return place;
}
