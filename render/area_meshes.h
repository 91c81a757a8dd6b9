#pragma once

#include <cstdint>
#include <vector>

#include "model/base/progress.h"
#include "model/document.h"
#include "model/geometry/discretise.h"

namespace render {

/// A discretised and triangulated shape in its own coordinates (nm).
struct ShapeMesh {
    model::PolygonSet polygons;
    std::vector<std::uint32_t> triangles;  ///< three indices into polygons.points each, counter-clockwise
    std::vector<std::uint32_t>
        next;  ///< per point, the end of its wall; itself where two contour edges cancel and no wall stands
    bool wasRepaired = false;  ///< crossed itself and went through integer booleans
    bool failed = false;       ///< could not be triangulated even then: nothing is drawn
};

/// Which shapes are in use, in rising order.
[[nodiscard]] std::vector<model::ShapeId> shapesInUse(const model::Document& document);

/// Curves to chords, one shape per task (Table 4, "discretise").
[[nodiscard]] std::vector<ShapeMesh> discretiseShapes(const model::Document& document,
                                                      const std::vector<model::ShapeId>& shapes,
                                                      const model::Discretisation& how, base::Progress& progress);

/// Triangulates polygon `row` of the set and appends indices into `set.points`; false if it crosses itself or another
/// loop of its own: then nothing is appended.
[[nodiscard]] bool triangulatePolygon(const model::PolygonSet& set, std::size_t row,
                                      std::vector<std::uint32_t>& triangles);

/// Per point of the set, the end of the wall that starts there (ShapeMesh::next).
[[nodiscard]] std::vector<std::uint32_t> findWalls(const model::PolygonSet& set);

/// Triangulates and finds the walls, one shape per task, largest first (Table 4, "triangulate").
void triangulateShapes(std::vector<ShapeMesh>& meshes, base::Progress& progress);

}  // namespace render
