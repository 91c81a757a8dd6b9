#include "model/design_rules/bridged.h"

#include "model/figures/distance.h"

namespace model {

bool isBridged(const LayerGeometry& geometry, const Spacing& spacing,
               const std::function<bool(std::uint32_t)>& isWanted) {
    return isCovered(geometry, {(spacing.from.x + spacing.to.x) / 2, (spacing.from.y + spacing.to.y) / 2}, isWanted);
}

bool isCovered(const LayerGeometry& geometry, PointD point, const std::function<bool(std::uint32_t)>& isWanted) {
    FigureTable dot;
    dot.addTrack(point, point, 0.0);
    bool isCovered = false;
    geometry.visitNear(dot.box(0), 0.0, [&](std::uint32_t row) {
        isCovered =
            isCovered || (isWanted(row) && spacingBetween(dot, 0, geometry.figures(), row, kTouchNm).has_value());
    });
    return isCovered;
}

}  // namespace model
