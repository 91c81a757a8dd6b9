#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_mesh_shader : require
#include "lib/frame.glsl"
#include "lib/prism.glsl"
#include "lib/surface.glsl"
#include "lib/payload.glsl"

// Mesh back end, second half: makes the vertices and triangles of several small lets, one let, or one slice of a large let.
layout(local_size_x = kClusterSize) in;
layout(triangles, max_vertices = kSliceMaxVertices, max_primitives = kSliceMaxTriangles) out;

layout(location = 0) out vec3 outPosition[];
layout(location = 1) flat out vec4 outColour[];
layout(location = 2) flat out uint outMaterial[];
out gl_MeshPerVertexEXT {
    invariant vec4 gl_Position;
} gl_MeshVerticesEXT[];

// The share of this workgroup.
struct Share {
    uint level;
    uint firstLet;    // in the payload
    uint letCount;
    uint firstSegment;
    uint intervals;
    bool hasFirstEnd;  // walls across the ends of an open ladder
    bool hasLastEnd;
};

Share shareOf(uint group) {
    uint start = 0u;
    uint bucket = 0u;
    for (; bucket < kBucketCount - 1u; ++bucket) {
        const uint groups = groupsFor(bucket, payload.counts[bucket]);
        if (group < groups) {
            break;
        }
        group -= groups;
        start += payload.counts[bucket];
    }
    const uint topology = bucket / kLevelCount;
    const uint level = bucket % kLevelCount;
    const uint slices = slicesOf(topology, level);
    const uint together = letsPerGroup(topology, level);
    const uint first = group / slices * together;
    const uint segment = group % slices * kSliceIntervals;
    Share share;
    share.level = level;
    share.firstLet = start + first;
    share.letCount = min(together, payload.counts[bucket] - first);
    share.firstSegment = segment;
    share.intervals = min(kSliceIntervals, ladderIntervals(topology, level) - segment);
    const bool hasEnds = topology == kTopologyOpen && FRAME.triangleCount > kUpperTriangles;
    share.hasFirstEnd = hasEnds && segment == 0u;
    share.hasLastEnd = hasEnds && segment + share.intervals == ladderIntervals(topology, level);
    return share;
}

uint trianglesPerLet(Share share) {
    if (share.level >= kLevelFlat) {
        return share.intervals * kUpperTriangles;
    }
    return share.intervals * FRAME.triangleCount + (share.hasFirstEnd ? kEndTriangleCount : 0u) +
           (share.hasLastEnd ? kEndTriangleCount : 0u);
}

// A quad has the face that can be seen only: its vertices are not 8 but 4.
uint verticesPerLet(Share share) {
    return share.level == kLevelQuad ? 4u : (share.intervals + 1u) * 4u;
}

// Corners of triangle `index` of a let, as vertices of that let's share.
uvec3 triangleOf(Share share, uint index) {
    uint segment = 0u;
    uint digits;
    if (share.level == kLevelQuad) {
        digits = kIntervalTriangles[FRAME.quadFace == 0u ? index : index + kIntervalTriangleCount - kUpperTriangles];
        return uvec3(digits >> 8u, digits >> 4u, digits) >> 1u & 3u;
    }
    if (share.level == kLevelFlat) {
        digits = kIntervalTriangles[FRAME.quadFace * (kIntervalTriangleCount - kUpperTriangles) + index % kUpperTriangles];
        return uvec3(digits >> 8u & 15u, digits >> 4u & 15u, digits & 15u) + 4u * (index / kUpperTriangles);
    }
    const uint inIntervals = share.intervals * FRAME.triangleCount;
    if (index < inIntervals) {
        segment = index / FRAME.triangleCount;
        digits = kIntervalTriangles[FRAME.firstTriangle + index % FRAME.triangleCount];
    } else if (share.hasFirstEnd && index < inIntervals + kEndTriangleCount) {
        digits = kFirstEndTriangles[index - inIntervals];
    } else {
        segment = share.intervals;
        digits = kLastEndTriangles[index - inIntervals - (share.hasFirstEnd ? kEndTriangleCount : 0u)];
    }
    return uvec3(digits >> 8u & 15u, digits >> 4u & 15u, digits & 15u) + 4u * segment;
}

void writeVertex(Share share, uint vertex) {
    const uint perLet = verticesPerLet(share);
    const uint local = vertex % perLet;
    const Let let = FRAME.lets.at[payload.lets[share.firstLet + vertex / perLet]];
    const LayerState layer = FRAME.layers.at[let.meta >> kLetLayerShift];
    const uint code = share.level == kLevelQuad ? local * 2u + FRAME.quadFace : share.firstSegment * 4u + local;
    const vec3 position = letPosition(let, layer, share.level, code) - FRAME.centre;
    const bool isBore = has(let.meta, kLetBore);
    gl_MeshVerticesEXT[vertex].gl_Position =
        clipPosition(position, layer, let.element, isBore, float((code & 1u) == 0u), slendernessOf(let));
    outPosition[vertex] = position;
    outColour[vertex] = colourOf(layer, let.element, isBore);
    outMaterial[vertex] = materialOf(layer, let.element, isBore);
}

void main() {
    const Share share = shareOf(gl_WorkGroupID.x);
    const uint vertexCount = share.letCount * verticesPerLet(share);
    const uint perLet = trianglesPerLet(share);
    const uint triangleCount = share.letCount * perLet;
    SetMeshOutputsEXT(vertexCount, triangleCount);
    for (uint i = gl_LocalInvocationID.x; i < vertexCount; i += kClusterSize) {
        writeVertex(share, i);
    }
    for (uint i = gl_LocalInvocationID.x; i < triangleCount; i += kClusterSize) {
        gl_PrimitiveTriangleIndicesEXT[i] = triangleOf(share, i % perLet) + i / perLet * verticesPerLet(share);
    }
}
