// What every shader of a frame sees, shared by C++ and GLSL: buffers by address, camera, level-of-detail limits. There
// is one FrameData for each copy of a step that is drawn: everything in it is in the coordinates of that step, so that
// shaders know nothing of copies.
#ifndef COPPERSCOPE_SHADERS_SHARED_FRAME_H
#define COPPERSCOPE_SHADERS_SHARED_FRAME_H

#include "board.h"
#include "let_mesh.h"

#ifdef __cplusplus
namespace shader {
#define GPU_ADDRESS(Column) std::uint64_t
#else
#define GPU_ADDRESS(Column) Column
#endif

// VkDrawIndexedIndirectCommand and VkDrawIndirectCommand.
struct DrawIndexed {
    uint indexCount, instanceCount, firstIndex, vertexOffset, firstInstance;
};
GPU_SIZE(DrawIndexed, 20);
struct Draw {
    uint vertexCount, instanceCount, firstVertex, firstInstance;
};
GPU_SIZE(Draw, 16);

// The areas of one layer that have one shape: what drawing them takes.
struct AreaDraw {
    uint indexCount, firstIndex, vertexOffset;  // of caps
    uint wallVertexCount, firstWallVertex;
    uint firstInstance;
};
GPU_SIZE(AreaDraw, 24);
// AreaDraws of one layer, one behind the other: those with areas in view are drawn by one indirect command list, which
// every device takes.
GPU_CONST kMostAreaDraws = 4096;
struct AreaRun {
    uint first, count;
};
GPU_SIZE(AreaRun, 8);

// Some elements of one layer in the standard pipeline.
GPU_READ(StandardVertices, StandardVertex, 4);
struct StandardPartRecord {
    GPU_ADDRESS(StandardVertices) vertices;
    uint layer;
    uint reserved;
};
GPU_SIZE(StandardPartRecord, 16);

// A box around a shape in its own coordinates, for culling and patches.
struct ShapeBound {
    vec2 centre;
    vec2 extent;  // half of its size
    float stray;  // how far the box strays from the shape
};
GPU_SIZE(ShapeBound, 20);

#ifndef __cplusplus
GPU_READ(StandardParts, StandardPartRecord, 8);
GPU_READ(Lets, Let, 4);
GPU_READ(Clusters, Cluster, 4);
GPU_READ(Layers, LayerState, 4);
GPU_READ(Vertices, vec2, 4);
GPU_READ(Words, uint, 4);
GPU_READ(Instances, AreaInstance, 4);
GPU_READ(Bounds, ShapeBound, 4);
GPU_READ(AreaDraws, AreaDraw, 4);
GPU_READ(AreaRuns, AreaRun, 4);
GPU_READ(Colours, vec3, 4);
GPU_WRITE(WordList, uint, 4);
GPU_WRITE(IndexedDraws, DrawIndexed, 4);
GPU_WRITE(Draws, Draw, 4);
// The clusters in view, with the command that dispatches one workgroup for each (up to a limit; the rest by striding).
layout(buffer_reference, scalar, buffer_reference_align = 4) buffer ClusterList {
    uint groupsX, groupsY, groupsZ, count, at[];
};
#endif

GPU_CONST kFrameFlat = 1;           // no lighting
GPU_CONST kFrameMono = 2;           // everything visible is white
GPU_CONST kFrameOutlines = 4;       // flat views: outlines, and nothing in them
GPU_CONST kFrameCull = 8;           // frustum culling and level of detail
GPU_CONST kFramePaperLevels = 16;   // none but the paper's three levels of detail
GPU_CONST kFrameImpostors = 32;     // all lets are quads, whose fragments know the outline
GPU_CONST kFrameSmoothed = 64;      // four samples per pixel
GPU_CONST kFrameStandingOut = 128;  // only what is highlighted or has a colour of its own
GPU_CONST kFrameSilhouettes = 256;  // everything in one dark colour
GPU_CONST kFrameFabricated = 512;   // without what is milled away

GPU_CONST kPatchVertices = 6;

GPU_CONST kSlotBits = 28;

GPU_CONST kPlaneCount = 6;

// Where bodies darken the side of the board that is seen (render/modelling/body_shadows.h).
struct Shadows {
    GPU_ADDRESS(Words) cells;
    vec2 origin;  // lower left corner of the map, relative to FrameData::centre, mm
    float cellsPerMm;
    float strength;      // by how much where it is darkest
    uint width, height;  // cells
};
GPU_SIZE(Shadows, 32);

struct FrameData {
    mat4 clipFromBoard;        // of positions relative to `centre`: differences of nearby numbers stay exact in 32 bits
    vec4 planes[kPlaneCount];  // of the frustum, pointing inwards, for positions relative to `centre`
    vec4 eye;                  // relative to `centre`; w = 1: a point (perspective), w = 0: the direction to the viewer
    vec3 centre;               // what the camera looks at, mm
    // The picture stood up at `centre`, facing the viewer, relative to it: its upper left corner and the line from one
    // pixel to the next, mm.
    vec3 screen, screenRight, screenDown;
    uint width, height;      // of the picture, pixels
    vec2 light;              // unit vector to where the light comes from
    float pixelsPerMm;       // at w = 1: pixels = mm * pixelsPerMm / w
    float tolerancePx;       // how far a polygon may stray from the true outline
    float quadRadiusPx;      // lets with a smaller pen become quads; 0 = never
    float rasterRadiusPx;    // lets with a smaller circle around them are rasterised by compute shaders; 0 = never
    float thinPx;            // walls of fewer pixels are left out; 0 = never
    vec3 sectionPlane;       // p relative to `centre` is cut away where dot(cut.xy, p.xy) > cut.z (lib/section.glsl)
    float restStrength;      // of what is neither highlighted nor has a colour of its own: 0 = as the background
    float nudgeZ, nudgeW;    // one step of tie-break moves z by nudgeZ * z + nudgeW * w
    float sliverNudge;       // by how much of itself a step grows for each width a let is long
    float boreProtrusionMm;  // how far the dark inside of a hole protrudes from the outer faces
    uint flags;
    uint firstTriangle;  // of the 8 of a ladder interval, the run that can be seen (let_mesh.h)
    uint triangleCount;
    uint quadFace;  // 0 = the upper, 1 = the lower face faces the viewer
    uint clusterCount;
    uint letDrawCount;  // of letDraws
    uint instanceCount;
    uint maxDispatch;  // largest number of workgroups along x
    vec3 background;   // linear

    GPU_ADDRESS(Layers) layers;
    GPU_ADDRESS(Lets) lets;
    GPU_ADDRESS(Clusters) clusters;
    GPU_ADDRESS(ClusterList) visibleClusters;
    GPU_ADDRESS(WordList)
    letSlots;  // by let of a visible cluster: kSlotBits of its place in its draw, above them the bucket
    GPU_ADDRESS(WordList)
    visibleLets;  // by draw: at[firstInstance + instance], of groups of quads as many for each instance
    GPU_ADDRESS(IndexedDraws) letDraws;  // batch * kDrawCount + topology * kLevelCount + level
    GPU_ADDRESS(Vertices) vertices;
    GPU_ADDRESS(Words) next;
    GPU_ADDRESS(Instances) instances;
    GPU_ADDRESS(AreaDraws) areaDraws;
    GPU_ADDRESS(AreaRuns) areaRuns;
    GPU_ADDRESS(Words) drawOfInstance;  // row of areaDraws
    GPU_ADDRESS(Bounds) bounds;
    GPU_ADDRESS(WordList) areaCounts;          // by draw: so many instances are in view
    GPU_ADDRESS(WordList) visibleInstances;    // by draw: at[firstInstance + instance]
    GPU_ADDRESS(WordList) visiblePatches;      // by layer: at[firstInstance + vertex / 6]
    GPU_ADDRESS(Draws) patchDraws;             // by layer
    GPU_ADDRESS(WordList) commandCounts;       // by run: how many of its draws have instances in view
    GPU_ADDRESS(IndexedDraws) capDraws;        // by run, from its first draw on: the commands of those
    GPU_ADDRESS(Draws) wallDraws;              // likewise
    GPU_ADDRESS(Words) elementStates;          // a byte per element
    GPU_ADDRESS(Colours) palette;              // colours of elements, linear
    GPU_ADDRESS(StandardParts) standardParts;  // null in the hybrid pipeline

    vec3 keyLight;  // unit vector to what glossy surfaces mirror
    uint reserved;

    Shadows shadows;
};
GPU_SIZE(FrameData, 64 + 96 + 16 + 4 * 12 + 8 + 16 + 22 * 4 + 24 * 8 + 16 + 32);

#ifndef __cplusplus
layout(buffer_reference, scalar, buffer_reference_align = 8) readonly buffer Frame {
    FrameData data;
};
#endif

// Push constants of all pipelines.
struct Push {
    GPU_ADDRESS(Frame) frame;
    uint first;  // task: the first cluster; standard: the part
    uint face;   // caps of areas: 0 = upper, 1 = lower
    // Those of the frame: reading them from memory for every pixel costs software devices a fifth of a frame.
    Shadows shadows;
};
GPU_SIZE(Push, 48);

GPU_CONST kCullGroupSize = 64;  // threads per workgroup of the compute shaders that test clusters and area instances
GPU_CONST kCullRow = 1024;  // workgroups of them along x: devices need take no more than 65,535 along x, nor along y

#ifdef __cplusplus
}  // namespace shader
#endif
#endif
