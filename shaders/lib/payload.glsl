// What a task workgroup hands to its mesh workgroups: the lets of one cluster that are in view, sorted by topology and level.
struct Payload {
    uint counts[kBucketCount];
    uint lets[kClusterSize];
};
taskPayloadSharedEXT Payload payload;

// Mesh workgroups share small lets and divide large ones, so that each makes about 64 vertices.

// Lets per workgroup.
uint letsPerGroup(uint topology, uint level) {
    if (level == kLevelQuad) {
        return 16u;
    }
    return topology == kTopologyOpen ? max(1u, 16u / kEndPoints[level]) : 1u;
}

// Workgroups per let (1 where several lets share one).
uint slicesOf(uint topology, uint level) {
    return (ladderIntervals(topology, level) + kSliceIntervals - 1u) / kSliceIntervals;
}

uint groupsFor(uint bucket, uint letCount) {
    const uint topology = bucket / kLevelCount;
    const uint level = bucket % kLevelCount;
    const uint together = letsPerGroup(topology, level);
    return (letCount + together - 1u) / together * slicesOf(topology, level);
}
