#pragma once

#include <cstdint>
#include <vector>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/board/document.h"

namespace model {

/// Which net copper belongs to, on all layers at once. Copper without a net (text, shapes, teardrops, unconnected pads)
/// belongs to the net that it touches, directly or by more such copper and plated holes, of several to the lowest row;
/// what touches none is an island that belongs to itself.
class CopperOwners {
public:
    /// One search for all that touches, and none where all copper has a net. Errors: Cancelled.
    [[nodiscard]] static base::Result<CopperOwners> of(const Document& document, base::Progress& progress);

    /// Equal for two elements that belong together.
    [[nodiscard]] std::uint32_t of(ElementId element) const { return m_owner[element.row()]; }
    /// None for an island.
    [[nodiscard]] NetId netOf(ElementId element) const {
        const std::uint32_t owner = of(element);
        return owner < m_netCount ? NetId{owner} : NetId{};
    }

private:
    std::uint32_t m_netCount = 0;
    std::vector<std::uint32_t> m_owner;  ///< by element: a net's row, or from m_netCount on an island
};

}  // namespace model
