// The true outlines of lets, as seen from a location p beside, on or inside one.
//
// The functions from...() return in xy: the line from the outline to p or on from it, a normal pointing outwards, not of unit length; z: how far outside p lies, mm,
// negative inside, exact in its sign.

// How wide outlines are where nothing but outlines is drawn.
const float kOutlinePx = 1.25;

// Whether q, relative to the centre, lies in the sector of an arc.
bool isInSector(Let let, vec2 q) {
    const float middle = let.p3 + 0.5 * let.p4;
    const float halfSweep = 0.5 * abs(let.p4);
    // In a frame whose x axis goes through the middle of the arc, mirrored to its upper half.
    const vec2 u = vec2(cos(middle), sin(middle));
    const vec2 local = vec2(dot(q, u), abs(dot(q, vec2(-u.y, u.x))));
    return local.y * cos(halfSweep) <= local.x * sin(halfSweep);
}

// Where the centre line of an arc starts (side = 0) or ends (1), relative to the centre.
vec2 arcEnd(Let let, float side) {
    const float angle = let.p3 + side * let.p4;
    return let.p2 * vec2(cos(angle), sin(angle));
}

vec3 fromArc(Let let, vec2 p) {
    const vec2 q = p - vec2(let.p0, let.p1);
    if (isInSector(let, q)) {
        const float beyond = length(q) - let.p2;
        return vec3(beyond < 0.0 ? -q : q, abs(beyond) - let.p5);
    }
    const vec2 a = q - arcEnd(let, 0.0);
    const vec2 b = q - arcEnd(let, 1.0);
    const vec2 nearest = dot(a, a) < dot(b, b) ? a : b;
    return vec3(nearest, length(nearest) - let.p5);
}

vec3 fromRound(vec2 a, vec2 b, float radius, vec2 p) {
    const vec2 d = b - a;
    const float len = dot(d, d);
    const float t = len > 0.0 ? clamp(dot(p - a, d) / len, 0.0, 1.0) : 0.0;
    const vec2 delta = p - a - t * d;
    return vec3(delta, length(delta) - radius);
}

// What an axis-parallel square pen passes: a hexagon, the box around both ends cut by a strip along the track.
vec3 fromSquare(vec2 a, vec2 b, float radius, vec2 p) {
    const vec2 q = p - 0.5 * (a + b);
    const vec2 beyond = abs(q) - 0.5 * abs(b - a) - radius;
    const vec3 box = beyond.x > beyond.y ? vec3(q.x, 0.0, beyond.x) : vec3(0.0, q.y, beyond.y);
    const vec2 d = b - a;
    const float len = length(d);
    if (len == 0.0) {
        return box;
    }
    const vec2 normal = vec2(-d.y, d.x) / len;
    const float across = dot(q, normal);
    const float beside = abs(across) - radius * (abs(normal.x) + abs(normal.y));
    return beside > box.z ? vec3(across < 0.0 ? -normal : normal, beside) : box;
}

vec3 fromTrack(Let let, float radius, vec2 p) {
    const vec2 a = vec2(let.p0, let.p1);
    const vec2 b = vec2(let.p2, let.p3);
    return has(let.meta, kLetSquarePen) ? fromSquare(a, b, radius, p) : fromRound(a, b, radius, p);
}

// Of what surrounds a hole only the hole's edge is an outline: the cell's sides lie inside copper.
vec3 fromOutline(Let let, vec2 p) {
    const uint kind = let.meta & kLetKindMask;
    if (kind == kLetArc) {
        return fromArc(let, p);
    }
    if (kind == kLetHole) {
        const vec2 delta = vec2(let.p0, let.p1) - p;
        return vec3(delta, let.p5 - length(delta));
    }
    const vec3 outer = fromTrack(let, let.p4, p);
    if (let.p5 == 0.0) {
        return outer;
    }
    const vec3 inner = -fromTrack(let, let.p5, p);
    return inner.z > outer.z ? inner : outer;
}

float outside(Let let, vec2 p) {
    return fromOutline(let, p).z;
}

// Whether p is drawn: it lies in the let, or in outline mode along the inside of its outline. Arcs may be pieces of longer ones: their ends are no outlines then.
bool isDrawn(Let let, vec2 p) {
    const float beyond = outside(let, p);
    if (!has(FRAME.flags, kFrameOutlines)) {
        return beyond <= 0.0;
    }
    const bool isEnd = (let.meta & kLetKindMask) == kLetArc && !isInSector(let, p - vec2(let.p0, let.p1));
    return beyond <= 0.0 && beyond > -kOutlinePx / FRAME.pixelsPerMm && !isEnd;
}
