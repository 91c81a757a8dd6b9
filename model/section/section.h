#pragma once

#include <string>
#include <vector>

#include "model/base/result.h"
#include "model/index/board_index.h"

/// A board cut by a section plane along a line: what lies in the cut, and from where to where. Every element is an
/// upright prism, so the cut is made of rectangles, and they are exact.
namespace model {

struct SectionRequest {
    std::vector<PointD> line;  ///< corners of the line in nanometres of the board, two at least
    std::vector<bool> layers;  ///< which take part, by layer; empty: all that are made of something
};

/// A rectangle of the cut.
struct SectionPiece {
    LayerId layer;    ///< of the board, where a flipped copy has put it
    BoardElement at;  ///< element none: of several (see merged)
    double from = 0;  ///< along the line from its start, over all corners, nm
    double to = 0;
    Nm bottom = 0;  ///< equal to `top` where the layer has no thickness
    Nm top = 0;
};

struct Section {
    std::vector<PointD> line;          ///< as requested, corners without a distance between them left out
    std::vector<double> stations;      ///< how far along the line its corners are; the last is its length
    std::vector<SectionPiece> pieces;  ///< what is solid, walls of plated holes included; by layer, location, element
    std::vector<SectionPiece> bores;   ///< what drills and routers took out, as wide as drilled; in the same order
    std::vector<std::string> notes;    ///< what the reader of the section must know, in plain words
};

/// Is the layer made of something that a cut can show? Not: mask openings, drawings, outlines.
[[nodiscard]] bool hasSubstance(const Layer& layer);

/// Cuts the board with all its copies of steps. Holes are taken out of copper and dielectrics (the substrate and the
/// solder mask have no material there to begin with), also where a drill of a panel passes its steps. The substrate
/// fills the whole height between the outer copper layers, also where inner copper lies in it. A wall reaches as far as
/// Document::platedSpanOf says. The cost follows what lies near the line.
///
/// A line beside the board gives no pieces and a note, as do layers without a thickness or with an assumed one, and
/// plated holes whose wall has no thickness (routed areas): they are cut without it.
/// Errors: BadUsage for a line without length, of more than kMostCorners corners, or off the coordinates of boards.
[[nodiscard]] base::Result<Section> makeSection(const BoardIndex& index, const SectionRequest& request);

inline constexpr std::size_t kMostCorners = 10'000;

/// The same cut with a piece per layer and height wherever its elements cover the line without a break; for drawing.
[[nodiscard]] std::vector<SectionPiece> merged(const std::vector<SectionPiece>& pieces);

}  // namespace model
