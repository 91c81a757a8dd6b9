#pragma once

#include <cstdint>
#include <vector>

#include "model/base/progress.h"
#include "model/board/document.h"
#include "model/geometry/discretise.h"
#include "render/modelling/round_holes.h"
#include "tri/triangulate.h"

namespace render {

/// A discretised and triangulated shape in its own coordinates (nm).
struct ShapeMesh {
    model::PolygonSet polygons;
    std::vector<RoundHole> holes;          ///< what lets fill in
    std::vector<model::Box> fields;        ///< where; `polygons` has them as loops, which get no walls
    std::vector<std::uint32_t> triangles;  ///< three indices into polygons.points each, counter-clockwise
    std::vector<std::uint32_t>
        next;  ///< per point, the end of its wall; itself where two contour edges cancel and there is no wall
    bool wasRepaired = false;  ///< crossed itself and went through integer booleans
    bool failed = false;       ///< could not be triangulated even then: nothing is drawn
};

/// Which shapes are in use, in rising order.
[[nodiscard]] std::vector<model::ShapeId> shapesInUse(const model::Document& document);

/// Curves to chords, one shape per task (Table 4, "discretise"), with the round holes of shapes that are placed once
/// left to lets. Triangles of a shape that is placed more than once are shared, lets would not be. Bodies of components
/// keep their holes, too.
[[nodiscard]] std::vector<ShapeMesh> punchShapes(const model::Document& document,
                                                 const std::vector<model::ShapeId>& shapes,
                                                 const model::Discretisation& how, base::Progress& progress);

/// Triangulates polygon `row` of the set and appends indices into `set.points`; false if it crosses itself or another
/// loop of its own: then nothing is appended.
[[nodiscard]] bool triangulatePolygon(const model::PolygonSet& set, std::size_t row,
                                      std::vector<std::uint32_t>& triangles,
                                      tri::Triangulator triangulator = tri::Triangulator::Auto);

/// Per point of the set, the end of the wall that starts there (ShapeMesh::next).
[[nodiscard]] std::vector<std::uint32_t> findWalls(const model::PolygonSet& set);

/// Who triangulates: `onDevice` all shapes at once if it is there, else `triangulator` one shape per task, the largest
/// first. The triangles are the same.
struct AreaTriangulator {
    tri::Triangulator triangulator = tri::Triangulator::Auto;
    tri::BatchTriangulator onDevice;
};

/// Triangulates and finds the walls (Table 4, "triangulate"). What crosses itself goes through integer booleans and is
/// tried again, on the CPU.
void triangulateShapes(std::vector<ShapeMesh>& meshes, const AreaTriangulator& how, base::Progress& progress);

/// Polygon `row` of the set as tri/ takes it: `visit(first point, polygon)`.
template <class Visit>
void visitPolygon(const model::PolygonSet& set, std::size_t row, const Visit& visit) {
    const model::PolygonSet::Polygon& polygon = set.polygons[row];
    const std::uint32_t first = set.loopStart[polygon.firstLoop];
    std::vector<std::uint32_t> loopStart;
    for (std::uint32_t i = 0; i <= polygon.loopCount; ++i) {
        loopStart.push_back(set.loopStart[polygon.firstLoop + i] - first);
    }
    visit(first, tri::Polygon{std::span(set.points).subspan(first, loopStart.back()), loopStart});
}

/// All of them.
template <class Visit>
void forEachPolygon(const model::PolygonSet& set, const Visit& visit) {
    for (std::size_t row = 0; row < set.polygons.size(); ++row) {
        visitPolygon(set, row, visit);
    }
}

}  // namespace render
