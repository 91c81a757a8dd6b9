#pragma once

#include <string_view>

namespace fuzz {

/// Any text as contours into all triangulators, the kernels' oracle included: a line is a loop, two characters are a
/// point, and the first character says how large the whole is. They have to agree in outcome and triangles, and the
/// verifier has to accept these; aborts if not.
void contours(std::string_view input);

}  // namespace fuzz
