#version 460
#extension GL_GOOGLE_include_directive : require
#include "forest.glsl"

// One workgroup per small tree: all its steps in shared memory, with barriers instead of dispatches. The result goes to the tree's place in the
// forest, where it is erased with all others. A tree that does not get ready in time is left to the other kernels.
layout(local_size_x = kGroupSize) in;

const uint kVertices = kSmallVertices + 4u;
const uint kTriangles = 2u * kVertices;
const uint kMaxSteps = 1000u;

shared uint corners[3 * kTriangles], across[3 * kTriangles], moved[3 * kTriangles];
shared uint best[kTriangles], claimed[kTriangles], stamp[kTriangles], awake[kTriangles];
shared uint where[kVertices], note[kVertices], corridor[kSmallEdges];
shared bool isInserting;
shared uint phase, step, inserted, awakeCount, missing, flips, flags;
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
#define ACROSS(t, i) across[3u * (t) + (i)]
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
#define ADD_INSERTED(count) atomicAdd(inserted, count)
#define ADD_AWAKE(count) atomicAdd(awakeCount, count)
#define ADD_MISSING(count) atomicAdd(missing, count)
#define ADD_FLIPS(count) atomicAdd(flips, count)
#define ADD_FLAG(v, flag) atomicMax(flags, flag)

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
        tree = FOREST.trees.at[groupIndex()];
        phase = kInserting;
        step = 0u;
        inserted = 0u;
        awakeCount = 0u;
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
    const bool isWaiting = inserted < tree.vertexCount;
    const bool isQuiet = awakeCount == 0u;
    const bool isComplete = missing == 0u;
    const uint before = phase;
    barrier();
    if (gl_LocalInvocationID.x == 0u) {
        if (before == kInserting && !isWaiting && isQuiet) {
            phase = kConstraining;
        } else if (before == kConstraining && isComplete && isQuiet) {
            phase = kFinished;
        }
        isInserting = phase == kInserting && isWaiting && isQuiet;
        ++step;
        awakeCount = 0u;
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
        for (uint i = 0u; i < 3u; ++i) {
            FOREST.corners.at[3u * (firstTriangle + t) + i] = isEmpty ? kNone : CORNER(t, i) + tree.firstVertex;
            FOREST.across.at[3u * (firstTriangle + t) + i] = inForest(ACROSS(t, i));
        }
        FOREST.awake.at[firstTriangle + t] = 0u;
    }
    FOR_EACH(v, VERTEX_COUNT) {
        FOREST.where.at[tree.firstVertex + v] = kNone;
    }
    if (gl_LocalInvocationID.x == 0u) {
        atomicAdd(FOREST.control.at[0].inserted, tree.vertexCount);
        atomicAdd(FOREST.control.at[0].flips, flips);
        FOREST.trees.at[groupIndex()].flags = flags;
    }
}

void main() {
    if (groupIndex() >= FOREST.smallTrees) {
        return;
    }
    begin();
    if (contourCount() > kSmallEdges) {
        return;
    }
    nextStep();
    while (phase != kFinished && step < kMaxSteps) {
        if (isInserting) {
            insertRound();
        }
        if (phase == kConstraining) {
            contourRound();
        }
        flipRound();
        nextStep();
    }
    if (phase == kFinished) {
        deliver();
    }
}
