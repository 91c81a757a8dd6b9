// Erasing: one thread per triangle, then the proof that what is left is the polygon (tri/erase.h).

// Contours::sideAt: is the location right beside a, in the direction of b, inside? Here for one contour through a.
TRI_FN uint sideOfSector(uint a, uint b, uint next, uint previous) {
    if (b == next || b == previous) {
        return b == next ? kStays : kErased;
    }
    const bool isLeftOfNext = orientationAt(a, next, b) > 0;
    const bool isRightOfPrevious = orientationAt(a, previous, b) < 0;
    const bool isConvex = orientationAt(a, next, previous) > 0;
    return (isConvex ? isLeftOfNext && isRightOfPrevious : isLeftOfNext || isRightOfPrevious) ? kStays : kErased;
}

// Less than half a turn clockwise from the direction a-b?
TRI_FN bool isNear(uint a, uint b, uint other) {
    const int orientation = orientationAt(a, b, other);
    return orientation != 0 ? orientation < 0 : isAhead(a, b, other);
}

// The same for several: the first ray clockwise from a-b decides.
TRI_FN uint sideOfRays(uint a, uint b) {
    uint best = kNone;
    for (uint r = PREVIOUS(a); r < RAY_COUNT && RAY_AT(r) == a; ++r) {
        const bool isRNear = isNear(a, b, RAY_OTHER(r));
        const bool isBestNear = best != kNone && isNear(a, b, RAY_OTHER(best));
        if (best == kNone || (isRNear != isBestNear ? isRNear : orientationAt(a, RAY_OTHER(r), RAY_OTHER(best)) < 0)) {
            best = r;
        }
    }
    return best == kNone ? kUndecided : (RAY_LEAVES(best) ? kStays : kErased);
}

TRI_FN uint sideSeenFrom(uint a, uint b) {
    const uint next = NEXT(a);
    return next == kFree ? kUndecided : (next == kBusy ? sideOfRays(a, b) : sideOfSector(a, b, next, PREVIOUS(a)));
}

TRI_FN uint decideBySector(uint t) {
    for (uint i = 0u; i < 3u; ++i) {
        const uint side = sideSeenFrom(CORNER(t, i), CORNER(t, nextCorner(i)));
        if (side != kUndecided) {
            return side;
        }
    }
    return kUndecided;
}

// Does a ray from the centroid of triangle t to the right cross the edge a-b? All coordinates three times, relative to
// corner 0.
TRI_FN bool isRightOfCentroid(uint t, uint a, uint b) {
    const ivec2 p = POINT(CORNER(t, 0));
    const ivec2 q = POINT(CORNER(t, 1));
    const ivec2 r = POINT(CORNER(t, 2));
    // Heights above the centroid, times three: the sum of those above the corners. At most 3 * 2^31.4 in size.
    const uvec2 heightA = add64(add64(signed64(POINT(a).y, p.y), signed64(POINT(a).y, q.y)), signed64(POINT(a).y, r.y));
    const uvec2 heightB = add64(add64(signed64(POINT(b).y, p.y), signed64(POINT(b).y, q.y)), signed64(POINT(b).y, r.y));
    if (isNegative64(heightA) == isNegative64(heightB)) {
        return false;
    }
    // Is the centroid left of the edge that goes up? Its turn is the mean of the corners'; they sum up below 3 * 2^63.
    const uvec4 sum = add128(add128(widen(orient(POINT(a), POINT(b), p)), widen(orient(POINT(a), POINT(b), q))),
                             widen(orient(POINT(a), POINT(b), r)));
    return isNegative64(heightA) ? !isNegative128(sum) : isNegative128(sum);
}

// The paper's rule, as it stands. Where loops touch, or islands lie in holes, it keeps triangles that lie outside: the
// proof flags the tree.
TRI_FN uint decideByLoop(uint t) {
    const uint loop = FOREST.loops.at[CORNER(t, 0)];
    if (FOREST.loops.at[CORNER(t, 1)] != loop || FOREST.loops.at[CORNER(t, 2)] != loop) {
        return kStays;
    }
    const Tree tree = TREE_OF(CORNER(t, 0));
    uint crossings = 0u;
    for (uint v = tree.firstVertex; v < tree.firstVertex + tree.vertexCount; ++v) {
        crossings += NEXT(v) < kBusy && isRightOfCentroid(t, v, NEXT(v)) ? 1u : 0u;
    }
    for (uint r = tree.firstRay; r < tree.firstRay + tree.rayCount; ++r) {
        crossings += RAY_LEAVES(r) && isRightOfCentroid(t, RAY_AT(r), RAY_OTHER(r)) ? 1u : 0u;
    }
    return (crossings & 1u) != 0u ? kStays : kErased;
}

TRI_FN void decide(uint t) {
    STATE(t) = kErased;
    if (PHASE != kFinished || isDead(t) || isBox(CORNER(t, 0)) || isBox(CORNER(t, 1)) || isBox(CORNER(t, 2))) {
        return;
    }
    const uint side = FOREST.eraser == kEraseByLoop ? decideByLoop(t) : decideBySector(t);
    if (side == kUndecided) {
        ADD_FLAG(CORNER(t, 0), kFlagUndecided);
    }
    STATE(t) = side;
}

// Kept and erased triangles meet exactly along the contours, each on the left. All contours are edges of the mesh, so
// they cover what the contours surround, once, and nothing else.
TRI_FN void prove(uint t) {
    if (PHASE != kFinished || isDead(t)) {
        return;
    }
    for (uint i = 0u; i < 3u; ++i) {
        const uint other = ACROSS(t, i);
        const bool isBorder = STATE(t) == kStays && (other == kNone || STATE(triangleOf(other)) != kStays);
        const bool isContourHere = contourFrom(CORNER(t, nextCorner(i)), CORNER(t, previousCorner(i))) != kNone;
        if (isBorder != isContourHere) {
            ADD_FLAG(CORNER(t, i), kFlagBorder);
        }
    }
}

TRI_FN uint blockCount() {
    return (2u * FOREST.vertexCount + kBlockSize - 1u) / kBlockSize;
}

TRI_FN bool isKept(uint t) {
    return t < 2u * FOREST.vertexCount && STATE(t) == kStays && TREE_FLAGS(t >> 1) == 0u;
}

TRI_FN void writeKept(uint t, uint slot) {
    if (t < 2u * FOREST.vertexCount && t == 2u * TREE_OF(t >> 1).firstVertex) {
        TREE_OF(t >> 1).start = slot;
    }
    if (isKept(t)) {
        FOREST.kept.at[3u * slot] = ID(CORNER(t, 0));
        FOREST.kept.at[3u * slot + 1u] = ID(CORNER(t, 1));
        FOREST.kept.at[3u * slot + 2u] = ID(CORNER(t, 2));
    }
}
