#include "model/session/saved_selection.h"

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

namespace model::session {

namespace {

LayerId layerOf(const Document& step, const StepCopy& copy, ElementId element) {
    return step.layerOfCopy(step.elements.layer[element.row()], copy.isFlipped);
}

/// Layer row, kind and box: steps of one board share its layers.
using Key = std::tuple<std::size_t, ElementKind, Nm, Nm, Nm, Nm>;

Key keyOf(std::size_t layer, ElementKind kind, const Box& box) {
    return {layer, kind, box.min.x, box.min.y, box.max.x, box.max.y};
}

/// How often each is wanted; elements of layers that the board does not have are counted as missing.
std::map<Key, std::size_t> wantedOf(const Document& board, const SavedSelection& saved, std::size_t& missing) {
    std::map<Key, std::size_t> wanted;
    for (const SavedElement& element : saved.elements) {
        const auto layer = std::ranges::find(board.layers, element.layer, &Layer::name);
        if (layer == board.layers.end()) {
            ++missing;
        } else {
            ++wanted[keyOf(static_cast<std::size_t>(layer - board.layers.begin()), element.kind, element.box)];
        }
    }
    return wanted;
}

/// Of others the box need not be found.
bool isAnyWanted(const std::map<Key, std::size_t>& wanted, std::size_t layer, ElementKind kind) {
    constexpr Nm kLeast = std::numeric_limits<Nm>::min();
    const auto first = wanted.lower_bound({layer, kind, kLeast, kLeast, kLeast, kLeast});
    return first != wanted.end() && std::get<0>(first->first) == layer && std::get<1>(first->first) == kind;
}

void addElements(const StepTree& board, const SavedSelection& saved, FoundSelection& found) {
    std::map<Key, std::size_t> wanted = wantedOf(*board.steps.front(), saved, found.missingElements);
    if (wanted.empty()) {
        return;
    }
    for (std::uint32_t row = 0; row < board.copies.size(); ++row) {
        const StepCopy& copy = board.copies[row];
        const Document& step = *board.steps[copy.step];
        for (std::uint32_t i = 0; i < step.elements.size(); ++i) {
            const ElementId element{i};
            const std::size_t layer = layerOf(step, copy, element).row();
            const ElementKind kind = step.elements.kind[i];
            const auto at = isAnyWanted(wanted, layer, kind)
                                ? wanted.find(keyOf(layer, kind, copy.placement.boxOf(step.boxOf(element))))
                                : wanted.end();
            if (at != wanted.end() && at->second > 0) {
                --at->second;
                found.elements.push_back({row, element});
            }
        }
    }
    for (const auto& [key, left] : wanted) {
        found.missingElements += left;
    }
}

void addNets(const StepTree& board, const SavedSelection& saved, FoundSelection& found) {
    for (const NetName& net : saved.nets) {
        const auto step =
            std::ranges::find_if(board.steps, [&](const Document* each) { return each->job.step == net.step; });
        const NetId id = step == board.steps.end() ? NetId{} : (*step)->findNet(net.name);
        if (id.isValid()) {
            found.nets.push_back({static_cast<std::uint32_t>(step - board.steps.begin()), id});
        } else {
            found.missingNets.push_back(net.name);
        }
    }
    std::ranges::sort(found.nets);
}

}  // namespace

SavedSelection saveSelection(const StepTree& board, std::span<const BoardElement> elements,
                             std::span<const BoardNet> nets) {
    SavedSelection saved;
    for (const BoardElement& at : elements) {
        const StepCopy& copy = board.copies[at.copy];
        const Document& step = *board.steps[copy.step];
        saved.elements.push_back({step.layers[layerOf(step, copy, at.element).row()].name,
                                  step.elements.kind[at.element.row()], copy.placement.boxOf(step.boxOf(at.element))});
    }
    for (const BoardNet& net : nets) {
        const Document& step = *board.steps[net.step];
        saved.nets.push_back({step.job.step, step.nets[net.net.row()].name});
    }
    return saved;
}

FoundSelection findSelection(const StepTree& board, const SavedSelection& saved) {
    FoundSelection found;
    addElements(board, saved, found);
    addNets(board, saved, found);
    return found;
}

std::optional<ElementKind> kindOf(const std::string& word) {
    for (std::size_t row = 0; row < kElementKindCount; ++row) {
        if (word == toString(static_cast<ElementKind>(row))) {
            return static_cast<ElementKind>(row);
        }
    }
    return std::nullopt;
}

}  // namespace model::session
