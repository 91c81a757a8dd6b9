#pragma once

#include <vector>

#include "model/figures/figures.h"
#include "model/geometry/box_index.h"

namespace model {

/// The round holes without plating of a document, as what cuts tracks in two: a hole that a track passes beneath from
/// side to side leaves two parts of it, apart from each other. Document must outlive it.
///
/// A part ends round where its middle line meets the hole, so that it reaches a little into the hole but not to the
/// next part. Slots, and areas that holes cut in two, are left out of account.
class SeveringHoles {
public:
    explicit SeveringHoles(const Document& document);

    /// Adds the figures of an element as FigureTable::add does; a track that holes sever, in its parts.
    void addTo(FigureTable& table, ElementId element, const Placement& placement = {}) const;

private:
    /// What a hole takes of a middle line: from and to, as lengths along it.
    struct Cut {
        double from = 0.0;
        double to = 0.0;
    };
    struct Hole {
        Edge outline;  ///< a full circle
        LayerId drill;
    };

    [[nodiscard]] std::vector<std::vector<Edge>> partsOf(ElementId element) const;
    [[nodiscard]] std::vector<Cut> cutsOf(const Edge& edge, LayerId layer) const;

    const Document& m_document;
    std::vector<Hole> m_holes;
    BoxIndex m_index;
};

}  // namespace model
