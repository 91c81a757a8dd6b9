#pragma once

#include <vector>

#include "model/board/document.h"
#include "model/geometry/box_index.h"

namespace model {

/// Finds elements of a step near a location, on all of its layers or on one of them. Reading is safe from every thread.
class ElementIndex {
public:
    /// `boxes` by element of the step.
    ElementIndex(const Document& step, std::span<const Box> boxes);

    /// Calls `visit(row of an ElementId)` for every element whose box shares a point with `box`, layer by layer.
    void visit(const Box& box, const std::function<void(std::uint32_t)>& visit) const;
    /// The same for those of one layer of the step.
    void visit(LayerId layer, const Box& box, const std::function<void(std::uint32_t)>& visit) const;

private:
    struct OfLayer {
        std::uint32_t first = 0;  ///< element
        BoxIndex boxes;
    };
    static void visitIn(const OfLayer& layer, const Box& box, const std::function<void(std::uint32_t)>& visit);

    std::vector<OfLayer> m_layers;
};

}  // namespace model
