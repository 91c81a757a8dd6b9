#pragma once

#include <glm/glm.hpp>

#include "model/base/point.h"
#include "model/base/units.h"

namespace ui {

/// Between nanometres of the job and millimetres of the board model, whose origin is in the middle of the board.
struct BoardPosition {
    base::Point origin;

    [[nodiscard]] base::PointD toJob(const glm::vec3& mm) const {
        return {static_cast<double>(mm.x) * base::kNmPerMm + origin.x,
                static_cast<double>(mm.y) * base::kNmPerMm + origin.y};
    }
    [[nodiscard]] glm::vec3 toModel(base::PointD nm, double z = 0.0) const {
        return {static_cast<float>((nm.x - origin.x) / base::kNmPerMm),
                static_cast<float>((nm.y - origin.y) / base::kNmPerMm), static_cast<float>(z / base::kNmPerMm)};
    }
};

}  // namespace ui
