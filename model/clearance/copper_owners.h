#pragma once

#include <cstdint>
#include <vector>

#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/nets/net_ties.h"

namespace model {

/// Which net copper belongs to, on all layers at once. Copper without a net (text, shapes, teardrops, unconnected pads)
/// belongs to the net that it touches, directly or by more such copper and plated holes, of several to the lowest row;
/// what touches none is an island that belongs to itself.
class CopperOwners {
public:
    CopperOwners(const Document& document, const Connectivity& connectivity);

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

/// What tells whether two elements have to keep a clearance.
struct CopperNets {
    CopperOwners owners;
    NetTies ties;

    /// One search for all that touches. Errors: Cancelled.
    [[nodiscard]] static base::Result<CopperNets> of(const Document& document, base::Progress& progress);

    [[nodiscard]] NetId netOf(ElementId element) const { return owners.netOf(element); }
    /// Is it a net tie that brings these two together?
    [[nodiscard]] bool areTied(ElementId a, ElementId b) const { return ties.joins(a, netOf(a), b, netOf(b)); }
};

}  // namespace model
