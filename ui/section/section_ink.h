#pragma once

#include <QColor>

namespace ui {

/// What places sections in the views: the line in 2D, the arrow of the plane in 3D.
inline constexpr QColor kSectionInk(255, 120, 200);
inline constexpr QColor kSectionRim(20, 20, 24, 200);

}  // namespace ui
