#pragma once

#include <string>

#include "model/board/diagnostics.h"

namespace model {

/// Where in the job an entry is about, as compilers write it: "matrix/matrix:12", "matrix/matrix", or empty.
[[nodiscard]] std::string placeOf(const Diagnostic& entry);
/// The first thing that could not be read, and so is not on the board, or not as it should be; null if there is none.
[[nodiscard]] const Diagnostic* firstError(const Diagnostics& diagnostics);

}  // namespace model
