#pragma once

#include <algorithm>
#include <cstdint>
#include <glm/glm.hpp>

#include "render/tiles/sample_scan.h"

/// What tells which samples of a row lie beside a straight edge, as a rasteriser of Vulkan does.
namespace render {

inline constexpr int kStepsPerPixel = 256;  ///< corners are moved to the nearest of them

/// A corner in steps.
struct Corner {
    std::int64_t x = 0;
    std::int64_t y = 0;

    static Corner near(glm::dvec2 pixels) {
        const auto toStep = [](double x) {
            return static_cast<std::int64_t>(x * kStepsPerPixel + (x < 0.0 ? -0.5 : 0.5));
        };
        return {toStep(pixels.x), toStep(pixels.y)};
    }
};

/// The first row of samples of a tile that is not above `y` (steps).
[[nodiscard]] inline int firstRow(std::int64_t y) {
    constexpr std::int64_t kRows = std::int64_t{kRowsPerPixel} * kTilePixels;
    constexpr std::int64_t kSteps = kStepsPerPixel / kRowsPerPixel;
    return static_cast<int>(std::clamp((y + kSteps / 2 - 1) / kSteps, std::int64_t{0}, kRows));
}

/// The height of a row of samples, pixels.
[[nodiscard]] inline double heightOf(int row) {
    return (row + 0.5) / kRowsPerPixel;
}

/// The first column, or one beside the tile, that is not left of `x`. Library calls would cost more than all else of a
/// small shape.
[[nodiscard]] inline int ceilColumn(double x) {
    const double clamped = std::clamp(x, -1.0, kTilePixels + 1.0);
    const int whole = static_cast<int>(clamped);
    return whole + (clamped > whole ? 1 : 0);
}

/// An edge from its upper end down; y from `top` to before `bottom`, pixels.
struct SampleEdge {
    double top = 0.0;
    double bottom = 0.0;
    double x = 0.0;  ///< of its upper end
    double slope = 0.0;

    /// `from` and `to` are not equally high.
    static SampleEdge between(Corner from, Corner to) {
        if (from.y > to.y) {
            std::swap(from, to);
        }
        constexpr double kSteps = kStepsPerPixel;
        return {static_cast<double>(from.y) / kSteps, static_cast<double>(to.y) / kSteps,
                static_cast<double>(from.x) / kSteps,
                static_cast<double>(to.x - from.x) / static_cast<double>(to.y - from.y)};
    }
    /// The first column whose sample, `place` from its left, is not left of the edge at this height.
    [[nodiscard]] int column(double y, double place) const { return ceilColumn(x + (y - top) * slope - place); }
};

}  // namespace render
