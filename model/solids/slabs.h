#pragma once

#include <vector>

#include "model/document.h"

namespace model {

/// A part of the laminate that the same holes pass all the way.
struct Slab {
    Nm bottom = 0;
    Nm top = 0;
    ShapeId outline;
    std::vector<LayerId> holes;  ///< drill and rout layers, rising

    [[nodiscard]] bool isLike(const Slab& other) const { return outline == other.outline && holes == other.holes; }
};

/// Whether slabs keep to the outlines of single layers (rigid-flex). The steps of a panel have the same layers, ours
/// included, but each its own outlines: there slabs must not depend on them.
enum class LayerOutlines { Ignore, Follow };

/// The laminate from the top. It reaches from the upper face of the lowest to the lower face of the highest copper
/// layer (of a board with one copper layer: the board's thickness below it) and is cut where a hole layer ends and
/// where a layer with an outline of its own begins or ends; slabs that are alike are one. Depends on the layers only,
/// not on what is on them.
[[nodiscard]] std::vector<Slab> slabsOf(const Document& document, LayerOutlines outlines);

}  // namespace model
