#include "model/solids/slabs.h"

#include <algorithm>
#include <set>

namespace model {

namespace {

struct Heights {
    Nm bottom = 0;
    Nm top = 0;
};

Nm upperFace(const Layer& layer) {
    return layer.z + layer.thickness;
}

bool isStack(const Layer& layer) {
    return layer.context == LayerContext::Board && (layer.isCopper() || layer.type == LayerType::Dielectric);
}

bool hasOutline(const Layer& layer, LayerOutlines outlines) {
    return outlines == LayerOutlines::Follow && isStack(layer) && layer.profile.isValid();
}

bool isHoles(const Layer& layer) {
    return layer.type == LayerType::Drill || layer.type == LayerType::Rout;
}

Heights bodyHeights(const Document& document) {
    const Layer* lowest = nullptr;
    const Layer* highest = nullptr;
    for (const Layer& layer : document.layers) {
        if (!layer.isCopper() || layer.context != LayerContext::Board) {
            continue;
        }
        lowest = lowest == nullptr || layer.z < lowest->z ? &layer : lowest;
        highest = highest == nullptr || layer.z > highest->z ? &layer : highest;
    }
    if (lowest == nullptr) {
        return {0, document.boardThickness};
    }
    if (lowest == highest) {
        return {highest->z - document.boardThickness, highest->z};
    }
    return {upperFace(*lowest), highest->z};
}

/// Heights at which something about the laminate changes, rising.
std::set<Nm> planesOf(const Document& document, const Heights& body, LayerOutlines outlines) {
    std::set<Nm> planes{body.bottom, body.top};
    for (const Layer& layer : document.layers) {
        if (isHoles(layer) || hasOutline(layer, outlines)) {
            planes.insert(std::clamp(layer.z, body.bottom, body.top));
            planes.insert(std::clamp(upperFace(layer), body.bottom, body.top));
        }
    }
    return planes;
}

Slab slabBetween(const Document& document, Nm bottom, Nm top, LayerOutlines outlines) {
    Slab slab{bottom, top, document.profile, {}};
    for (std::size_t row = 0; row < document.layers.size(); ++row) {
        const Layer& layer = document.layers[row];
        if (layer.z > bottom || upperFace(layer) < top) {
            continue;
        }
        if (isHoles(layer)) {
            slab.holes.emplace_back(row);
        } else if (hasOutline(layer, outlines)) {
            slab.outline = layer.profile;
        }
    }
    return slab;
}

}  // namespace

std::vector<Slab> slabsOf(const Document& document, LayerOutlines outlines) {
    std::vector<Slab> slabs;
    const Heights body = bodyHeights(document);
    if (body.top <= body.bottom) {
        return slabs;
    }
    const std::set<Nm> planes = planesOf(document, body, outlines);
    for (auto top = planes.rbegin(), bottom = std::next(top); bottom != planes.rend(); top = bottom++) {
        Slab slab = slabBetween(document, *bottom, *top, outlines);
        if (!slabs.empty() && slabs.back().isLike(slab)) {
            slabs.back().bottom = slab.bottom;
        } else {
            slabs.push_back(std::move(slab));
        }
    }
    return slabs;
}

}  // namespace model
