#pragma once

#include "model/geometry/loops/edge_loops.h"

/// What tests make regions of exact edges from; all in mm.
namespace loop_shapes {

inline constexpr double kNmPerMm = 1e6;

inline void addRectangle(model::EdgeLoops& loops, double left, double bottom, double right, double top) {
    const model::PointD corners[] = {{left, bottom}, {right, bottom}, {right, top}, {left, top}};
    for (int i = 0; i < 4; ++i) {
        const model::PointD a = corners[i];
        const model::PointD b = corners[(i + 1) % 4];
        loops.addLine({a.x * kNmPerMm, a.y * kNmPerMm}, {b.x * kNmPerMm, b.y * kNmPerMm});
    }
    loops.endLoop();
}

[[nodiscard]] inline model::EdgeLoops rectangle(double left, double bottom, double right, double top) {
    model::EdgeLoops loops;
    addRectangle(loops, left, bottom, right, top);
    return loops;
}

[[nodiscard]] inline model::EdgeLoops disc(double x, double y, double radius) {
    model::EdgeLoops loops;
    loops.addCircle({x * kNmPerMm, y * kNmPerMm}, radius * kNmPerMm);
    return loops;
}

}  // namespace loop_shapes
