#pragma once

#include <vector>

#include "model/board/document.h"

namespace model::formats {

/// The elements made from a feature, rising. Elements of a layer are in the order of their features; only a trail comes
/// from several, one per track.
[[nodiscard]] std::vector<ElementId> elementsOf(const Document& document, LayerId layer, std::size_t feature);

}  // namespace model::formats
