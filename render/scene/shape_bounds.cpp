#include "render/scene/shape_bounds.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "model/base/parallel.h"
#include "render/modelling/edge_grid.h"

namespace render {

namespace {

float cross(glm::vec2 a, glm::vec2 b) {
    return a.x * b.y - a.y * b.x;
}

/// Of its triangles, mm².
double areaOf(const BoardModel& model, const AreaShape& piece) {
    double sum = 0.0;
    for (std::uint32_t i = piece.firstIndex; i < piece.firstIndex + 3 * piece.triangleCount; i += 3) {
        const auto corner = [&](std::uint32_t k) { return model.vertices[piece.firstVertex + model.indices[i + k]]; };
        sum += 0.5 * std::abs(cross(corner(1) - corner(0), corner(2) - corner(0)));
    }
    return sum;
}

/// Corner after corner of the outline it is asked whether that is convex, and one loop.
float strayOf(const BoardModel& model, const AreaShape& piece, const Box2& box) {
    const float everything = glm::distance(box.min, box.max);
    const glm::vec2 corners[] = {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
    std::array<float, 4> nearest{everything, everything, everything, everything};
    constexpr float kRounding = 1e-3F;
    double turned = 0.0;
    double enclosed = 0.0;
    for (std::uint32_t i = piece.firstWall; i < piece.firstWall + piece.wallCount; ++i) {
        const glm::vec2 from = model.vertices[i];
        const glm::vec2 to = model.vertices[model.next[i]];
        const glm::vec2 along = to - from;
        const glm::vec2 then = model.vertices[model.next[model.next[i]]] - to;
        if (model.next[i] == i || cross(along, then) < -kRounding * glm::length(along) * glm::length(then)) {
            return everything;
        }
        turned += std::atan2(cross(along, then), glm::dot(along, then));
        enclosed += 0.5 * cross(from - box.min, to - box.min);
        for (std::size_t corner = 0; corner < nearest.size(); ++corner) {
            nearest[corner] = std::min(nearest[corner], Edge{from, to}.distance(corners[corner]));
        }
    }
    const bool isConvex = piece.wallCount > 2 && turned < 3.0 * std::numbers::pi;
    const bool isCovered = std::abs(areaOf(model, piece) - enclosed) < 1e-3 * enclosed;
    return isConvex && isCovered ? std::ranges::max(nearest) : everything;
}

shader::ShapeBound boundOf(const BoardModel& model, const AreaShape& piece) {
    Box2 box;
    for (std::uint32_t i = piece.firstIndex; i < piece.firstIndex + 3 * piece.triangleCount; ++i) {
        box.include(model.vertices[piece.firstVertex + model.indices[i]]);
    }
    for (std::uint32_t i = piece.firstWall; i < piece.firstWall + piece.wallCount; ++i) {
        box.include(model.vertices[i]);
        box.include(model.vertices[model.next[i]]);
    }
    if (box.min.x > box.max.x) {
        return {};
    }
    return {0.5F * (box.min + box.max), 0.5F * (box.max - box.min), strayOf(model, piece, box)};
}

}  // namespace

std::vector<shader::ShapeBound> boundsOf(const BoardModel& model) {
    std::vector<shader::ShapeBound> bounds(model.shapes.size());
    base::parallelFor(bounds.size(), [&](std::size_t row) { bounds[row] = boundOf(model, model.shapes[row]); });
    return bounds;
}

}  // namespace render
