#include "model/solids/substrates.h"

#include <algorithm>
#include <set>

#include "model/board/board_heights.h"
#include "model/board/holes.h"

namespace model {

namespace {

Nm upperFace(const Layer& layer) {
    return layer.z + layer.thickness;
}

bool isStackupLayer(const Layer& layer) {
    return layer.context == LayerContext::Board && (layer.isCopper() || layer.type == LayerType::Dielectric);
}

/// Rigid-flex: layers are only where their zones have them.
bool hasOutlines(const Document& document) {
    return std::ranges::any_of(document.layers, [](const Layer& layer) { return layer.outlineGroup > 0; });
}

/// Heights at which something about the substrate changes, rising.
std::set<Nm> planesOf(const Document& document, const ZRange& body) {
    const bool isByLayer = hasOutlines(document);
    std::set<Nm> planes{body.bottom, body.top};
    for (const Layer& layer : document.layers) {
        if (isHoles(layer.type) || (isByLayer && isStackupLayer(layer))) {
            planes.insert(std::clamp(layer.z, body.bottom, body.top));
            planes.insert(std::clamp(upperFace(layer), body.bottom, body.top));
        }
    }
    return planes;
}

/// What lies between two heights: a layer of the stackup, or else what lies above and below it.
struct Neighbours {
    const Layer* here = nullptr;
    const Layer* above = nullptr;
    const Layer* below = nullptr;
};

Neighbours neighboursOf(const Document& document, Nm bottom, Nm top) {
    Neighbours found;
    for (const Layer& layer : document.layers) {
        if (!isStackupLayer(layer)) {
            continue;
        }
        if (layer.z <= bottom && upperFace(layer) >= top) {
            found.here = &layer;
        } else if (layer.z >= top) {
            found.above = found.above == nullptr || layer.z < found.above->z ? &layer : found.above;
        } else if (upperFace(layer) <= bottom) {
            found.below = found.below == nullptr || layer.z > found.below->z ? &layer : found.below;
        }
    }
    return found;
}

/// The layers that must all be at a location for the substrate to be there.
std::vector<const Layer*> bounding(const Neighbours& neighbours) {
    const Layer* here = neighbours.here;
    if (here != nullptr && !here->isCopper()) {
        return {here};
    }
    std::vector<const Layer*> layers;
    for (const Layer* layer : {neighbours.above, neighbours.below}) {
        if (layer != nullptr) {
            layers.push_back(layer);
        }
        // A dielectric that is no layer is only where the copper on both sides of it is.
        if (here != nullptr && (layer == nullptr || layer->isCopper())) {
            layers.push_back(here);
        }
    }
    return layers;
}

bool isWithin(const Document& document, ShapeId inner, ShapeId outer) {
    const Box& a = document.shapes.shapes[inner.row()].box;
    const Box& b = document.shapes.shapes[outer.row()].box;
    return a.min.x >= b.min.x && a.min.y >= b.min.y && a.max.x <= b.max.x && a.max.y <= b.max.y;
}

void setOutlines(const Document& document, SubstratePart& part) {
    const Neighbours neighbours = neighboursOf(document, part.bottom, part.top);
    std::set<std::uint32_t> groups;
    std::set<ShapeId> outlines;
    for (const Layer* layer : bounding(neighbours)) {
        groups.insert(layer->outlineGroup);
        const ShapeId own = layer->profile;
        // What joins two layers and is none itself is not widened by an outline that reaches beyond the board's.
        const bool isBoards = !own.isValid() || (neighbours.here == nullptr && document.profile.isValid() &&
                                                 !isWithin(document, own, document.profile));
        outlines.insert(isBoards ? document.profile : own);
    }
    if (outlines.empty()) {
        outlines.insert(document.profile);
    }
    groups.erase(0);
    outlines.erase(ShapeId{});
    part.outlineGroups.assign(groups.begin(), groups.end());
    part.outlines.assign(outlines.begin(), outlines.end());
}

SubstratePart partBetween(const Document& document, Nm bottom, Nm top) {
    SubstratePart part;
    part.bottom = bottom;
    part.top = top;
    setOutlines(document, part);
    for (std::size_t row = 0; row < document.layers.size(); ++row) {
        const Layer& layer = document.layers[row];
        if (isHoles(layer.type) && layer.z <= bottom && upperFace(layer) >= top) {
            part.holes.emplace_back(row);
        }
    }
    return part;
}

/// Follows a stackup down, slice by slice, and says where one dielectric ends and the next begins. What lies beside
/// copper goes with the dielectric above it; at the top of a part, with the one below.
class Slabs {
public:
    explicit Slabs(const Document& document) : m_document(document) {}

    /// Whether the next slice goes with the ones before; `isLike`: for all else it does.
    [[nodiscard]] bool continuesWith(const SubstratePart& slice, bool isLike) {
        const Layer* here = neighboursOf(m_document, slice.bottom, slice.top).here;
        const bool isCopper = here != nullptr && here->isCopper();
        const bool isAnother = !isCopper && m_hasDielectric && (m_isEnded || here != m_dielectric);
        const bool continues = isLike && !isAnother;
        m_hasDielectric = !isCopper || (continues && m_hasDielectric);
        m_isEnded = isCopper;
        m_dielectric = isCopper ? m_dielectric : here;
        return continues;
    }

private:
    const Document& m_document;
    const Layer* m_dielectric = nullptr;  ///< the last one; null: no row of the job
    bool m_hasDielectric = false;         ///< the part so far is not beside copper only
    bool m_isEnded = false;               ///< copper was the last
};

}  // namespace

std::vector<SubstratePart> substratesOf(const Document& document) {
    std::vector<SubstratePart> parts;
    const ZRange body = substrateHeights(document);
    if (body.top <= body.bottom) {
        return parts;
    }
    const std::set<Nm> planes = planesOf(document, body);
    const bool isByLayer = hasOutlines(document);
    Slabs slabs(document);
    for (auto top = planes.rbegin(), bottom = std::next(top); bottom != planes.rend(); top = bottom++) {
        SubstratePart part = partBetween(document, *bottom, *top);
        const bool isLike = !parts.empty() && parts.back().isLike(part);
        if (isByLayer ? slabs.continuesWith(part, isLike) : isLike) {
            parts.back().bottom = part.bottom;
            // A dielectric is where it is, also beyond what bounds the copper beside it.
            if (part.outlines.size() < parts.back().outlines.size()) {
                parts.back().outlines = std::move(part.outlines);
            }
        } else {
            parts.push_back(std::move(part));
        }
    }
    return parts;
}

}  // namespace model
