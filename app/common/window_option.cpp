#include "app/common/window_option.h"

#include <algorithm>
#include <cmath>

#include "model/text/formatting.h"

namespace app {

using base::Box;
using base::Nm;
using base::Point;

base::Result<Box> boxOfWindow(const std::vector<double>& corners) {
    const auto nm = [](double mm) { return static_cast<Nm>(std::llround(mm * base::kNmPerMm)); };
    const double largest = std::abs(*std::ranges::max_element(corners, {}, [](double mm) { return std::abs(mm); }));
    if (largest * base::kNmPerMm > base::kMaxCoordinate) {
        return base::Error{base::ErrorCode::BadUsage, "--window is larger than a board can be"};
    }
    Box window;
    window.include(Point{nm(corners[0]), nm(corners[1])});
    window.include(Point{nm(corners[2]), nm(corners[3])});
    if (window.width() == 0 || window.height() == 0) {
        return base::Error{base::ErrorCode::BadUsage, "--window is empty"};
    }
    return window;
}

base::Status checkMeets(const Box& window, const Box& extent) {
    if (extent.isEmpty() || window.meets(extent)) {
        return base::Done{};
    }
    const auto mm = [](Nm length) { return model::formatted("%.6g", base::toMm(length)); };
    return base::Error{base::ErrorCode::BadUsage, "--window lies beside the board, all of which is within " +
                                                      mm(extent.min.x) + ',' + mm(extent.min.y) + ',' +
                                                      mm(extent.max.x) + ',' + mm(extent.max.y)};
}

}  // namespace app
