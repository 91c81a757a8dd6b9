#include "model/nets/net_ties.h"

#include <algorithm>
#include <functional>
#include <set>
#include <span>
#include <utility>

#include "model/base/disjoint_sets.h"
#include "model/index/pin_names.h"
#include "model/nets/tie_claims.h"

namespace model {

namespace {

/// Copper that is a component's own reaches no farther beyond its pads.
constexpr Nm kBeyondPads = 100'000;

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
    Box pads;                    ///< around those of its own
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
        for (auto& [component, joints] : m_joints) {
            addTiesOf(component, joints);
        }
        std::ranges::stable_sort(ties, {}, [](const NetTie& tie) { return std::pair(tie.component, tie.layer); });
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
        for (const Contact& contact : m_connectivity.contacts()) {
            for (const ElementId element : {m_connectivity.element(contact.a), m_connectivity.element(contact.b)}) {
                if (isFree(element)) {
                    m_freeBoxes[partOf(element)].include(m_document.boxOf(element));
                }
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
            Joints& joints = m_joints[ofA];
            joints.own.push_back({a, b, &contact});
            joints.pads.include(m_document.boxOf(a));
            joints.pads.include(m_document.boxOf(b));
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
            m_joints[component].pads.include(m_document.boxOf(pad));
        } else if (netOf(pad).isValid() && netOf(other).isValid()) {
            m_joints[component].foreign.push_back({pad, other, &contact});
        }
    }

    void addTiesOf(ComponentId component, Joints& joints) {
        const TiedNets tied = tiedNetsOf(m_document, component);
        if (tied.groups.empty()) {
            return;
        }
        m_isAssumed = tied.claim == TieClaim::Jumper || tied.claim == TieClaim::NetTie;
        if (m_isAssumed) {
            std::erase_if(joints.own, [&](const Joint& joint) { return !isWithin(joint, joints.pads); });
        }
        for (const std::vector<NetId>& nets : tied.groups) {
            const bool isJoined = addOwn(component, joints.own, nets);
            const bool isTie = tied.claim == TieClaim::NetTie || tied.claim == TieClaim::Declared;
            if (!isJoined && nets.size() == 2 && isTie) {
                addForeign(component, nets, joints.foreign);
            }
        }
    }

    /// Is the copper without a net, if it joins any, all of it beside the pads?
    [[nodiscard]] bool isWithin(const Joint& joint, const Box& pads) const {
        const auto found = m_freeBoxes.find(joint.b);
        const Box room = pads.grownBy(kBeyondPads);
        return found == m_freeBoxes.end() || (room.holds(found->second.min) && room.holds(found->second.max));
    }

    /// Is any of these nets joined with another of them?
    bool addOwn(ComponentId component, std::span<const Joint> joints, const std::vector<NetId>& nets) {
        const auto isOfNets = [&](ElementId part) {
            return !netOf(part).isValid() || std::ranges::binary_search(nets, netOf(part));
        };
        const auto isWanted = [&](const Joint& joint) { return isOfNets(joint.a) && isOfNets(joint.b); };
        std::set<LayerId> layers;
        for (const Joint& joint : joints) {
            layers.insert(joint.contact->layer);
        }
        for (const LayerId layer : layers) {
            Islands islands(m_document, joints,
                            [&](const Joint& j) { return j.contact->layer == layer && isWanted(j); });
            for (const Islands::Island& island : islands.ofSeveralNets()) {
                addTies(component, layer, island, joints);
            }
        }
        Islands islands(m_document, joints, isWanted);
        islands.joinPins([&](ElementId part) { return pinAt(part); });
        const std::vector<Islands::Island> joined = islands.ofSeveralNets();
        for (const Islands::Island& island : joined) {
            for (const ElementId part : island.parts) {
                parts.emplace(part, std::vector<NetId>(island.nets.begin(), island.nets.end()));
            }
        }
        return !joined.empty();
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
                ties.push_back({component, layer, lowest, net, element, joint->contact->location, m_isAssumed});
            }
        }
    }

    /// Of a component that is a tie and leaves the joining to a track.
    void addForeign(ComponentId component, const std::vector<NetId>& nets, std::span<const Joint> joints) {
        std::set<LayerId> seen;
        for (const Joint& joint : joints) {
            if (std::ranges::count(nets, netOf(joint.a)) > 0 && std::ranges::count(nets, netOf(joint.b)) > 0) {
                const LayerId layer = joint.contact->layer;
                parts.emplace(joint.a, nets);
                if (seen.insert(layer).second) {
                    ties.push_back({component, layer, nets[0], nets[1], joint.a, joint.contact->location, m_isAssumed});
                }
            }
        }
    }

    const Document& m_document;
    PinFinder m_pins;
    const Connectivity& m_connectivity;
    DisjointSets m_free;                   ///< by element: copper without a net that touches
    std::map<ElementId, Box> m_freeBoxes;  ///< by the first: around copper without a net that touches
    std::map<ComponentId, Joints> m_joints;
    bool m_isAssumed = false;  ///< of the component at hand
};

}  // namespace

std::string textOf(const Document& step, const NetTie& tie) {
    return step.components[tie.component.row()].refdes + " ties " + step.nets[tie.netA.row()].name + " and " +
           step.nets[tie.netB.row()].name + " on " + step.layer(tie.layer).name +
           (tie.isAssumed ? ", assumed from its name and its copper" : "");
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
