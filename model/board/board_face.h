#pragma once

#include "model/board/document.h"

namespace model {

/// On copper a mask is so much of its thickness thick (IPC-SM-840 prints: 20 to 30 µm beside, 8 to 15 µm on tracks).
inline constexpr double kMaskOnCopper = 0.5;

/// One side of a board: where the surface is that a mask flows over. Heights are counted outwards, so that both sides
/// are alike: z = face + sign * height.
struct BoardFace {
    Nm substrate = 0;  ///< where outer copper lies on the substrate
    Nm copper = 0;     ///< outer face of that copper
    Nm mask = 0;       ///< thickness of the mask; 0: none
    LayerId maskLayer;
    bool isTop = true;
    bool isFlat = false;  ///< a plate over a level surface, as the 3D view draws it

    [[nodiscard]] Nm outwards() const { return isTop ? 1 : -1; }
    /// Outer face of the mask beside copper, and on it.
    [[nodiscard]] Nm besideCopper() const;
    [[nodiscard]] Nm onCopper() const;
};

}  // namespace model
