#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "model/base/point.h"
#include "model/base/progress.h"

/// Polygons with holes in, triangles out. Knows nothing of boards.
///
/// What you get is *the* constrained Delaunay triangulation: all different positions of the polygon's points are its
/// vertices, its contours are its constraints, and everything outside is erased (paper, "Non-procedural"). Where four
/// points lie on one circle, the choice is made as if each point were lifted by an infinitesimal amount that falls with
/// its index (predicates.h). So the set of triangles depends on nothing but the input: every triangulator here gives
/// the same one, on one thread or many, and triangleSetHash() compares them.
///
/// Exact: no point is moved or added, every decision is made in integers.
namespace tri {

using base::Point;

/// One polygon: loop i is points[loopStart[i] .. loopStart[i + 1]), `loopStart` has one entry more than there are
/// loops. The outline winds counter-clockwise, holes clockwise, an island in a hole counter-clockwise again. Loops are
/// not closed by a repeated point. A coordinate is at most base::kMaxCoordinate (2^30) in size.
///
/// Loops may touch themselves and each other at points (also a vertex inside an edge) and along edges: the runs of
/// contours along an edge are added up, opposite ones cancel (the bridge of a keyhole, a slit, a spike). They may not
/// cross, and no location may be surrounded twice.
struct Polygon {
    std::span<const Point> points;
    std::span<const std::uint32_t> loopStart;
};

enum class Outcome : std::uint8_t {
    Ok,          ///< the triangles cover the polygon exactly (proven: their border is the contours)
    Degenerate,  ///< no area: no triangles
    Crossing,    ///< edges cross or regions overlap: no triangles; repair with integer booleans and try again
};

/// No edge of the polygon.
inline constexpr std::uint32_t kNoEdge = 0xFFFFFFFF;

/// How it went. An edge is named by the index of the point it starts at.
struct Status {
    Outcome outcome = Outcome::Ok;
    /// Crossing only: the two edges that cross or run along each other in the same direction; twice the same edge if it
    /// does not separate inside from outside (a contour that winds the wrong way, a region in a region).
    std::uint32_t firstEdge = kNoEdge;
    std::uint32_t secondEdge = kNoEdge;

    bool operator==(const Status&) const = default;
};

enum class Triangulator : std::uint8_t {
    Auto,      ///< the fastest for this polygon
    Cpu,       ///< sequential insertion, one thread
    Parallel,  ///< one large polygon over all cores
    Cgal,  ///< CGAL's constrained triangulation with a final pass of perturbed flips: slow, independent; does not name
           ///< crossing edges
    Gpu,   ///< all polygons of a board at once on a Vulkan device: tri/gpu/triangulator.h, not triangulate()
};

/// Those that triangulate() takes.
inline constexpr Triangulator kTriangulators[] = {Triangulator::Auto, Triangulator::Cpu, Triangulator::Parallel,
                                                  Triangulator::Cgal};

[[nodiscard]] std::string_view nameOf(Triangulator triangulator);
/// By its name ("auto", "cpu", "parallel", "cgal", "gpu").
[[nodiscard]] std::optional<Triangulator> triangulatorNamed(std::string_view name);

/// One polygon's result, for those who have many.
struct Triangulation {
    Status status;
    std::vector<std::uint32_t> triangles;
};

/// Something that takes all polygons of a board at once: a device. What it gives back after a cancel is of no use.
using BatchTriangulator = std::function<std::vector<Triangulation>(std::span<const Polygon>, base::Progress& progress)>;

/// Appends three indices into `polygon.points` per triangle, counter-clockwise; of points at the same position the
/// lowest index is used. Nothing is appended unless the outcome is Ok. The order of the triangles is not part of the
/// contract. Thread-safe on different outputs: put one polygon into a task, the largest first. A thread keeps its
/// working memory (about 80 bytes per vertex, at most 64 MB) for the next polygon.
[[nodiscard]] Status triangulate(const Polygon& polygon, Triangulator triangulator,
                                 std::vector<std::uint32_t>& triangles);

/// A number that is the same for the same set of triangles, in whatever order they and their corners are listed.
[[nodiscard]] std::uint64_t triangleSetHash(std::span<const std::uint32_t> triangles);

}  // namespace tri
