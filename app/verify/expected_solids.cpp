#include "app/verify/expected_solids.h"

#include <algorithm>
#include <map>

namespace app {

using model::Document;
using model::ElementId;
using model::ElementKind;
using model::LayerType;
using model::SolidPlan;
using model::StepSolids;

namespace {

template <class IsWanted>
bool hasEdge(const Document& document, model::ShapeId shape, const IsWanted& isWanted) {
    return std::ranges::any_of(document.shapes.contoursOf(shape), [&](const model::Contour& contour) {
        return std::ranges::any_of(document.shapes.nodesOf(contour),
                                   [&](const model::PathNode& node) { return isWanted(node.edge); });
    });
}

std::string_view shapeOfArea(const Document& document, ElementId element) {
    switch (document.layer(document.elements.layer[element.row()]).type) {
        case LayerType::Body: return "substrate";
        case LayerType::ComponentBody: return "component body";
        case LayerType::SolderMask: return "solder mask";
        default: break;
    }
    const model::ShapeId shape = document.areas[document.elements.geometry[element.row()]].shape;
    const auto isCurve = [](model::EdgeKind edge) { return edge == model::EdgeKind::Curve; };
    return hasEdge(document, shape, isCurve)        ? "area with NURBS edges"
           : hasEdge(document, shape, model::isArc) ? "area with arcs"
                                                    : "area of lines";
}

void addSolids(const SolidPlan& plan, const StepSolids& step, const model::RegionLimits& limits,
               std::vector<ExpectedSolid>& out) {
    for (const ElementId element : step.elements) {
        const std::string_view shape = shapeOf(*step.document, element);
        for (const model::Shell& shell : plan.shellsOf(step, element).shells) {
            for (const model::EdgeLoops& piece : model::splitLarge(shell.outline, limits)) {
                out.push_back({shape, volumeOf(model::Shell{piece, shell.z}), element});
            }
        }
    }
}

/// Keeps the elements that `isKept` wants, and no empty groups.
template <class IsKept>
void keep(StepSolids& step, const IsKept& isKept) {
    std::vector<ElementId> elements;
    std::vector<model::SolidGroup> groups;
    for (model::SolidGroup group : step.groups) {
        const auto first = static_cast<std::uint32_t>(elements.size());
        for (std::uint32_t i = 0; i < group.elements.count; ++i) {
            const ElementId element = step.elements[group.elements.first + i];
            if (isKept(element)) {
                elements.push_back(element);
            }
        }
        group.elements = {first, static_cast<std::uint32_t>(elements.size()) - first};
        if (group.elements.count > 0) {
            groups.push_back(group);
        }
    }
    step.elements = std::move(elements);
    step.groups = std::move(groups);
}

}  // namespace

std::string_view shapeOf(const Document& document, ElementId element) {
    const std::size_t row = element.row();
    const std::uint32_t geometry = document.elements.geometry[row];
    const bool isHole = (document.elements.flags[row] & model::kHole) != 0;
    switch (document.elements.kind[row]) {
        case ElementKind::Line:
            return isHole                                                    ? "slot"
                   : (document.elements.flags[row] & model::kSquarePen) != 0 ? "line with a square pen"
                                                                             : "line";
        case ElementKind::Arc: return "arc";
        case ElementKind::Circle:
            return isHole ? "tube" : document.circles[geometry].innerDiameter > 0 ? "ring" : "disc";
        case ElementKind::Trail: return isHole ? "slot" : "trail";
        case ElementKind::Area: return shapeOfArea(document, element);
    }
    return "";
}

std::vector<ExpectedSolid> expectedSolids(const SolidPlan& plan, const model::RegionLimits& limits) {
    std::vector<std::vector<ExpectedSolid>> ofSteps(plan.steps.size());
    for (std::size_t i = 0; i < plan.steps.size(); ++i) {
        addSolids(plan, plan.steps[i], limits, ofSteps[i]);
    }
    std::vector<ExpectedSolid> all;
    for (const model::SolidCopy& copy : plan.copies) {
        all.insert(all.end(), ofSteps[copy.step].begin(), ofSteps[copy.step].end());
    }
    return all;
}

void thinOut(SolidPlan& plan, std::size_t most) {
    using Kind = std::pair<std::string_view, std::uint32_t>;
    std::map<Kind, std::size_t> counts;
    const auto kindOf = [](const StepSolids& step, ElementId element) {
        return Kind{shapeOf(*step.document, element),
                    static_cast<std::uint32_t>(step.document->elements.layer[element.row()].row())};
    };
    for (const StepSolids& step : plan.steps) {
        for (const ElementId element : step.elements) {
            ++counts[kindOf(step, element)];
        }
    }
    if (plan.elements <= most) {
        return;
    }
    const std::size_t share = std::max<std::size_t>(1, most / counts.size());
    std::map<Kind, std::size_t> seen;
    plan.elements = 0;
    for (StepSolids& step : plan.steps) {
        keep(step, [&](ElementId element) {
            const Kind kind = kindOf(step, element);
            const std::size_t stride = (counts[kind] + share - 1) / share;
            return seen[kind]++ % stride == 0;
        });
        plan.elements += step.elements.size();
    }
}

}  // namespace app
