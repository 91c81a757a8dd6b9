#pragma once

#include <vector>

#include "model/section/intervals.h"
#include "model/section/section_piece.h"

/// Solder mask as it flows over copper, and what is printed on it. Jobs draw where a mask is and say how thick it is at
/// most: its shape is assumed.
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

/// The mask of a face: `piece` is where its layer draws it, `raised` where copper or a hole that is tented lies under
/// it. Beside what is raised the mask falls in shoulders as wide as it is thick, or as there is room.
[[nodiscard]] std::vector<SectionPiece> maskOver(const BoardFace& face, const SectionPiece& piece,
                                                 const Intervals& raised);

/// Ink on a face: on the mask (`masked`) or without it on what is raised, and on the substrate. Not on shoulders.
[[nodiscard]] std::vector<SectionPiece> inkOver(const BoardFace& face, const SectionPiece& piece,
                                                const Intervals& raised, const Intervals& masked);

}  // namespace model
