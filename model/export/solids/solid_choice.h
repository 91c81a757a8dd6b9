#pragma once

#include <optional>
#include <string>
#include <vector>

#include "model/board/document.h"

namespace model {

/// As far as programs keep the chords that they write for the arcs of pours, nm.
inline constexpr double kArcTolerance = 5'000.0;

/// Corners this near to the line between their neighbours are left out of solids, nm: what is left of clipping pours on
/// a grid of 1 nm (decision 0148).
inline constexpr double kCornerTolerance = 5.0;

/// Which part of a board is exported as solids, and how.
struct SolidChoice {
    /// What copies have there (Document::layerOfCopy); empty: all that a finished board consists of (isSolidLayer)
    std::vector<LayerId> layers;
    std::vector<std::string> nets;  ///< only copper of these nets, and what is no copper; empty: all
    /// Only elements whose box meets this one, whole; the substrate and other synthetic layers stay whole too.
    std::optional<Box> window;
    /// Round holes that are drilled narrower than this, nm, are left out: substrate and copper are closed there, and no
    /// barrel is written.
    Nm minHole = 0;
    /// What a mechanical design needs: the substrate and the bodies of components. Of outer copper layers that `layers`
    /// names also the pads that are not part of a via. No inner layers, tracks, planes, mask or print.
    bool isOuterOnly = false;
    /// Runs of chords become arcs that are nowhere further away than kArcTolerance (withFittedArcs). Else they stay
    /// what the job says.
    bool hasFittedArcs = false;
    bool isMerged = false;      ///< touching copper of one net and layer becomes one solid
    bool isOnePart = false;     ///< one product with all solids instead of a tree of layers and nets
    bool isAsDesigned = false;  ///< with what is milled away beyond the board outline
};

/// Is the layer part of a finished board: copper, plated holes, the substrate, solder mask, print, bodies of
/// components? Paste, documentation, drawings that the job calls silkscreen and what it draws as openings are not.
[[nodiscard]] bool isSolidLayer(const Layer& layer);

}  // namespace model
