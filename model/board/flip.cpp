#include "model/board/flip.h"

#include <algorithm>

#include "model/board/holes.h"

namespace model {

namespace {

/// Rows of the layers of the board for which `belongs` holds, from the top.
template <class Belongs>
std::vector<std::size_t> rowsWhere(const std::vector<Layer>& layers, Belongs belongs) {
    std::vector<std::size_t> rows;
    for (std::size_t row = 0; row < layers.size(); ++row) {
        if (layers[row].context == LayerContext::Board && belongs(layers[row])) {
            rows.push_back(row);
        }
    }
    return rows;
}

/// Pairs first with first, second with second; what is left over stays alone.
void pair(std::vector<Layer>& layers, const std::vector<std::size_t>& ones, const std::vector<std::size_t>& others) {
    for (std::size_t i = 0; i < std::min(ones.size(), others.size()); ++i) {
        layers[ones[i]].opposite = LayerId{others[i]};
        layers[others[i]].opposite = LayerId{ones[i]};
    }
}

void pairWithReverse(std::vector<Layer>& layers, const std::vector<std::size_t>& rows) {
    pair(layers, rows, {rows.rbegin(), rows.rend()});
}

void pairSides(std::vector<Layer>& layers, LayerType type) {
    const auto on = [type](LayerSide side) {
        return [type, side](const Layer& layer) { return layer.type == type && layer.side == side; };
    };
    std::vector<std::size_t> top = rowsWhere(layers, on(LayerSide::Top));
    std::ranges::reverse(top);  // from the board outwards, as those below it
    pair(layers, top, rowsWhere(layers, on(LayerSide::Bottom)));
}

LayerId oppositeOf(const std::vector<Layer>& layers, LayerId id) {
    return id.isValid() ? layers[id.row()].opposite : LayerId{};
}

/// The layer of holes of the same type that spans the mirror image of what `layer` spans.
LayerId mirroredSpan(const std::vector<Layer>& layers, std::size_t row) {
    const Layer& layer = layers[row];
    const LayerId top = oppositeOf(layers, layer.spanBottom);
    const LayerId bottom = oppositeOf(layers, layer.spanTop);
    const auto fits = [&](const Layer& other) {
        return other.type == layer.type && other.use == layer.use && other.spanTop == top && other.spanBottom == bottom;
    };
    if (fits(layer)) {
        return LayerId{row};
    }
    const auto found = std::ranges::find_if(layers, fits);
    return found == layers.end() ? LayerId{} : LayerId{static_cast<std::size_t>(found - layers.begin())};
}

}  // namespace

void setOpposites(std::vector<Layer>& layers) {
    pairWithReverse(layers, rowsWhere(layers, [](const Layer& layer) { return layer.isCopper(); }));
    pairWithReverse(layers, rowsWhere(layers, [](const Layer& layer) {
                        return layer.type == LayerType::Dielectric && layer.side == LayerSide::Inner;
                    }));
    for (const LayerType type :
         {LayerType::Dielectric, LayerType::SolderMask, LayerType::SolderPaste, LayerType::SilkScreen, LayerType::Mask,
          LayerType::ConductivePaste, LayerType::Component}) {
        pairSides(layers, type);
    }
    for (std::size_t row = 0; row < layers.size(); ++row) {
        if (isHoles(layers[row].type)) {
            layers[row].opposite = mirroredSpan(layers, row);
        }
    }
}

}  // namespace model
