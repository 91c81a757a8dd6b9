#version 460
#extension GL_GOOGLE_include_directive : require
#extension GL_EXT_shader_explicit_arithmetic_types_int64 : require
#extension GL_EXT_shader_atomic_int64 : require
#include "lib/raster.glsl"
#include "lib/prism.glsl"
#include "lib/surface.glsl"
#include "lib/outline.glsl"
#include "lib/sight.glsl"

// Raster back end: one workgroup per cluster in view, one thread per small let. Casts a line of sight through every pixel the let's box may cover and keeps
// the nearest let of each.
layout(local_size_x = kClusterSize) in;

layout(buffer_reference, scalar, buffer_reference_align = 8) buffer NearestLets { uint64_t at[]; };  // RasterPixels as numbers

// Pixels whose centres lie in the picture of the let's box: from xy to before zw.
ivec4 pixelsOf(Let let, LayerState layer) {
    const float protrusion = has(let.meta, kLetBore) ? FRAME.boreProtrusionMm : 0.0;
    vec2 low = vec2(1e30);
    vec2 high = vec2(-1e30);
    for (int i = 0; i < 8; ++i) {
        const vec2 corner = vec2((i & 1) == 0 ? -1.0 : 1.0, (i & 2) == 0 ? -1.0 : 1.0);
        const float z = (i & 4) == 0 ? layer.z0 - protrusion : layer.z1 + protrusion;
        const vec4 clip = FRAME.clipFromBoard * vec4(vec3(boundCorner(let, corner, 0.0), z) - FRAME.centre, 1.0);
        low = min(low, clip.xy / clip.w);
        high = max(high, clip.xy / clip.w);
    }
    const vec2 size = vec2(FRAME.width, FRAME.height);
    const vec2 last = size - 1.0;
    return ivec4(clamp(ceil((0.5 * low + 0.5) * size - 0.5), vec2(0.0), size),
                 clamp(floor((0.5 * high + 0.5) * size - 0.5), vec2(-1.0), last) + 1.0);
}

void keepNearest(Let let, LayerState layer, uint id, ivec2 pixel) {
    const Seen seen = seenOf(let, layer, sightAt(vec2(pixel) + 0.5));
    if (!seen.isHit) {
        return;
    }
    const vec4 clip = clipPosition(seen.position, layer, let.element, has(let.meta, kLetBore), seen.height, slendernessOf(let));
    const float depth = clip.z / clip.w;
    if (depth > 0.0 && depth <= 1.0) {
        const uint64_t mine = uint64_t(floatBitsToUint(depth)) << 32u | uint64_t(id);
        atomicMax(NearestLets(push.pixels).at[uint(pixel.y) * FRAME.width + uint(pixel.x)], mine);
    }
}

void rasterise(uint index, LayerState layer) {
    const Let let = FRAME.lets.at[index];
    const ivec4 pixels = pixelsOf(let, layer);
    const uint id = push.copies.at[push.copy].firstId + index;
    for (int y = pixels.y; y < pixels.w; ++y) {
        for (int x = pixels.x; x < pixels.z; ++x) {
            keepNearest(let, layer, id, ivec2(x, y));
        }
    }
}

void main() {
    frame = push.copies.at[push.copy].frame;
    const uint count = FRAME.visibleClusters.count;
    for (uint i = gl_WorkGroupID.x; i < count; i += gl_NumWorkGroups.x) {
        const Cluster cluster = FRAME.clusters.at[FRAME.visibleClusters.at[i]];
        const uint index = cluster.firstLet + gl_LocalInvocationID.x;
        if (gl_LocalInvocationID.x < cluster.count && FRAME.letSlots.at[index] >> kSlotBits == kBucketRaster) {
            rasterise(index, FRAME.layers.at[cluster.layer]);
        }
    }
}
