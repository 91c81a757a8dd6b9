#include "model/formats/common/copy_outlines.h"

#include "model/figures/element_polygons.h"
#include "model/geometry/boolean.h"

namespace model::formats {

namespace {

/// What copies of one step take away, in that step's coordinates.
PolygonSet takenBy(const Document& step, const Discretisation& how) {
    if (step.profile.isValid()) {
        return discretise(step.shapes, step.profile, how);
    }
    PolygonSet taken;
    for (std::size_t row = 0; row < step.elements.size(); ++row) {
        if ((step.elements.flags[row] & kHole) != 0) {
            taken.append(discretise(step, ElementId{row}, how));
        }
    }
    return taken;
}

PolygonSet takenByCopies(const Document& document, const Discretisation& how) {
    std::vector<PolygonSet> ofStep;
    for (const auto& step : document.steps) {
        ofStep.push_back(takenBy(*step, how));
        if (!step->profile.isValid()) {
            ofStep.back().append(takenByCopies(*step, how));
        }
    }
    PolygonSet taken;
    for (const StepInstance& instance : document.instances) {
        taken.append(placed(ofStep[instance.step], instance.placement));
    }
    return taken;
}

}  // namespace

PolygonSet withoutCopies(const Document& document, const PolygonSet& region, const Discretisation& how) {
    return document.instances.empty() ? region : subtract(region, takenByCopies(document, how));
}

}  // namespace model::formats
