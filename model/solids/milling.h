#pragma once

#include <vector>

#include "model/base/progress.h"
#include "model/board/copies.h"
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
/// Layers that we add (Layer::isSynthetic) end at the outline already. Copies of other steps are not looked at: a panel
/// is whole until it is milled, but for their cut-outs (findInCutouts). Curves become chords of `how`, of the elements
/// listed only. The same with 1 and N threads; incomplete when cancelled.
[[nodiscard]] MilledBoard findMilled(const Document& document, const Discretisation& how,
                                     const base::Progress& progress);

/// The regions that cut-outs of the outline of a step take out of it, as chords of `how`; empty where there are none.
[[nodiscard]] PolygonSet cutoutsOf(const Document& step, const Discretisation& how);

/// The same of every copy of a step on the board, where it lies there; rows as StepTree::copies, that of the board
/// itself is empty. Each step is looked at once.
[[nodiscard]] std::vector<PolygonSet> cutoutsOfCopies(const StepTree& tree, const Discretisation& how);

/// The same as findMilled of a step that a panel places: only what reaches into cut-outs of its outline. Those are open
/// in the panel too; beyond the outline it goes on.
[[nodiscard]] MilledBoard findInCutouts(const Document& step, const Discretisation& how,
                                        const base::Progress& progress);

}  // namespace model
