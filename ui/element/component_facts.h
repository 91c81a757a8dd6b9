#pragma once

#include "ui/element/element_facts.h"
#include "ui/parts/part_picking.h"

namespace ui {

/// What the job says of a component: package, side, position, rotation, height, nets, attributes.
[[nodiscard]] Facts componentFacts(const model::Document& step, model::ComponentId id, LengthUnit unit);

}  // namespace ui
