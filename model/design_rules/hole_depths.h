#pragma once

#include <map>
#include <optional>

#include "model/board/document.h"
#include "model/geometry/discretise.h"

namespace model {

/// How deep holes are drilled, from face to face of the copper that their drill passes: as deep as they are plated,
/// before a back-drill takes some of it. A laser via ends on the near face of its target. On a rigid-flex board what is
/// missing where the hole lies does not count. Not thread-safe.
class HoleDepths {
public:
    /// The document must outlive it.
    explicit HoleDepths(const Document& document);

    /// nm. None where nobody knows: the drill has no span, or a dielectric that it passes has a thickness that is
    /// assumed, or an even share of the board's while the drill does not pass all that have one.
    [[nodiscard]] std::optional<Nm> of(ElementId hole);

private:
    /// Copper or a dielectric between copper, within these heights?
    [[nodiscard]] bool isPassed(const StackupRow& row, const ZRange& heights) const;
    [[nodiscard]] bool isKnown(const std::vector<bool>& isDrilled) const;
    /// By row of the stackup: is it where the hole lies?
    [[nodiscard]] std::vector<bool> rowsAt(Point middle);
    [[nodiscard]] bool isWithin(ShapeId shape, Point location);

    const Document& m_document;
    bool m_isEven = true;  ///< all layers are everywhere
    std::map<ShapeId, PolygonSet> m_outlines;
};

}  // namespace model
