#pragma once

#include <vector>

#include "model/base/progress.h"
#include "model/board/document.h"
#include "model/geometry/discretise.h"
#include "model/solids/milling.h"

namespace model {

/// The document's silkscreen that lies over holes which are open at its face of the board, and what is left of it: jobs
/// draw lines and texts across them, and no ink lies in mid-air. Rising.
///
/// Open are routs, NPTHs, plated holes wider than solder mask closes (kWidestTent), and narrower ones in an opening of
/// the mask; all of them where the job draws no mask. Solder paste is not looked at: it is printed over holes on
/// purpose. Copies of other steps are not looked at, and holes of a panel do not cut what is printed on its steps.
/// Curves become chords of `how`, of the elements listed only. The same with 1 and N threads; incomplete when
/// cancelled.
[[nodiscard]] std::vector<MilledElement> findDrilledPrint(const Document& document, const Discretisation& how,
                                                          const base::Progress& progress);

/// Adds such print to what is milled of the same board: of an element that is both, what neither takes is left.
void addDrilledPrint(std::vector<MilledElement> print, std::vector<MilledElement>& milled);

}  // namespace model
