#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace render {

/// Lower and upper face of a layer, mm.
struct ZRange {
    float z0 = 0.0F;
    float z1 = 0.0F;
};

/// One layer before explosion.
struct StackedLayer {
    ZRange z;
    bool isVisible = true;
    bool isBarrels = false;  ///< holds strokes and discs only: what it spans, it runs through (drill layers)
};

/// Moves the visible layers apart so that the whole stack grows by `spread` mm. Layers at one height stay together,
/// order and thickness remain. A layer of barrels that spans others is stretched with them; the laminate, which spans
/// the inner layers, stays one slab among them.
[[nodiscard]] std::vector<ZRange> explode(std::span<const StackedLayer> layers, float spread);

}  // namespace render
