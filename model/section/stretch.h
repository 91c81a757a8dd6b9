#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "model/board/local_stack.h"
#include "model/section/layer_ranges.h"
#include "model/section/section_piece.h"

namespace model {

/// A part of a line all along which the same layers are: on rigid-flex boards a zone, or what layers with outlines of
/// their own make; else all of the line.
struct Stretch {
    double from = 0.0;
    double to = 0.0;
    LocalStack stack;
    std::vector<BoardFace> faces;  ///< top, bottom; fewer where nothing is
    std::vector<DielectricBand> bands;
    std::optional<ZRange> core;  ///< from the lowest to the highest face; none: as the layers are
    bool isBounded = false;      ///< layers may be missing
};

/// Between two locations of a line, from one to the other, without a break. `whole` are the faces where all layers are;
/// those of a solid (SectionRequest::isAsSolid) are the same everywhere.
[[nodiscard]] std::vector<Stretch> stretchesBetween(const Document& board, double from, double to,
                                                    const LayerRanges& ranges, const std::vector<BoardFace>& whole,
                                                    bool isAsSolid);

/// The part of a level piece between two locations.
[[nodiscard]] std::optional<SectionPiece> alongPart(SectionPiece piece, double from, double to);
/// Pieces that were cut where nothing changes become one again.
void joinAlong(std::vector<SectionPiece>& pieces);
/// Lets holes reach no farther than what is there.
void fitHoles(const std::vector<Stretch>& stretches, std::vector<SectionPiece>& pieces,
              const std::function<bool(const SectionPiece&)>& isHole);

}  // namespace model
