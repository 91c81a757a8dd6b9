#pragma once

#include <algorithm>

#include "model/base/point.h"

namespace model::formats {

/// A point of a file that counts from another origin. Where that would be beyond the largest coordinate, it stays
/// there.
[[nodiscard]] constexpr base::Point moved(base::Point p, base::Point shift) {
    const auto sum = [](std::int64_t a, std::int64_t b) {
        return static_cast<base::Nm>(std::clamp<std::int64_t>(a + b, -base::kMaxCoordinate, base::kMaxCoordinate));
    };
    return {sum(p.x, shift.x), sum(p.y, shift.y)};
}

}  // namespace model::formats
