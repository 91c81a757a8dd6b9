// What the index tables of the pull back end say (shared/let_mesh.h): which vertex of which let.

uint codeOfIndex() {
    const uint index = uint(gl_VertexIndex);
    return index & (has(index, kIndexGrouped) ? (1u << kIndexQuadShift) - 1u : (1u << kIndexLevelShift) - 1u);
}

uint levelOfIndex() {
    return (uint(gl_VertexIndex) & (kIndexGrouped - 1u)) >> kIndexLevelShift;
}

// The row of the let.
uint letOfIndex() {
    const uint index = uint(gl_VertexIndex);
    const uint instance = uint(gl_InstanceIndex);
    const uint nth = (index >> kIndexQuadShift) % kQuadGroup;
    return FRAME.visibleLets.at[has(index, kIndexGrouped) ? instance * kQuadGroup + nth : instance];
}
