#pragma once

#include <span>
#include <vector>

#include "render/modelling/board_frame.h"
#include "render/scene/explosion.h"

namespace render {

/// How many times as thick as it is everything is drawn.
struct ZScale {
    float copper = 1.0F;
    float dielectric = 1.0F;  ///< and all that is no copper: substrate, solder mask, print
    bool operator==(const ZScale&) const = default;
};

/// Stretches heights so that whatever a copper layer covers grows by one factor and everything else by the other. z = 0
/// stays, order and touching faces remain.
[[nodiscard]] std::vector<ZRange> scaleHeights(std::span<const FrameLayer> layers, const ZScale& scale);

/// A board's box (BoardFrame::boxMin and boxMax) as it is drawn.
[[nodiscard]] Box3 scaledBox(const BoardFrame& board, const ZScale& scale);

}  // namespace render
