#pragma once

#include "model/formats/gerber/job_files.h"
#include "model/formats/gerber/pad_index.h"

namespace model::gerber {

/// Reads a drill file again in another format where the one it states, or that was assumed, does not put its holes on
/// the board and another does; what was done is reported.
void fitToCopper(ReadFile& drills, const PadIndex& pads, const Box& copper);
/// Does the second file drill the same holes as the first?
[[nodiscard]] bool areSameHoles(const Image& first, const Image& second);

}  // namespace model::gerber
