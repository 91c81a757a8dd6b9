#include "model/nets/net_ties.h"

#include <algorithm>
#include <functional>
#include <set>
#include <span>
#include <string_view>

#include "model/base/disjoint_sets.h"
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

/// Two parts that touch: pads, or copper without a net, which counts as one part with all such copper that it touches.
struct Joint {
    ElementId a;
    ElementId b;
    const Contact* contact = nullptr;
};

/// All joints of a component.
struct Joints {
    std::vector<Joint> own;      ///< of its pads, and of copper without a net
    std::vector<Joint> foreign;  ///< of a pad (first) and copper of another net of the component
};

/// Parts of a component that joints join.
class Islands {
public:
    Islands(const Document& document, std::span<const Joint> joints, const std::function<bool(const Joint&)>& isWanted)
        : m_document(document), m_sets(2 * joints.size()) {
        for (const Joint& joint : joints) {
            if (isWanted(joint)) {
                m_sets.join(rowOf(joint.a), rowOf(joint.b));
            }
        }
    }

    /// Pads of one pin are one part of a board: plated holes join them.
    void joinPins(const std::function<PinId(ElementId)>& pinOf) {
        std::map<PinId, std::uint32_t> first;
        for (const auto& [part, row] : m_rows) {
            if (const PinId pin = pinOf(part); pin.isValid()) {
                m_sets.join(first.try_emplace(pin, row).first->second, row);
            }
        }
    }

    struct Island {
        std::set<NetId> nets;
        std::vector<ElementId> parts;
    };
    /// Those of several nets.
    [[nodiscard]] std::vector<Island> ofSeveralNets() {
        std::map<std::uint32_t, Island> islands;
        for (const auto& [part, row] : m_rows) {
            Island& island = islands[m_sets.find(row)];
            island.parts.push_back(part);
            if (const NetId net = m_document.elements.net[part.row()]; net.isValid()) {
                island.nets.insert(net);
            }
        }
        std::vector<Island> found;
        for (auto& [row, island] : islands) {
            if (island.nets.size() > 1) {
                found.push_back(std::move(island));
            }
        }
        return found;
    }

private:
    std::uint32_t rowOf(ElementId part) {
        return m_rows.try_emplace(part, static_cast<std::uint32_t>(m_rows.size())).first->second;
    }

    const Document& m_document;
    DisjointSets m_sets;
    std::map<ElementId, std::uint32_t> m_rows;
};

class TieFinder {
public:
    TieFinder(const Document& document, const Connectivity& connectivity)
        : m_document(document), m_pins(document), m_connectivity(connectivity), m_free(document.elements.size()) {}

    void run() {
        joinFreeCopper();
        for (const Contact& contact : m_connectivity.contacts()) {
            addJoints(contact);
        }
        for (const auto& [component, joints] : m_joints) {
            addOwn(component, joints);
        }
    }

    std::vector<NetTie> ties;
    std::multimap<ElementId, std::vector<NetId>> parts;

    [[nodiscard]] ElementId partOf(ElementId element) { return ElementId{m_free.find(element.value)}; }

private:
    [[nodiscard]] NetId netOf(ElementId element) const { return m_document.elements.net[element.row()]; }

    [[nodiscard]] PinId pinAt(ElementId element) const {
        return (m_document.elements.flags[element.row()] & kHole) != 0 ? PinId{} : pinOf(m_document, m_pins, element);
    }

    [[nodiscard]] ComponentId componentOf(ElementId element) const {
        const PinId pin = pinAt(element);
        return pin.isValid() ? m_document.pins[pin.row()].component : ComponentId{};
    }

    /// Copper of no net, no component and no hole: what may be part of any component.
    [[nodiscard]] bool isFree(ElementId element) const {
        return !netOf(element).isValid() && (m_document.elements.flags[element.row()] & kHole) == 0 &&
               !componentOf(element).isValid();
    }

    void joinFreeCopper() {
        for (const Contact& contact : m_connectivity.contacts()) {
            const ElementId a = m_connectivity.element(contact.a);
            const ElementId b = m_connectivity.element(contact.b);
            if (!netOf(a).isValid() && !netOf(b).isValid() && isFree(a) && isFree(b)) {
                m_free.join(a.value, b.value);
            }
        }
    }

    void addJoints(const Contact& contact) {
        const ElementId a = m_connectivity.element(contact.a);
        const ElementId b = m_connectivity.element(contact.b);
        if (netOf(a) == netOf(b) && netOf(a).isValid()) {
            return;
        }
        const ComponentId ofA = componentOf(a);
        const ComponentId ofB = componentOf(b);
        if (ofA.isValid() && ofA == ofB) {
            m_joints[ofA].own.push_back({a, b, &contact});
            return;
        }
        addJoint(a, ofA, b, contact);
        addJoint(b, ofB, a, contact);
    }

    /// Of a pad and something that is no pad of the same component.
    void addJoint(ElementId pad, ComponentId component, ElementId other, const Contact& contact) {
        if (!component.isValid()) {
            return;
        }
        if (isFree(other)) {
            m_joints[component].own.push_back({pad, partOf(other), &contact});
        } else if (netOf(pad).isValid() && netOf(other).isValid()) {
            m_joints[component].foreign.push_back({pad, other, &contact});
        }
    }

    void addOwn(ComponentId component, const Joints& joints) {
        std::set<LayerId> layers;
        for (const Joint& joint : joints.own) {
            layers.insert(joint.contact->layer);
        }
        for (const LayerId layer : layers) {
            Islands islands(m_document, joints.own, [&](const Joint& j) { return j.contact->layer == layer; });
            for (const Islands::Island& island : islands.ofSeveralNets()) {
                addTies(component, layer, island, joints.own);
            }
        }
        Islands islands(m_document, joints.own, [](const Joint&) { return true; });
        islands.joinPins([&](ElementId part) { return pinAt(part); });
        const std::vector<Islands::Island> joined = islands.ofSeveralNets();
        for (const Islands::Island& island : joined) {
            for (const ElementId part : island.parts) {
                parts.emplace(part, std::vector<NetId>(island.nets.begin(), island.nets.end()));
            }
        }
        if (joined.empty()) {
            addForeign(component, joints.foreign);
        }
    }

    void addTies(ComponentId component, LayerId layer, const Islands::Island& island, std::span<const Joint> joints) {
        const NetId lowest = *island.nets.begin();
        for (const NetId net : island.nets) {
            const auto isAt = [&](const Joint& joint) {
                const auto isPart = [&](ElementId part) {
                    return netOf(part) == net && std::ranges::binary_search(island.parts, part);
                };
                return joint.contact->layer == layer && (isPart(joint.a) || isPart(joint.b));
            };
            if (const auto joint = std::ranges::find_if(joints, isAt); net != lowest && joint != joints.end()) {
                const ElementId element = netOf(joint->b).isValid() ? joint->a : joint->b;
                ties.push_back({component, layer, lowest, net, element, joint->contact->location});
            }
        }
    }

    /// Of a component that says that it is a tie, and leaves the joining to a track.
    void addForeign(ComponentId id, std::span<const Joint> joints) {
        const Component& component = m_document.components[id.row()];
        const std::vector<NetId> nets = netsOf(m_document, component);
        if (nets.size() != 2 || !saysNetTie(m_document, component)) {
            return;
        }
        std::set<LayerId> seen;
        for (const Joint& joint : joints) {
            if (std::ranges::count(nets, netOf(joint.b)) > 0) {
                parts.emplace(joint.a, nets);
                if (seen.insert(joint.contact->layer).second) {
                    ties.push_back({id, joint.contact->layer, nets[0], nets[1], joint.a, joint.contact->location});
                }
            }
        }
    }

    const Document& m_document;
    PinFinder m_pins;
    const Connectivity& m_connectivity;
    DisjointSets m_free;  ///< by element: copper without a net that touches
    std::map<ComponentId, Joints> m_joints;
};

}  // namespace

std::string textOf(const Document& step, const NetTie& tie) {
    return step.components[tie.component.row()].refdes + " ties " + step.nets[tie.netA.row()].name + " and " +
           step.nets[tie.netB.row()].name + " on " + step.layer(tie.layer).name;
}

NetTies::NetTies(const Document& document, const Connectivity& connectivity) {
    if (document.components.empty()) {
        return;
    }
    TieFinder finder(document, connectivity);
    finder.run();
    m_ties = std::move(finder.ties);
    m_parts = std::move(finder.parts);
    for (std::size_t row = 0; !m_parts.empty() && row < document.elements.size(); ++row) {
        m_part.push_back(finder.partOf(ElementId{row}));
    }
}

bool NetTies::isOf(ElementId part, NetId a, NetId b) const {
    const auto [first, end] = m_parts.equal_range(m_part[part.row()]);
    return std::any_of(first, end, [&](const auto& entry) {
        return std::ranges::count(entry.second, a) > 0 && std::ranges::count(entry.second, b) > 0;
    });
}

bool NetTies::joins(ElementId a, NetId netA, ElementId b, NetId netB) const {
    return !m_parts.empty() && (isOf(a, netA, netB) || isOf(b, netA, netB));
}

}  // namespace model
