#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <vector>

namespace render {

struct BoardModel;

/// Where a map lies: square cells, row by row from the lower left.
struct ShadowGrid {
    glm::vec2 origin{0.0F};  ///< lower left corner, mm
    float cellMm = 1.0F;
    std::uint32_t width = 1;  ///< cells
    std::uint32_t height = 1;
};

/// How dark the bodies of one side make the board beneath and around them: 1 under a body, falling to 0 at its reach,
/// of several bodies the darkest. Each cell has its four corners, so that a shader reads one word to interpolate.
/// Corners on the rim are 0: so is everything beyond it.
struct ShadowMap : ShadowGrid {
    /// 255 times the darkness of a corner, a byte each: lower left, lower right, upper left and upper right from the
    /// lowest byte on.
    std::vector<std::uint32_t> cells{0};

    [[nodiscard]] bool isEmpty() const { return cells.size() == 1; }  ///< nothing is dark
};

/// Contact shadows of the bodies of components (decision 129).
struct BodyShadows {
    ShadowMap top;
    ShadowMap bottom;

    [[nodiscard]] bool isEmpty() const { return top.isEmpty() && bottom.isEmpty(); }
};

/// Cells along the longer side of a map; fewer where they would be finer than kFinestShadowCell, mm.
inline constexpr std::uint32_t kMostShadowCells = 1024;
inline constexpr float kFinestShadowCell = 0.1F;

/// How far from a body's outline the board is darker, mm: nine tenths of its height within these limits, and two cells
/// at least.
inline constexpr float kShortestShadow = 0.4F;
inline constexpr float kLongestShadow = 3.0F;

/// From everything on layers of bodies that stands on the board and has walls, as far as the board reaches. `model` has
/// its box, instances, vertices and walls, and is not cut into pieces. The same with 1 and N threads.
[[nodiscard]] BodyShadows castShadows(const BoardModel& model);

}  // namespace render
