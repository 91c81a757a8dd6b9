// Structs and constants shared by C++ and GLSL: the one place where the layout of GPU records is written down.
// C++ sees them in namespace shader with GLM types; all blocks use scalar layout; every struct is followed by its size.
#ifndef COPPERSCOPE_SHADERS_SHARED_BOARD_H
#define COPPERSCOPE_SHADERS_SHARED_BOARD_H

#ifdef __cplusplus
#include <cstdint>
#include <glm/glm.hpp>
namespace shader {
using uint = std::uint32_t;
using vec2 = glm::vec2;
using vec3 = glm::vec3;
using vec4 = glm::vec4;
using mat4 = glm::mat4;
#define GPU_CONST constexpr uint
#define GPU_SIZE(Name, bytes) static_assert(sizeof(Name) == (bytes))
#define GPU_READ(Name, Item, align)
#define GPU_WRITE(Name, Item, align)
#else
#extension GL_EXT_buffer_reference : require
#extension GL_EXT_scalar_block_layout : require
#define GPU_CONST const uint
#define GPU_SIZE(Name, bytes)
// Arrays of records, of which a shader has the address: read only, and written too.
#define GPU_READ(Name, Item, align)                                                         \
    layout(buffer_reference, scalar, buffer_reference_align = align) readonly buffer Name { \
        Item at[];                                                                          \
    }
#define GPU_WRITE(Name, Item, align)                                               \
    layout(buffer_reference, scalar, buffer_reference_align = align) buffer Name { \
        Item at[];                                                                 \
    }
bool has(uint flags, uint flag) {
    return (flags & flag) != 0;
}
#endif

// Lengths on the GPU are millimetres relative to the board model's origin: 32-bit floats then resolve 15 nm at 250 mm.

// What a let is made of. The paper's LineLet and CircleLet are one shape here: a circle is a line with equal ends.
GPU_CONST kLetStadium = 0;  // p0,p1 = a   p2,p3 = b   p4 = pen radius   p5 = inner radius (0 = solid, else a ring)
GPU_CONST kLetArc =
    1;  // p0,p1 = centre   p2 = arc radius   p3 = start angle   p4 = signed sweep (rad)   p5 = pen radius
GPU_CONST kLetHole =
    2;  // what is left of a rectangular cell around a round hole: p0,p1 = centre   p5 = radius of the hole
        // p4 = tan(a/2) of the angle a of its x axis, -1..1   p2 = how far it reaches back and forth along x, p3 =
        // along y: two 16-bit numbers in units of kCellUnitsPerMm, the lower one back (lib/cell.glsl)
GPU_CONST kCellUnitsPerMm = 1000;
// Chords along one arc let in the finest of the paper's three levels (let_mesh.h): 2 * (9 + 1) points on its two sides
// and 6 more round each end are 32 points per face. Longer arcs are split on the CPU, so that no let needs more.
GPU_CONST kArcFineChords = 9;

// Let::meta: bits 0-3 kind, bits 4-7 flags, bits 8-31 layer.
GPU_CONST kLetKindMask = 0xf;
GPU_CONST kLetSquarePen = 0x10;  // axis-parallel square pen (stadium only)
GPU_CONST kLetBore = 0x20;       // the empty inside of a hole: drawn dark and slightly protruding from the outer faces
GPU_CONST kLetLayerShift = 8;

struct Let {
    float p0, p1, p2, p3, p4, p5;
    uint meta;
    uint element;
};
GPU_SIZE(Let, 32);

// What a fabricator mills away (model/solids/milling.h) is drawn only in views of the board as designed; what is left
// of elements that are milled in part, only in views of the board as fabricated (kFrameFabricated); all else (0) in
// both.
GPU_CONST kOnlyAsDesigned = 1;
GPU_CONST kOnlyAsFabricated = 2;

// 32 lets of one layer, neighbours along a Morton curve, all milled or none. `count` may be less than 32 at the end of
// either.
GPU_CONST kClusterSize = 32;
struct Cluster {
    vec2 boxMin;
    vec2 boxMax;
    uint firstLet;
    uint count;
    uint layer;
    uint onlyAs;
};
GPU_SIZE(Cluster, 32);

// Per layer, rewritten whenever a style or the explosion changes; geometry never is.
// LayerState::flags: bits 0-7 flags, bits 8-15 and 16-23 the tie-break of the lower and the upper face among layers
// whose faces lie in one plane, bits 24-27 the material, bit 28 kMaterialShadowed.
GPU_CONST kLayerVisible = 1;
GPU_CONST kLayerTranslucent = 2;  // drawn in its own blended pass
GPU_CONST kLayerGrowsUp = 4;      // areas differ in height: each grows up from the lower face
GPU_CONST kLayerGrowsDown = 8;    // areas differ in height: each grows down from the upper face
GPU_CONST kLayerMilledOnly = 16;  // of all that is on it only what is milled, or left of it, may be seen
GPU_CONST kLayerBottomRankShift = 8;
GPU_CONST kLayerTopRankShift = 16;
GPU_CONST kLayerMaterialShift = 24;
GPU_CONST kMaterialMask = 0xf;
// How a surface takes the light (lib/shading.glsl).
GPU_CONST kMaterialMatt = 0;   // the same from everywhere
GPU_CONST kMaterialMetal = 1;  // mirrors the light in its own colour
GPU_CONST kMaterialGloss = 2;  // mirrors some of the light as it is, over its own colour
// With any of them: faces have the shadows of the bodies that stand on them.
GPU_CONST kMaterialShadowed = 0x10;
struct LayerState {
    vec4 colour;   // linear RGB, opacity; with kFrameStandingOut the last is how bright it is for its depth
    float z0, z1;  // mm, explosion included
    uint flags;
    uint batch;  // 0 = with all opaque layers, else the translucent batch that draws it
};
GPU_SIZE(LayerState, 32);

// How an element differs from the style of its layer: a byte each, four to a word.
GPU_CONST kElementHighlighted = 0x80;  // stands out: in one strong colour, or its own at full brightness
GPU_CONST kElementHidden = 0x40;       // is not drawn
GPU_CONST kElementColourMask = 0x3f;   // 0 = the layer's colour, else 1 + row of the palette
GPU_CONST kElementColourCount = 63;
GPU_CONST kHighlightRow = 57;  // of the palette: from here on the colours of what is highlighted
GPU_CONST kElementsPerWord = 4;
// Behind the colours of elements the palette has those of what bodies of components are made of.
GPU_CONST kMaterialRow = kElementColourCount;
GPU_CONST kMaterialCount = 10;

// p' = origin + M(mirror) * R * p with R = (c s; -s c), clockwise by the angle.
struct AreaInstance {
    vec2 origin;
    vec2 cosSin;
    uint shape;
    uint layer;
    uint element;
    uint isMirrored;
    float height;  // mm, on a layer that grows up or down, of the face away from the board; 0 = as high as the layer
    uint onlyAs;
    float floor;    // of the face towards the board, where `height` is not 0; negative: it reaches into the board
    uint material;  // 0 = the layer's colour, else 1 + row behind kMaterialRow of the palette
};
GPU_SIZE(AreaInstance, 48);

// A corner of a prism in the standard pipeline's vertex buffers.
GPU_CONST kStandardBore = 0x80000000;  // bit of `owner`: the empty inside of a hole (kLetBore)
struct StandardVertex {
    float x, y;
    float face;  // 0 = on the lower, 1 = on the upper face of its layer; in between for what is lower than it
    uint owner;  // element and kStandardBore
};
GPU_SIZE(StandardVertex, 16);

#ifdef __cplusplus
}  // namespace shader
#endif
#endif
