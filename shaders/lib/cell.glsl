// The rectangle that a let of a round hole fills (kLetHole).
#ifndef COPPERSCOPE_SHADERS_LIB_CELL_GLSL
#define COPPERSCOPE_SHADERS_LIB_CELL_GLSL

// How far it reaches from the centre, mm: back (x) and forth (y) along one axis.
vec2 cellReach(float packedReach) {
    const uint bits = floatBitsToUint(packedReach);
    return vec2(bits & 0xffffu, bits >> 16u) / float(kCellUnitsPerMm);
}

vec2 cellAlong(Let let) {
    return vec2(1.0 - let.p4 * let.p4, 2.0 * let.p4) / (1.0 + let.p4 * let.p4);
}

// From -1, -1 to 1, 1: corner to corner, 0, 0 being the centre of the hole.
vec2 placeInCell(Let let, vec2 p) {
    const vec2 x = cellReach(let.p2);
    const vec2 y = cellReach(let.p3);
    const vec2 local = vec2(p.x * (p.x < 0.0 ? x.x : x.y), p.y * (p.y < 0.0 ? y.x : y.y));
    const vec2 along = cellAlong(let);
    return vec2(let.p0, let.p1) + local.x * along + local.y * vec2(-along.y, along.x);
}

#endif
