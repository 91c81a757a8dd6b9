#pragma once

#include <cstdint>
#include <glm/glm.hpp>
#include <span>
#include <vector>

namespace render {

/// Lower and upper face of a layer, mm.
struct ZRange {
    float z0 = 0.0F;
    float z1 = 0.0F;
    bool operator==(const ZRange&) const = default;
};

/// One layer before explosion.
struct StackedLayer {
    ZRange z;
    bool isVisible = true;
    bool isBarrels = false;  ///< holds tracks and discs only: what it spans, it runs through (drill layers)
};

/// Moves the visible layers apart so that the whole stackup grows by `spread` mm. Layers at one height stay together,
/// order and thickness remain. A layer of barrels that spans others is stretched with them; the substrate, which spans
/// the inner layers, stays one part among them.
[[nodiscard]] std::vector<ZRange> explode(std::span<const StackedLayer> layers, float spread);

/// By how much the stackup of a board grows when ViewSettings::explode is 1, as a part of the board's larger side.
inline constexpr float kFullSpread = 0.5F;

struct Box3 {
    glm::vec3 min;
    glm::vec3 max;
};

/// A board's box (BoardModel::boxMin and boxMax, mm) grown for ViewSettings::explode: what a camera must see.
[[nodiscard]] Box3 explodedBox(const Box3& board, float explode);

}  // namespace render
