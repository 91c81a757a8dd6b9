#pragma once

#include <cstdint>
#include <vector>

#include "tri/contours.h"
#include "tri/insertion_order.h"
#include "tri/mesh.h"
#include "tri/threads.h"

namespace tri {

/// Everything one polygon needs while it is triangulated. One per thread lives on from polygon to polygon: fresh memory
/// costs more in page faults than small polygons cost in all.
struct Workspace {
    Mesh mesh;
    Contours contours;
    Scratch<std::uint32_t> vertexOf;  ///< per index; overwritten by finish()
    Scratch<std::uint8_t> states;
    RoundStarts roundStart{};

    /// Orders the polygon's points into the mesh and takes over its contours. Anything but Ok is the final status.
    [[nodiscard]] Status start(const Polygon& polygon, Cores cores);
    /// After the triangulation in the box: contours and erasing.
    [[nodiscard]] Status finish(Cores cores, std::vector<std::uint32_t>& triangles);

    [[nodiscard]] std::size_t bytes() const;
    /// Gives the memory back if there is more than a thread may keep.
    void trim();
};

}  // namespace tri
