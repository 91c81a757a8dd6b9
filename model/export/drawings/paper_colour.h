#pragma once

#include <cstdint>

namespace model {

/// The colour, or if it were hardly seen on white paper a darker one of its hue: all stand out from white by 3 to 1, as
/// WCAG counts and asks it of graphics. 0xRRGGBB.
[[nodiscard]] std::uint32_t onPaper(std::uint32_t colour);

}  // namespace model
