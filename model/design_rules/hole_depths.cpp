#include "model/design_rules/hole_depths.h"

#include <algorithm>

#include "model/board/laser_via.h"
#include "model/board/local_stack.h"
#include "model/geometry/region.h"
#include "model/solids/region_distance.h"

namespace model {

HoleDepths::HoleDepths(const Document& document)
    : m_document(document),
      m_isEven(std::ranges::none_of(document.layers, [](const Layer& layer) { return layer.profile.isValid(); })) {}

std::optional<Nm> HoleDepths::of(ElementId hole) {
    const Layer& drill = m_document.layer(m_document.elements.layer[hole.row()]);
    if (!drill.spanTop.isValid() || !drill.spanBottom.isValid() || drill.thickness <= 0) {
        return std::nullopt;
    }
    const LayerId target = targetOf(m_document, hole);
    const Nm kept = target.isValid() ? m_document.layer(target).thickness : 0;
    const std::vector<StackupRow>& rows = m_document.stackup.rows;
    if (rows.empty()) {  // the job states heights themselves
        return drill.thickness - kept;
    }
    std::vector<bool> isDrilled = rowsAt(m_document.boxOf(hole).middle());
    Nm depth = 0;
    for (std::size_t row = 0; row < rows.size(); ++row) {
        isDrilled[row] = isDrilled[row] && isPassed(rows[row], {drill.z, drill.z + drill.thickness});
        depth += isDrilled[row] ? rows[row].thickness : 0;
    }
    return isKnown(isDrilled) && depth > kept ? std::optional(depth - kept) : std::nullopt;
}

bool HoleDepths::isPassed(const StackupRow& row, const ZRange& heights) const {
    const bool isWithinHeights = heights.bottom <= row.z && row.z + row.thickness <= heights.top;
    if (!row.layer.isValid()) {
        return isWithinHeights;
    }
    const Layer& layer = m_document.layer(row.layer);
    return isWithinHeights && !isLaidOn(layer) && (layer.isBoardCopper() || layer.type == LayerType::Dielectric);
}

/// An even share says nothing of one dielectric, and all shares together say what the job does.
bool HoleDepths::isKnown(const std::vector<bool>& isDrilled) const {
    bool hasShare = false;
    bool lacksShare = false;
    for (std::size_t row = 0; row < isDrilled.size(); ++row) {
        const StackupRow& own = m_document.stackup.rows[row];
        if (own.type != LayerType::Dielectric) {
            continue;
        }
        if (isDrilled[row] && own.source == Source::Assumed) {
            return false;
        }
        hasShare = hasShare || (isDrilled[row] && own.source == Source::Derived);
        lacksShare = lacksShare || (!isDrilled[row] && own.source == Source::Derived);
    }
    return !(hasShare && lacksShare);
}

std::vector<bool> HoleDepths::rowsAt(Point middle) {
    if (m_isEven) {
        return std::vector<bool>(m_document.stackup.rows.size(), true);
    }
    return rowsWhere(m_document, [&](LayerId id) {
        const ShapeId own = m_document.layer(id).profile;
        return !own.isValid() || isWithin(own, middle);
    });
}

bool HoleDepths::isWithin(ShapeId shape, Point location) {
    const auto [outline, isNew] = m_outlines.try_emplace(shape);
    if (isNew) {
        outline->second = discretise(m_document.shapes, shape, kBooleanChords);
    }
    return contains(outline->second, outline->second.polygons, location);
}

}  // namespace model
