#include "model/formats/common/board_outline.h"

#include <numeric>
#include <string>

#include "model/formats/common/element_regions.h"
#include "model/geometry/outlines.h"
#include "model/solids/shells/area_shell.h"

namespace model::formats {

namespace {

std::uint64_t copperElements(const Document& step) {
    std::uint64_t count = 0;
    for (const Layer& layer : step.layers) {
        if (layer.isBoardCopper()) {
            count = std::accumulate(layer.countsWithCopies.begin(), layer.countsWithCopies.end(), count);
        }
    }
    return count;
}

/// Calls `visit(box, count)` for every element on a copper layer, and for every copy of a step with all its copper.
template <class Visit>
void forEachCopper(const Document& document, Visit visit) {
    for (const Layer& layer : document.layers) {
        for (std::uint32_t i = 0; i < layer.elements.count && layer.isBoardCopper(); ++i) {
            visit(document.boxOf(ElementId{layer.elements.first + i}), 1);
        }
    }
    for (const StepInstance& instance : document.instances) {
        const Document& step = *document.steps[instance.step];
        visit(instance.placement.boxOf(step.board), copperElements(step));
    }
}

/// What copies of one step take away, in that step's coordinates.
RegionBoolean takenBy(const Document& step) {
    if (step.profile.isValid()) {
        return {areaOutlines(step.shapes, step.profile), true};
    }
    RegionBoolean taken;
    for (std::size_t row = 0; row < step.elements.size(); ++row) {
        if ((step.elements.flags[row] & kHole) != 0) {
            taken.append(regionsOf(step, ElementId{row}));
        }
    }
    return taken;
}

RegionBoolean takenByCopies(const Document& document) {
    std::vector<RegionBoolean> ofStep;
    for (const auto& step : document.steps) {
        ofStep.push_back(takenBy(*step));
        if (!step->profile.isValid()) {
            ofStep.back().append(takenByCopies(*step));
        }
    }
    RegionBoolean taken;
    for (const StepInstance& instance : document.instances) {
        taken.isExact = taken.isExact && ofStep[instance.step].isExact;
        for (const EdgeLoops& region : ofStep[instance.step].regions) {
            taken.regions.push_back(placed(region, instance.placement));
        }
    }
    return taken;
}

}  // namespace

bool fitsCopper(const ShapeSketch& outline, const Document& soFar) {
    const Box box = boxOf(outline).grownBy(1'000'000);
    std::uint64_t inside = 0;
    std::uint64_t all = 0;
    forEachCopper(soFar, [&](const Box& element, std::uint64_t count) {
        all += count;
        inside += box.holds(element.middle()) ? count : 0;
    });
    return 2 * inside >= all;
}

std::optional<ShapeSketch> outlineOfCopper(const Document& soFar) {
    Box box;
    forEachCopper(soFar, [&](const Box& element, std::uint64_t) { box.include(element); });
    if (box.isEmpty() || box.width() == 0 || box.height() == 0) {
        return std::nullopt;
    }
    ShapeSketch sketch;
    addBox(sketch, box);
    return sketch;
}

void setOutline(DocumentBuilder& builder, std::optional<ShapeSketch> sketch, std::string_view whyNone,
                std::string_view file) {
    Source source = Source::Job;
    if (!sketch || !fitsCopper(*sketch, builder.soFar())) {
        const std::string why = sketch ? "the profile does not enclose the copper" : std::string(whyNone);
        source = Source::Assumed;
        sketch = outlineOfCopper(builder.soFar());
        builder.diagnostics().report(Severity::Warning, file, 0,
                                     why + (sketch ? "; the box around all copper is used as the board's outline"
                                                   : "; the board has no outline"));
    }
    if (sketch) {
        builder.setProfile(builder.addShape(*sketch), source);
    }
}

RegionBoolean withoutCopies(const Document& document, std::vector<EdgeLoops> region) {
    if (document.instances.empty()) {
        return {std::move(region), true};
    }
    const RegionBoolean taken = takenByCopies(document);
    RegionBoolean left = differenceOf(region, taken.regions);
    left.isExact = left.isExact && taken.isExact;
    return left;
}

}  // namespace model::formats
