#pragma once

#include <vector>

#include "model/formats/gerber/board_groups.h"

namespace model::gerber {

/// Reports what the files of a board speak of and the job does not hold: copper layers that are skipped where files
/// count them ("Copper,L1,Top", "Copper,L4,Bot"), and images that a job file lists. It is an error where copper, solder
/// mask, silkscreen, outline or holes are missing: then not all of the board is there to be checked. What
/// innerBehindGaps() finds is a warning.
void reportMissingLayers(const std::vector<ReadFile>& files, const BoardFiles& board, Diagnostics& diagnostics);

/// The files, rows of `files`, that are inner copper n by a number of the inner layers, where no file is n - 1; these
/// count from 1, or from 2 where the top is 1. Either a layer is missing or the file is no layer of the board: gEDA
/// numbers its groups of layers, of which one may hold jumpers.
[[nodiscard]] std::vector<std::size_t> innerBehindGaps(const std::vector<ReadFile>& files, const BoardFiles& board);

}  // namespace model::gerber
