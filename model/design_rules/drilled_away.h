#pragma once

#include <vector>

#include "model/board/document.h"

namespace model {

/// Which elements of copper layers NPTHs take away as a whole, by element: pads of the size of their hole, or smaller,
/// as libraries draw them for mounting holes. No copper is left of them.
[[nodiscard]] std::vector<bool> drilledAway(const Document& document);

}  // namespace model
