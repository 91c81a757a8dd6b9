#pragma once

#include <string_view>
#include <vector>

#include "model/export/solids/solid_plan.h"
#include "model/geometry/loops/split_loops.h"

namespace app {

/// A solid that a STEP file of a plan must have.
struct ExpectedSolid {
    std::string_view shape;      ///< "line", "disc", "tube", … as the paper's tables name them
    double volume = 0.0;         ///< nm³, from the formula of its region
    model::ElementId element{};  ///< of its step
};

/// The shape that an element's solid has.
[[nodiscard]] std::string_view shapeOf(const model::Document& document, model::ElementId element);

/// Those of all copies, in the order in which the assembly tree of the file has them.
[[nodiscard]] std::vector<ExpectedSolid> expectedSolids(const model::SolidPlan& plan,
                                                        const model::RegionLimits& limits);

/// Leaves about `most` elements in the plan, spread over all shapes and layers; all of them if there are no more.
void thinOut(model::SolidPlan& plan, std::size_t most);

}  // namespace app
