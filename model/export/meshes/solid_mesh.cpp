#include "model/export/meshes/solid_mesh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "model/export/meshes/united.h"
#include "model/geometry/vectors.h"
#include "tri/triangulate.h"

namespace model {

namespace {

/// From its start to its end, counter-clockwise positive.
double sweepOf(const Edge& arc) {
    constexpr double kTurn = 2 * std::numbers::pi;
    const PointD a = minus(arc.a, arc.centre);
    const PointD b = minus(arc.b, arc.centre);
    const double turned = arc.isFullCircle() ? 0.0 : std::atan2(cross(a, b), dot(a, b));
    if (arc.isClockwise) {
        return turned >= 0.0 ? turned - kTurn : turned;
    }
    return turned <= 0.0 ? turned + kTurn : turned;
}

void addCorner(PointD p, std::vector<Point>& corners) {
    const Point corner{toNm(p.x), toNm(p.y)};
    if (corners.empty() || corners.back() != corner) {
        corners.push_back(corner);
    }
}

/// The corners of an edge without its end.
void addCorners(const Edge& edge, const Discretisation& how, std::vector<Point>& corners) {
    addCorner(edge.a, corners);
    if (!edge.isArc()) {
        return;
    }
    const double sweep = sweepOf(edge);
    const PointD from = minus(edge.a, edge.centre);
    const double start = std::atan2(from.y, from.x);
    const int chords = chordCount(edge.radius, sweep, edge.isFullCircle(), how);
    for (int i = 1; i < chords; ++i) {
        const double angle = start + sweep * i / chords;
        addCorner({edge.centre.x + edge.radius * std::cos(angle), edge.centre.y + edge.radius * std::sin(angle)},
                  corners);
    }
}

/// How often loops go through booleans: rounding may let them cross again, by a nanometre.
constexpr int kRounds = 3;

/// The loops that could be triangulated: those given, or what they cover. Empty if none could.
LoopSet triangulated(const LoopSet& given, std::vector<std::uint32_t>& triangles) {
    LoopSet loops = given;
    for (int round = 0; round <= kRounds; ++round) {
        triangles.clear();
        const tri::Polygon flat{loops.points, loops.loopStart};
        if (tri::triangulate(flat, tri::Triangulator::Auto, triangles).outcome != tri::Outcome::Crossing) {
            return loops;
        }
        loops = unitedLoops(loops);
    }
    triangles.clear();
    return {};
}

/// The edges that only one triangle has, as it runs through them: what walls stand on.
std::vector<std::pair<std::uint32_t, std::uint32_t>> borderOf(std::span<const std::uint32_t> triangles) {
    using Run = std::pair<std::uint32_t, std::uint32_t>;
    std::vector<std::pair<Run, bool>> runs;  // with the smaller row first, and whether that is how it runs
    runs.reserve(triangles.size());
    for (std::size_t i = 0; i < triangles.size(); i += 3) {
        for (std::size_t k = 0; k < 3; ++k) {
            const std::uint32_t a = triangles[i + k];
            const std::uint32_t b = triangles[i + (k + 1) % 3];
            runs.push_back({std::minmax(a, b), a < b});
        }
    }
    std::ranges::sort(runs);
    std::vector<Run> border;
    for (std::size_t i = 0; i < runs.size(); ++i) {
        if (i + 1 < runs.size() && runs[i].first == runs[i + 1].first) {
            ++i;
            continue;
        }
        const Run run = runs[i].first;
        border.push_back(runs[i].second ? run : Run{run.second, run.first});
    }
    return border;
}

/// Rows of the points that triangles use, numbered anew in the same order.
struct UsedPoints {
    std::vector<std::uint32_t> rows;
    std::vector<std::uint32_t> rowOf;

    UsedPoints(std::span<const std::uint32_t> triangles, std::size_t points) : rowOf(points, 0) {
        for (const std::uint32_t corner : triangles) {
            rowOf[corner] = 1;
        }
        for (std::uint32_t row = 0; row < points; ++row) {
            if (rowOf[row] != 0) {
                rowOf[row] = static_cast<std::uint32_t>(rows.size());
                rows.push_back(row);
            }
        }
    }
};

/// Each from its smallest row on, in rising order: several cores find them in another order every time.
std::vector<std::array<std::uint32_t, 3>> inRisingOrder(std::span<const std::uint32_t> flat) {
    std::vector<std::array<std::uint32_t, 3>> triangles;
    triangles.reserve(flat.size() / 3);
    for (std::size_t i = 0; i < flat.size(); i += 3) {
        std::array<std::uint32_t, 3> triangle{flat[i], flat[i + 1], flat[i + 2]};
        std::ranges::rotate(triangle, std::ranges::min_element(triangle));
        triangles.push_back(triangle);
    }
    std::ranges::sort(triangles);
    return triangles;
}

/// Planes have millions of triangles: exactly the room for them, where that is more than twice of what is there.
template <class T>
void makeRoom(std::vector<T>& list, std::size_t more) {
    if (list.size() + more > list.capacity()) {
        list.reserve(std::max(list.size() + more, 2 * list.capacity()));
    }
}

}  // namespace

void SolidMesh::append(const SolidMesh& other) {
    const auto first = static_cast<std::uint32_t>(points.size());
    points.insert(points.end(), other.points.begin(), other.points.end());
    for (const std::uint32_t corner : other.triangles) {
        triangles.push_back(first + corner);
    }
}

void SolidMesh::append(const SolidMesh& other, const Placement& placement) {
    const std::size_t first = points.size();
    append(other);
    for (std::size_t i = first; i < points.size(); ++i) {
        const Point moved = placement.apply(Point{points[i].x, points[i].y});
        points[i] = {moved.x, moved.y, points[i].z};
    }
}

PolygonSet polygonsOf(const EdgeLoops& region, const Discretisation& how) {
    PolygonSet set;
    set.beginPolygon();
    std::vector<Point> corners;
    for (std::size_t i = 0; i < region.loopCount(); ++i) {
        corners.clear();
        for (const Edge& edge : region.loop(i)) {
            addCorners(edge, how, corners);
        }
        while (corners.size() > 1 && corners.front() == corners.back()) {
            corners.pop_back();
        }
        if (!set.addLoop(corners) && i == 0) {
            return {};
        }
    }
    return set;
}

bool appendPrism(const LoopSet& given, const ZRange& z, SolidMesh& mesh) {
    std::vector<std::uint32_t> flat;
    const LoopSet loops = triangulated(given, flat);
    if (flat.empty()) {
        return false;
    }
    const UsedPoints used(flat, loops.points.size());
    const auto below = static_cast<std::uint32_t>(mesh.points.size());
    const auto above = below + static_cast<std::uint32_t>(used.rows.size());
    makeRoom(mesh.points, 2 * used.rows.size());
    for (const Nm height : {z.bottom, z.top}) {
        for (const std::uint32_t row : used.rows) {
            mesh.points.push_back({loops.points[row].x, loops.points[row].y, height});
        }
    }
    for (std::uint32_t& corner : flat) {
        corner = used.rowOf[corner];
    }
    const auto border = borderOf(flat);
    makeRoom(mesh.triangles, 2 * flat.size() + 6 * border.size());
    for (const auto& [a, b, c] : inRisingOrder(flat)) {
        mesh.triangles.insert(mesh.triangles.end(), {above + a, above + b, above + c});
        mesh.triangles.insert(mesh.triangles.end(), {below + c, below + b, below + a});
    }
    for (const auto& [a, b] : border) {
        mesh.triangles.insert(mesh.triangles.end(), {below + a, below + b, above + b});
        mesh.triangles.insert(mesh.triangles.end(), {below + a, above + b, above + a});
    }
    return true;
}

bool appendPrisms(const PolygonSet& polygons, const ZRange& z, SolidMesh& mesh) {
    bool isWhole = !polygons.polygons.empty();
    for (std::size_t row = 0; row < polygons.polygons.size(); ++row) {
        isWhole = appendPrism(loopsOf(polygons, row), z, mesh) && isWhole;
    }
    return isWhole;
}

double volumeOf(const SolidMesh& mesh) {
    double sixfold = 0.0;
    const auto at = [&](std::size_t corner) {
        const MeshPoint& p = mesh.points[mesh.triangles[corner]];
        const MeshPoint& base = mesh.points.front();
        return std::array<double, 3>{static_cast<double>(p.x) - base.x, static_cast<double>(p.y) - base.y,
                                     static_cast<double>(p.z) - base.z};
    };
    for (std::size_t i = 0; i < mesh.triangles.size(); i += 3) {
        const auto a = at(i);
        const auto b = at(i + 1);
        const auto c = at(i + 2);
        sixfold += a[0] * (b[1] * c[2] - b[2] * c[1]) + a[1] * (b[2] * c[0] - b[0] * c[2]) +
                   a[2] * (b[0] * c[1] - b[1] * c[0]);
    }
    return sixfold / 6;
}

}  // namespace model
