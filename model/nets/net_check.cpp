#include "model/nets/net_check.h"

#include <algorithm>
#include <map>
#include <tuple>

#include "model/base/disjoint_sets.h"
#include "model/board/copies.h"
#include "model/index/pin_names.h"
#include "model/nets/pad_groups.h"

namespace model {

namespace {

constexpr std::uint32_t kNoJumper = 0xffffffffu;

PointD middleOf(const Box& box) {
    return {static_cast<double>(box.min.x + box.max.x) / 2, static_cast<double>(box.min.y + box.max.y) / 2};
}

class NetChecker {
public:
    NetChecker(const Document& document, const Connectivity& connectivity)
        : m_document(document),
          m_connectivity(connectivity),
          m_pins(document),
          m_joined(connectivity.islandCount()),
          m_unassigned(connectivity.pieceCount()),
          m_ties(document, connectivity) {}

    NetReport run() {
        findOpens();
        findShorts();
        joinUnassigned();
        findShortsThroughOtherCopper();
        findShortsByPoints();
        findPinsOnNets();
        for (auto& [key, entry] : m_shorts) {
            const ComponentId component = componentOf(entry.elementA);
            entry.component = component == componentOf(entry.elementB) ? component : ComponentId{};
            m_report.shorts.push_back(entry);
        }
        m_report.ties = m_ties.ties();
        return std::move(m_report);
    }

private:
    [[nodiscard]] NetId netOf(std::uint32_t piece) const {
        return m_document.elements.net[m_connectivity.element(piece).row()];
    }

    /// Of a pad or hole.
    [[nodiscard]] PinId pinAt(ElementId element) const { return pinOf(m_document, m_pins, element); }

    [[nodiscard]] ComponentId componentOf(ElementId element) const {
        const PinId pin = pinAt(element);
        return pin.isValid() ? m_document.pins[pin.row()].component : ComponentId{};
    }

    /// Islands that jumpers join within parts count as one.
    void joinJumpers() {
        for (std::size_t row = 0; row < m_document.components.size(); ++row) {
            for (const PinGroup& group : jumperGroups(m_document, ComponentId{row})) {
                m_jumperOf.resize(m_document.pins.size(), kNoJumper);
                for (const PinId pin : group) {
                    m_jumperOf[pin.row()] = m_jumperCount;
                }
                ++m_jumperCount;
            }
        }
        std::map<std::pair<NetId, std::uint32_t>, std::uint32_t> first;
        for (std::uint32_t piece = 0; !m_jumperOf.empty() && piece < m_connectivity.pieceCount(); ++piece) {
            const NetId net = netOf(piece);
            const PinId pin = net.isValid() ? pinAt(m_connectivity.element(piece)) : PinId{};
            if (pin.isValid() && m_jumperOf[pin.row()] != kNoJumper) {
                const std::uint32_t island = m_connectivity.island(piece);
                m_joined.join(first.try_emplace({net, m_jumperOf[pin.row()]}, island).first->second, island);
            }
        }
    }

    void findOpens() {
        joinJumpers();
        std::map<std::pair<NetId, std::uint32_t>, NetIsland> islands;
        for (std::uint32_t piece = 0; piece < m_connectivity.pieceCount(); ++piece) {
            if (const NetId net = netOf(piece); net.isValid()) {
                const std::uint32_t island = m_joined.find(m_connectivity.island(piece));
                const auto [location, isNew] = islands.try_emplace({net, island});
                count(piece, isNew, location->second);
            }
        }
        for (auto first = islands.begin(); first != islands.end();) {
            const NetId net = first->first.first;
            const auto end = islands.lower_bound({NetId{net.row() + 1}, 0});
            if (std::next(first) != end) {
                addOpen(net, first, end);
            }
            first = end;
        }
    }

    void count(std::uint32_t piece, bool isFirst, NetIsland& island) const {
        const ElementId element = m_connectivity.element(piece);
        if (isFirst) {
            island.element = element;
            island.layer = m_document.elements.layer[element.row()];
            island.location = isUseful(element) ? middleOf(m_document.boxOf(element)) : m_connectivity.point(piece);
        }
        ++island.pieceCount;
        island.padCount += isUseful(element) ? 1 : 0;
    }

    [[nodiscard]] bool isUseful(ElementId element) const {
        return (m_document.elements.flags[element.row()] & (kPad | kHole)) != 0;
    }

    template <class Iterator>
    void addOpen(NetId net, Iterator first, Iterator end) {
        OpenNet open{net, static_cast<std::uint32_t>(m_report.islands.size()), 0};
        for (; first != end; ++first, ++open.islandCount) {
            m_report.islands.push_back(first->second);
        }
        std::ranges::stable_sort(m_report.islands.begin() + open.firstIsland, m_report.islands.end(),
                                 std::ranges::greater(), &NetIsland::pieceCount);
        m_report.opens.push_back(open);
    }

    void findShorts() {
        for (const Contact& contact : m_connectivity.contacts()) {
            const NetId a = netOf(contact.a);
            const NetId b = netOf(contact.b);
            const ElementId elementA = m_connectivity.element(contact.a);
            const ElementId elementB = m_connectivity.element(contact.b);
            if (a.isValid() && b.isValid() && a != b && !m_ties.joins(elementA, a, elementB, b)) {
                addShort({a, b, contact.layer, elementA, elementB, contact.location, ElementId{}, 0});
            }
        }
    }

    void joinUnassigned() {
        for (const Contact& contact : m_connectivity.contacts()) {
            if (!netOf(contact.a).isValid() && !netOf(contact.b).isValid()) {
                m_unassigned.join(contact.a, contact.b);
            }
        }
    }

    /// Calls `take` with the contact, the piece without a net and the one with a net where such two touch.
    template <class Take>
    void forEachTouch(const Take& take) const {
        for (const Contact& contact : m_connectivity.contacts()) {
            const bool isUnassignedA = !netOf(contact.a).isValid();
            if (isUnassignedA != !netOf(contact.b).isValid()) {
                take(contact, isUnassignedA ? contact.a : contact.b, isUnassignedA ? contact.b : contact.a);
            }
        }
    }

    /// Copper without a net that touches several nets joins them; each is reported against the first.
    void findShortsThroughOtherCopper() {
        std::map<std::uint32_t, std::uint32_t> firstPiece;  // by set: the first piece with a net that touches it
        forEachTouch([&](const Contact& contact, std::uint32_t other, std::uint32_t piece) {
            const std::uint32_t first = firstPiece.try_emplace(m_unassigned.find(other), piece).first->second;
            const ElementId through = m_connectivity.element(other);
            if (netOf(first) != netOf(piece) && !m_ties.joins(through, netOf(first), through, netOf(piece))) {
                addShort({netOf(first), netOf(piece), contact.layer, m_connectivity.element(first),
                          m_connectivity.element(piece), contact.location, through, 0});
            }
        });
    }

    /// Netlist points that lie on copper of other nets only, where nets follow from the copper and its points: one
    /// piece may carry the points of several. Documents with nets of the job have subnets.
    void findShortsByPoints() {
        if (!m_document.subnets.empty()) {
            return;
        }
        for (const NetPoint& point : m_document.netPoints) {
            const LayerId layer = outerCopper(point.side);
            if (!point.net.isValid() || !layer.isValid()) {
                continue;
            }
            const std::vector<std::uint32_t> pieces = m_connectivity.piecesAt(layer, point.position, 0);
            const auto isOther = [&](std::uint32_t piece) {
                return netOf(piece).isValid() && netOf(piece) != point.net;
            };
            if (!pieces.empty() && std::ranges::all_of(pieces, isOther)) {
                const ElementId element = m_connectivity.element(pieces.front());
                addShort({point.net, netOf(pieces.front()), layer, element, element, toDouble(point.position),
                          ElementId{}, 0});
            }
        }
    }

    [[nodiscard]] LayerId outerCopper(LayerSide side) const {
        LayerId outer;
        for (std::size_t row = 0; row < m_document.layers.size(); ++row) {
            if (m_document.layers[row].isCopper() && (side == LayerSide::Bottom || !outer.isValid())) {
                outer = LayerId{row};
            }
        }
        return outer;
    }

    /// Pins that are to be connected to nothing. A pad without a number that touches its own part is a piece of it.
    void findPinsOnNets() {
        std::map<std::uint32_t, PinOnNet> touches;  // by set
        forEachTouch([&](const Contact& contact, std::uint32_t other, std::uint32_t piece) {
            touches.try_emplace(m_unassigned.find(other),
                                PinOnNet{PinId{}, netOf(piece), ElementId{}, m_connectivity.element(piece),
                                         contact.layer, contact.location});
        });
        std::map<PinId, PinOnNet> found;
        for (std::uint32_t piece = 0; !touches.empty() && piece < m_connectivity.pieceCount(); ++piece) {
            const auto touch = netOf(piece).isValid() ? touches.end() : touches.find(m_unassigned.find(piece));
            const PinId pin = touch == touches.end() ? PinId{} : pinAt(m_connectivity.element(piece));
            if (pin.isValid() && !m_document.pins[pin.row()].net.isValid() && !isPieceOf(pin, touch->second.copper)) {
                PinOnNet entry = touch->second;
                entry.pin = pin;
                entry.pad = m_connectivity.element(piece);
                found.try_emplace(pin, entry);
            }
        }
        for (const auto& [pin, entry] : found) {
            m_report.pinsOnNets.push_back(entry);
        }
    }

    [[nodiscard]] bool isPieceOf(PinId pin, ElementId copper) const {
        return pinName(m_document, pin).empty() && componentOf(copper) == m_document.pins[pin.row()].component;
    }

    void addShort(ShortedNets entry) {
        if (entry.b < entry.a) {
            std::swap(entry.a, entry.b);
            std::swap(entry.elementA, entry.elementB);
        }
        ++m_shorts.try_emplace({entry.a, entry.b, entry.layer}, entry).first->second.contactCount;
    }

    const Document& m_document;
    const Connectivity& m_connectivity;
    PinFinder m_pins;
    DisjointSets m_joined;                  ///< islands
    DisjointSets m_unassigned;              ///< pieces without a net that touch
    std::vector<std::uint32_t> m_jumperOf;  ///< by pin; empty without jumpers
    std::uint32_t m_jumperCount = 0;
    NetTies m_ties;
    NetReport m_report;
    std::map<std::tuple<NetId, NetId, LayerId>, ShortedNets> m_shorts;
};

}  // namespace

std::string textOf(const Document& step, const ShortedNets& entry) {
    const std::string text = entry.through.isValid() ? "are joined by copper without a net" : "touch";
    return entry.component.isValid() ? text + (entry.through.isValid() ? " between pads of " : " at pads of ") +
                                           step.components[entry.component.row()].refdes
                                     : text;
}

std::string textOf(const Document& step, const PinOnNet& entry) {
    return fullPinName(step, entry.pin) + " has no net and touches " + step.nets[entry.net.row()].name;
}

NetReport checkNets(const Document& document, const Connectivity& connectivity) {
    return NetChecker(document, connectivity).run();
}

bool hasSeveralPadIslands(const NetReport& report, const OpenNet& open) {
    return std::ranges::count_if(report.islandsOf(open), [](const NetIsland& island) { return island.padCount > 0; }) >
           1;
}

base::Result<std::vector<StepCheck>> checkAllNets(const Document& board, base::Progress& progress) {
    std::vector<StepCheck> checks;
    for (const Document* step : distinctSteps(board)) {
        ASSIGN_OR_RETURN(const auto connectivity, Connectivity::of(*step, progress));
        checks.push_back({step, connectivity.islandCount(), checkNets(*step, connectivity)});
    }
    return checks;
}

}  // namespace model
