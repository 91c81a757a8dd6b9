#pragma once

#include <algorithm>
#include <cmath>

#include "model/geometry/shapes.h"

/// Vectors in the plane.
namespace model {

constexpr PointD minus(PointD a, PointD b) {
    return {a.x - b.x, a.y - b.y};
}

constexpr double cross(PointD a, PointD b) {
    return a.x * b.y - a.y * b.x;
}

constexpr double dot(PointD a, PointD b) {
    return a.x * b.x + a.y * b.y;
}

/// Coordinates are far from where squares overflow, so the slow std::hypot is not needed.
inline double length(PointD v) {
    return std::sqrt(dot(v, v));
}

inline double distance(PointD a, PointD b) {
    return std::hypot(a.x - b.x, a.y - b.y);
}

inline double distance(Point a, Point b) {
    return distance(toDouble(a), toDouble(b));
}

inline Nm toNm(double value) {
    return static_cast<Nm>(std::llround(value));
}

/// All within `reach` of a location, as far as coordinates go.
inline Box boxAround(PointD location, double reach) {
    const auto nm = [](double v) {
        return static_cast<Nm>(std::clamp<double>(v, -base::kMaxCoordinate, base::kMaxCoordinate));
    };
    return {{nm(std::floor(location.x - reach)), nm(std::floor(location.y - reach))},
            {nm(std::ceil(location.x + reach)), nm(std::ceil(location.y + reach))}};
}

}  // namespace model
