#pragma once

#include "ui/element/element_facts.h"

namespace ui {

/// What is known of a highlighted net: its step if that is not the board, its elements per layer and its pins by name.
[[nodiscard]] Facts netFacts(const model::StepTree& tree, const model::BoardNet& net);

}  // namespace ui
