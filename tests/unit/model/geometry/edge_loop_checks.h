#pragma once

#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "model/geometry/discretise.h"
#include "model/geometry/loops/edge_loops.h"
#include "model/geometry/vectors.h"

/// What tests say about regions of exact edges.
namespace edge_loop_checks {

/// Corners of arcs every so many nanometres of distance to their chord.
inline std::vector<model::Point> pointsOf(std::span<const model::Edge> loop, double chordNm) {
    std::vector<model::Point> points;
    for (const model::Edge& edge : loop) {
        const double full = model::lengthOf(edge);
        const double step = edge.isArc() ? std::sqrt(8 * edge.radius * chordNm) : full;
        const int count = std::max(edge.isFullCircle() ? 8 : 1, static_cast<int>(std::ceil(full / step)));
        for (int i = 0; i < count; ++i) {
            const model::PointD p = model::pointAt(edge, full * i / count);
            points.push_back({model::toNm(p.x), model::toNm(p.y)});
        }
    }
    return points;
}

inline model::PolygonSet polygonsOf(const model::EdgeLoops& loops, double chordNm) {
    model::PolygonSet set;
    set.beginPolygon();
    for (std::size_t i = 0; i < loops.loopCount(); ++i) {
        set.addLoop(pointsOf(loops.loop(i), chordNm));
    }
    return set;
}

inline double areaOf(const model::PolygonSet& set) {
    return static_cast<double>(model::twiceArea(set)) / 2;
}

inline double lengthOf(const model::EdgeLoops& loops) {
    double sum = 0.0;
    for (const model::Edge& edge : loops.edges) {
        sum += model::lengthOf(edge);
    }
    return sum;
}

/// Every edge begins where the one before it ends, bit for bit.
inline bool areClosed(const model::EdgeLoops& loops) {
    for (std::size_t i = 0; i < loops.loopCount(); ++i) {
        const auto loop = loops.loop(i);
        for (std::size_t k = 0; k < loop.size(); ++k) {
            if (loop.empty() || loop[k].b != loop[(k + 1) % loop.size()].a) {
                return false;
            }
        }
    }
    return loops.loopStart.back() == loops.edges.size();
}

/// Both ends of arcs lie on their circle but for the rounding of doubles.
inline bool areTrueCircles(const model::EdgeLoops& loops) {
    for (const model::Edge& edge : loops.edges) {
        if (edge.isArc() && (std::abs(model::distance(edge.a, edge.centre) - edge.radius) > 1e-5 ||
                             std::abs(model::distance(edge.b, edge.centre) - edge.radius) > 1e-5)) {
            return false;
        }
    }
    return true;
}

/// The first loop winds counter-clockwise, all others clockwise.
inline bool windAsTheyMust(const model::EdgeLoops& loops) {
    for (std::size_t i = 0; i < loops.loopCount(); ++i) {
        double area = 0.0;
        for (const model::Edge& edge : loops.loop(i)) {
            area += model::areaUnder(edge, loops.loop(i).front().a);
            if (edge.isHole != (i > 0) || edge.winding != (i > 0 ? -1 : 1)) {
                return false;
            }
        }
        if ((area > 0) != (i == 0)) {
            return false;
        }
    }
    return true;
}

inline bool areSound(const model::EdgeLoops& loops) {
    return areClosed(loops) && areTrueCircles(loops) && windAsTheyMust(loops);
}

/// |a - b| as a part of b.
inline double relative(double a, double b) {
    return std::abs(a - b) / std::abs(b);
}

inline constexpr double kPi = std::numbers::pi;

}  // namespace edge_loop_checks
