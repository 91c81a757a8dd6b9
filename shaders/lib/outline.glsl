// The true outlines of lets: how far outside of one a place lies, mm; negative inside. Exact in its sign.

float outsideArc(Let let, vec2 p) {
    const vec2 q = p - vec2(let.p0, let.p1);
    const float middle = let.p3 + 0.5 * let.p4;
    const float halfSweep = 0.5 * abs(let.p4);
    // In a frame whose x axis goes through the middle of the arc, mirrored to its upper half.
    const vec2 u = vec2(cos(middle), sin(middle));
    const vec2 local = vec2(dot(q, u), abs(dot(q, vec2(-u.y, u.x))));
    const vec2 end = let.p2 * vec2(cos(halfSweep), sin(halfSweep));
    const bool isBeside = local.y * end.x <= local.x * end.y;  // in the sector
    return (isBeside ? abs(length(local) - let.p2) : length(local - end)) - let.p5;
}

float outsideRound(vec2 a, vec2 b, float radius, vec2 p) {
    const vec2 d = b - a;
    const float len = dot(d, d);
    const float t = len > 0.0 ? clamp(dot(p - a, d) / len, 0.0, 1.0) : 0.0;
    return length(p - a - t * d) - radius;
}

// What an axis-parallel square pen passes: a hexagon.
float outsideSquare(vec2 a, vec2 b, float radius, vec2 p) {
    const vec2 beyond = abs(p - 0.5 * (a + b)) - 0.5 * abs(b - a) - radius;
    const vec2 d = b - a;
    const float len = length(d);
    if (len == 0.0) {
        return max(beyond.x, beyond.y);
    }
    const vec2 normal = vec2(-d.y, d.x) / len;
    const float beside = abs(dot(p - a, normal)) - radius * (abs(normal.x) + abs(normal.y));
    return max(beside, max(beyond.x, beyond.y));
}

float outsideStroke(Let let, float radius, vec2 p) {
    const vec2 a = vec2(let.p0, let.p1);
    const vec2 b = vec2(let.p2, let.p3);
    return has(let.meta, kLetSquarePen) ? outsideSquare(a, b, radius, p) : outsideRound(a, b, radius, p);
}

float outside(Let let, vec2 p) {
    const uint kind = let.meta & kLetKindMask;
    if (kind == kLetArc) {
        return outsideArc(let, p);
    }
    if (kind == kLetHole) {
        return let.p5 - distance(p, vec2(let.p0, let.p1));  // the cell's sides are those of the rectangle drawn
    }
    const float outer = outsideStroke(let, let.p4, p);
    return let.p5 > 0.0 ? max(outer, -outsideStroke(let, let.p5, p)) : outer;
}
