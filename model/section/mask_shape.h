#pragma once

#include <vector>

#include "model/board/board_face.h"
#include "model/section/intervals.h"
#include "model/section/section_piece.h"

/// Solder mask as it flows over copper, and what is printed on it. Jobs draw where a mask is and say how thick it is at
/// most: its shape is assumed.
namespace model {

/// The mask of a face: `piece` is where its layer draws it, `raised` where copper or a hole that is tented lies under
/// it. Beside what is raised the mask falls in shoulders as wide as it is thick, or as there is room.
[[nodiscard]] std::vector<SectionPiece> maskOver(const BoardFace& face, const SectionPiece& piece,
                                                 const Intervals& raised);

/// Ink on a face: on the mask (`masked`) or without it on what is raised, and on the substrate. Not on shoulders.
[[nodiscard]] std::vector<SectionPiece> inkOver(const BoardFace& face, const SectionPiece& piece,
                                                const Intervals& raised, const Intervals& masked);

}  // namespace model
