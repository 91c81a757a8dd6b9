#include "model/clearance/annular_ring.h"

#include <algorithm>
#include <tuple>

#include "model/base/parallel.h"
#include "model/clearance/layer_geometry.h"

namespace model {

namespace {

/// Larger is better for the hole.
auto rankOf(const Document& document, const AnnularRing& ring) {
    const bool isPad = ring.pad.isValid() && (document.elements.flags[ring.pad.row()] & kPad) != 0;
    int rank = 0;
    switch (ring.ring.state) {
        case RingState::Apart: break;
        case RingState::BreaksOut: rank = isPad ? 3 : 1; break;
        case RingState::Removed: rank = 2; break;
        case RingState::Around: rank = 4; break;
    }
    return std::tuple(rank, ring.ring.width.distance);
}

bool mayBelong(const Document& document, ElementId hole, ElementId copper) {
    const NetId ofHole = document.elements.net[hole.row()];
    const NetId ofCopper = document.elements.net[copper.row()];
    return ofHole == ofCopper || !ofHole.isValid() || !ofCopper.isValid();
}

AnnularRing ringOf(const Document& document, const LayerGeometry& copper, ElementId hole, double below) {
    FigureTable figures;
    figures.add(document, hole);
    AnnularRing best{hole, {}, {}};
    copper.visitNear(document.boxOf(hole), 0.0, [&](std::uint32_t row) {
        const ElementId element = copper.elementOf(row);
        if (mayBelong(document, hole, element)) {
            const AnnularRing found{hole, element, ringAround(figures, copper.figures(), row, below)};
            const bool isBetter = rankOf(document, found) > rankOf(document, best);
            best = found.ring.state != RingState::Apart && isBetter ? found : best;
        }
    });
    return best;
}

std::vector<ElementId> holesThrough(const Document& document, LayerId layer) {
    std::vector<ElementId> holes;
    for (const Layer& drill : document.layers) {
        const Range range = drill.spans(layer) ? drill.elements : Range{};
        for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
            const ElementId hole{i};
            if (isPlatedHole(document.elements.flags[i]) && document.platedSpanOf(hole).joins(layer) &&
                !hasNoSize(document, hole)) {
                holes.push_back(hole);
            }
        }
    }
    return holes;
}

}  // namespace

std::vector<AnnularRing> annularRings(const Document& document, LayerId layer, double below) {
    const LayerGeometry copper = layerGeometry(document, layer);
    const std::vector<ElementId> holes = holesThrough(document, layer);
    std::vector<AnnularRing> rings(holes.size());
    base::parallelFor(holes.size(), [&](std::size_t i) { rings[i] = ringOf(document, copper, holes[i], below); });
    return rings;
}

}  // namespace model
