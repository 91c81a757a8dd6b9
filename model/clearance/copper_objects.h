#pragma once

#include <vector>

#include "model/board/document.h"
#include "model/clearance/design_rules.h"

namespace model {

/// What every element of a copper layer and every plated hole is, by element; Any for what is neither.
[[nodiscard]] std::vector<CopperObject> copperObjectsOf(const Document& document);

}  // namespace model
