#pragma once

#include <vector>

#include "model/formats/gerber/board_groups.h"

namespace model::gerber {

/// Reports what the files of a board speak of and the job does not hold: copper layers that are skipped where files
/// count them ("Copper,L1,Top", "Copper,L4,Bot"), and images that a job file lists. It is an error where copper, solder
/// mask, silkscreen, outline or holes are missing: then not all of the board is there to be checked.
void reportMissingLayers(const std::vector<ReadFile>& files, const BoardFiles& board, Diagnostics& diagnostics);

}  // namespace model::gerber
