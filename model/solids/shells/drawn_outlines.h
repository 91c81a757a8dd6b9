#pragma once

#include "model/solids/shells/element_shells.h"

namespace model {

/// The regions of an element as a drawing of its layer has them: those of outlinesOf, but holes are what is drilled,
/// not what is plated.
[[nodiscard]] ElementOutlines drawnOutlinesOf(const Document& document, ElementId element);

}  // namespace model
