#pragma once

#include <span>
#include <vector>

#include "model/base/point.h"
#include "model/geometry/bezier.h"

/// Polynomials over 0 to 1 by their Bernstein coefficients: their values lie between the least and the largest of
/// these, and they change sign no more often than these do.
namespace model {

/// How far the points of a curve lie beside a line through `origin` with direction `unit`, left positive, times the
/// curve's weight there: a polynomial of the curve's degree.
[[nodiscard]] std::vector<double> besideLine(const Bezier& curve, PointD origin, PointD unit);

/// The squared distance of the curve's points from `centre` less the squared radius, times the square of the curve's
/// weight there: a polynomial of twice the curve's degree.
[[nodiscard]] std::vector<double> besideCircle(const Bezier& curve, PointD centre, double radius);

/// A stretch of 0 to 1.
struct Stretch {
    double from = 0.0;
    double to = 0.0;
};
/// Where the polynomial has a root, or all values are at most `tolerance`; rising, stretches that meet united.
[[nodiscard]] std::vector<Stretch> rootsOf(std::vector<double> coefficients, double tolerance);

}  // namespace model
