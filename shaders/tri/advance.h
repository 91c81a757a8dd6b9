// Between two steps: where the work stands, and how many threads each kernel of the next step needs. Runs in one
// thread.

TRI_FN Groups groupsFor(uint threads) {
    const uint groups = (threads + kGroupSize - 1u) / kGroupSize;
    Groups result;
    result.x = groups < kMaxGroupsX ? groups : kMaxGroupsX;
    result.y = groups == 0u ? 0u : (groups + kMaxGroupsX - 1u) / kMaxGroupsX;
    result.z = 1u;
    return result;
}

TRI_FN void advance() {
    const uint vertices = FOREST.vertexCount;
    const bool isWaiting = CONTROL.inserted < CONTROL.total;
    if (PHASE == kInserting && !isWaiting && CONTROL.awake == 0u) {
        PHASE = kConstraining;
    } else if (PHASE == kConstraining && CONTROL.missing == 0u && CONTROL.awake == 0u) {
        PHASE = kFinished;
    }
    ++STEP;
    // The last few flips of a round may wait for the next: each round costs as much as a barrier, however little it
    // does.
    const bool isInserting = PHASE == kInserting && isWaiting && CONTROL.awake <= CONTROL.inserted / 32u;
    const bool isConstraining = PHASE == kConstraining;
    CONTROL.rounds += isInserting ? 1u : 0u;
    CONTROL.awake = 0u;
    CONTROL.missing = 0u;
    CONTROL.scratchUsed = 0u;
    CONTROL.insertGroups = groupsFor(isInserting ? vertices : 0u);
    CONTROL.relocateGroups = groupsFor(PHASE == kInserting && isWaiting ? vertices : 0u);
    CONTROL.flipGroups = groupsFor(PHASE != kFinished ? 2u * vertices : 0u);
    CONTROL.splitGroups = groupsFor(isInserting ? 2u * vertices : 0u);
    CONTROL.contourGroups = groupsFor(isConstraining ? 2u * vertices : 0u);
    CONTROL.edgeGroups = groupsFor(isConstraining ? vertices + FOREST.rayCount : 0u);
}
