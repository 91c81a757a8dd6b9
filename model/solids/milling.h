#pragma once

#include <vector>

#include "model/base/progress.h"
#include "model/board/document.h"
#include "model/geometry/discretise.h"

/// What a fabricator mills away: all that a job draws beyond the outline of the board.
namespace model {

/// What reaches less than this beyond the outline is not milled, nm: jobs draw copper to the edge in rounded numbers.
inline constexpr Nm kMillingTolerance = 2'500;

/// An element of which milling leaves a part, or nothing.
struct MilledElement {
    ElementId element;
    PolygonSet rest;  ///< what is left of it, in the document's coordinates; empty: nothing
};

/// What findMilled finds.
struct MilledBoard {
    std::vector<MilledElement> elements;  ///< rising
    /// More copper elements lie beyond the outline than within, those of copies counted: it is taken for that of
    /// something else, and nothing is milled.
    bool isOutlineDoubtful = false;
};

/// The document's elements that lie beyond its outline (Document::profile) or reach across it; none where there is no
/// outline, or a doubtful one.
///
/// A hole across the outline (a castellation) keeps its plating within the outline; what it passes is open there.
/// Layers that we add (Layer::isSynthetic) end at the outline already. Copies of other steps are not milled: a panel is
/// whole until it is. Curves become chords of `how`, of the elements listed only. The same with 1 and N
/// threads; incomplete when cancelled.
[[nodiscard]] MilledBoard findMilled(const Document& document, const Discretisation& how,
                                     const base::Progress& progress);

}  // namespace model
