#pragma once

#include "model/board/document.h"

/// Where the board itself lies in height. A board of one copper layer reaches as far as the substrate below that layer,
/// or above it where it is the bottom one (docs/decisions/0237-a-single-copper-layer-may-be-the-bottom-one.md).
namespace model {

/// nm, from the lowest to the highest face of copper, without masks and prints; with its substrate for a single copper
/// layer. From 0 to the board's thickness without copper.
[[nodiscard]] ZRange boardHeights(const Document& document);

/// nm, the same without the outermost copper.
[[nodiscard]] ZRange substrateHeights(const Document& document);

}  // namespace model
