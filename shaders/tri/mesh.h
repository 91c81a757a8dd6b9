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

// Does the triangle on the other side have its apex inside this one's circle? There is one.
TRI_FN bool isFlipNeeded(uint t, uint corner) {
    const uint other = ACROSS(t, corner);
    const uint a = CORNER(t, 0);
    const uint b = CORNER(t, 1);
    const uint c = CORNER(t, 2);
    const uint d = CORNER(triangleOf(other), cornerOf(other));
    return isInPerturbedCircle(POINT(a), POINT(b), POINT(c), POINT(d), uvec4(ID(a), ID(b), ID(c), ID(d)));
}
