#pragma once

#include <map>
#include <string>
#include <vector>

#include "model/nets/connectivity.h"

namespace model {

/// Two nets that a component joins on purpose.
struct NetTie {
    ComponentId component;
    LayerId layer;
    NetId netA;  ///< the lower row
    NetId netB;
    ElementId element;  ///< a pad or a piece of copper that joins them
    PointD location;    ///< where it touches
};
/// "NT1 ties GND and AGND on TOP"
[[nodiscard]] std::string textOf(const Document& step, const NetTie& tie);

/// Where components join nets on purpose: pads of one component and of different nets that overlap, or that copper
/// without a net joins, on one layer; a component of two nets that says so by its name, package, part or an attribute
/// ("net tie") may also be joined by copper of one of them, if it has no copper of its own that does. What a component
/// does not join is no tie, whatever it says. Pads and joining copper of a tie may touch and come close to all copper
/// of the nets that are joined there, over several bridges too; two tracks beside it may not, nor may a pad of the
/// component that no bridge reaches.
class NetTies {
public:
    NetTies() = default;
    NetTies(const Document& document, const Connectivity& connectivity);

    /// By component and layer. Of several nets that are joined on a layer, the lowest with each other one.
    [[nodiscard]] const std::vector<NetTie>& ties() const { return m_ties; }
    /// Is it a tie that brings these two elements together, which belong to these nets (CopperOwners)?
    [[nodiscard]] bool joins(ElementId a, NetId netA, ElementId b, NetId netB) const;

private:
    [[nodiscard]] bool isOf(ElementId part, NetId a, NetId b) const;

    std::vector<NetTie> m_ties;
    /// Pads and joining copper, and the nets that are joined there; of copper without a net the first that touches.
    std::multimap<ElementId, std::vector<NetId>> m_parts;
    std::vector<ElementId> m_part;  ///< by element: its row of m_parts, if it is one; empty without ties
};

}  // namespace model
