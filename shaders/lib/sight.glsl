// Lines of sight: where they meet the exact prism over a let's outline. Needs prism.glsl and outline.glsl.
//
// In plan a line of sight is o + t * d. A convex shape holds it between two values of t, xy of a Span; what it misses has none (x > y).

struct Sight {
    vec3 start;  // relative to FRAME.centre, mm
    vec3 along;
};

// Through a location of the picture, pixels from its upper left corner.
Sight sightAt(vec2 pixel) {
    const vec3 start = FRAME.screen + pixel.x * FRAME.screenRight + pixel.y * FRAME.screenDown;
    return Sight(start, FRAME.eye.w == 0.0 ? -FRAME.eye.xyz : start - FRAME.eye.xyz);
}

#define Span vec2
const float kFar = 1e15;  // its square is still a number
const Span kNowhere = Span(kFar, -kFar);

bool isEmpty(Span span) {
    return span.x > span.y;
}
Span overlap(Span a, Span b) {
    return Span(max(a.x, b.x), min(a.y, b.y));
}
// Of two parts of one convex shape.
Span joined(Span a, Span b) {
    return Span(min(a.x, b.x), max(a.y, b.y));
}

Span inDisc(vec2 centre, float radius, vec2 o, vec2 d) {
    const vec2 q = o - centre;
    const float speed = dot(d, d);
    const float nearest = -dot(q, d) / speed;
    const vec2 delta = q + nearest * d;
    const float room = radius * radius - dot(delta, delta);
    const float reach = sqrt(max(room, 0.0) / speed);
    return room < 0.0 ? kNowhere : Span(nearest - reach, nearest + reach);
}

// Of a strip, from how far a location is beside its middle and by how much that grows with t.
Span inStrip(float beside, float slope, float halfWidth) {
    if (slope == 0.0) {
        return abs(beside) <= halfWidth ? Span(-kFar, kFar) : kNowhere;
    }
    const float middle = -beside / slope;
    const float reach = halfWidth / abs(slope);
    return Span(middle - reach, middle + reach);
}

Span inRound(vec2 a, vec2 b, float radius, vec2 o, vec2 d) {
    const Span atA = inDisc(a, radius, o, d);
    const float len = distance(a, b);
    if (len == 0.0) {
        return atA;
    }
    const vec2 u = (b - a) / len;
    const vec2 left = vec2(-u.y, u.x);
    const vec2 q = o - 0.5 * (a + b);
    const Span between = overlap(inStrip(dot(q, u), dot(d, u), 0.5 * len), inStrip(dot(q, left), dot(d, left), radius));
    const Span ends = joined(atA, inDisc(b, radius, o, d));
    return isEmpty(between) ? ends : joined(between, ends);
}

Span inSquare(vec2 a, vec2 b, float radius, vec2 o, vec2 d) {
    const vec2 q = o - 0.5 * (a + b);
    const vec2 reach = 0.5 * abs(b - a) + radius;
    const Span box = overlap(inStrip(q.x, d.x, reach.x), inStrip(q.y, d.y, reach.y));
    const float len = distance(a, b);
    if (len == 0.0) {
        return box;
    }
    const vec2 normal = vec2(a.y - b.y, b.x - a.x) / len;
    return overlap(box, inStrip(dot(q, normal), dot(d, normal), radius * (abs(normal.x) + abs(normal.y))));
}

Span inTrack(Let let, float radius, vec2 o, vec2 d) {
    const vec2 a = vec2(let.p0, let.p1);
    const vec2 b = vec2(let.p2, let.p3);
    return has(let.meta, kLetSquarePen) ? inSquare(a, b, radius, o, d) : inRound(a, b, radius, o, d);
}

// The cell around a hole, larger by `seam`, which hides the rounding between it and the area it is part of.
Span inCell(Let let, float seam, vec2 o, vec2 d) {
    const vec2 q = o - vec2(let.p0, let.p1);
    const vec2 u = cellAlong(let);
    const vec2 left = vec2(-u.y, u.x);
    const vec2 x = cellReach(let.p2) + seam;
    const vec2 y = cellReach(let.p3) + seam;
    return overlap(inStrip(dot(q, u) - 0.5 * (x.y - x.x), dot(d, u), 0.5 * (x.x + x.y)),
                   inStrip(dot(q, left) - 0.5 * (y.y - y.x), dot(d, left), 0.5 * (y.x + y.y)));
}

// Where in `slab` a line comes into an arc, or kFar.
float intoArc(Let let, vec2 o, vec2 d, Span part) {
    if (outside(let, o + part.x * d) <= 0.0) {
        return part.x;
    }
    const vec2 centre = vec2(let.p0, let.p1);
    const vec2 q = o - centre;
    // Into either end, through the outer edge inwards, or through the inner edge outwards. What lies a rounding before the slab is at its start.
    const float positions[4] = float[](inDisc(arcEnd(let, 0.0), let.p5, q, d).x, inDisc(arcEnd(let, 1.0), let.p5, q, d).x,
                                    inDisc(vec2(0.0), let.p2 + let.p5, q, d).x, inDisc(vec2(0.0), let.p2 - let.p5, q, d).y);
    const float rounding = 1e-5 * let.p5 / length(d);
    float first = kFar;
    for (int i = 0; i < 4; ++i) {
        const bool isPart = i < 2 || (isInSector(let, q + positions[i] * d) && (i == 2 || let.p2 > let.p5));
        const bool isInPart = positions[i] >= part.x - rounding && positions[i] <= part.y;
        first = isPart && isInPart ? min(first, max(positions[i], part.x)) : first;
    }
    return first;
}

// Where in `slab` a line comes into a convex shape with a hole in it (`inner`, which may be nowhere), or kFar.
float intoRing(Span outer, Span inner, Span part) {
    const Span meets = overlap(outer, part);
    if (isEmpty(meets)) {
        return kFar;
    }
    const bool isInHole = meets.x > inner.x && meets.x < inner.y;
    return !isInHole ? meets.x : inner.y <= meets.y ? inner.y : kFar;
}

float intoLet(Let let, float seam, vec2 o, vec2 d, Span part) {
    const uint kind = let.meta & kLetKindMask;
    if (kind == kLetArc) {
        return intoArc(let, o, d, part);
    }
    if (kind == kLetHole) {
        // Its sides are no walls: sight enters by the face or not at all.
        const Span cell = inCell(let, seam, o, d);
        return cell.x <= part.x ? intoRing(cell, inDisc(vec2(let.p0, let.p1), let.p5, o, d), part) : kFar;
    }
    const Span inner = let.p5 > 0.0 ? inTrack(let, let.p5, o, d) : kNowhere;
    return intoRing(inTrack(let, let.p4, o, d), inner, part);
}

// The let with its place relative to FRAME.centre: differences of nearby numbers are exact.
Let aroundCentre(Let let) {
    let.p0 -= FRAME.centre.x;
    let.p1 -= FRAME.centre.y;
    if ((let.meta & kLetKindMask) == kLetStadium) {
        let.p2 -= FRAME.centre.x;
        let.p3 -= FRAME.centre.y;
    }
    return let;
}

// What a cut through the board leaves of a line.
Span clippedBy(vec2 o, vec2 d) {
    const float beyond = dot(FRAME.sectionPlane.xy, o) - FRAME.sectionPlane.z;
    const float slope = dot(FRAME.sectionPlane.xy, d);
    if (slope == 0.0) {
        return beyond <= 0.0 ? Span(-kFar, kFar) : kNowhere;
    }
    return slope > 0.0 ? Span(-kFar, -beyond / slope) : Span(-beyond / slope, kFar);
}

// What is seen of a let.
struct Seen {
    bool isHit;
    vec3 position;  // relative to FRAME.centre
    float height;   // 0 on the lower, 1 on the upper face
    vec3 normal;    // a unit vector
};

Seen seenOf(Let let, LayerState layer, Sight sight) {
    const float protrusion = has(let.meta, kLetBore) ? FRAME.boreProtrusionMm : 0.0;
    const float z0 = layer.z0 - protrusion - FRAME.centre.z;
    const float z1 = layer.z1 + protrusion - FRAME.centre.z;
    const Let near = aroundCentre(let);
    // Counted from beside the let, where numbers are small.
    const vec3 toLet = vec3(near.p0, near.p1, 0.5 * (z0 + z1)) - sight.start;
    const float toO = dot(toLet, sight.along) / dot(sight.along, sight.along);
    const vec3 o = sight.start + toO * sight.along;
    const float pixelMm = length(FRAME.screenRight) * (FRAME.eye.w == 0.0 ? 1.0 : 1.0 + toO);
    const bool fromAbove = sight.along.z < 0.0;
    const Span part = inStrip(o.z - 0.5 * (z0 + z1), sight.along.z, 0.5 * (z1 - z0));
    // Straight down a line of sight is a point in plan: it is given a way that leads nowhere.
    const bool isStraight = dot(sight.along.xy, sight.along.xy) < 1e-24;
    const vec2 d = isStraight ? vec2(1e-12, 0.0) : sight.along.xy;
    const Span clipped = overlap(part, clippedBy(o.xy, d));
    const float t = isEmpty(clipped) ? kFar : intoLet(near, kSnapPx * pixelMm, o.xy, d, clipped);
    Seen seen;
    // What starts at a cut is its face, which is drawn by itself (section_face.vert).
    seen.isHit = t < kFar && (t > clipped.x || clipped.x == part.x);
    seen.position = o + t * sight.along;
    if (t == part.x) {
        seen.position.z = fromAbove ? z1 : z0;
        seen.height = float(fromAbove);
        seen.normal = vec3(0.0, 0.0, fromAbove ? 1.0 : -1.0);
    } else {
        seen.height = (seen.position.z - z0) / (z1 - z0);
        seen.normal = vec3(normalize(fromOutline(near, seen.position.xy).xy), 0.0);
    }
    return seen;
}
