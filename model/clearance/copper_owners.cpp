#include "model/clearance/copper_owners.h"

#include <algorithm>

#include "model/base/disjoint_sets.h"

namespace model {

namespace {

struct Touch {
    std::uint32_t a;
    std::uint32_t b;
};

/// Of elements; in each the first one has no net.
std::vector<Touch> touchesOf(const Document& document, const Connectivity& connectivity) {
    std::vector<Touch> touches;
    for (const Contact& contact : connectivity.contacts()) {
        const std::uint32_t a = connectivity.element(contact.a).value;
        const std::uint32_t b = connectivity.element(contact.b).value;
        if (!document.elements.net[a].isValid()) {
            touches.push_back({a, b});
        } else if (!document.elements.net[b].isValid()) {
            touches.push_back({b, a});
        }
    }
    return touches;
}

}  // namespace

CopperOwners::CopperOwners(const Document& document, const Connectivity& connectivity)
    : m_netCount(static_cast<std::uint32_t>(document.nets.size())), m_owner(document.elements.size()) {
    const std::vector<Touch> touches = touchesOf(document, connectivity);
    const auto netOf = [&](std::uint32_t element) { return document.elements.net[element]; };
    DisjointSets islands(document.elements.size());
    for (const Touch& touch : touches) {
        if (!netOf(touch.b).isValid()) {
            islands.join(touch.a, touch.b);
        }
    }
    constexpr auto kNone = ~std::uint32_t{0};
    std::vector<std::uint32_t> ofIsland(document.elements.size(), kNone);
    for (const Touch& touch : touches) {
        std::uint32_t& net = ofIsland[islands.find(touch.a)];
        net = std::min(net, netOf(touch.b).isValid() ? netOf(touch.b).value : kNone);
    }
    for (std::uint32_t i = 0; i < m_owner.size(); ++i) {
        const std::uint32_t island = islands.find(i);
        m_owner[i] = netOf(i).isValid()          ? netOf(i).value
                     : ofIsland[island] != kNone ? ofIsland[island]
                                                 : m_netCount + island;
    }
}

base::Result<CopperNets> CopperNets::of(const Document& document, base::Progress& progress) {
    ASSIGN_OR_RETURN(const Connectivity connectivity, Connectivity::of(document, progress));
    return CopperNets{CopperOwners(document, connectivity), NetTies(document, connectivity)};
}

}  // namespace model
