#include "model/board/laser_via.h"

#include <algorithm>
#include <functional>

#include "model/board/holes.h"

namespace model {

namespace {

std::ptrdiff_t copperBetween(const Document& document, std::size_t first, std::size_t end) {
    const auto at = [&](std::size_t row) { return document.layers.begin() + static_cast<std::ptrdiff_t>(row); };
    return first < end ? std::count_if(at(first), at(end), std::mem_fn(&Layer::isBoardCopper)) : 0;
}

}  // namespace

LayerId targetOf(const Document& document, ElementId hole) {
    const Layer& layer = document.layer(document.elements.layer[hole.row()]);
    const bool isRound = document.elements.kind[hole.row()] == ElementKind::Circle;
    if (!isRound || !isPlatedHole(document.elements.flags[hole.row()]) || !layer.spanTop.isValid() ||
        !layer.spanBottom.isValid() || layer.spanTop == layer.spanBottom) {
        return {};
    }
    const std::size_t top = layer.spanTop.row();
    const std::size_t bottom = layer.spanBottom.row();
    const std::ptrdiff_t above = copperBetween(document, 0, top);
    const std::ptrdiff_t below = copperBetween(document, bottom + 1, document.layers.size());
    const bool isBetweenNeighbours = copperBetween(document, top + 1, bottom) == 0 && above + below > 0;
    if (!isBetweenNeighbours || spanOf(document, hole) != HoleSpan::Micro) {
        return {};
    }
    return above > below ? layer.spanTop : layer.spanBottom;
}

}  // namespace model
