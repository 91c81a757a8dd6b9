#include "model/formats/ipc2581/shapes/turn.h"

#include <cmath>
#include <numbers>

namespace model::ipc2581 {

double normalDegrees(double degrees) {
    const double rest = std::fmod(degrees, 360.0);
    return rest < 0.0 ? rest + 360.0 : rest + 0.0;
}

SineCosine sineCosineOf(double degrees) {
    const double angle = normalDegrees(degrees);
    if (angle == 0.0) {
        return {0.0, 1.0};
    }
    if (angle == 90.0) {
        return {1.0, 0.0};
    }
    if (angle == 180.0) {
        return {0.0, -1.0};
    }
    if (angle == 270.0) {
        return {-1.0, 0.0};
    }
    const double radians = angle * std::numbers::pi / 180.0;
    return {std::sin(radians), std::cos(radians)};
}

PointD Turn::apply(PointD p) const {
    if (isPlain()) {
        return {origin.x + p.x, origin.y + p.y};
    }
    const auto [sine, cosine] = sineCosineOf(ccwDeg);
    const double x = scale * (cosine * p.x - sine * p.y);
    const double y = scale * (sine * p.x + cosine * p.y);
    return {origin.x + (isMirrored ? -x : x), origin.y + y};
}

Turn Turn::after(const Turn& inner) const {
    // R(a) · M = M · R(−a), so a mirrored inner turn is rotated the other way round by this one.
    return {apply(inner.origin), normalDegrees(inner.isMirrored ? inner.ccwDeg - ccwDeg : inner.ccwDeg + ccwDeg),
            isMirrored != inner.isMirrored, scale * inner.scale};
}

}  // namespace model::ipc2581
