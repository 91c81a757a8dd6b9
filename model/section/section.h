#pragma once

#include <string>
#include <vector>

#include "model/base/result.h"
#include "model/index/board_index.h"
#include "model/section/section_piece.h"

/// A board cut by a section plane along a line: what lies in the cut, and from where to where. Every element is an
/// upright prism, so what the job draws is cut in rectangles, and they are exact. What a job does not say of a board
/// that is made follows from stated assumptions: how mask flows over copper (mask_shape.h), how laser vias land
/// (landing_via.h), how films lie (laid_film.h), where parts stand (standing_parts.h). Section::notes names those that
/// were made.
namespace model {

struct SectionRequest {
    std::vector<PointD> line;  ///< corners of the line in nanometres of the board, two at least
    std::vector<bool> layers;  ///< which take part, by layer; empty: all that are made of something
    /// As the 3D view draws the board: the outer face of a mask is level, bodies of components are prisms, every layer
    /// lies at the height that it has where all layers are, the substrate is whole also where inner copper lies in it.
    bool isAsSolid = false;
    /// Elements that a fabricator mills away, whole or in part, rising; rows as StepTree::steps, missing ones are
    /// empty. Of the board (findMilled in model/solids/milling.h) what lies beyond its outline is left out, of the
    /// steps that a panel places (findInCutouts) what lies in their cut-outs. Empty: as designed.
    std::vector<std::vector<ElementId>> milled = {};
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
/// fills the height between the outer copper layers, in pieces by the dielectrics of the stackup: beside inner copper
/// one of its neighbours fills that height too (dielectricBandsOf), where copper lies none does. A wall reaches as far
/// as Document::platedSpanOf says. Laser vias (HoleSpan::Micro) end on their target pad; which of their ends that is
/// follows from which side of the board is nearer. Copper is as thick as the stackup says, with whatever plating there
/// is on it. The cost follows what lies near the line.
///
/// On a rigid-flex board what lies on others lies on what each zone has (Layer::profile, model/board/local_stack.h),
/// and plating reaches no farther. A coverlay, adhesive or stiffener of which the job draws nothing is all over the
/// zones that have it; such pieces are of no element.
///
/// What is milled away gives a note where the line meets it.
///
/// A line beside the board gives no pieces and a note, as do layers without a thickness or with an assumed one, and
/// plated holes whose wall has no thickness (routed areas): they are cut without it.
/// Errors: BadUsage for a line without length, of more than kMostCorners corners, or off the coordinates of boards.
[[nodiscard]] base::Result<Section> makeSection(const BoardIndex& index, const SectionRequest& request);

inline constexpr std::size_t kMostCorners = 10'000;

/// How far along the line it bends: by 10 degrees or more, which the chords of arcs (NetLine) do not.
[[nodiscard]] std::vector<double> bendsOf(const Section& section);

/// The same cut with a piece per layer, height and material wherever its elements cover the line without a break; for
/// drawing.
[[nodiscard]] std::vector<SectionPiece> merged(const std::vector<SectionPiece>& pieces);

}  // namespace model
