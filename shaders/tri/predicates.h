// The predicates of tri/predicates.h for the kernels: the same numbers, from 32-bit words alone, so that no device
// needs 64-bit integers. Wider numbers are vectors of words, lowest first, in two's complement. Why nothing overflows
// is explained in tri/predicates.h.
#ifndef COPPERSCOPE_SHADERS_TRI_PREDICATES_H
#define COPPERSCOPE_SHADERS_TRI_PREDICATES_H

#include "cpp_and_glsl.h"

#ifdef __cplusplus
namespace shader::tri {
#endif

TRI_FN uvec2 add64(uvec2 a, uvec2 b) {
    const uint low = a.x + b.x;
    return uvec2(low, a.y + b.y + (low < a.x ? 1u : 0u));
}

TRI_FN uvec2 subtract64(uvec2 a, uvec2 b) {
    return uvec2(a.x - b.x, a.y - b.y - (a.x < b.x ? 1u : 0u));
}

TRI_FN bool isNegative64(uvec2 a) {
    return (a.y >> 31) != 0u;
}

TRI_FN uvec2 magnitude64(uvec2 a) {
    return isNegative64(a) ? subtract64(uvec2(0u, 0u), a) : a;
}

// |a - b|: below 2^32 for coordinates of a triangulation.
TRI_FN uint distanceBetween(int a, int b) {
    return a < b ? uint(b) - uint(a) : uint(a) - uint(b);
}

// (a - b) * (c - d), below 2^63 in size.
TRI_FN uvec2 productOfDifferences(int a, int b, int c, int d) {
    const uvec2 size = multiply(distanceBetween(a, b), distanceBetween(c, d));
    return (a < b) == (c < d) ? size : subtract64(uvec2(0u, 0u), size);
}

// Twice the signed area of (a, b, c).
TRI_FN uvec2 orient(ivec2 a, ivec2 b, ivec2 c) {
    return subtract64(productOfDifferences(b.x, a.x, c.y, a.y), productOfDifferences(b.y, a.y, c.x, a.x));
}

// a - b as a wider number.
TRI_FN uvec2 signed64(int a, int b) {
    const uvec2 size = uvec2(distanceBetween(a, b), 0u);
    return a < b ? subtract64(uvec2(0u, 0u), size) : size;
}

TRI_FN uvec4 widen(uvec2 a) {
    const uint high = isNegative64(a) ? 0xFFFFFFFFu : 0u;
    return uvec4(a.x, a.y, high, high);
}

// 1 counter-clockwise, -1 clockwise, 0 collinear.
TRI_FN int turnOf(ivec2 a, ivec2 b, ivec2 c) {
    const uvec2 area = orient(a, b, c);
    return isNegative64(area) ? -1 : ((area.x | area.y) != 0u ? 1 : 0);
}

TRI_FN uvec4 add128(uvec4 a, uvec4 b) {
    const uint x = a.x + b.x;
    const uint carryX = x < a.x ? 1u : 0u;
    const uint y = a.y + b.y;
    const uint carryY = y < a.y ? 1u : 0u;
    const uint yy = y + carryX;
    const uint carryYy = yy < y ? 1u : 0u;
    const uint z = a.z + b.z;
    const uint carryZ = z < a.z ? 1u : 0u;
    const uint zz = z + carryY + carryYy;
    const uint carryZz = zz < z ? 1u : 0u;
    return uvec4(x, yy, zz, a.w + b.w + carryZ + carryZz);
}

TRI_FN uvec4 negate128(uvec4 a) {
    return add128(uvec4(~a.x, ~a.y, ~a.z, ~a.w), uvec4(1u, 0u, 0u, 0u));
}

// 64 x 64 bits, unsigned.
TRI_FN uvec4 multiply64(uvec2 a, uvec2 b) {
    const uvec2 low = multiply(a.x, b.x);
    const uvec2 high = multiply(a.y, b.y);
    const uvec2 cross = multiply(a.x, b.y);
    const uvec2 crossToo = multiply(a.y, b.x);
    const uvec4 outer = uvec4(low.x, low.y, high.x, high.y);
    return add128(add128(outer, uvec4(0u, cross.x, cross.y, 0u)), uvec4(0u, crossToo.x, crossToo.y, 0u));
}

// The squared distance of two points: needs all 64 bits, unsigned.
TRI_FN uvec2 liftOf(ivec2 p, ivec2 d) {
    const uint x = distanceBetween(p.x, d.x);
    const uint y = distanceBetween(p.y, d.y);
    return add64(multiply(x, x), multiply(y, y));
}

// lift * minor, where only the minor has a sign.
TRI_FN uvec4 liftTimes(uvec2 lift, uvec2 minor) {
    const uvec4 size = multiply64(lift, magnitude64(minor));
    return isNegative64(minor) ? negate128(size) : size;
}

// For a counter-clockwise triangle (a, b, c): positive if d lies inside its circumscribed circle, 0 if it lies on it.
TRI_FN uvec4 inCircle(ivec2 a, ivec2 b, ivec2 c, ivec2 d) {
    return add128(add128(liftTimes(liftOf(a, d), orient(d, b, c)), liftTimes(liftOf(b, d), orient(d, c, a))),
                  liftTimes(liftOf(c, d), orient(d, a, b)));
}

TRI_FN bool isZero128(uvec4 a) {
    return (a.x | a.y | a.z | a.w) == 0u;
}

TRI_FN bool isNegative128(uvec4 a) {
    return (a.w >> 31) != 0u;
}

// tri/predicates.h, isInPerturbedCircle: `ids` of a, b, c, d break the tie.
TRI_FN bool isInPerturbedCircle(ivec2 a, ivec2 b, ivec2 c, ivec2 d, uvec4 ids) {
    const uvec4 exact = inCircle(a, b, c, d);
    if (!isZero128(exact)) {
        return !isNegative128(exact);
    }
    const uint low = ids.x < ids.y ? ids.x : ids.y;
    const uint lowest = low < ids.z ? low : ids.z;
    if (ids.w < lowest) {
        return false;
    }
    const ivec2 p = lowest == ids.x ? b : (lowest == ids.y ? c : a);
    const ivec2 q = lowest == ids.x ? c : (lowest == ids.y ? a : b);
    return turnOf(p, q, d) > 0;
}

// A number of 31 bits that grows with a positive determinant: the location of its highest bit, and the 24 bits after
// that.
TRI_FN uint rankOf(uvec4 positive) {
    uint shift = 96u;
    while (shift > 0u && positive.w == 0u) {
        positive = uvec4(0u, positive.x, positive.y, positive.z);
        shift -= 32u;
    }
    const uint top = highestBit(positive.w | 1u);
    // The 32 bits after the highest one.
    const uint after = top == 0u ? positive.z : (positive.w << (32u - top)) | (positive.z >> top);
    return (shift + top) << 24 | after >> 8;
}

#ifdef __cplusplus
}  // namespace shader::tri
#endif
#endif
