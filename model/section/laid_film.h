#pragma once

#include <vector>

#include "model/section/mask_shape.h"

/// Films and plates on a board: coverlay, adhesive and stiffener. Jobs say where and how thick they are; how they lie
/// is assumed: level outside, and what is glued fills the space beside copper.
namespace model {

/// What was laid on a face so far: where, and how high it is.
struct LaidPart {
    Interval where;
    Nm outer = 0;
};

struct LaidFilm {
    std::vector<SectionPiece> pieces;
    LaidPart part;
};

/// A film of a face as it lies there, `piece` being where its layer is: level, as thick as stated over copper or over
/// what was laid before. Films that flow fill what lies lower under them (`raised`: where it does not); plates do not.
[[nodiscard]] LaidFilm filmOver(const BoardFace& face, const SectionPiece& piece, Nm thickness, bool flows,
                                const Intervals& raised, const std::vector<LaidPart>& laid);

/// What a mask is of what was laid: lower beside copper.
[[nodiscard]] std::vector<LaidPart> laidMask(const BoardFace& face, const Intervals& masked, const Intervals& raised);

}  // namespace model
