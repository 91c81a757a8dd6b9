#pragma once

#include <span>
#include <vector>

#include "model/solids/shells/shell.h"

namespace model {

/// Several elements as few solids.
struct MergedShells {
    std::vector<Shell> shells;  ///< in the document's coordinates; they do not overlap each other, but for `apart`
    std::size_t apart = 0;      ///< how many of them may overlap others, as they could not be united
    std::size_t problems = 0;   ///< elements of which there is no solid, or not of all (ElementShells::problem)
};

/// The copper of one net on one layer, tracks, pads and pours, as one solid for each piece that hangs together. Holes
/// that are drilled through it are no part of this: drilled_copper.h cuts them out of what is merged.
/// All elements lie on one layer. Pieces whose boxes are apart are united on their own, so that what cannot be united
/// affects as little as possible.
[[nodiscard]] MergedShells mergedShells(const Document& document, std::span<const ElementId> elements);

}  // namespace model
