#include "model/measure/hole_ring.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/clearance/ring_width.h"

namespace model {

namespace {

/// More than any ring within the box can be.
double beyondRingsIn(const Box& box) {
    const double sides = static_cast<double>(box.width()) + static_cast<double>(box.height());
    return std::min(sides, double{base::kMaxCoordinate} / 2);
}

bool isHole(const BoardIndex& index, BoardElement at) {
    return (index.stepOf(at.copy).elements.flags[at.element.row()] & kHole) != 0;
}

bool isOneHole(const BoardIndex& index, const Pieces& item) {
    return item.elements.size() == 1 && isHole(index, item.elements.front());
}

bool isOneCopper(const BoardIndex& index, const Pieces& item) {
    return item.elements.size() == 1 && !isHole(index, item.elements.front()) &&
           index.board->layer(layerOf(index, item.elements.front())).isCopper();
}

/// Copper of another net around a hole is a short, and no ring.
bool mayBelong(const BoardIndex& index, BoardElement hole, BoardElement copper) {
    const NetId ofHole = netOf(index, hole);
    const NetId ofCopper = netOf(index, copper);
    return !ofHole.isValid() || !ofCopper.isValid() || (ofHole == ofCopper && hole.copy == copper.copy);
}

std::optional<Spacing> ringOf(const BoardIndex& index, const Pieces& hole, const Pieces& copper) {
    const bool isPair = isOneHole(index, hole) && isOneCopper(index, copper) && !hole.pieces.empty() &&
                        !copper.pieces.empty() && hole.pieces.front().sharesLayerWith(copper.pieces.front()) &&
                        mayBelong(index, hole.elements.front(), copper.elements.front());
    return isPair ? annularRing(hole.figures, copper.figures) : std::nullopt;
}

}  // namespace

std::optional<Spacing> annularRing(const FigureTable& hole, const FigureTable& copper) {
    if (hole.size() == 0) {
        return std::nullopt;  // without a size
    }
    for (std::size_t row = 0; row < copper.size(); ++row) {
        const RingWidth ring = ringAround(hole, copper, row, beyondRingsIn(copper.box(row)));
        if (ring.state == RingState::Around && std::isfinite(ring.width.distance)) {
            return ring.width;
        }
    }
    return std::nullopt;
}

std::optional<Spacing> annularRing(const BoardIndex& index, const Pieces& a, const Pieces& b) {
    if (!isOneHole(index, b)) {
        return ringOf(index, a, b);
    }
    std::optional<Spacing> ring = ringOf(index, b, a);
    if (ring) {
        std::swap(ring->from, ring->to);
    }
    return ring;
}

std::optional<PadHole> holeInPad(const BoardIndex& index, BoardElement pad) {
    const std::uint32_t stepRow = index.tree.copies[pad.copy].step;
    const Document& step = *index.tree.steps[stepRow];
    const std::size_t padRow = pad.element.row();
    const LayerId layer = step.elements.layer[padRow];
    if ((step.elements.flags[padRow] & (kPad | kHole)) != kPad || !step.layer(layer).isCopper()) {
        return std::nullopt;
    }
    const Box box = step.boxOf(pad.element);
    std::vector<ElementId> holes;
    index.elements[stepRow].visit(box, [&](std::uint32_t row) {
        const ElementId hole{row};
        const bool isPlated = isPlatedHole(step.elements.flags[row]) && box.holds(step.boxOf(hole).middle());
        if (isPlated && mayBelong(index, {pad.copy, hole}, pad) && step.layer(step.elements.layer[row]).spans(layer) &&
            step.platedSpanOf(hole).joins(layer)) {
            holes.push_back(hole);
        }
    });
    if (holes.size() != 1) {
        return std::nullopt;
    }
    const auto figures = index.figuresOf(stepRow, holes.front());
    return PadHole{holes.front(), annularRing(*figures, *index.figuresOf(stepRow, pad.element))};
}

}  // namespace model
