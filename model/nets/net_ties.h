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
    ElementId element;       ///< a pad or a piece of copper that joins them
    PointD location;         ///< where it touches
    bool isAssumed = false;  ///< the job cannot declare ties; taken for one as the component is called so
};
/// "NT1 ties GND and AGND on TOP", and that it is assumed
[[nodiscard]] std::string textOf(const Document& step, const NetTie& tie);

/// Where components join nets on purpose: those that the job declares to do so, or that are called a net tie or a
/// jumper where its format cannot (tiedNetsOf), and only nets that they may join. Pads of one component and of
/// different nets tie them if they overlap or if copper without a net joins them, on one layer; where the tie is
/// assumed, that copper has to lie beside its pads. A net tie of two nets may also be joined by copper of one of them,
/// if it has no copper of its own that does. What a component does not join is no tie, whatever it says, and what
/// nothing calls a tie is a short. Pads and joining copper of a tie may touch and come close to all copper of the nets
/// that are joined there, over several bridges too; two tracks beside it may not, nor may a pad of the component that
/// no bridge reaches.
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
