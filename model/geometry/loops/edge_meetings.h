#pragma once

#include <array>

#include "model/geometry/edges.h"

namespace model {

/// The points where two middle lines cross or touch, at most two; without allocations.
struct Meetings {
    std::array<PointD, 2> at;
    int count = 0;

    void add(PointD p) {
        if (count < 2) {
            at[static_cast<std::size_t>(count++)] = p;
        }
    }
};

/// Lines cross only where each passes strictly from one side of the other to its other side, so ends that touch are not
/// found; nor are runs of lines or of arcs of one circle (centres within 1e-3 nm) that cover each other. Errors are
/// below 1e-3 nm but where a line or circle nearly touches a circle of radius r: there the square root of 1e-6 nm times
/// r.
[[nodiscard]] Meetings meetingsOf(const Edge& a, const Edge& b);

/// From a point to the nearest one of an edge.
[[nodiscard]] double distanceTo(const Edge& edge, PointD p);

}  // namespace model
