#version 460
#extension GL_GOOGLE_include_directive : require
#define TRI_COHERENT coherent
#define THREADS_PER_GROUP kTailThreads
#include "whole_forest.glsl"

// One workgroup: the last flips, one round after the other. Rounds that have a handful of triangles left are many, and a dispatch for each costs more
// than what it does.
void sync() {
    groupMemoryBarrier();
    barrier();
}

#define FOR_EACH(index, count) for (uint index = gl_LocalInvocationID.x; index < (count); index += kTailThreads)

void main() {
    while (isTail()) {
        barrier();
        if (gl_LocalInvocationID.x == 0u) {
            beginStep();
        }
        sync();
        FOR_EACH(i, AWAKE_COUNT(STEP)) {
            testEdges(AWAKE_AT(i));
        }
        sync();
        FOR_EACH(i, CONTROL.claimed) {
            flipEdge(CLAIMED_AT(i));
        }
        sync();
        FOR_EACH(i, CONTROL.claimed) {
            fixLinks(CLAIMED_AT(i), kStageFlip);
        }
        sync();
    }
}
