#include "model/agreement/net_agreement.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <utility>

#include "model/agreement/point_matcher.h"

namespace model {

namespace {

/// A pin or pad of both boards and its nets there.
struct Probe {
    std::array<std::int32_t, 2> nets{};
    std::array<Point, 2> at;                 ///< in either board
    std::array<std::int32_t, 2> own = nets;  ///< as `nets`, before those of one pin are left out
};

/// Pads on one layer of both.
void addPads(const FlatBoard& a, const FlatBoard& b, std::int32_t layer, Nm reach, std::vector<Probe>& probes) {
    std::vector<std::size_t> rows;
    std::vector<Point> points;
    for (std::size_t row = 0; row < b.pads.size(); ++row) {
        if (b.pads[row].layer == layer) {
            rows.push_back(row);
            points.push_back(b.pads[row].middle);
        }
    }
    PointMatcher matcher(std::move(points));
    for (const FlatBoard::Pad& pad : a.pads) {
        const auto found = pad.layer != layer ? std::nullopt : matcher.take(pad.middle, reach, [&](std::size_t i) {
            // Of several pads at one location those of a net belong together.
            const bool hasNet = b.pads[rows[i]].net != FlatBoard::kNoNet;
            return hasNet == (pad.net != FlatBoard::kNoNet) ? 0 : 1;
        });
        if (found) {
            const FlatBoard::Pad& other = b.pads[rows[*found]];
            probes.push_back({{pad.net, other.net}, {pad.middle, other.middle}});
        }
    }
}

std::vector<Probe> probesOf(const FlatBoard& a, const FlatBoard& b, const MatchedParts& parts, Nm reach) {
    std::vector<Probe> probes;
    for (const auto& [ours, theirs] : parts.samePins) {
        probes.push_back({{a.pins[ours].net, b.pins[theirs].net}, {a.pins[ours].position, b.pins[theirs].position}});
    }
    std::int32_t layers = 0;
    for (const FlatBoard::Pad& pad : a.pads) {
        layers = std::max(layers, pad.layer + 1);
    }
    for (std::int32_t layer = 0; layer < layers; ++layer) {
        addPads(a, b, layer, reach, probes);
    }
    return probes;
}

using NetSet = std::set<std::int32_t>;

/// The nets of the other board that a net of one meets, each with a location.
using Partners = std::map<std::int32_t, std::map<std::int32_t, Point>>;

class NetComparer {
public:
    NetComparer(const FlatBoard& a, const FlatBoard& b, std::vector<Probe> probes, Nm reach,
                const AgreementRequest& request)
        : m_boards{&a, &b},
          m_names{std::set(a.nets.begin(), a.nets.end()), std::set(b.nets.begin(), b.nets.end())},
          m_probes(std::move(probes)),
          m_reach(reach),
          m_most(request.most) {}

    std::vector<Comparison> run() {
        dropSingles();
        for (const int side : {0, 1}) {
            m_partners[static_cast<std::size_t>(side)] = partnersOf(side);
        }
        std::vector<Comparison> comparisons(2);
        comparisons[0].aspect = Aspect::Nets;
        comparisons[1].aspect = Aspect::NetNames;
        for (Comparison& comparison : comparisons) {
            comparison.counts = {m_boards[0]->nets.size(), m_boards[1]->nets.size()};
            if (const std::string why = whyNot(); !why.empty()) {
                comparison.accord = Accord::NotCompared;
                comparison.note = why;
            }
        }
        if (comparisons[0].accord == Accord::Agree) {
            comparePartition(0, comparisons[0]);
            comparePartition(1, comparisons[0]);
            compareNames(comparisons[1]);
        }
        return comparisons;
    }

private:
    [[nodiscard]] std::string whyNot() const {
        for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
            if (m_boards[side]->nets.empty()) {
                return std::string(side == 0 ? "A" : "B") + " has no nets";
            }
        }
        return m_probes.empty() ? "no pin or pad lies at one location in both" : "";
    }

    /// A net of one pin is called what the format likes, or nothing.
    void dropSingles() {
        for (const std::size_t side : {std::size_t{0}, std::size_t{1}}) {
            std::map<std::int32_t, std::pair<std::size_t, Point>> members;
            std::map<std::int32_t, bool> isAtOnePlace;
            for (const Probe& probe : m_probes) {
                auto& [count, at] = members[probe.nets[side]];
                bool& isOne = isAtOnePlace.try_emplace(probe.nets[side], true).first->second;
                at = count == 0 ? probe.at[side] : at;
                isOne = isOne && isSamePlace(at, probe.at[side], m_reach);  // a pin and its pad may be rounded apart
                ++count;
            }
            for (Probe& probe : m_probes) {
                if (isAtOnePlace[probe.nets[side]]) {
                    probe.nets[side] = FlatBoard::kNoNet;
                }
            }
        }
    }

    [[nodiscard]] Partners partnersOf(int side) const {
        Partners partners;
        for (const Probe& probe : m_probes) {
            const std::int32_t net = probe.nets[static_cast<std::size_t>(side)];
            if (net != FlatBoard::kNoNet) {
                partners[net].try_emplace(probe.nets[static_cast<std::size_t>(1 - side)], probe.at[0]);
            }
        }
        return partners;
    }

    [[nodiscard]] std::string nameOf(int side, std::int32_t net) const {
        return net == FlatBoard::kNoNet
                   ? "no net"
                   : std::string(m_boards[static_cast<std::size_t>(side)]->nets[static_cast<std::size_t>(net)]);
    }

    /// Nets of this side whose pins are in several nets of the other.
    void comparePartition(int side, Comparison& comparison) const {
        for (const auto& [net, others] : m_partners[static_cast<std::size_t>(side)]) {
            if (others.size() == 1 && others.begin()->first != FlatBoard::kNoNet) {
                continue;
            }
            std::string list;
            for (const std::int32_t other : comparison.differing < m_most ? netsThere(side, net) : NetSet()) {
                list += (list.empty() ? "" : ", ") + nameOf(1 - side, other);
            }
            const char* const in = side == 0 ? " of A is in B: " : " of B is in A: ";
            comparison.add({nameOf(side, net) + in + list, std::prev(others.end())->second}, m_most);
        }
    }

    /// In which nets of the other side its pins are, those of one pin as they are called there.
    [[nodiscard]] NetSet netsThere(int side, std::int32_t net) const {
        NetSet nets;
        for (const Probe& probe : m_probes) {
            if (probe.nets[static_cast<std::size_t>(side)] == net) {
                nets.insert(probe.own[static_cast<std::size_t>(1 - side)]);
            }
        }
        return nets;
    }

    void compareNames(Comparison& comparison) const {
        for (const auto& [net, others] : m_partners[0]) {
            const std::int32_t other = others.begin()->first;
            const bool isOneToOne =
                others.size() == 1 && other != FlatBoard::kNoNet && m_partners[1].at(other).size() == 1;
            if (isOneToOne && nameOf(0, net) != nameOf(1, other)) {
                comparison.add(
                    {nameOf(0, net) + " of A is called " + nameOf(1, other) + " in B", others.begin()->second}, m_most);
            }
        }
        compareNamesOfSingles(comparison);
    }

    /// Nets of one pin in both are called what the format likes, but not by a name that the other board has elsewhere:
    /// then nets are exchanged.
    void compareNamesOfSingles(Comparison& comparison) const {
        std::set<std::pair<std::int32_t, std::int32_t>> seen;
        for (const Probe& probe : m_probes) {
            const auto [a, b] = probe.own;
            const bool isSingle = probe.nets[0] == FlatBoard::kNoNet && probe.nets[1] == FlatBoard::kNoNet;
            if (!isSingle || a == FlatBoard::kNoNet || b == FlatBoard::kNoNet || nameOf(0, a) == nameOf(1, b) ||
                !(hasNet(1, nameOf(0, a)) || hasNet(0, nameOf(1, b))) || !seen.emplace(a, b).second) {
                continue;
            }
            comparison.add({nameOf(0, a) + " of A is called " + nameOf(1, b) + " in B", probe.at[0]}, m_most);
        }
    }

    [[nodiscard]] bool hasNet(int side, const std::string& name) const {
        return m_names[static_cast<std::size_t>(side)].contains(name);
    }

    std::array<const FlatBoard*, 2> m_boards;
    std::array<std::set<std::string_view>, 2> m_names;  ///< of all nets
    std::vector<Probe> m_probes;
    Nm m_reach;
    std::size_t m_most;
    std::array<Partners, 2> m_partners;
};

}  // namespace

std::vector<Comparison> compareNets(const FlatBoard& a, const FlatBoard& b, const MatchedParts& parts, Nm reach,
                                    const AgreementRequest& request) {
    return NetComparer(a, b, probesOf(a, b, parts, reach), reach, request).run();
}

}  // namespace model
