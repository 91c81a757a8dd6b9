#include "tri/delaunay.h"

#include <algorithm>
#include <array>

namespace tri {

void startInBox(Mesh& mesh) {
    base::Box box;
    for (std::uint32_t i = 0; i < mesh.vertexCount; ++i) {
        box.include(mesh.points[i]);
    }
    box = box.grownBy(static_cast<base::Nm>(std::max(box.width(), box.height()) / 8 + 1));
    mesh.isCompact = std::max(box.width(), box.height()) < kCompactExtent;
    const std::uint32_t n = mesh.vertexCount;
    const std::array corners = {box.min, Point{box.max.x, box.min.y}, box.max, Point{box.min.x, box.max.y}};
    for (std::uint32_t i = 0; i < kBoxCorners; ++i) {
        mesh.points[n + i] = corners[i];
        mesh.ids[n + i] = 0xFFFFFFF0U + i;
    }
    mesh.triangleCount = 2;
    mesh.triangles[0] = {{n, n + 1, n + 2}, {kOutside, kOutside, kOutside}};
    mesh.triangles[1] = {{n, n + 2, n + 3}, {kOutside, kOutside, kOutside}};
    // The choice between the box's own two diagonals must be the perturbed one as well.
    mesh.link(EdgeRef::of(0, 1), EdgeRef::of(1, 2));
    if (mesh.isFlipNeeded(EdgeRef::of(0, 1))) {
        mesh.flip(EdgeRef::of(0, 1));
    }
}

}  // namespace tri
