// A round of flips. Every awake triangle finds an edge that is not Delaunay and claims the triangles on both sides
// of it; who has both flips.

// Lowest key wins.
TRI_FN void claimForFlip(uint t, uint key) {
    if (atomicMin(CLAIM(t), key) == kNone) {
        LIST_CLAIMED(t);
    }
}

TRI_FN void testEdges(uint t) {
    if (AWAKE(t) < STEP) {
        return;
    }
    for (uint i = 0u; i < 3u; ++i) {
        const uint other = ACROSS(t, i);
        const uint u = triangleOf(other);
        // Of two awake triangles the first looks at the edge between them.
        if (other == kNone || (u < t && AWAKE(u) >= STEP)) {
            continue;
        }
        const bool isFixed =
            PHASE == kConstraining && isContour(CORNER(t, nextCorner(i)), CORNER(t, previousCorner(i)));
        if (!isFixed && isInside(circleOf(t), CORNER(u, cornerOf(other)))) {
            const uint key = edgeRef(t, i);
            wake(t, STEP + 1u);
            claimForFlip(t, key);
            claimForFlip(u, key);
            return;
        }
    }
}

// tri/mesh.h, Mesh::flip.
TRI_FN void flipEdge(uint t) {
    const uint key = CLAIM(t);
    if (key == kNone || triangleOf(key) != t) {
        return;
    }
    const uint i = cornerOf(key);
    const uint other = ACROSS(t, i);
    const uint u = triangleOf(other);
    const uint j = cornerOf(other);
    if (CLAIM(u) != key) {
        return;
    }
    const uint outerOfU = ACROSS(u, nextCorner(j));
    const uint outerOfT = ACROSS(t, nextCorner(i));
    const uint apexOfT = CORNER(t, i);
    CORNER(t, previousCorner(i)) = CORNER(u, j);
    CORNER(u, previousCorner(j)) = apexOfT;
    ACROSS(t, i) = stale(outerOfU);
    ACROSS(u, j) = stale(outerOfT);
    ACROSS(t, nextCorner(i)) = edgeRef(u, nextCorner(j));
    ACROSS(u, nextCorner(j)) = edgeRef(t, nextCorner(i));
    ACROSS(t, previousCorner(i)) = stale(ACROSS(t, previousCorner(i)));
    ACROSS(u, previousCorner(j)) = stale(ACROSS(u, previousCorner(j)));
    MOVED(u, nextCorner(j)) = edgeRef(t, i);
    MOVED(t, nextCorner(i)) = edgeRef(u, j);
    MOVED(t, previousCorner(i)) = edgeRef(t, previousCorner(i));
    MOVED(u, previousCorner(j)) = edgeRef(u, previousCorner(j));
    STAMP(t) = stampOf(kStageFlip) << 2 | nextCorner(i);
    STAMP(u) = stampOf(kStageFlip) << 2 | nextCorner(j);
    wake(u, STEP + 1u);
    COUNT_FLIP;
}

// As relocateInserted.
TRI_FN void relocateFlipped(uint p) {
    const uint t = WHERE(p);
    if (t == kNone || !isChanged(t, kStageFlip)) {
        return;
    }
    const uint i = STAMP(t) & 3u;
    if (orientationAt(CORNER(t, nextCorner(i)), CORNER(t, previousCorner(i)), p) < 0) {
        WHERE(p) = triangleOf(ACROSS(t, i));
    }
}
