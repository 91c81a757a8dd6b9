#pragma once

#include <vector>

#include "model/board/document.h"

/// The groups of pads that the properties of a component declare (model/board/pad_group_names.h).
namespace model {

using PinGroup = std::vector<PinId>;

/// Each rising, of those that have a pin there.
[[nodiscard]] std::vector<PinGroup> netTieGroups(const Document& document, ComponentId component);
[[nodiscard]] std::vector<PinGroup> jumperGroups(const Document& document, ComponentId component);

}  // namespace model
