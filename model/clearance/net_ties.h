#pragma once

#include <map>
#include <vector>

#include "model/base/progress.h"
#include "model/clearance/copper_owners.h"
#include "model/clearance/rule_report.h"
#include "model/index/pin_finder.h"

namespace model {

/// Where components join nets on purpose. A component is a net tie by its name, package, part or an attribute that says
/// so ("net tie"), or because on a layer two of its pads of different nets overlap, or are joined by one piece of
/// copper that has no net. Pads and joining copper of a tie may touch and come close to all copper of its nets; two
/// tracks beside it may not.
class NetTies {
public:
    NetTies(const Document& document, const CopperOwners& owners, base::Progress& progress);

    /// By component and layer, each pair of nets once. Of components that say so without pads that meet: the first two
    /// nets, on the layer of their first pad.
    [[nodiscard]] const std::vector<NetTie>& ties() const { return m_ties; }
    /// Is it a tie that brings these two elements together?
    [[nodiscard]] bool joins(ElementId a, ElementId b) const;

private:
    void addDeclared(const PinFinder& pins);
    void addLayer(const PinFinder& pins, LayerId layer, base::Progress& progress);
    void add(const NetTie& tie);
    [[nodiscard]] bool isOf(ElementId part, NetId a, NetId b) const;

    const Document& m_document;
    const CopperOwners& m_owners;
    std::vector<NetTie> m_ties;
    std::multimap<ElementId, std::vector<NetId>> m_parts;  ///< pads and joining copper, and the nets tied there
};

}  // namespace model
