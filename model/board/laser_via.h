#pragma once

#include "model/board/document.h"

namespace model {

/// The layer that a laser via lands on: its copper stays whole, and the via ends on its near face. Of the two ends of a
/// round plated hole with HoleSpan::Micro it is the one with more copper beyond it, of equal ones the lower. None:
/// another hole, which passes all copper of its span.
[[nodiscard]] LayerId targetOf(const Document& document, ElementId hole);

}  // namespace model
