#pragma once

#include <map>
#include <optional>
#include <vector>

#include "model/section/laid_film.h"
#include "model/section/landing_via.h"
#include "model/section/stretch.h"

namespace model {

/// A component as a line cuts it, with heights from the face it stands on (partPieces).
struct StandingPart {
    bool isTop = true;
    bool isFlipped = false;  ///< of a flipped copy
    std::vector<SectionPiece> pieces;
};

/// What was met on one straight part of a line. Locations are those along all of the line.
struct LegCut {
    double from = 0.0;
    double to = 0.0;
    std::vector<SectionPiece> pieces;      ///< as the layers have them, holes taken out
    std::vector<SectionPiece> leftCopper;  ///< the same of copper that is not shown: dielectrics end at it too
    std::vector<SectionPiece> bores;
    std::vector<std::pair<LandingVia, SectionPiece>> vias;  ///< and a piece like their plating
    std::vector<StandingPart> parts;
    LayerRanges ranges;  ///< of layers that are not all along
};

/// Makes of what the layers of a board draw what is found when the board is cut: dielectrics by material, laser vias
/// that land, mask that flows over copper, films on what is there, parts that stand on the board.
class LegShaper {
public:
    /// `isAsSolid`: see SectionRequest.
    LegShaper(const Document& board, bool isAsSolid);

    [[nodiscard]] std::vector<SectionPiece> shape(LegCut leg) const;

private:
    void addVias(LegCut& leg) const;
    void shapeSurfaces(const std::vector<Stretch>& stretches, LegCut& leg) const;
    [[nodiscard]] std::optional<Nm> floorOf(const StandingPart& part) const;
    [[nodiscard]] const Stretch& standingIn(const std::vector<Stretch>& stretches, const StandingPart& part) const;
    void shapeStretch(const Stretch& stretch, LegCut& leg) const;
    void shapeFace(const Stretch& stretch, const BoardFace& face, std::vector<LaidStack>& stacks, LegCut& leg) const;
    void shapeFilms(const LaidStack& stack, const Intervals& raised, std::vector<LaidPart>& laid, LegCut& leg) const;
    void movePaste(const BoardFace& face, LegCut& leg) const;
    void addParts(const Stretch& stretch, const BoardFace& face, LegCut& leg) const;
    [[nodiscard]] Nm maskOn(const Stretch& stretch, const BoardFace& face, bool isFlipped) const;
    [[nodiscard]] Nm seatOf(const Stretch& stretch, const BoardFace& face, bool isFlipped) const;
    [[nodiscard]] bool isSurface(const SectionPiece& piece) const;
    [[nodiscard]] bool isFilm(const SectionPiece& piece) const;
    void splitDielectrics(const std::vector<Stretch>& stretches, std::vector<SectionPiece>& pieces) const;
    void takeCopperOut(LegCut& leg) const;

    const Document& m_board;
    bool m_isAsSolid;
    std::vector<BoardFace> m_faces;         ///< where all layers are
    std::map<LayerId, std::size_t> m_rows;  ///< of the stackup; dielectrics that are layers
};

}  // namespace model
