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

#define CORNER(t, i) FOREST.triangles.at[t].corners[i]
#define CORNERS(t) uvec3(FOREST.triangles.at[t].corners)
#define ACROSS(t, i) FOREST.triangles.at[t].across[i]
#define ALL_ACROSS(t) uvec3(FOREST.triangles.at[t].across)
#define MOVED(t, i) FOREST.moved.at[3u * (t) + (i)]
#define BEST(t) FOREST.best.at[t]
#define CLAIM(t) FOREST.claim.at[t]
#define STAMP(t) FOREST.triangles.at[t].corners.w
#define AWAKE(t) FOREST.triangles.at[t].across.w
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

#define COUNT_INSERTED atomicAdd(CONTROL.inserted, 1u)
#define COUNT_MISSING atomicAdd(CONTROL.missing, 1u)
#define COUNT_FLIP atomicAdd(CONTROL.flips, 1u)
#define ADD_FLAG(v, flag) atomicMax(TREE_FLAGS(v), flag)

// Lists, in whatever order they come: triangles awake in even steps, in odd ones, and in one place first the vertices
// elected, then the triangles that flips claimed.
#define AWAKE_COUNT(step) CONTROL.awake[(step)&1u]
#define LISTED(list, i) FOREST.kept.at[2u * VERTEX_COUNT * (list) + (i)]
#define AWAKE_AT(i) LISTED(STEP & 1u, i)
#define ELECTED_AT(i) LISTED(2u, i)
#define CLAIMED_AT(i) LISTED(2u, i)
#define LIST_AWAKE(t, step) LISTED((step)&1u, atomicAdd(AWAKE_COUNT(step), 1u)) = t
#define LIST_ELECTED(q) ELECTED_AT(atomicAdd(CONTROL.elected, 1u)) = q
#define LIST_CLAIMED(t) CLAIMED_AT(atomicAdd(CONTROL.claimed, 1u)) = t

// The first of the four corners of the box around the tree of a vertex.
TRI_FN uint boxOf(uint v) {
    return TREE_OF(v).firstVertex + TREE_OF(v).vertexCount;
}
