#pragma once

#include <cmath>
#include <numbers>
#include <random>

#include "model/geometry/nurbs.h"

/// NURBS curves for tests.
namespace model::testing {

/// A full circle as nine control points of degree 2, counter-clockwise from the right.
inline Nurbs circleCurve(PointD centre, double radius) {
    constexpr int kDx[] = {1, 1, 0, -1, -1, -1, 0, 1, 1};
    constexpr int kDy[] = {0, 1, 1, 1, 0, -1, -1, -1, 0};
    Nurbs circle{2, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}, {}};
    for (int i = 0; i < 9; ++i) {
        circle.controls.push_back(
            {{centre.x + kDx[i] * radius, centre.y + kDy[i] * radius}, i % 2 == 0 ? 1.0 : std::numbers::sqrt2 / 2});
    }
    return circle;
}

/// A clamped curve of random control points in a square of `size` nm around 0, 0; weights from 0.2 to 5.
inline Nurbs randomCurve(std::mt19937_64& random, int degree, int controls, double size) {
    const auto number = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
    Nurbs curve{degree, {}, {}};
    for (int i = 0; i < controls; ++i) {
        curve.controls.push_back(
            {{number(-size / 2, size / 2), number(-size / 2, size / 2)}, std::exp(number(-1.6, 1.6))});
    }
    curve.knots.assign(static_cast<std::size_t>(degree) + 1, 0.0);
    double knot = 0.0;
    for (int i = degree + 1; i < controls; ++i) {
        knot += number(0.1, 1.0);
        curve.knots.push_back(knot);
    }
    curve.knots.insert(curve.knots.end(), static_cast<std::size_t>(degree) + 1, knot + 0.5);
    return curve;
}

/// Points at equal steps of the parameter, both ends among them.
inline std::vector<PointD> samplesOf(const Nurbs& curve, int count) {
    const NurbsView view = curve.view();
    std::vector<PointD> samples;
    for (int i = 0; i < count; ++i) {
        samples.push_back(pointOn(view, view.from() + (view.to() - view.from()) * i / (count - 1)));
    }
    return samples;
}

}  // namespace model::testing
