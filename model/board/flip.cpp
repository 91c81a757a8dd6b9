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

/// How many faces of copper lie above the upper face of something, and below its lower one.
struct CopperFaces {
    std::ptrdiff_t above = 0;
    std::ptrdiff_t below = 0;
};

CopperFaces facesBeside(const std::vector<Layer>& layers, const Layer& part) {
    CopperFaces faces;
    for (const Layer& layer : layers) {
        for (const Nm face : {layer.z, layer.z + layer.thickness}) {
            faces.above += layer.isBoardCopper() && face > part.z + part.thickness ? 1 : 0;
            faces.below += layer.isBoardCopper() && face < part.z ? 1 : 0;
        }
    }
    return faces;
}

void pairSubstrate(std::vector<Layer>& layers) {
    const std::vector<std::size_t> parts =
        rowsWhere(layers, [](const Layer& layer) { return layer.type == LayerType::Body && layer.isSynthetic; });
    for (std::size_t i = 0; i < parts.size(); ++i) {
        const CopperFaces one = facesBeside(layers, layers[parts[i]]);
        const CopperFaces other = facesBeside(layers, layers[parts[parts.size() - 1 - i]]);
        if (one.above != other.below || one.below != other.above) {
            return;
        }
    }
    pairWithReverse(layers, parts);
}

/// The synthetic layer of the same type on the other side that belongs to the mirror image of what `layer` belongs to:
/// the openings of a solder mask, what bodies stand on (none: what is outermost).
LayerId mirroredFilm(const std::vector<Layer>& layers, const Layer& layer) {
    const LayerId openings = oppositeOf(layers, layer.openings);
    const LayerId floor = oppositeOf(layers, layer.spanTop);
    if (openings.isValid() != layer.openings.isValid() || floor.isValid() != layer.spanTop.isValid()) {
        return {};
    }
    const auto found = std::ranges::find_if(layers, [&](const Layer& other) {
        return other.isSynthetic && other.type == layer.type && other.side != layer.side &&
               other.openings == openings && other.spanTop == floor;
    });
    return found == layers.end() ? LayerId{} : LayerId{static_cast<std::size_t>(found - layers.begin())};
}

}  // namespace

void setOpposites(std::vector<Layer>& layers) {
    const std::vector<std::size_t> copper = rowsWhere(layers, [](const Layer& layer) { return layer.isCopper(); });
    if (copper.size() > 1) {
        pairWithReverse(layers, copper);
    }
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

void setSyntheticOpposites(std::vector<Layer>& layers) {
    pairSubstrate(layers);
    for (Layer& layer : layers) {
        if (layer.isSynthetic && (layer.type == LayerType::SolderMask || layer.type == LayerType::ComponentBody)) {
            layer.opposite = mirroredFilm(layers, layer);
        }
    }
}

}  // namespace model
