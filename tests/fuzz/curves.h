#pragma once

#include <string_view>

namespace fuzz {

/// Any text as a NURBS curve into all that is asked about curves: the first character is the degree, the second how
/// large the whole is, then a line of steps between inner knots, then three characters for each control point: x, y and
/// weight. What faultIn() accepts must be measured without contradiction; aborts if not.
void curves(std::string_view input);

}  // namespace fuzz
