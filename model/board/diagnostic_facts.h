#pragma once

#include <string>
#include <string_view>

#include "model/board/diagnostics.h"

namespace model {

/// Where in the job an entry is about, as compilers write it: "matrix/matrix:12", "matrix/matrix", or empty.
[[nodiscard]] std::string placeOf(const Diagnostic& entry);
/// The first thing that could not be read, and so is not on the board, or not as it should be; null if there is none.
[[nodiscard]] const Diagnostic* firstError(const Diagnostics& diagnostics);

/// How the message ends that the readers give where they make up the outline of a board.
inline constexpr std::string_view kBoxAsOutline = "the box around all copper is used as the board's outline";
/// Is the outline of the board made up? Then it can be shown, but nothing can be held against it.
[[nodiscard]] bool isOutlineAssumed(const Diagnostics& diagnostics);

}  // namespace model
