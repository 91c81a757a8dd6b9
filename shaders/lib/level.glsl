// Which lets are in view, and how finely they must be drawn. Needs in_view.glsl.

#include "cell.glsl"
#include "element.glsl"

bool isClusterInView(Cluster cluster, LayerState layer) {
    if (!isOnLayer(layer, cluster.onlyAs)) {
        return false;
    }
    return !has(FRAME.flags, kFrameCull) ||
           isBoxInView(middleOf(0.5 * (cluster.boxMin + cluster.boxMax), layer),
                       extentOf(0.5 * (cluster.boxMax - cluster.boxMin), layer));
}

uint topologyOf(Let let) {
    const bool isBarrel = (let.meta & kLetKindMask) != kLetArc && let.p5 > 0.0;
    return isBarrel ? kTopologyClosed : kTopologyOpen;
}

// A circle around a let: xy its centre, z its radius.
vec3 letCircle(Let let) {
    if ((let.meta & kLetKindMask) == kLetArc) {
        // Around the middle of the arc: the farthest of its points is an end, 2 R sin(sweep / 4) away.
        const float middle = let.p3 + 0.5 * let.p4;
        return vec3(vec2(let.p0, let.p1) + let.p2 * vec2(cos(middle), sin(middle)),
                    2.0 * let.p2 * sin(0.25 * abs(let.p4)) + let.p5);
    }
    const vec2 a = vec2(let.p0, let.p1);
    const vec2 b = vec2(let.p2, let.p3);
    if ((let.meta & kLetKindMask) == kLetHole) {
        const vec2 x = cellReach(let.p2);
        const vec2 y = cellReach(let.p3);
        return vec3(a, length(vec2(max(x.x, x.y), max(y.x, y.y))));
    }
    const float corner = has(let.meta, kLetSquarePen) ? 1.41421357 : 1.0;
    return vec3(0.5 * (a + b), 0.5 * length(b - a) + corner * let.p4);
}

// Pixels per millimetre where the box is nearest to the eye.
float pixelsPerMmAt(vec3 middle, vec3 extent) {
    const vec4 w = vec4(FRAME.clipFromBoard[0].w, FRAME.clipFromBoard[1].w, FRAME.clipFromBoard[2].w,
                        FRAME.clipFromBoard[3].w);
    const float nearest = dot(w.xyz, middle) + w.w - dot(abs(w.xyz), extent);
    return FRAME.pixelsPerMm / max(nearest, 1e-6);
}

// How far the polygon of a unit circle strays from it, by level: (1 - c) / (1 + c) with c = cos(pi / 2 / (points - 1)).
const float kEndError[4] = float[](1.5544e-4, 2.7466e-3, 1.26952e-2, 7.17968e-2);
const float kRingError[4] = float[](1.5060e-4, 2.4135e-3, 9.7005e-3, 3.95662e-2);  // of a hole, whose points go all round
const float kArcEndError[4] = float[](6.4216e-4, 1.26952e-2, 7.17968e-2, 7.17968e-2);

float letError(Let let, uint level) {
    const uint kind = let.meta & kLetKindMask;
    if (kind != kLetArc) {
        return kind == kLetHole ? let.p5 * kRingError[level] : let.p4 * kEndError[level];
    }
    const float quarterChord = sin(0.25 * abs(let.p4) / float(kArcChords[level]));
    return max(let.p5 * kArcEndError[level], 2.0 * (let.p2 + let.p5) * quarterChord * quarterChord);
}

bool isQuad(Let let, LayerState layer, float pixelsPerMm) {
    if ((let.meta & kLetKindMask) == kLetHole) {
        return let.p5 * pixelsPerMm < FRAME.quadRadiusPx;  // what is deep in so small a hole is not seen
    }
    const float radius = (let.meta & kLetKindMask) == kLetArc ? 1e30 : let.p4;
    // Its walls must be out of sight too: barrels stand far taller than they are wide.
    return radius * pixelsPerMm < FRAME.quadRadiusPx && (layer.z1 - layer.z0) * pixelsPerMm < 1.0;
}

const uint kNotDrawn = 0xffffffffu;

// The paper's levels go by size alone.
uint paperLevel(vec3 circle, float pixelsPerMm) {
    const float radiusPx = circle.z * pixelsPerMm;
    return radiusPx > 32.0 ? kLevel64 : radiusPx > 8.0 ? kLevel32 : kLevel16;
}

// topology * kLevelCount + level, or kNotDrawn: the coarsest level that stays within the tolerance.
uint letBucket(Let let, LayerState layer) {
    const uint base = topologyOf(let) * kLevelCount;
    if (isHidden(let.element)) {
        return kNotDrawn;
    }
    if (!has(FRAME.flags, kFrameCull)) {
        return has(FRAME.flags, kFrameImpostors) ? kLevelQuad : base + kLevel64;
    }
    const vec3 circle = letCircle(let);
    const vec3 middle = middleOf(circle.xy, layer);
    const vec3 extent = extentOf(circle.zz, layer);
    if (!isBoxInView(middle, extent)) {
        return kNotDrawn;
    }
    if (has(FRAME.flags, kFrameImpostors)) {
        return kLevelQuad;
    }
    const float pixelsPerMm = pixelsPerMmAt(middle, extent);
    if (max(circle.z, extent.z) * pixelsPerMm < FRAME.rasterRadiusPx && layer.batch == 0u) {
        return kBucketRaster;
    }
    if (has(FRAME.flags, kFramePaperLevels)) {
        return base + paperLevel(circle, pixelsPerMm);
    }
    if (isQuad(let, layer, pixelsPerMm)) {
        return kLevelQuad;
    }
    for (uint level = kLevel16; level > kLevelFine; --level) {
        if (letError(let, level) * pixelsPerMm <= FRAME.tolerancePx) {
            const bool isThin = (layer.z1 - layer.z0) * pixelsPerMm < FRAME.thinPx;
            return base + (level == kLevel16 && isThin ? kLevelFlat : level);
        }
    }
    return base + kLevelFine;
}
