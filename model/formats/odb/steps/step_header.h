#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "model/base/point.h"
#include "model/board/diagnostics.h"
#include "model/formats/odb/text/records.h"

namespace model::odb {

/// A STEP-REPEAT block: `columns` × `rows` copies of a step (odb-notes, Panels). The datum of copy (i, j) lands on
/// first
/// + (i · pitch.x, j · pitch.y); the copy is rotated clockwise, then mirrored x → −x.
struct StepRepeat {
    std::string step;
    base::Point first;
    base::Point pitch;
    int columns = 1;
    int rows = 1;
    double clockwiseDeg = 0.0;
    bool isMirrored = false;
    bool isFlipped = false;  ///< mirrored and upside down: top layers land on the bottom
    std::uint32_t line = 0;
};

struct StepHeader {
    base::Point datum;
    std::vector<StepRepeat> repeats;
};

/// A block of more than base::kMostCopies copies is reported and left out.
[[nodiscard]] StepHeader parseStepHeader(std::string_view text, std::string_view path, Unit defaultUnit,
                                         Diagnostics& diagnostics);

}  // namespace model::odb
