#pragma once

#include <string>

#include "model/board/diagnostics.h"

namespace model {

/// Where in the job an entry is about, as compilers write it: "matrix/matrix:12", "matrix/matrix", or empty.
[[nodiscard]] std::string placeOf(const Diagnostic& entry);

}  // namespace model
