// The one place where a let becomes points: vertices of both back ends come from here. See let_mesh.h for segments, sides and codes.
#include "cell.glsl"

const float kHalfPi = 1.57079632679;

// Rasterisers move corners by up to half of 1/256 of a pixel: what must not be missed at edges is larger by this.
const float kSnapPx = 0.01;

vec2 leftOf(vec2 direction) {
    return vec2(-direction.y, direction.x);
}

// The corner of the unit square that lies farthest in a direction; halfway between two corners when both are equally far.
vec2 squareSupport(vec2 u) {
    return vec2(abs(u.x) < 1e-4 ? 0.0 : sign(u.x), abs(u.y) < 1e-4 ? 0.0 : sign(u.y));
}

// Point `k` of a rounded end with `points` points, counted from its side (k = 0, exactly one radius off the axis) to its tip. The points between
// stand out by half the chord error, so that the polygon strays as far to the outside as to the inside: half as far as an inscribed one.
// A square pen's outline is spanned by the farthest corners in the same directions.
vec2 endPoint(vec2 centre, vec2 outward, float sign, float radius, bool isSquare, uint k, uint points) {
    const float steps = float(points - 1u);
    const float angle = kHalfPi * (1.0 - 2.0 * float(k) / steps);
    const vec2 side = sign * leftOf(outward);
    const vec2 u = k == 0u ? side : cos(angle) * outward + sin(angle) * side;
    if (isSquare) {
        return centre + radius * squareSupport(u);
    }
    const float reach = k == 0u ? 1.0 : 2.0 / (1.0 + cos(kHalfPi / steps));
    return centre + radius * reach * u;
}

vec2 trackDirection(vec2 a, vec2 b) {
    const vec2 d = b - a;
    const float len = length(d);
    return len > 0.0 ? d / len : vec2(1.0, 0.0);
}

vec2 stadiumPoint(Let let, uint level, uint segment, bool isLeft) {
    const vec2 a = vec2(let.p0, let.p1);
    const vec2 b = vec2(let.p2, let.p3);
    const vec2 d = trackDirection(a, b);
    const float sign = isLeft ? 1.0 : -1.0;
    const bool isSquare = has(let.meta, kLetSquarePen);
    if (level == kLevelQuad) {
        // As long as it must be to cover the area of the true outline.
        const vec2 along = d * let.p4 * (isSquare ? 1.0 : 0.5 * kHalfPi);
        return (segment == 0u ? a - along : b + along) + sign * let.p4 * leftOf(d);
    }
    const uint points = kEndPoints[level];
    const uint ends = points / 2u;
    return segment < ends ? endPoint(a, -d, -sign, let.p4, isSquare, ends - 1u - segment, points)
                       : endPoint(b, d, sign, let.p4, isSquare, segment - ends, points);
}

// Segment `segment` of a ring, counter-clockwise from the right side of end b.
vec2 barrelPoint(Let let, uint level, uint segment, bool isInner) {
    const vec2 a = vec2(let.p0, let.p1);
    const vec2 b = vec2(let.p2, let.p3);
    const vec2 d = trackDirection(a, b);
    const uint points = kEndPoints[level];
    const uint ring = segment % (2u * points);
    const bool atB = ring < points;
    const uint along = atB ? ring : ring - points;
    const bool isRight = along < points / 2u;
    return endPoint(atB ? b : a, atB ? d : -d, isRight ? -1.0 : 1.0, isInner ? let.p5 : let.p4,
                    has(let.meta, kLetSquarePen), isRight ? along : points - 1u - along, points);
}

// Segment `segment` of what surrounds a round hole, counter-clockwise: the circle inside, the cell outside. Corners of the cell are segments at all levels.
vec2 holePoint(Let let, uint level, uint segment, bool isInner) {
    const float segments = float(2u * kEndPoints[level]);
    const float angle = 4.0 * kHalfPi * float(segment) / segments;
    const vec2 u = vec2(cos(angle), sin(angle));
    if (!isInner) {
        return placeInCell(let, u / max(abs(u.x), abs(u.y)));
    }
    const vec2 local = let.p5 * 2.0 / (1.0 + cos(2.0 * kHalfPi / segments)) * u;
    const vec2 along = cellAlong(let);
    return vec2(let.p0, let.p1) + local.x * along + local.y * leftOf(along);
}

// Less than a pixel: the cell is filled.
vec2 cellCorner(Let let, uint segment, bool isLeft) {
    return placeInCell(let, vec2(segment == 0u ? -1.0 : 1.0, isLeft ? 1.0 : -1.0));
}

vec2 arcPoint(Let let, uint level, uint segment, bool isLeft) {
    const vec2 centre = vec2(let.p0, let.p1);
    const uint ends = kArcEndSegments[level];
    const uint segments = kEndPoints[level];
    const uint chords = kArcChords[level];
    const float sign = isLeft ? 1.0 : -1.0;
    const float forward = let.p4 < 0.0 ? -1.0 : 1.0;
    // Segments ends - 1 and segments - ends are the two ends of the centre line, those between divide it evenly.
    const uint step = uint(clamp(int(segment) - int(ends) + 1, 0, int(chords)));
    const float angle = let.p3 + let.p4 * float(step) / float(chords);
    const vec2 radial = vec2(cos(angle), sin(angle));
    const vec2 onLine = centre + let.p2 * radial;
    const vec2 tangent = forward * leftOf(radial);
    if (segment < ends) {
        return endPoint(onLine, -tangent, -sign, let.p5, false, ends - 1u - segment, 2u * ends);
    }
    if (segment >= segments - ends) {
        return endPoint(onLine, tangent, sign, let.p5, false, segment - (segments - ends), 2u * ends);
    }
    return onLine + sign * let.p5 * leftOf(tangent);
}

vec2 letPoint(Let let, uint level, uint segment, uint side) {
    if ((let.meta & kLetKindMask) == kLetArc) {
        return arcPoint(let, level, segment, side == 0u);
    }
    if ((let.meta & kLetKindMask) == kLetHole) {
        return level == kLevelQuad ? cellCorner(let, segment, side == 0u) : holePoint(let, level, segment, side == 0u);
    }
    // A ring of less than a pixel is drawn as a full quad.
    return let.p5 > 0.0 && level != kLevelQuad ? barrelPoint(let, level, segment, side == 0u)
                                               : stadiumPoint(let, level, segment, side == 0u);
}

// Where a vertex of a let lies on the board.
vec3 letPosition(Let let, LayerState layer, uint level, uint code) {
    const float protrusion = has(let.meta, kLetBore) ? FRAME.boreProtrusionMm : 0.0;
    const float z = (code & 1u) == 0u ? layer.z1 + protrusion : layer.z0 - protrusion;
    return vec3(letPoint(let, level, code >> 2u, (code >> 1u) & 1u), z);
}

// Corner (-1 or 1 each) that a vertex code of a quad means.
vec2 quadCorner(uint code) {
    return vec2((code >> 2u) == 0u ? -1.0 : 1.0, (code & 2u) == 0u ? 1.0 : -1.0);
}

// Corner (-1 or 1 each) of the smallest rectangle around a let, `margin` mm larger than it. What surrounds a hole is that rectangle: its sides are exact.
vec2 boundCorner(Let let, vec2 corner, float margin) {
    const vec2 p = vec2(let.p0, let.p1);
    const uint kind = let.meta & kLetKindMask;
    if (kind == kLetHole) {
        return placeInCell(let, corner);
    }
    if (kind == kLetArc) {
        const float middle = let.p3 + 0.5 * let.p4;
        const vec2 u = vec2(cos(middle), sin(middle));
        const float reach = let.p5 + margin;
        const float low = let.p2 * cos(0.5 * let.p4) - reach;
        const float high = let.p2 + reach;
        return p + (corner.x < 0.0 ? low : high) * u + corner.y * (let.p2 * sin(0.5 * abs(let.p4)) + reach) * leftOf(u);
    }
    const vec2 q = vec2(let.p2, let.p3);
    const vec2 d = trackDirection(p, q);
    const float reach = let.p4 * (has(let.meta, kLetSquarePen) ? 1.41421357 : 1.0) + margin;
    return (corner.x < 0.0 ? p : q) + reach * (corner.x * d + corner.y * leftOf(d));
}

// Length over width of a track; arcs are cut into short pieces, and cells keep clear of others.
float slendernessOf(Let let) {
    const bool isTrack = (let.meta & kLetKindMask) == kLetStadium;
    return !isTrack ? 0.0 : distance(vec2(let.p0, let.p1), vec2(let.p2, let.p3)) / (2.0 * let.p4);
}
