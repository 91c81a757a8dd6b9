#pragma once

#include <string_view>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/formats/drawing/drawn_job.h"
#include "model/formats/kicad/project.h"

namespace model::kicad {

/// What a board draws, from the text of its .kicad_pcb. `file` is what messages call it, and what texts
/// call the board. Errors: BadInput when the text
/// is no board or has no layers, Cancelled.
[[nodiscard]] base::Result<formats::DrawnJob> drawBoard(std::string_view text, std::string_view file,
                                                        const Project& project, base::Progress& progress);

}  // namespace model::kicad
