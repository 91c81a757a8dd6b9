// What the kernels of triangulation work on: all polygons of a board as one forest of meshes. Every polygon is a tree:
// its vertices and the four corners of a box around it lie behind each other in the arrays, and vertex v owns the
// triangle slots 2v and 2v+1. Inserting a vertex makes exactly two more triangles, so every triangle has its place
// before anything runs, and results do not depend on the order of threads.
#ifndef COPPERSCOPE_SHADERS_TRI_FOREST_H
#define COPPERSCOPE_SHADERS_TRI_FOREST_H

#include "cpp_and_glsl.h"

#ifdef __cplusplus
namespace shader::tri {
// A pointer here and an address there are the same 64 bits.
struct Words {
    uint* at;
};
struct Points {
    ivec2* at;
};
#else
// For kernels in which one thread reads what another wrote: `coherent`.
#ifndef TRI_COHERENT
#define TRI_COHERENT
#endif
layout(buffer_reference, scalar, buffer_reference_align = 4) TRI_COHERENT buffer Words {
    uint at[];
};
layout(buffer_reference, scalar, buffer_reference_align = 4) readonly buffer Points {
    ivec2 at[];
};
#endif

TRI_CONST kNone = 0xFFFFFFFFu;
// `next` of a vertex: no contour here, or several (then `previous` is the first of its rays).
TRI_CONST kFree = 0xFFFFFFFFu;
TRI_CONST kBusy = 0xFFFFFFFEu;
// Ids from here on are corners of boxes.
TRI_CONST kBoxIds = 0xFFFFFFF0u;
// An edge is a triangle << 2 | the corner opposite to it (tri/mesh.h). This bit marks a link to what was there before
// this stage.
TRI_CONST kStale = 0x80000000u;

// Control::phase
TRI_CONST kInserting = 0u;
TRI_CONST kConstraining = 1u;
TRI_CONST kFinished = 2u;

// What a stage of a step does to the mesh; part of the stamp on the triangles it changes.
TRI_CONST kStageInsert = 0u;
TRI_CONST kStageRebuild = 1u;
TRI_CONST kStageFlip = 2u;

// Forest::eraser
TRI_CONST kEraseBySector = 0u;  // docs/triangulation.md: exact wherever contours touch
TRI_CONST kEraseByLoop =
    1u;  // the paper's: stays if its corners lie on different loops, else if its centroid lies inside

// Forest::state
TRI_CONST kErased = 0u;
TRI_CONST kStays = 1u;
TRI_CONST kUndecided = 2u;

// Why a tree has to go to the CPU (Tree::flags); of several the largest.
TRI_CONST kFlagBorder = 1u;     // kept and erased triangles do not meet exactly along the contours
TRI_CONST kFlagUndecided = 2u;  // a triangle whose corners all have no contour
TRI_CONST kFlagScratch = 3u;    // a corridor does not fit into the scratch memory
TRI_CONST kFlagBlocked = 4u;    // a contour edge meets a vertex or another contour
TRI_CONST kFlagNoTree = 5u;     // from the start: no area, or contours that run along each other

struct Groups {
    uint x, y, z;
};

// Where the work stands; written by the kernels, read by the host between submissions.
struct Control {
    uint phase;
    uint step;   // from 1
    uint total;  // vertices to insert
    uint inserted;
    uint awake[2];        // triangles that this step's flips look at, by the lowest bit of the step; and the next one's
    uint elected;         // vertices that claim triangles to split in this step
    uint claimed;         // triangles that this step's flips claimed
    uint missing;         // contour edges that were not there at the last look
    uint scratchUsed;     // words
    uint kept;            // triangles inside
    uint flips;           // so far
    uint rounds;          // steps that inserted vertices
    Groups insertGroups;  // of threads per vertex
    Groups electedGroups;   // of threads per vertex elected
    Groups relocateGroups;  // of threads per vertex
    Groups flipGroups;      // of threads per triangle listed
    Groups splitGroups;     // of threads per triangle
    Groups contourGroups;   // of threads per triangle
    Groups edgeGroups;      // of threads per contour edge
};
TRI_SIZE(Control, 52 + 7 * 12);

struct Tree {
    uint firstVertex;
    uint vertexCount;  // without the four corners of the box, which follow
    uint firstRay;
    uint rayCount;
    uint flags;
    uint start;  // of its triangles in the output
};
TRI_SIZE(Tree, 24);

#ifdef __cplusplus
struct Controls {
    Control* at;
};
struct Trees {
    Tree* at;
};
#else
layout(buffer_reference, scalar, buffer_reference_align = 4) TRI_COHERENT buffer Controls {
    Control at[];
};
layout(buffer_reference, scalar, buffer_reference_align = 4) buffer Trees {
    Tree at[];
};
#endif

// What is read together lies together: kernels read from everywhere, and every read costs them the same.
struct Triangle {
    uvec4 corners;  // w: stamp, (step * 4 + stage) * 4 + the corner opposite to the diagonal of a flip
    uvec4 across;   // the other side of the edges; w: awake, the last step whose flips look at it
};
TRI_SIZE(Triangle, 32);

#ifdef __cplusplus
struct Triangles {
    Triangle* at;
};
#else
layout(buffer_reference, scalar, buffer_reference_align = 16) TRI_COHERENT buffer Triangles {
    Triangle at[];
};
#endif

struct Forest {
    uint vertexCount;  // with the corners of the boxes; twice as many triangle slots
    uint treeCount;
    uint rayCount;
    uint scratchSize;  // words
    uint eraser;
    uint tinyTrees;   // the first so many trees belong to the kernel of one workgroup per tree of up to kTinyVertices
    uint smallTrees;  // the next so many to the one of up to kSmallVertices
    uint reserved;
    Controls control;
    Trees trees;
    // Per vertex
    Points points;
    Words ids;
    Words treeOf;
    Words loops;  // which contour it came with
    Words next;   // along the contour
    Words previous;
    Words where;  // the triangle in which it waits; kNone once it is inserted
    Words note;   // while inserting: its rank; after that: a triangle at it
    // Per triangle
    Triangles triangles;
    Words moved;  // three: where the edges went that it had before the stage of its stamp
    Words best;
    Words claim;
    Words state;  // of the eraser
    // Rays, the contour edges at busy vertices: vertex, other end, 1 if it leaves the vertex
    Words rays;
    // Per contour edge: one per vertex, then one per ray
    Words found;     // the last step in which it was an edge of the mesh
    Words corridor;  // the first edge that crosses it
    Words scratch;
    Words sums;  // triangles kept, per block of slots
    Words kept;  // the result: three ids per triangle; before that lists of triangles (access.h)
};
TRI_SIZE(Forest, 32 + 21 * 8);

// Push constants of all kernels.
#ifdef __cplusplus
struct Forests {
    std::uint64_t address;
};
#else
layout(buffer_reference, scalar, buffer_reference_align = 8) readonly buffer Forests {
    Forest at[];
};
#endif
struct Push {
    Forests forest;
    uint stage;      // for fix_links
    uint firstTree;  // for tiny and small
};
TRI_SIZE(Push, 16);

TRI_CONST kGroupSize = 64u;
TRI_CONST kMaxGroupsX = 32768u;    // devices guarantee 65535
TRI_CONST kBlockSize = 256u;       // slots per block of the compaction
TRI_CONST kMaxListGroups = 4096u;  // for a list, whose threads take several triangles each if it is long
// Trees up to these sizes, rays included, can live in the shared memory of one workgroup; the smaller they are, the
// more of them run at once.
TRI_CONST kTinyVertices = 64u;
TRI_CONST kTinyEdges = 128u;
TRI_CONST kSmallVertices = 256u;
TRI_CONST kSmallEdges = 512u;
// So few triangles are left to one workgroup: a barrier costs it less than a dispatch.
TRI_CONST kFewAwake = 1024u;
TRI_CONST kTailThreads = 128u;  // no device has fewer

#ifdef __cplusplus
}  // namespace shader::tri
#endif
#endif
