#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/geometry/shapes.h"

namespace model {

/// How curves become polygons.
struct Discretisation {
    double chordToleranceNm = 5000.0;  ///< largest distance between curve and chord; 500 (0.5 µm) to 50,000 (50 µm)
    /// The fixed numbers of the paper's Table 2 instead: 50 segments per full circle, 20 per arc.
    bool paperSegments = false;

    static constexpr double kMinChordNm = 500.0;
    static constexpr double kMaxChordNm = 50000.0;
    static constexpr int kPaperCircleSegments = 50;
    static constexpr int kPaperArcSegments = 20;
};

/// Polygons with holes as flat arrays, the form tri/ and the booleans take. Each polygon is an outline
/// (counter-clockwise) followed by its holes (clockwise); loops are not closed by a repeated point and hold no two
/// equal neighbours.
struct PolygonSet {
    struct Polygon {
        std::uint32_t firstLoop = 0;
        std::uint32_t loopCount = 0;
    };
    std::vector<Point> points;
    std::vector<std::uint32_t>
        loopStart;  ///< loop i: points[loopStart[i] .. loopStart[i + 1]); one more entry than loops
    std::vector<Polygon> polygons;

    void beginPolygon() { polygons.push_back({static_cast<std::uint32_t>(loopCount()), 0}); }
    /// Adds a loop to the last polygon, with the winding that its level needs. Loops of fewer than three points are
    /// left out: returns false.
    bool addLoop(std::span<const Point> loop);
    [[nodiscard]] std::size_t loopCount() const { return loopStart.empty() ? 0 : loopStart.size() - 1; }
    [[nodiscard]] std::span<const Point> loop(std::size_t index) const {
        return std::span(points).subspan(loopStart[index], loopStart[index + 1] - loopStart[index]);
    }
    void append(const PolygonSet& other);
};

/// Laid down elsewhere; mirrored loops are turned round, so that they wind as they must.
[[nodiscard]] PolygonSet placed(const PolygonSet& polygons, const Placement& placement);
/// The same region as a shape with straight edges.
[[nodiscard]] ShapeSketch sketchOf(const PolygonSet& polygons);

/// Twice the signed area of a loop, positive when counter-clockwise; exact for extents up to 2^30.
[[nodiscard]] __int128 twiceArea(std::span<const Point> loop);
[[nodiscard]] __int128 twiceArea(const PolygonSet& set);

/// Number of chords for an arc of `radius` nm and `sweep` radians (full circle: 2π).
[[nodiscard]] int chordCount(double radius, double sweep, bool isFullCircle, const Discretisation& how);

/// Sweep of the arc from `from.point` to `to` in radians, signed (counter-clockwise positive); ±2π for equal ends.
[[nodiscard]] double sweepOf(const PathNode& from, Point to);

/// Appends the points of one line or arc without its last point.
void discretiseEdge(const PathNode& from, Point to, const Discretisation& how, std::vector<Point>& out);
/// The same for one edge of a closed path, which may be a curve: no chord lies farther from it than the tolerance (with
/// paperSegments: 20 chords for each of its Bézier pieces), nor stands for more than an eighth of a turn.
void discretiseEdge(const PathNodes& path, std::size_t node, const Discretisation& how, std::vector<Point>& out);

/// The polygons of a shape, one per island with the holes that follow it: in its own coordinates, or placed.
[[nodiscard]] PolygonSet discretise(const ShapeTable& shapes, ShapeId shape, const Discretisation& how,
                                    const Placement* placement = nullptr);

}  // namespace model
