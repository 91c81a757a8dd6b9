#pragma once

#include "model/agreement/agreement.h"

namespace model {

/// Thicknesses of the copper layers by their order from the top, of the dielectric between two of them (all its plies
/// together), and of the board from the outermost copper to the outermost copper, or of the substrate of a single
/// copper layer. Copper may differ by what programs take an ounce for (3.5 %), all by as much as numbers in mil are
/// rounded (2 µm), the board by as much as all of these. What is assumed in one of the jobs, or its share of a board's
/// thickness, is not compared, which a note says; then the board is as thick as a job says, with or without its solder
/// mask. Where the jobs have different numbers of copper layers, the board alone is compared.
[[nodiscard]] Comparison compareStackups(const Document& a, const Document& b, const AgreementRequest& request);

}  // namespace model
