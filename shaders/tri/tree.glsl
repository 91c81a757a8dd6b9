// One workgroup per tree of up to kMostVertices and kMostEdges: all its steps in shared memory, with barriers instead of dispatches. The result goes
// to the tree's place in the forest, where it is erased with all others. A tree that does not get ready in time is left to the other kernels.
#include "forest.glsl"

layout(local_size_x = kGroupSize) in;

const uint kVertices = kMostVertices + 4u;
const uint kTriangles = 2u * kVertices;
const uint kMaxSteps = 1000u;

shared uint corners[3 * kTriangles], across[3 * kTriangles], moved[3 * kTriangles];
shared uint best[kTriangles], claimed[kTriangles], stamp[kTriangles], awake[kTriangles];
shared uint where[kVertices], note[kVertices], corridor[kMostEdges];
shared bool isInserting, isSearching;
shared uint phase, step, inserted, awakeCount[2], missing, flips, flags;
shared Tree tree;

// The names of access.h, counted from the tree's first vertex, triangle and ray.
#define STEP step
#define PHASE phase
#define VERTEX_COUNT (tree.vertexCount + 4u)
#define RAY_COUNT tree.rayCount
#define POINT(v) FOREST.points.at[tree.firstVertex + (v)]
#define ID(v) FOREST.ids.at[tree.firstVertex + (v)]
#define NEXT(v) localVertex(FOREST.next.at[tree.firstVertex + (v)])
#define PREVIOUS(v) (FOREST.previous.at[tree.firstVertex + (v)] - tree.firstRay)
#define WHERE(v) where[v]
#define RANK(v) note[v]
#define AROUND(v) note[v]
#define CORNER(t, i) corners[3u * (t) + (i)]
#define CORNERS(t) uvec3(CORNER(t, 0u), CORNER(t, 1u), CORNER(t, 2u))
#define ACROSS(t, i) across[3u * (t) + (i)]
#define ALL_ACROSS(t) uvec3(ACROSS(t, 0u), ACROSS(t, 1u), ACROSS(t, 2u))
#define MOVED(t, i) moved[3u * (t) + (i)]
#define BEST(t) best[t]
#define CLAIM(t) claimed[t]
#define STAMP(t) stamp[t]
#define AWAKE(t) awake[t]
#define RAY_AT(r) (FOREST.rays.at[3u * (tree.firstRay + (r))] - tree.firstVertex)
#define RAY_OTHER(r) (FOREST.rays.at[3u * (tree.firstRay + (r)) + 1u] - tree.firstVertex)
#define RAY_LEAVES(r) (FOREST.rays.at[3u * (tree.firstRay + (r)) + 2u] != 0u)
#define FOUND(e) best[e]  // while contours are searched for nobody votes
#define CORRIDOR(e) corridor[e]
#define SCRATCH(i) FOREST.scratch.at[i]
#define SCRATCH_SIZE FOREST.scratchSize
#define SCRATCH_USED FOREST.control.at[0].scratchUsed
#define TREE_FLAGS(v) flags
#define COUNT_INSERTED atomicAdd(inserted, 1u)
#define LIST_AWAKE(t, step) atomicAdd(awakeCount[(step) & 1u], 1u)  // counted only: going through all is no more work
#define LIST_ELECTED(q)
#define LIST_CLAIMED(t)
#define COUNT_MISSING atomicAdd(missing, 1u)
#define COUNT_FLIP atomicAdd(flips, 1u)
#define ADD_FLAG(v, flag) atomicMax(flags, flag)

uint treeIndex() {
    return push.firstTree + groupIndex();
}

uint localVertex(uint v) {
    return v < kBusy ? v - tree.firstVertex : v;
}

#include "mesh.h"
#include "insert.h"
#include "flip.h"
#include "constrain.h"

#define FOR_EACH(index, count) for (uint index = gl_LocalInvocationID.x; index < (count); index += kGroupSize)

void fixAll(uint stage) {
    FOR_EACH(t, 2u * VERTEX_COUNT) {
        fixLinks(t, stage);
    }
}

void insertRound() {
    FOR_EACH(q, VERTEX_COUNT) {
        vote(q);
    }
    barrier();
    FOR_EACH(q, VERTEX_COUNT) {
        claimPlace(q);
    }
    barrier();
    FOR_EACH(q, VERTEX_COUNT) {
        splitPlace(q);
    }
    barrier();
    fixAll(kStageInsert);
    FOR_EACH(p, VERTEX_COUNT) {
        relocateInserted(p);
    }
    barrier();
}

void contourRound() {
    FOR_EACH(t, 2u * VERTEX_COUNT) {
        findContours(t);
    }
    barrier();
    FOR_EACH(e, contourCount()) {
        claimCorridor(e);
    }
    barrier();
    FOR_EACH(e, contourCount()) {
        rebuildCorridor(e);
    }
    barrier();
    fixAll(kStageRebuild);
    barrier();
}

void flipRound() {
    FOR_EACH(t, 2u * VERTEX_COUNT) {
        testEdges(t);
    }
    barrier();
    FOR_EACH(t, 2u * VERTEX_COUNT) {
        flipEdge(t);
    }
    barrier();
    fixAll(kStageFlip);
    FOR_EACH(p, VERTEX_COUNT) {
        relocateFlipped(p);
    }
    barrier();
}

void begin() {
    if (gl_LocalInvocationID.x == 0u) {
        tree = FOREST.trees.at[treeIndex()];
        phase = kInserting;
        step = 0u;
        inserted = 0u;
        awakeCount[0] = 0u;
        awakeCount[1] = 0u;
        missing = 0u;
        flips = 0u;
        flags = 0u;
    }
    barrier();
    FOR_EACH(v, VERTEX_COUNT) {
        initVertex(v, tree.vertexCount);
    }
    barrier();
}

// What advance() is for the forest. Every thread comes to the same phase.
void nextStep() {
    barrier();
    if (gl_LocalInvocationID.x == 0u) {
        const uint awakeNext = awakeCount[(step + 1u) & 1u];
        const bool isWaiting = inserted < tree.vertexCount;
        isSearching = missing != 0u;
        if (phase == kInserting && !isWaiting && awakeNext <= kGroupSize / 4u) {
            phase = kConstraining;
            isSearching = true;
        } else if (phase == kConstraining && !isSearching && awakeNext == 0u) {
            phase = kFinished;
        }
        isInserting = isWaiting && awakeNext <= inserted / 2u + kGroupSize / 4u;
        ++step;
        awakeCount[(step + 1u) & 1u] = 0u;
        missing = 0u;
    }
    barrier();
}

// Vertex, triangle and edge numbers become those of the forest.
uint inForest(uint edge) {
    return edge == kNone ? kNone : edge + (8u * tree.firstVertex);
}

void deliver() {
    const uint firstTriangle = 2u * tree.firstVertex;
    FOR_EACH(t, 2u * VERTEX_COUNT) {
        const bool isEmpty = isDead(t);
        const uvec3 corners = isEmpty ? uvec3(kNone) : CORNERS(t) + tree.firstVertex;
        const uvec3 across = ALL_ACROSS(t);
        FOREST.triangles.at[firstTriangle + t] =
            Triangle(uvec4(corners, 0u), uvec4(inForest(across.x), inForest(across.y), inForest(across.z), 0u));
    }
    FOR_EACH(v, VERTEX_COUNT) {
        FOREST.where.at[tree.firstVertex + v] = kNone;
    }
    if (gl_LocalInvocationID.x == 0u) {
        atomicAdd(FOREST.control.at[0].inserted, tree.vertexCount);
        atomicAdd(FOREST.control.at[0].flips, flips);
        FOREST.trees.at[treeIndex()].flags = flags;
    }
}

void main() {
    if (groupIndex() >= kTrees) {
        return;
    }
    begin();
    if (contourCount() > kMostEdges) {
        return;
    }
    nextStep();
    while (phase != kFinished && step < kMaxSteps) {
        if (isInserting) {
            insertRound();
        }
        if (isSearching) {
            contourRound();
        }
        flipRound();
        nextStep();
    }
    if (phase == kFinished) {
        deliver();
    }
}
