// A round of insertion. Every triangle elects one of the vertices that wait in it, the one nearest to the middle of its
// circle; the elected claim the triangles they split; who has all of them splits.

// Where is vertex q relative to triangle t, in which it waits: on the edge of that number, or 3 = inside.
TRI_FN uint edgeUnder(uint t, uint q) {
    const Circle circle = circleOf(t);
    const ivec2 p = POINT(q);
    if (turnOf(circle.b, circle.c, p) == 0) {
        return 0u;
    }
    return turnOf(circle.c, circle.a, p) == 0 ? 1u : (turnOf(circle.a, circle.b, p) == 0 ? 2u : 3u);
}

// The two triangles of a tree's box, in the slots of its first corner. Which diagonal is right will be seen.
TRI_FN void initBox(uint box) {
    const uint t = 2u * box;
    for (uint i = 0u; i < 2u; ++i) {
        CORNER(t + i, 0) = box;
        CORNER(t + i, 1) = box + 1u + i;
        CORNER(t + i, 2) = box + 2u + i;
        ACROSS(t + i, 0) = kNone;
        ACROSS(t + i, 1) = kNone;
        ACROSS(t + i, 2) = kNone;
        wake(t + i, 1u);
    }
    ACROSS(t, 1) = edgeRef(t + 1u, 2u);
    ACROSS(t + 1u, 2) = edgeRef(t, 1u);
}

// Vertex v of a tree, the first corner of whose box is `box`, waits in one of the two.
TRI_FN void initVertex(uint v, uint box) {
    for (uint t = 2u * v; t < 2u * v + 2u; ++t) {
        CORNER(t, 0) = kNone;
        BEST(t) = 0u;
        CLAIM(t) = kNone;
        STAMP(t) = 0u;
        AWAKE(t) = 0u;
    }
    WHERE(v) = kNone;
    if (v == box) {
        initBox(box);
    } else if (v < box) {
        WHERE(v) = 2u * box + (orientationAt(box, box + 2u, v) > 0 ? 1u : 0u);
    }
}

TRI_FN void vote(uint q) {
    const uint t = WHERE(q);
    if (t == kNone) {
        return;
    }
    const Circle circle = circleOf(t);
    const uint rank = rankOf(inCircle(circle.a, circle.b, circle.c, POINT(q)));
    RANK(q) = rank;
    atomicMax(BEST(t), rank);
}

TRI_FN void claimPlace(uint q) {
    const uint t = WHERE(q);
    if (t == kNone || RANK(q) != BEST(t)) {
        return;
    }
    LIST_ELECTED(q);
    const uint i = edgeUnder(t, q);
    atomicMin(CLAIM(t), q);
    if (i < 3u) {
        atomicMin(CLAIM(triangleOf(ACROSS(t, i))), q);
    }
}

// A triangle (q, a, b) around the vertex q; edge a-b was `outer` before, the other two lead to its neighbours around q.
TRI_FN void writeAround(uint t, uint q, uint a, uint b, uint outer, uint left, uint right) {
    CORNER(t, 0) = q;
    CORNER(t, 1) = a;
    CORNER(t, 2) = b;
    ACROSS(t, 0) = stale(outer);
    ACROSS(t, 1) = edgeRef(left, 2u);
    ACROSS(t, 2) = edgeRef(right, 1u);
    STAMP(t) = stampOf(kStageInsert) << 2;
    wake(t, STEP);
}

TRI_FN void splitTriangle(uint t, uint q) {
    const uint second = 2u * q;
    const uint third = second + 1u;
    const uvec3 v = CORNERS(t);
    const uvec3 outer = ALL_ACROSS(t);
    writeAround(t, q, v.y, v.z, outer.x, second, third);
    writeAround(second, q, v.z, v.x, outer.y, third, t);
    writeAround(third, q, v.x, v.y, outer.z, t, second);
    MOVED(t, 0) = edgeRef(t, 0u);
    MOVED(t, 1) = edgeRef(second, 0u);
    MOVED(t, 2) = edgeRef(third, 0u);
}

TRI_FN void splitEdge(uint t, uint i, uint q) {
    const uint other = ACROSS(t, i);
    const uint u = triangleOf(other);
    const uint j = cornerOf(other);
    const uint second = 2u * q;
    const uint fourth = second + 1u;
    const uint a = CORNER(t, i);
    const uint b = CORNER(t, nextCorner(i));
    const uint c = CORNER(t, previousCorner(i));
    const uint d = CORNER(u, j);
    const uint outerCa = ACROSS(t, nextCorner(i));
    const uint outerAb = ACROSS(t, previousCorner(i));
    const uint outerBd = ACROSS(u, nextCorner(j));
    const uint outerDc = ACROSS(u, previousCorner(j));
    // Counter-clockwise around q.
    writeAround(t, q, c, a, outerCa, second, fourth);
    writeAround(second, q, a, b, outerAb, u, t);
    writeAround(u, q, b, d, outerBd, fourth, second);
    writeAround(fourth, q, d, c, outerDc, t, u);
    MOVED(t, nextCorner(i)) = edgeRef(t, 0u);
    MOVED(t, previousCorner(i)) = edgeRef(second, 0u);
    MOVED(u, nextCorner(j)) = edgeRef(u, 0u);
    MOVED(u, previousCorner(j)) = edgeRef(fourth, 0u);
}

// Of a vertex that was elected.
TRI_FN void splitPlace(uint q) {
    const uint t = WHERE(q);
    // Whoever does not own t must not look at it: its owner may be splitting it right now.
    if (t == kNone || CLAIM(t) != q) {
        return;
    }
    const uint i = edgeUnder(t, q);
    if (i == 3u) {
        splitTriangle(t, q);
    } else if (CLAIM(triangleOf(ACROSS(t, i))) == q) {
        splitEdge(t, i, q);
    } else {
        return;
    }
    WHERE(q) = kNone;
    COUNT_INSERTED;
}

// After a stage: links to what was there before it become links to what is there now. Clears what was claimed.
TRI_FN void fixLinks(uint t, uint stage) {
    BEST(t) = 0u;
    CLAIM(t) = kNone;
    if (!isChanged(t, stage)) {
        return;
    }
    for (uint i = 0u; i < 3u; ++i) {
        const uint link = ACROSS(t, i);
        if (link == kNone || (link & kStale) == 0u) {
            continue;
        }
        const uint before = link & ~kStale;
        if (isChanged(triangleOf(before), stage)) {
            ACROSS(t, i) = MOVED(triangleOf(before), cornerOf(before));
        } else {
            ACROSS(t, i) = before;
            ACROSS(triangleOf(before), cornerOf(before)) = edgeRef(t, i);
        }
    }
}

// Reads only links that fixLinks leaves alone, so both may run at the same time.
TRI_FN void relocateInserted(uint p) {
    uint t = WHERE(p);
    if (t == kNone || !isChanged(t, kStageInsert)) {
        return;
    }
    // Around the new vertex, corner 0 of them all, until p lies between the two sides.
    const uint q = CORNER(t, 0);
    for (uint i = 0u; i < 4u; ++i) {
        if (orientationAt(q, CORNER(t, 1), p) >= 0 && orientationAt(q, CORNER(t, 2), p) < 0) {
            break;
        }
        t = triangleOf(ACROSS(t, 1));
    }
    WHERE(p) = t;
}
