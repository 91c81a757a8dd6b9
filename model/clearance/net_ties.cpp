#include "model/clearance/net_ties.h"

#include <algorithm>
#include <set>
#include <string_view>

#include "model/clearance/layer_geometry.h"
#include "model/clearance/side_names.h"
#include "model/figures/distance.h"
#include "model/index/attributes.h"
#include "model/index/pin_names.h"

namespace model {

namespace {

/// "NetTie-2_SMD_Pad0.5mm", "NET_TIE", "Net Tie"
bool saysNetTie(std::string_view text) {
    std::string letters;
    for (const char c : text) {
        if (c != ' ' && c != '_' && c != '-') {
            letters += static_cast<char>(c >= 'A' && c <= 'Z' ? c - 'A' + 'a' : c);
        }
    }
    return letters.find("nettie") != std::string::npos;
}

bool saysNetTie(const Document& document, const Component& component) {
    bool says = saysNetTie(component.part) || saysNetTie(component.refdes) ||
                (component.package.isValid() && saysNetTie(document.packages[component.package.row()].name));
    forEachAttribute(document, component, [&](const std::string& name, const std::string& value) {
        says = says || saysNetTie(name) || saysNetTie(value);
    });
    return says;
}

}  // namespace

NetTies::NetTies(const Document& document, const CopperOwners& owners, base::Progress& progress)
    : m_document(document), m_owners(owners) {
    const PinFinder pins(document);
    addDeclared(pins);
    for (std::size_t row = 0; row < document.layers.size() && !progress.isCancelled(); ++row) {
        if (document.layers[row].isCopper()) {
            addLayer(pins, LayerId{row}, progress);
        }
    }
}

void NetTies::addDeclared(const PinFinder& pins) {
    for (std::size_t row = 0; row < m_document.components.size(); ++row) {
        const ComponentId id{row};
        const std::vector<NetId> nets = netsOf(m_document, m_document.components[row]);
        if (nets.size() < 2 || !saysNetTie(m_document, m_document.components[row])) {
            continue;
        }
        LayerId first;
        for (const ElementId element : pins.elementsOf(id)) {
            if (m_document.bodyOf(element) == nullptr) {
                m_parts.emplace(element, nets);
                first = first.isValid() ? first : m_document.elements.layer[element.row()];
            }
        }
        if (first.isValid()) {
            m_ties.push_back({id, first, nets[0], nets[1]});
        }
    }
}

void NetTies::add(const NetTie& tie) {
    const auto isSame = [&](const NetTie& other) { return other.component == tie.component; };
    const bool isDeclared = std::ranges::any_of(m_ties, [&](const NetTie& other) {
        return isSame(other) && other.layer == tie.layer && other.netA == tie.netA && other.netB == tie.netB;
    });
    if (!isDeclared) {
        m_ties.push_back(tie);
    }
}

/// Pads that overlap, and what joins pads.
void NetTies::addLayer(const PinFinder& pins, LayerId layer, base::Progress& progress) {
    const auto componentOf = [&](ElementId e) {
        const PinId pin = pinOf(m_document, pins, e);
        return pin.isValid() ? m_document.pins[pin.row()].component : ComponentId{};
    };
    const auto netOf = [&](ElementId e) { return m_document.elements.net[e.row()]; };
    const LayerGeometry pads =
        layerGeometry(m_document, layer, [&](ElementId e) { return netOf(e).isValid() && componentOf(e).isValid(); });
    const LayerGeometry bridges = layerGeometry(m_document, layer, [&](ElementId e) { return !netOf(e).isValid(); });
    std::vector<ComponentId> owners;
    for (std::size_t row = 0; row < pads.size(); ++row) {
        owners.push_back(componentOf(pads.elementOf(row)));
    }
    PairRequest overlap;
    overlap.reach = kTouchNm;
    overlap.isWanted = [&](std::uint32_t a, std::uint32_t b) {
        return owners[a] == owners[b] && netOf(pads.elementOf(a)) != netOf(pads.elementOf(b));
    };
    const auto join = [&](ElementId a, ElementId b, ComponentId component, ElementId bridge) {
        const auto [low, high] = std::minmax({netOf(a), netOf(b)});
        add({component, layer, low, high});
        for (const ElementId part : {a, b, bridge}) {
            if (part.isValid()) {
                m_parts.emplace(part, std::vector{low, high});
            }
        }
    };
    for (const FigurePair& pair : closestPairs(pads, pads, overlap, progress)) {
        join(pads.elementOf(pair.a), pads.elementOf(pair.b), owners[pair.a], {});
    }
    PairRequest touch;
    touch.reach = kTouchNm;
    std::map<std::pair<ElementId, ComponentId>, std::vector<ElementId>> joined;
    for (const FigurePair& pair : closestPairs(bridges, pads, touch, progress)) {
        joined[{bridges.elementOf(pair.a), owners[pair.b]}].push_back(pads.elementOf(pair.b));
    }
    for (const auto& [bridge, of] : joined) {
        for (std::size_t i = 1; i < of.size(); ++i) {
            if (netOf(of[i]) != netOf(of[0])) {
                join(of[0], of[i], bridge.second, bridge.first);
            }
        }
    }
}

bool NetTies::isOf(ElementId part, NetId a, NetId b) const {
    const auto [first, end] = m_parts.equal_range(part);
    return std::any_of(first, end, [&](const auto& entry) {
        return std::ranges::count(entry.second, a) > 0 && std::ranges::count(entry.second, b) > 0;
    });
}

bool NetTies::joins(ElementId a, ElementId b) const {
    const NetId netA = m_owners.netOf(a);
    const NetId netB = m_owners.netOf(b);
    return !m_parts.empty() && (isOf(a, netA, netB) || isOf(b, netA, netB));
}

}  // namespace model
