#pragma once

#include <string_view>

namespace fuzz {

/// Any text as regions of lines and arcs into the exact booleans: a line of text is a region, its first character says
/// what it is (`c` a disc: centre, radius; `t` a track: two ends, half its width; else a contour: corners, each with
/// how far its edge bulges, where `@` is straight and `|` ends a loop), and the text's first character says how large
/// the whole is. Results must be regions that findFault() passes, and what is taken away and what is left must add up;
/// STEP solids are written of them. Aborts if not.
void regions(std::string_view input);

}  // namespace fuzz
