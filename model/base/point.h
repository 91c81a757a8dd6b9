#pragma once

#include <algorithm>
#include <compare>
#include <cstdint>
#include <limits>

#include "model/base/units.h"

namespace base {

/// A point on the integer grid of 1 nm.
struct Point {
    Nm x = 0;
    Nm y = 0;
    constexpr auto operator<=>(const Point&) const = default;
};

/// A derived point or vector in nanometres.
struct PointD {
    double x = 0.0;
    double y = 0.0;
    constexpr bool operator==(const PointD&) const = default;
};

constexpr PointD toDouble(Point p) {
    return {static_cast<double>(p.x), static_cast<double>(p.y)};
}

/// An axis-parallel box with both corners inside; a default-made one is empty and grows by `include`.
struct Box {
    Point min{std::numeric_limits<Nm>::max(), std::numeric_limits<Nm>::max()};
    Point max{std::numeric_limits<Nm>::min(), std::numeric_limits<Nm>::min()};

    [[nodiscard]] constexpr bool isEmpty() const { return min.x > max.x || min.y > max.y; }
    [[nodiscard]] constexpr std::int64_t width() const { return isEmpty() ? 0 : std::int64_t{max.x} - min.x; }
    [[nodiscard]] constexpr std::int64_t height() const { return isEmpty() ? 0 : std::int64_t{max.y} - min.y; }
    constexpr void include(Point p) {
        min = {std::min(min.x, p.x), std::min(min.y, p.y)};
        max = {std::max(max.x, p.x), std::max(max.y, p.y)};
    }
    constexpr void include(const Box& other) {
        if (!other.isEmpty()) {
            include(other.min);
            include(other.max);
        }
    }
    [[nodiscard]] constexpr bool holds(Point p) const {
        return min.x <= p.x && p.x <= max.x && min.y <= p.y && p.y <= max.y;
    }
    /// Have they a point in common? Touching boxes do.
    [[nodiscard]] constexpr bool meets(const Box& other) const {
        return min.x <= other.max.x && other.min.x <= max.x && min.y <= other.max.y && other.min.y <= max.y;
    }
    /// Not to be asked of an empty one.
    [[nodiscard]] constexpr Point middle() const {
        return {static_cast<Nm>((std::int64_t{min.x} + max.x) / 2), static_cast<Nm>((std::int64_t{min.y} + max.y) / 2)};
    }
    [[nodiscard]] constexpr Box grownBy(Nm margin) const {
        return isEmpty() ? *this : Box{{min.x - margin, min.y - margin}, {max.x + margin, max.y + margin}};
    }
    constexpr bool operator==(const Box&) const = default;
};

}  // namespace base
