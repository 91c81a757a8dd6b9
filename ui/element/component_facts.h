#pragma once

#include "ui/element/element_facts.h"
#include "ui/parts/part_picking.h"

namespace ui {

/// What the job says of a component: package, side, position, rotation, height, nets, attributes. `isOneOfSteps`: its
/// step lies on a panel, so it is said whose coordinates these are.
[[nodiscard]] Facts componentFacts(const model::Document& step, model::ComponentId id, LengthUnit unit,
                                   bool isOneOfSteps);

}  // namespace ui
