// The mesh of a let, shared by C++ (index tables of the pull back end) and GLSL (mesh back end, vertices of both).
//
// Seen from above every let is a ladder: segments that each have a left and a right end on the outline, and an interval
// between two neighbouring segments. Extruded from z0 to z1 an interval is 8 triangles: 2 above, 2 of the left wall, 2
// of the right wall, 2 below. An open ladder (track, disc, arc) has a wall at either end; a closed one (ring: left =
// inner, right = outer outline) returns to its first segment. A vertex is named by its code: segment * 4 + side * 2 +
// face, side 0 = left, face 0 = upper.
#ifndef COPPERSCOPE_SHADERS_SHARED_LET_MESH_H
#define COPPERSCOPE_SHADERS_SHARED_LET_MESH_H

#include "board.h"

#ifdef __cplusplus
namespace shader {
#define GPU_TABLE constexpr uint
#define GPU_FN constexpr
#else
#define GPU_TABLE const uint
#define GPU_FN
#endif

GPU_CONST kTopologyOpen = 0;
GPU_CONST kTopologyClosed = 1;
GPU_CONST kTopologyCount = 2;

// Levels of detail: the paper's three (64, 32 and 16 vertices per solid let), one finer for deep zoom, the coarsest
// without walls for what is thin, and a flat quad for less than a pixel.
GPU_CONST kLevelFine = 0;
GPU_CONST kLevel64 = 1;
GPU_CONST kLevel32 = 2;
GPU_CONST kLevel16 = 3;
GPU_CONST kLevelFlat = 4;  // from here on only the face that can be seen
GPU_CONST kLevelQuad = 5;
GPU_CONST kLevelCount = 6;
GPU_CONST kBucketCount = 12;  // kTopologyCount * kLevelCount
// Quads are open, so the last bucket is free: lets that the raster back end draws without triangles.
GPU_CONST kBucketRaster = 11;

// A batch of lets is drawn by one draw for each bucket, and one more for the quads that fill no group: software devices
// draw many small instances slowly, so quads are drawn by groups of so many.
GPU_CONST kQuadGroup = 32;
GPU_CONST kDrawOfRest = 12;
GPU_CONST kDrawCount = 13;

// An index of the pull back end's tables: level << kIndexLevelShift | vertex code; of grouped quads kIndexGrouped |
// level << kIndexLevelShift | which of the group << kIndexQuadShift | vertex code. Below 2^24, as every device can.
GPU_CONST kIndexQuadShift = 3;
GPU_CONST kIndexLevelShift = 16;
GPU_CONST kIndexGrouped = 0x80000;

// Points of one rounded end by level; an open ladder has as many segments, a ring's outline twice as many points.
GPU_TABLE kEndPoints[6] = {64, 16, 8, 4, 4, 2};
// Segments of an arc that round either end, and chords of its body: segments - 2 * ends + 1.
GPU_TABLE kArcEndSegments[5] = {16, 4, 2, 2, 2};
GPU_TABLE kArcChords[5] = {33, 9, 5, 1, 1};

// Triangles of an interval by codes relative to its first segment (0-3 that segment, 4-7 the next), counter-clockwise
// from outside, one hexadecimal digit per corner. Upper, walls, lower: whatever side one looks from, what can be seen
// is a run.
GPU_CONST kIntervalTriangleCount = 8;
GPU_TABLE kIntervalTriangles[8] = {0x026, 0x064, 0x045, 0x051, 0x623, 0x637, 0x173, 0x157};
GPU_CONST kUpperTriangles = 2;
GPU_CONST kWallTriangles = 4;
// The end walls of an open ladder: two triangles at the first segment, two at the last (digits: 0-3 that segment).
GPU_CONST kEndTriangleCount = 2;
GPU_TABLE kFirstEndTriangles[2] = {0x201, 0x213};
GPU_TABLE kLastEndTriangles[2] = {0x023, 0x031};

// The mesh back end draws a let in slices of at most this many intervals: 17 segments are 68 vertices.
GPU_CONST kSliceIntervals = 16;
GPU_CONST kSliceMaxVertices = 68;    // (kSliceIntervals + 1) * 4
GPU_CONST kSliceMaxTriangles = 132;  // kSliceIntervals * 8 + 4

// Intervals of a ladder of this topology and level.
GPU_FN uint ladderIntervals(uint topology, uint level) {
    return topology == kTopologyClosed ? kEndPoints[level] * 2 : kEndPoints[level] - 1;
}

#ifdef __cplusplus
}  // namespace shader
#endif
#endif
