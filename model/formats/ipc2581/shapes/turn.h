#pragma once

#include "model/geometry/shapes.h"

namespace model::ipc2581 {

/// How something lies in what holds it: p' = origin + Mₓᵐ · R_ccw(angle) · (scale · p) — scaled, rotated
/// counter-clockwise, then mirrored x → −x, as Location and Xform say together (decision 163). Nanometres.
struct Turn {
    PointD origin;
    double ccwDeg = 0.0;
    bool isMirrored = false;
    double scale = 1.0;

    [[nodiscard]] PointD apply(PointD p) const;
    /// The turn that first does `inner`, then this one.
    [[nodiscard]] Turn after(const Turn& inner) const;
    /// Does nothing but move?
    [[nodiscard]] bool isPlain() const { return ccwDeg == 0.0 && !isMirrored && scale == 1.0; }
};

/// Of an angle in degrees, exact for multiples of 90.
struct SineCosine {
    double sine = 0.0;
    double cosine = 1.0;
};
[[nodiscard]] SineCosine sineCosineOf(double degrees);

/// 0 to 360.
[[nodiscard]] double normalDegrees(double degrees);

}  // namespace model::ipc2581
