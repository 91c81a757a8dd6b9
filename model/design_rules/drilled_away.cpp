#include "model/design_rules/drilled_away.h"

#include "model/clearance/layer_geometry.h"
#include "model/clearance/ring_width.h"

namespace model {

namespace {

bool isTakenBy(const Document& document, ElementId hole, ElementId copper) {
    FigureTable drill;
    drill.add(document, hole);
    FigureTable figures;
    figures.add(document, copper);
    for (std::size_t row = 0; row < figures.size(); ++row) {
        if (ringAround(drill, figures, row, 0.0).state != RingState::Removed) {
            return false;
        }
    }
    return figures.size() > 0;
}

void markLayer(const Document& document, LayerId layer, std::vector<bool>& isAway) {
    const LayerGeometry copper = layerGeometry(document, layer);
    const LayerGeometry holes = holeGeometry(document, layer);
    for (std::size_t hole = 0; hole < holes.size(); ++hole) {
        if (isPlatedHole(document.elements.flags[holes.elementOf(hole).row()])) {
            continue;
        }
        const Box reach = holes.figures().box(hole).grownBy(1);
        copper.visitNear(reach, 0.0, [&](std::uint32_t row) {
            const ElementId element = copper.elementOf(row);
            const Box& box = copper.figures().box(row);
            if (reach.holds(box.min) && reach.holds(box.max) && !isAway[element.row()]) {
                isAway[element.row()] = isTakenBy(document, holes.elementOf(hole), element);
            }
        });
    }
}

}  // namespace

std::vector<bool> drilledAway(const Document& document) {
    std::vector<bool> isAway(document.elements.size());
    for (std::size_t row = 0; row < document.layers.size(); ++row) {
        if (document.layers[row].isCopper()) {
            markLayer(document, LayerId{row}, isAway);
        }
    }
    return isAway;
}

}  // namespace model
