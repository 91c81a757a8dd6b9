// A round of contours. Every contour edge that the mesh lacks claims all triangles it crosses; who has all of them
// replaces them by others that have the edge. The claims' order is scattered, so that neighbours do not wait for each
// other in a row; the first one always gets all of its own.

TRI_FN uint contourCount() {
    return VERTEX_COUNT + RAY_COUNT;
}
TRI_FN uint priorityOf(uint edge) {
    return edge * 0x9E3779B1u;  // odd: no two are the same
}

// The ends of a contour edge; both kNone if there is none of that number.
TRI_FN uvec2 contourEnds(uint edge) {
    if (edge < VERTEX_COUNT) {
        return NEXT(edge) < kBusy ? uvec2(edge, NEXT(edge)) : uvec2(kNone, kNone);
    }
    const uint ray = edge - VERTEX_COUNT;
    return RAY_LEAVES(ray) ? uvec2(RAY_AT(ray), RAY_OTHER(ray)) : uvec2(kNone, kNone);
}

// Which contour edges are edges of the mesh? And some triangle at every vertex.
TRI_FN void findContours(uint t) {
    if (isDead(t)) {
        return;
    }
    for (uint i = 0u; i < 3u; ++i) {
        AROUND(CORNER(t, i)) = t;
        const uint edge = contourFrom(CORNER(t, i), CORNER(t, nextCorner(i)));
        if (edge != kNone) {
            FOUND(edge) = STEP;
        }
    }
}

// Does vertex c, on the line through a and b, lie in the direction of b?
TRI_FN bool isAhead(uint a, uint b, uint c) {
    const ivec2 from = POINT(a);
    const ivec2 p = POINT(b);
    const ivec2 q = POINT(c);
    return (p.x > from.x) == (q.x > from.x) && (p.y > from.y) == (q.y > from.y);
}

// The first edge that the line from a to b crosses, seen from the triangle at a; kNone if it meets a vertex there.
TRI_FN uint firstObstacle(uint a, uint b) {
    uint t = AROUND(a);
    for (;;) {
        const uint i = CORNER(t, 0) == a ? 0u : (CORNER(t, 1) == a ? 1u : 2u);
        const uint right = CORNER(t, nextCorner(i));
        const int orientation = orientationAt(a, b, right);
        if (orientation == 0 && isAhead(a, b, right)) {
            return kNone;
        }
        if (orientation < 0 && orientationAt(a, b, CORNER(t, previousCorner(i))) > 0) {
            return edgeRef(t, i);
        }
        t = triangleOf(ACROSS(t, nextCorner(i)));
    }
}

// The edge that the line from a to b crosses next, after it entered a triangle over the edge `entered` of it. kNone if
// it meets the apex.
TRI_FN uint nextObstacle(uint entered, uint a, uint b) {
    const uint t = triangleOf(entered);
    const uint i = cornerOf(entered);
    const int orientation = orientationAt(a, b, CORNER(t, i));
    return orientation == 0 ? kNone : edgeRef(t, orientation > 0 ? nextCorner(i) : previousCorner(i));
}

// Can the edge be inserted? Then claims the triangles it crosses; flags its tree if not.
TRI_FN bool claimObstacles(uint edge, uint a, uint b) {
    uint crossed = CORRIDOR(edge);
    if (crossed == kNone) {
        return false;
    }
    atomicMin(CLAIM(triangleOf(crossed)), priorityOf(edge));
    for (;;) {
        const uint t = triangleOf(crossed);
        const uint i = cornerOf(crossed);
        if (isContour(CORNER(t, nextCorner(i)), CORNER(t, previousCorner(i)))) {
            return false;
        }
        const uint entered = ACROSS(t, i);
        atomicMin(CLAIM(triangleOf(entered)), priorityOf(edge));
        crossed = nextObstacle(entered, a, b);
        if (crossed == kNone) {
            return CORNER(triangleOf(entered), cornerOf(entered)) == b;
        }
    }
}

TRI_FN void claimCorridor(uint edge) {
    CORRIDOR(edge) = kNone;
    const uvec2 ends = contourEnds(edge);
    if (ends.x == kNone || FOUND(edge) == STEP || TREE_FLAGS(ends.x) != 0u) {
        return;
    }
    CORRIDOR(edge) = firstObstacle(ends.x, ends.y);
    if (claimObstacles(edge, ends.x, ends.y)) {
        COUNT_MISSING;
    } else {
        CORRIDOR(edge) = kNone;
        ADD_FLAG(ends.x, kFlagBlocked);
    }
}

// How many triangles the edge crosses, or 0 if it does not own them all. Looks at no triangle that it does not own:
// others may be writing there.
TRI_FN uint ownedLength(uint edge, uint a, uint b) {
    uint crossed = CORRIDOR(edge);
    if (crossed == kNone || CLAIM(triangleOf(crossed)) != priorityOf(edge)) {
        return 0u;
    }
    for (uint length = 2u;; ++length) {
        const uint entered = ACROSS(triangleOf(crossed), cornerOf(crossed));
        if (CLAIM(triangleOf(entered)) != priorityOf(edge)) {
            return 0u;
        }
        crossed = nextObstacle(entered, a, b);
        if (crossed == kNone) {
            return length;
        }
    }
}

// A corridor of n triangles in the scratch memory: the triangles, then for its left and its right side up to n + 1
// vertices, and for the edge that leads to each of them what it was before and what lies beyond; then a stack of
// vertices with the edge to the one below.
TRI_FN uint scratchFor(uint length) {
    return length + 8u * (length + 2u);
}
TRI_FN uint sideAt(uint base, uint length, bool isLeft) {
    return base + length + (isLeft ? 0u : 3u * (length + 2u));
}
TRI_FN uint stackAt(uint base, uint length) {
    return base + length + 6u * (length + 2u);
}

// Appends vertex v and the edge `before` that leads to it. Returns how many there are now.
TRI_FN uint appendToSide(uint side, uint count, uint v, uint before) {
    SCRATCH(side + 3u * count) = v;
    SCRATCH(side + 3u * count + 1u) = before;
    SCRATCH(side + 3u * count + 2u) = before == kNone ? kNone : ACROSS(triangleOf(before), cornerOf(before));
    return count + 1u;
}

// Notes the corridor's triangles and sides; returns the number of vertices on the left.
TRI_FN uint noteCorridor(uint base, uint length, uint first, uint a, uint b) {
    const uint left = sideAt(base, length, true);
    const uint right = sideAt(base, length, false);
    const uint t = triangleOf(first);
    const uint i = cornerOf(first);
    SCRATCH(base) = t;
    uint leftCount = appendToSide(left, 0u, a, kNone);
    uint rightCount = appendToSide(right, 0u, a, kNone);
    leftCount = appendToSide(left, leftCount, CORNER(t, previousCorner(i)), edgeRef(t, nextCorner(i)));
    rightCount = appendToSide(right, rightCount, CORNER(t, nextCorner(i)), edgeRef(t, previousCorner(i)));
    uint crossed = first;
    for (uint n = 1u; n < length; ++n) {
        const uint entered = ACROSS(triangleOf(crossed), cornerOf(crossed));
        const uint u = triangleOf(entered);
        const uint j = cornerOf(entered);
        const uint apex = CORNER(u, j);
        SCRATCH(base + n) = u;
        crossed = nextObstacle(entered, a, b);
        // The edges from the crossed one to the apex: the way leaves over one, the other is border. The last triangle
        // has both.
        if (crossed == kNone || cornerOf(crossed) == nextCorner(j)) {
            leftCount = appendToSide(left, leftCount, apex, edgeRef(u, previousCorner(j)));
        }
        if (crossed == kNone || cornerOf(crossed) == previousCorner(j)) {
            rightCount = appendToSide(right, rightCount, apex, edgeRef(u, nextCorner(j)));
        }
    }
    return leftCount;
}

// Makes a new triangle's edge and what it borders on know each other: the k-th edge of a side, or (not stale) another
// new triangle.
TRI_FN void joinEdge(uint side, uint made, uint neighbour) {
    if ((neighbour & kStale) == 0u) {
        ACROSS(triangleOf(made), cornerOf(made)) = neighbour;
        ACROSS(triangleOf(neighbour), cornerOf(neighbour)) = made;
        return;
    }
    const uint k = neighbour & ~kStale;
    const uint before = SCRATCH(side + 3u * k + 1u);
    ACROSS(triangleOf(made), cornerOf(made)) = stale(SCRATCH(side + 3u * k + 2u));
    MOVED(triangleOf(before), cornerOf(before)) = made;
}

// tri/corridor.cpp, Corridor::fill: a Graham scan over one side, which takes the triangles from SCRATCH(triangle) on.
// Returns the edge a-b.
TRI_FN uint fillSide(uint side, uint count, uint stack, uint triangle, bool isLeft) {
    uint height = 1u;
    uint edge = kNone;
    SCRATCH(stack) = SCRATCH(side);
    for (uint k = 1u; k < count; ++k) {
        const uint v = SCRATCH(side + 3u * k);
        edge = stale(k);
        for (; height > 1u; --height) {
            const uint ear = SCRATCH(stack + 2u * (height - 1u));
            const uint before = SCRATCH(stack + 2u * (height - 2u));
            const int orientation = orientationAt(before, ear, v);
            if (isLeft ? orientation >= 0 : orientation <= 0) {
                break;
            }
            const uint t = SCRATCH(triangle++);
            CORNER(t, 0) = before;
            CORNER(t, 1) = isLeft ? v : ear;
            CORNER(t, 2) = isLeft ? ear : v;
            joinEdge(side, edgeRef(t, 0u), edge);
            joinEdge(side, edgeRef(t, isLeft ? 1u : 2u), SCRATCH(stack + 2u * (height - 1u) + 1u));
            edge = edgeRef(t, isLeft ? 2u : 1u);
        }
        SCRATCH(stack + 2u * height) = v;
        SCRATCH(stack + 2u * height + 1u) = edge;
        ++height;
    }
    return edge;
}

TRI_FN void rebuildCorridor(uint edge) {
    const uvec2 ends = contourEnds(edge);
    if (ends.x == kNone) {
        return;
    }
    const uint length = ownedLength(edge, ends.x, ends.y);
    if (length == 0u) {
        return;
    }
    const uint base = atomicAdd(SCRATCH_USED, scratchFor(length));
    if (base + scratchFor(length) > SCRATCH_SIZE) {
        if (scratchFor(length) > SCRATCH_SIZE) {
            ADD_FLAG(ends.x, kFlagScratch);
        }
        return;  // another time
    }
    const uint leftCount = noteCorridor(base, length, CORRIDOR(edge), ends.x, ends.y);
    // Both sides together have two vertices more than there are triangles, and both ends twice.
    const uint rightCount = length + 4u - leftCount;
    const uint stack = stackAt(base, length);
    const uint left = fillSide(sideAt(base, length, true), leftCount, stack, base, true);
    const uint right = fillSide(sideAt(base, length, false), rightCount, stack, base + leftCount - 2u, false);
    ACROSS(triangleOf(left), cornerOf(left)) = right;
    ACROSS(triangleOf(right), cornerOf(right)) = left;
    for (uint n = 0u; n < length; ++n) {
        STAMP(SCRATCH(base + n)) = stampOf(kStageRebuild) << 2;
        wake(SCRATCH(base + n), STEP);
    }
}
