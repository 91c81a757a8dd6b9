#include "render/modelling/area_meshes.h"

#include <algorithm>
#include <atomic>
#include <numeric>
#include <tuple>

#include "model/base/edge_slots.h"
#include "model/base/parallel.h"
#include "model/figures/element_polygons.h"
#include "model/geometry/boolean.h"

namespace render {

using model::Point;
using model::PolygonSet;

namespace {

std::size_t nodeCount(const model::ShapeTable& table, model::ShapeId shape) {
    std::size_t sum = 0;
    for (const model::Contour& contour : table.contoursOf(shape)) {
        sum += contour.nodeCount;
    }
    return sum;
}

/// Triangulates every polygon of the set; false if one of them crosses itself or another loop of its own.
bool triangulateAll(const PolygonSet& set, tri::Triangulator triangulator, std::vector<std::uint32_t>& triangles) {
    for (std::size_t row = 0; row < set.polygons.size(); ++row) {
        if (!triangulatePolygon(set, row, triangles, triangulator)) {
            return false;
        }
    }
    return true;
}

struct WallEdge {
    Point low;
    Point high;
    bool isForward;
    std::uint32_t from;
};

void repair(ShapeMesh& mesh, tri::Triangulator triangulator) {
    mesh.triangles.clear();
    mesh.polygons = model::unite(mesh.polygons);
    mesh.wasRepaired = true;
    mesh.failed = !triangulateAll(mesh.polygons, triangulator, mesh.triangles);
    if (mesh.failed) {
        mesh.triangles.clear();
    }
}

/// The edges of which another one runs between the same points, there or back. `next` leads from a point to the end of
/// its edge, or to itself where it has none.
std::vector<WallEdge> sharedEdges(const std::vector<Point>& points, const std::vector<std::uint32_t>& next) {
    const auto edgeAt = [&](std::uint32_t i) {
        const Point a = points[i];
        const Point b = points[next[i]];
        return WallEdge{std::min(a, b), std::max(a, b), a < b, i};
    };
    base::EdgeSlots slots;
    slots.reset(points.size());
    std::vector<bool> isShared(points.size(), false);
    std::vector<WallEdge> shared;
    const auto share = [&](std::uint32_t i) {
        if (!isShared[i]) {
            isShared[i] = true;
            shared.push_back(edgeAt(i));
        }
    };
    for (std::uint32_t i = 0; i < points.size(); ++i) {
        if (next[i] == i) {
            continue;
        }
        const WallEdge edge = edgeAt(i);
        const std::uint32_t same = slots.findOrKeep(edge.low, edge.high, i, [&](std::uint32_t kept) {
            const WallEdge other = edgeAt(kept);
            return other.low == edge.low && other.high == edge.high;
        });
        if (same != base::EdgeSlots::kNone) {
            share(same);
            share(i);
        }
    }
    return shared;
}

/// The wall of every contour edge of loops without the flag `wallless` (empty: none has it), except where two opposite
/// edges coincide (the bridge of a keyhole contour; odb-notes, Features).
std::vector<std::uint32_t> findWalls(const PolygonSet& set, const std::vector<std::uint8_t>& wallless) {
    std::vector<std::uint32_t> next(set.points.size());
    std::iota(next.begin(), next.end(), 0U);
    for (std::size_t loop = 0; loop < set.loopCount(); ++loop) {
        if (!wallless.empty() && wallless[loop] != 0) {
            continue;
        }
        for (std::uint32_t i = set.loopStart[loop]; i < set.loopStart[loop + 1]; ++i) {
            next[i] = i + 1 < set.loopStart[loop + 1] ? i + 1 : set.loopStart[loop];
        }
    }
    std::vector<WallEdge> edges = sharedEdges(set.points, next);
    std::ranges::sort(edges, [](const WallEdge& a, const WallEdge& b) {
        return std::tuple(a.low, a.high, a.isForward, a.from) < std::tuple(b.low, b.high, b.isForward, b.from);
    });
    for (std::size_t i = 0; i < edges.size();) {
        std::size_t end = i;
        while (end < edges.size() && edges[end].low == edges[i].low && edges[end].high == edges[i].high) {
            ++end;
        }
        // Backward edges come first: pair them off against the forward ones from the other end.
        for (std::size_t last = end; i + 1 < last && edges[i].isForward != edges[last - 1].isForward; ++i, --last) {
            next[edges[i].from] = edges[i].from;
            next[edges[last - 1].from] = edges[last - 1].from;
        }
        i = end;
    }
    return next;
}

/// Fields of round holes have none. They are known by their corners: no other loop comes near them, repaired or not.
/// Not of a mesh that has its walls already, as long as it was not repaired.
void findMeshWalls(ShapeMesh& mesh) {
    if (!mesh.next.empty() && mesh.next.size() == mesh.polygons.points.size()) {
        return;
    }
    std::vector<Point> corners;
    std::ranges::transform(mesh.fields, std::back_inserter(corners), &model::Box::min);
    std::ranges::sort(corners);
    std::vector<std::uint8_t> isField(mesh.polygons.loopCount(), 0);
    for (std::size_t loop = 0; loop < isField.size() && !corners.empty(); ++loop) {
        const std::span<const Point> points = mesh.polygons.loop(loop);
        const bool isBox = points.size() == 4;
        isField[loop] = isBox && std::ranges::binary_search(corners, *std::ranges::min_element(points)) ? 1 : 0;
    }
    mesh.next = findWalls(mesh.polygons, isField);
}

void triangulateShape(ShapeMesh& mesh, tri::Triangulator triangulator) {
    if (!triangulateAll(mesh.polygons, triangulator, mesh.triangles)) {
        repair(mesh, triangulator);
    }
    findMeshWalls(mesh);
}

/// The polygons of all shapes behind each other, with loops that stay where they are.
struct Batch {
    std::vector<tri::Polygon> polygons;
    std::vector<std::size_t> firstOf;  ///< per shape, and the end
    std::vector<std::vector<std::uint32_t>> loops;
    std::vector<std::uint32_t> firstPoint;
};

Batch collect(const std::vector<ShapeMesh>& meshes) {
    Batch batch;
    for (const ShapeMesh& mesh : meshes) {
        batch.firstOf.push_back(batch.polygons.size());
        forEachPolygon(mesh.polygons, [&](std::uint32_t first, const tri::Polygon& polygon) {
            const auto& loops = batch.loops.emplace_back(polygon.loopStart.begin(), polygon.loopStart.end());
            batch.polygons.push_back({polygon.points, loops});
            batch.firstPoint.push_back(first);
        });
    }
    batch.firstOf.push_back(batch.polygons.size());
    return batch;
}

void triangulateOnDevice(std::vector<ShapeMesh>& meshes, const tri::BatchTriangulator& device,
                         base::Progress& progress) {
    const Batch batch = collect(meshes);
    const std::vector<tri::Triangulation> results = device(batch.polygons, progress);
    if (progress.isCancelled()) {
        return;
    }
    base::parallelFor(meshes.size(), [&](std::size_t shape) {
        ShapeMesh& mesh = meshes[shape];
        bool isRight = true;
        for (std::size_t i = batch.firstOf[shape]; i < batch.firstOf[shape + 1]; ++i) {
            isRight = isRight && results[i].status.outcome != tri::Outcome::Crossing;
            for (const std::uint32_t corner : results[i].triangles) {
                mesh.triangles.push_back(corner + batch.firstPoint[i]);
            }
        }
        if (!isRight) {
            repair(mesh, tri::Triangulator::Auto);
        }
        findMeshWalls(mesh);
    });
}

}  // namespace

bool triangulatePolygon(const PolygonSet& set, std::size_t row, std::vector<std::uint32_t>& triangles,
                        tri::Triangulator triangulator) {
    bool isRight = false;
    visitPolygon(set, row, [&](std::uint32_t first, const tri::Polygon& polygon) {
        const std::size_t before = triangles.size();
        isRight = tri::triangulate(polygon, triangulator, triangles).outcome != tri::Outcome::Crossing;
        for (std::size_t i = before; i < triangles.size(); ++i) {
            triangles[i] += first;
        }
    });
    return isRight;
}

std::vector<std::uint32_t> findWalls(const PolygonSet& set) {
    return findWalls(set, {});
}

std::vector<model::ShapeId> shapesInUse(const model::Document& document) {
    std::vector<std::uint8_t> isUsed(document.shapes.size(), 0);
    for (const model::AreaGeometry& area : document.areas) {
        isUsed[area.shape.row()] = 1;
    }
    std::vector<model::ShapeId> used;
    for (std::size_t row = 0; row < isUsed.size(); ++row) {
        if (isUsed[row] != 0) {
            used.emplace_back(row);
        }
    }
    return used;
}

std::vector<ShapeMesh> punchShapes(const model::Document& document, const std::vector<model::ShapeId>& shapes,
                                   const model::Discretisation& how, base::Progress& progress) {
    std::vector<std::uint32_t> locations(document.shapes.size(), 0);
    for (const model::AreaGeometry& area : document.areas) {
        ++locations[area.shape.row()];
    }
    // Lets are as high as their layer, bodies are not.
    for (const model::Body& body : document.bodies) {
        ++locations[document.areas[document.elements.geometry[body.element.row()]].shape.row()];
    }
    std::vector<ShapeMesh> meshes(shapes.size());
    const std::vector<std::uint32_t> order =
        base::largestFirst(shapes.size(), [&](std::size_t row) { return nodeCount(document.shapes, shapes[row]); });
    base::parallelFor(order.size(), [&](std::size_t task) {
        const std::uint32_t i = order[task];
        if (progress.isCancelled()) {
            return;
        }
        if (locations[shapes[i].row()] > 1) {
            meshes[i].polygons = model::discretise(document.shapes, shapes[i], how);
            return;
        }
        PunchedShape shape = punch(document.shapes, shapes[i], how);
        meshes[i].polygons = std::move(shape.polygons);
        meshes[i].holes = std::move(shape.holes);
        meshes[i].fields = std::move(shape.fields);
    });
    return meshes;
}

void triangulateShapes(std::vector<ShapeMesh>& meshes, const AreaTriangulator& how, base::Progress& progress) {
    if (how.onDevice) {
        triangulateOnDevice(meshes, how.onDevice, progress);
        return;
    }
    const std::vector<std::uint32_t> order =
        base::largestFirst(meshes.size(), [&](std::size_t i) { return meshes[i].polygons.points.size(); });
    std::size_t total = 1;
    for (const ShapeMesh& mesh : meshes) {
        total += mesh.polygons.points.size();
    }
    std::atomic<std::size_t> done{0};
    base::parallelFor(order.size(), [&](std::size_t i) {
        if (progress.isCancelled()) {
            return;
        }
        ShapeMesh& mesh = meshes[order[i]];
        const std::size_t size = mesh.polygons.points.size();
        triangulateShape(mesh, how.triangulator);
        progress.setFraction(static_cast<float>(done += size) / static_cast<float>(total));
    });
}

}  // namespace render
