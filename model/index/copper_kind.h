#pragma once

#include <string>

#include "model/board/document.h"

namespace model {

/// What copper or a hole is to people: "pad", "track", "area", "dot"; "via", "component hole", "plated slot", "NPTH" ….
/// Microvias are vias here: to tell them apart takes a look at the whole board (model/board/holes.h).
[[nodiscard]] std::string copperKind(const Document& document, ElementId element);

}  // namespace model
