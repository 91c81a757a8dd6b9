#pragma once

#include <cstdint>
#include <vector>

#include "tri/mesh.h"

namespace tri {

/// The four vertices after the polygon's own are the corners of a box around it, an eighth of the extent away. They
/// stand in for infinity: contours keep what happens outside from what is inside, so nothing more is needed.
inline constexpr std::uint32_t kBoxCorners = 4;

/// Starts a mesh: appends the box corners to its vertices and makes the first two triangles.
void startInBox(Mesh& mesh);

/// Flips until no edge on the stack, and none that a flip disturbs, has a perturbed circle with an apex in; edges for
/// which `isFixed(a, b)` holds stay. Takes edges in any order, also stale ones.
template <class IsFixed>
void restoreDelaunay(Mesh& mesh, std::vector<EdgeRef>& stack, const IsFixed& isFixed) {
    while (!stack.empty()) {
        const EdgeRef edge = stack.back();
        stack.pop_back();
        const Triangle& t = mesh.triangles[edge.triangle()];
        const std::uint32_t i = edge.corner();
        const EdgeRef other = t.across[i];
        if (!mesh.isFlipNeeded(edge) || isFixed(t.v[kNext[i]], t.v[kPrevious[i]])) {
            continue;
        }
        mesh.flip(edge);
        stack.push_back(EdgeRef::of(edge.triangle(), i));
        stack.push_back(EdgeRef::of(edge.triangle(), kPrevious[i]));
        stack.push_back(EdgeRef::of(other.triangle(), other.corner()));
        stack.push_back(EdgeRef::of(other.triangle(), kPrevious[other.corner()]));
    }
}

}  // namespace tri
