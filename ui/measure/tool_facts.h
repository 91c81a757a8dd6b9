#pragma once

#include <array>

#include "ui/measure/measure_feature.h"

namespace ui {

/// How a tool of measuring is used. Texts are English; MeasureFeature translates them.
struct ToolFacts {
    Catch what;
    std::size_t clicks;
    std::array<const char*, 3> hints;  ///< what each click is for
    const char* nothing;               ///< a click that catches nothing
};

[[nodiscard]] const ToolFacts& factsOf(MeasureFeature::Tool tool);

}  // namespace ui
