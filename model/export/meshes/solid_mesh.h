#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/geometry/boolean.h"
#include "model/geometry/discretise.h"
#include "model/solids/shells/shell.h"

namespace model {

/// On the grid of 1 nm, z up.
struct MeshPoint {
    Nm x = 0;
    Nm y = 0;
    Nm z = 0;
    bool operator==(const MeshPoint&) const = default;
};

/// Triangles with common corners, counter-clockwise seen from outside. A mesh of several solids is closed when each of
/// them is: every edge of a triangle is that of another one, run through the other way.
struct SolidMesh {
    std::vector<MeshPoint> points;
    std::vector<std::uint32_t> triangles;  ///< three rows of `points` each

    [[nodiscard]] std::size_t triangleCount() const { return triangles.size() / 3; }
    void append(const SolidMesh& other);
    /// Turned and moved; not for mirrored placements.
    void append(const SolidMesh& other, const Placement& placement);
};

/// The polygons of a region; corners are rounded to the grid, chords of arcs lie within the region where it is convex.
[[nodiscard]] PolygonSet polygonsOf(const EdgeLoops& region, const Discretisation& how);

/// Appends the closed prism over the loops. Those that cross go through integer booleans. False where nothing is left,
/// or they cannot be triangulated: then nothing is appended. Corners come in the order of the loops, triangles of the
/// faces in that of their corners, however many cores there are.
[[nodiscard]] bool appendPrism(const LoopSet& loops, const ZRange& z, SolidMesh& mesh);
/// The same over polygons, one by one.
[[nodiscard]] bool appendPrisms(const PolygonSet& polygons, const ZRange& z, SolidMesh& mesh);

/// In nm³, positive for a closed mesh whose triangles face outwards.
[[nodiscard]] double volumeOf(const SolidMesh& mesh);

}  // namespace model
