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
TRI_FN Groups groupsForList(uint most) {
    const uint threads = kMaxListGroups * kGroupSize;
    return groupsFor(most < threads ? most : threads);
}

// Do new vertices have to wait? Only while most of what was inserted is not Delaunay yet: flips cost less in a mesh
// that is nearly Delaunay, and steps more than flips.
TRI_FN bool mayInsert(uint inserted, uint awake) {
    return awake <= 2u * inserted + kGroupSize;
}

// The next step begins: the list of the one after it is empty.
TRI_FN void beginStep() {
    ++STEP;
    AWAKE_COUNT(STEP + 1u) = 0u;
    CONTROL.elected = 0u;
    CONTROL.claimed = 0u;
}

// Are flips all that is left to do, and so few of them that one workgroup does them (tail.comp.glsl)?
TRI_FN bool isTail() {
    const uint awake = AWAKE_COUNT(STEP + 1u);
    return PHASE == kConstraining && CONTROL.missing == 0u && awake != 0u && awake <= kFewAwake;
}

TRI_FN void advance() {
    const uint vertices = FOREST.vertexCount;
    const uint awake = AWAKE_COUNT(STEP + 1u);
    const bool isWaiting = CONTROL.inserted < CONTROL.total;
    // Flips remove no contour edge: once none is missing, none has to be looked for.
    bool isSearching = CONTROL.missing != 0u;
    if (PHASE == kInserting && !isWaiting && awake <= CONTROL.total / 16u) {
        PHASE = kConstraining;
        isSearching = true;
    } else if (PHASE == kConstraining && !isSearching && awake == 0u) {
        PHASE = kFinished;
    }
    beginStep();
    const bool isFinished = PHASE == kFinished;
    const bool isInserting = PHASE == kInserting && isWaiting && mayInsert(CONTROL.inserted, awake);
    // What is inserted or rebuilt in this step wakes others.
    const bool isMoreAwake = isInserting || isSearching;
    CONTROL.rounds += isInserting ? 1u : 0u;
    CONTROL.missing = 0u;
    CONTROL.scratchUsed = 0u;
    CONTROL.insertGroups = groupsFor(isInserting ? vertices : 0u);
    CONTROL.electedGroups = groupsForList(isInserting ? vertices : 0u);
    CONTROL.relocateGroups = groupsFor(PHASE == kInserting && isWaiting ? vertices : 0u);
    CONTROL.flipGroups = groupsForList(isFinished ? 0u : (isMoreAwake ? 2u * vertices : awake));
    CONTROL.splitGroups = groupsFor(isInserting ? 2u * vertices : 0u);
    CONTROL.contourGroups = groupsFor(isSearching ? 2u * vertices : 0u);
    CONTROL.edgeGroups = groupsFor(isSearching ? vertices + FOREST.rayCount : 0u);
}
