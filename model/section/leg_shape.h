#pragma once

#include <map>
#include <vector>

#include "model/section/landing_via.h"
#include "model/section/mask_shape.h"

namespace model {

/// A component as a line cuts it, with heights from the face it stands on (partPieces).
struct StandingPart {
    bool isTop = true;
    std::vector<SectionPiece> pieces;
};

/// What was met on one straight part of a line. Locations are those along all of the line.
struct LegCut {
    double from = 0.0;
    double to = 0.0;
    std::vector<SectionPiece> pieces;  ///< as the layers have them, holes taken out
    std::vector<SectionPiece> bores;
    std::vector<std::pair<LandingVia, SectionPiece>> vias;  ///< and a piece like their plating
    std::vector<StandingPart> parts;
};

/// Makes of what the layers of a board draw what is found when the board is cut: dielectrics by material, laser vias
/// that land, mask that flows over copper, parts that stand on the board.
class LegShaper {
public:
    /// `isAsSolid`: see SectionRequest.
    LegShaper(const Document& board, bool isAsSolid);

    [[nodiscard]] std::vector<SectionPiece> shape(LegCut leg) const;

private:
    void addVias(LegCut& leg) const;
    void shapeFace(const BoardFace& face, LegCut& leg) const;
    void addParts(const BoardFace& face, LegCut& leg) const;
    [[nodiscard]] Nm seatOf(const BoardFace& face) const;
    [[nodiscard]] Intervals copperOf(const BoardFace& face, const LegCut& leg) const;
    void splitDielectrics(std::vector<SectionPiece>& pieces) const;

    const Document& m_board;
    std::vector<BoardFace> m_faces;  ///< top, bottom; fewer where there is no copper
    std::vector<DielectricBand> m_bands;
    std::map<LayerId, SectionMaterial> m_rows;  ///< dielectrics that are layers
};

}  // namespace model
