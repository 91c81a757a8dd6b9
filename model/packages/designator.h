#pragma once

#include "model/packages/body_plan.h"

namespace model {

/// A character of a designator and where it is printed.
struct PrintedCharacter {
    char32_t character = 0;
    Nm height = 0;        ///< of capitals: one of few sizes, so that characters are shared
    Placement placement;  ///< from the character's own coordinates (characterStrokes) to the board's
};

/// The designator of a component on top of its body, as large as it fits; upright for who looks at that side of the
/// board, and along the body. Empty where it would be too small to read, and for components without a name.
[[nodiscard]] std::vector<PrintedCharacter> printDesignator(const Component& component, const BodyPlan& plan);

/// A character as strokes with a width, its lower left corner at the origin. Strokes may overlap.
[[nodiscard]] PolygonSet characterStrokes(char32_t character, Nm height);

}  // namespace model
