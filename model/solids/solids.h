#pragma once

#include "model/base/progress.h"
#include "model/board/document_builder.h"
#include "model/solids/substrates.h"

namespace model {

/// Widest plated hole that solder mask closes where the mask has no opening over it; tenting is not done beyond half a
/// millimetre.
inline constexpr Nm kWidestTent = 500'000;

/// Does solder mask without an opening over it close the hole? Plated ones that are narrow enough; NPTHs and routs are
/// made after the mask was applied.
[[nodiscard]] bool isTented(const Document& document, ElementId hole);

/// Adds what a board has besides the features of its job, as synthetic layers (Layer::isSynthetic), to be called when
/// all other layers are complete:
/// - the substrate (LayerType::Body): the outline minus all holes, from the upper face of the lowest to the lower face
///   of the highest copper layer. Cut into parts where blind and buried holes end, so that every part has the
///   holes that pass it, and on rigid-flex boards at every dielectric (substrates.h); parts are called "board", or
///   "board 1", "board 2", … from the top.
/// - the solder masks (LayerType::SolderMask): the outline minus the mask's openings and minus the
/// holes
///   that stay open (routs, NPTHs, plated ones wider than kWidestTent), named "<mask> solder mask".
/// Where copies of the board are flipped, the layers lie on each other (Layer::opposite).
/// Layers with an outline of their own keep within it. On a panel all that the outlines of the steps it places enclose
/// is cut out: they have solids of their own, and where an outline has a cut-out there is nothing. The layers depend on
/// those of the job only, so that all steps of a panel have the same rows; they are empty where there is no outline, or
/// a mask has no openings. False when cancelled.
[[nodiscard]] bool addSolids(DocumentBuilder& builder, const base::Progress& progress);

/// Gives solids that are there already the heights that follow from what the layers of the job now have. Which holes
/// cut which part does not change with thicknesses.
void placeSolids(Document& document);

}  // namespace model
