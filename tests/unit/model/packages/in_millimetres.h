#pragma once

#include <cmath>

#include "model/base/point.h"

/// Lengths and boxes as data sheets state them.
namespace packages {

inline base::Nm mm(double value) {
    return static_cast<base::Nm>(std::lround(value * 1e6));
}

/// Around a middle.
inline base::Box boxAt(double x, double y, double width, double height) {
    return {{mm(x - width / 2), mm(y - height / 2)}, {mm(x + width / 2), mm(y + height / 2)}};
}

}  // namespace packages
