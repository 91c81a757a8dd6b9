// Looking at the mesh; needs the names of access.h (or the ones of the kernel in shared memory).

TRI_FN uint nextCorner(uint i) {
    return i == 2u ? 0u : i + 1u;
}
TRI_FN uint previousCorner(uint i) {
    return i == 0u ? 2u : i - 1u;
}
TRI_FN uint edgeRef(uint triangle, uint corner) {
    return triangle << 2 | corner;
}
TRI_FN uint triangleOf(uint edge) {
    return edge >> 2;
}
TRI_FN uint cornerOf(uint edge) {
    return edge & 3u;
}
TRI_FN uint stale(uint edge) {
    return edge | kStale;  // kNone stays kNone
}
TRI_FN uint stampOf(uint stage) {
    return STEP * 4u + stage;
}
TRI_FN bool isChanged(uint t, uint stage) {
    return STAMP(t) >> 2 == stampOf(stage);
}
TRI_FN bool isDead(uint t) {
    return CORNER(t, 0) == kNone;
}
TRI_FN bool isBox(uint v) {
    return ID(v) >= kBoxIds;
}
TRI_FN int orientationAt(uint a, uint b, uint c) {
    return turnOf(POINT(a), POINT(b), POINT(c));
}

// Has the flips of a step, this one or the next, look at triangle t.
TRI_FN void wake(uint t, uint step) {
    if (atomicMax(AWAKE(t), step) < step) {
        LIST_AWAKE(t, step);
    }
}

// The ray from vertex `from` to `to`, or kNone.
TRI_FN uint rayBetween(uint from, uint to) {
    for (uint r = PREVIOUS(from); r < RAY_COUNT && RAY_AT(r) == from; ++r) {
        if (RAY_OTHER(r) == to && RAY_LEAVES(r)) {
            return r;
        }
    }
    return kNone;
}

// The contour edge from `from` to `to`: its number, or kNone.
TRI_FN uint contourFrom(uint from, uint to) {
    const uint next = NEXT(from);
    if (next != kBusy) {
        return next == to ? from : kNone;
    }
    const uint ray = rayBetween(from, to);
    return ray == kNone ? kNone : VERTEX_COUNT + ray;
}

TRI_FN bool isContour(uint a, uint b) {
    return contourFrom(a, b) != kNone || contourFrom(b, a) != kNone;
}

// The circle of a triangle.
struct Circle {
    uvec3 corners;
    ivec2 a, b, c;
};
TRI_FN Circle circleOf(uint t) {
    Circle circle;
    circle.corners = CORNERS(t);
    circle.a = POINT(circle.corners.x);
    circle.b = POINT(circle.corners.y);
    circle.c = POINT(circle.corners.z);
    return circle;
}
TRI_FN bool isInside(Circle circle, uint d) {
    const uvec3 v = circle.corners;
    return isInPerturbedCircle(circle.a, circle.b, circle.c, POINT(d), uvec4(ID(v.x), ID(v.y), ID(v.z), ID(d)));
}
