#include "model/index/joined_pads.h"

#include <algorithm>

#include "model/figures/distance.h"

namespace model {

namespace {

/// What touches an element of a step and is of its net, if `isWanted`.
template <class IsWanted>
std::vector<ElementId> touching(const BoardIndex& index, std::uint32_t stepRow, ElementId element,
                                const IsWanted& isWanted) {
    const Document& step = *index.tree.steps[stepRow];
    const auto figures = index.figuresOf(stepRow, element);
    std::vector<ElementId> found;
    index.elements[stepRow].visit(step.boxOf(element), [&](std::uint32_t row) {
        const ElementId other{row};
        if (step.elements.net[row] == step.elements.net[element.row()] && isWanted(other) &&
            spacingBetween(*figures, *index.figuresOf(stepRow, other), kTouchNm)) {
            found.push_back(other);
        }
    });
    return found;
}

}  // namespace

std::vector<BoardElement> joinedPads(const BoardIndex& index, BoardElement pad) {
    const std::uint32_t stepRow = index.tree.copies[pad.copy].step;
    const Document& step = *index.tree.steps[stepRow];
    const auto isPad = [&](ElementId element) {
        return (step.elements.flags[element.row()] & kPad) != 0 &&
               step.layer(step.elements.layer[element.row()]).isCopper();
    };
    std::vector<BoardElement> pads{pad};
    if (!isPad(pad.element)) {
        return pads;
    }
    // A hole passes the layers between its ends.
    const auto isPassed = [&](ElementId hole, ElementId element) {
        return step.layer(step.elements.layer[hole.row()]).spans(step.elements.layer[element.row()]);
    };
    const auto holes = touching(index, stepRow, pad.element, [&](ElementId element) {
        return isPlatedHole(step.elements.flags[element.row()]) && isPassed(element, pad.element);
    });
    for (const ElementId hole : holes) {
        for (const ElementId other : touching(
                 index, stepRow, hole, [&](ElementId element) { return isPad(element) && isPassed(hole, element); })) {
            pads.push_back({pad.copy, other});
        }
    }
    std::ranges::sort(pads);
    pads.erase(std::unique(pads.begin(), pads.end()), pads.end());
    return pads;
}

}  // namespace model
