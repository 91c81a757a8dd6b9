#include "model/clearance/annular_ring.h"

#include <algorithm>
#include <tuple>

#include "model/base/parallel.h"
#include "model/clearance/layer_geometry.h"
#include "model/figures/distance.h"

namespace model {

namespace {

/// Also a pad that the job draws as an area.
bool isPad(const Document& document, ElementId copper) {
    const SubnetId subnet = document.elements.subnet[copper.row()];
    return (document.elements.flags[copper.row()] & kPad) != 0 ||
           (subnet.isValid() && document.subnets[subnet.row()].kind == SubnetKind::PinPads);
}

/// Larger is better for the hole.
auto rankOf(const AnnularRing& ring) {
    int rank = 0;
    switch (ring.ring.state) {
        case RingState::Apart: break;
        case RingState::BreaksOut: rank = ring.isOfPads ? 3 : 1; break;
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

/// Is it a pad of this hole, and not one beside that the hole happens to cut into?
bool isPadOf(const Document& document, const LayerGeometry& copper, std::uint32_t row, const AnnularRing& ring) {
    const Point middle = document.boxOf(ring.hole).middle();
    const Box& box = copper.figures().box(row);
    const bool isMiddleIn =
        box.min.x <= middle.x && middle.x <= box.max.x && box.min.y <= middle.y && middle.y <= box.max.y;
    return ring.isOfPads &&
           (ring.ring.state == RingState::Around || (ring.ring.state == RingState::BreaksOut && isMiddleIn));
}

AnnularRing ringOf(const Document& document, const LayerGeometry& copper, ElementId hole, double below) {
    FigureTable figures;
    figures.add(document, hole);
    AnnularRing best{hole, {}, {}};
    AnnularRing ofPads{hole, {}, {}, true};
    std::vector<std::uint32_t> pads;
    copper.visitNear(document.boxOf(hole), 0.0, [&](std::uint32_t row) {
        const ElementId element = copper.elementOf(row);
        if (mayBelong(document, hole, element)) {
            const AnnularRing found{hole, element, ringAround(figures, copper.figures(), row, below),
                                    isPad(document, element)};
            const auto keepBetter = [&](AnnularRing& kept) { kept = rankOf(found) > rankOf(kept) ? found : kept; };
            if (found.ring.state != RingState::Apart) {
                keepBetter(best);
            }
            if (isPadOf(document, copper, row, found)) {
                pads.push_back(row);
                keepBetter(ofPads);
            }
        }
    });
    if (pads.size() > 1) {
        std::ranges::sort(pads);
        const RingWidth together = ringAround(figures, copper.figures(), pads, below);
        const bool isMore =
            together.state > ofPads.ring.state || together.width.distance > ofPads.ring.width.distance + kTouchNm;
        ofPads.ring = isMore ? together : ofPads.ring;  // of a ring as wide all around, the location stays
    }
    return pads.empty() ? best : ofPads;
}

/// Those whose barrels join the layer.
std::vector<ElementId> platedHolesOf(const Document& document, LayerId layer) {
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

std::vector<AnnularRing> ringsOf(const Document& document, const LayerGeometry& copper,
                                 std::span<const ElementId> holes, double below) {
    std::vector<AnnularRing> rings(holes.size());
    base::parallelFor(holes.size(), [&](std::size_t i) { rings[i] = ringOf(document, copper, holes[i], below); });
    return rings;
}

/// The copper of the layer that may be at one of the holes.
LayerGeometry copperAt(const Document& document, LayerId layer, std::span<const ElementId> holes) {
    constexpr Nm kRounding = 1'000;  ///< more than boxes of elements and of their figures may differ by
    std::vector<Box> boxes;
    boxes.reserve(holes.size());
    for (const ElementId hole : holes) {
        boxes.push_back(document.boxOf(hole).grownBy(kRounding));
    }
    const BoxIndex index(boxes);
    return layerGeometry(document, layer, [&](ElementId element) {
        bool isAtHole = false;
        index.visit(document.boxOf(element), [&isAtHole](std::uint32_t) { isAtHole = true; });
        return isAtHole;
    });
}

}  // namespace

std::vector<AnnularRing> annularRings(const Document& document, LayerId layer, double below) {
    return ringsOf(document, layerGeometry(document, layer), platedHolesOf(document, layer), below);
}

std::vector<AnnularRing> annularRings(const Document& document, LayerId layer, std::span<const ElementId> holes,
                                      double below) {
    return ringsOf(document, copperAt(document, layer, holes), holes, below);
}

}  // namespace model
