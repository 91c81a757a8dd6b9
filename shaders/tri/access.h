// How kernels that work on a whole forest name things; FOREST is theirs. The kernel in shared memory has names of its
// own (small.h).
#define CONTROL FOREST.control.at[0]
#define STEP CONTROL.step
#define PHASE CONTROL.phase
#define VERTEX_COUNT FOREST.vertexCount
#define RAY_COUNT FOREST.rayCount

#define POINT(v) FOREST.points.at[v]
#define ID(v) FOREST.ids.at[v]
#define NEXT(v) FOREST.next.at[v]
#define PREVIOUS(v) FOREST.previous.at[v]
#define WHERE(v) FOREST.where.at[v]
#define RANK(v) FOREST.note.at[v]
#define AROUND(v) FOREST.note.at[v]

#define CORNER(t, i) FOREST.corners.at[3u * (t) + (i)]
#define ACROSS(t, i) FOREST.across.at[3u * (t) + (i)]
#define MOVED(t, i) FOREST.moved.at[3u * (t) + (i)]
#define BEST(t) FOREST.best.at[t]
#define CLAIM(t) FOREST.claim.at[t]
#define STAMP(t) FOREST.stamp.at[t]
#define AWAKE(t) FOREST.awake.at[t]
#define STATE(t) FOREST.state.at[t]

#define RAY_AT(r) FOREST.rays.at[3u * (r)]
#define RAY_OTHER(r) FOREST.rays.at[3u * (r) + 1u]
#define RAY_LEAVES(r) (FOREST.rays.at[3u * (r) + 2u] != 0u)
#define FOUND(e) FOREST.found.at[e]
#define CORRIDOR(e) FOREST.corridor.at[e]
#define SCRATCH(i) FOREST.scratch.at[i]
#define SCRATCH_SIZE FOREST.scratchSize
#define SCRATCH_USED CONTROL.scratchUsed
#define TREE_OF(v) FOREST.trees.at[FOREST.treeOf.at[v]]
#define TREE_FLAGS(v) TREE_OF(v).flags

#define ADD_INSERTED(count) atomicAdd(CONTROL.inserted, count)
#define ADD_AWAKE(count) atomicAdd(CONTROL.awake, count)
#define ADD_MISSING(count) atomicAdd(CONTROL.missing, count)
#define ADD_FLIPS(count) atomicAdd(CONTROL.flips, count)
#define ADD_FLAG(v, flag) atomicMax(TREE_FLAGS(v), flag)

// The first of the four corners of the box around the tree of a vertex.
TRI_FN uint boxOf(uint v) {
    return TREE_OF(v).firstVertex + TREE_OF(v).vertexCount;
}
