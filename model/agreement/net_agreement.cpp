#include "model/agreement/net_agreement.h"

#include <algorithm>
#include <array>
#include <map>

#include "model/agreement/point_matcher.h"

namespace model {

namespace {

/// A pin or pad of both boards and its nets there.
struct Probe {
    std::array<std::int32_t, 2> nets{};
    Point at;
};

/// Pads on one layer of both.
void addPads(const FlatBoard& a, const FlatBoard& b, std::int32_t layer, std::vector<Probe>& probes) {
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
        const auto found = pad.layer != layer ? std::nullopt : matcher.take(pad.middle, kSamePlace, [&](std::size_t i) {
            // Of several pads at one location those of a net belong together.
            const bool hasNet = b.pads[rows[i]].net != FlatBoard::kNoNet;
            return hasNet == (pad.net != FlatBoard::kNoNet) ? 0 : 1;
        });
        if (found) {
            probes.push_back({{pad.net, b.pads[rows[*found]].net}, pad.middle});
        }
    }
}

std::vector<Probe> probesOf(const FlatBoard& a, const FlatBoard& b, const MatchedParts& parts) {
    std::vector<Probe> probes;
    for (const auto& [ours, theirs] : parts.samePins) {
        probes.push_back({{a.pins[ours].net, b.pins[theirs].net}, a.pins[ours].position});
    }
    std::int32_t layers = 0;
    for (const FlatBoard::Pad& pad : a.pads) {
        layers = std::max(layers, pad.layer + 1);
    }
    for (std::int32_t layer = 0; layer < layers; ++layer) {
        addPads(a, b, layer, probes);
    }
    return probes;
}

/// The nets of the other board that a net of one meets, each with a location.
using Partners = std::map<std::int32_t, std::map<std::int32_t, Point>>;

class NetComparer {
public:
    NetComparer(const FlatBoard& a, const FlatBoard& b, std::vector<Probe> probes, const AgreementRequest& request)
        : m_boards{&a, &b}, m_probes(std::move(probes)), m_most(request.most) {}

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
                isOne = isOne && (count == 0 || at == probe.at);
                at = probe.at;
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
                partners[net].try_emplace(probe.nets[static_cast<std::size_t>(1 - side)], probe.at);
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
            for (const auto& [other, at] : others) {
                list += (list.empty() ? "" : ", ") + nameOf(1 - side, other);
            }
            const char* const in = side == 0 ? " of A is in B: " : " of B is in A: ";
            comparison.add({nameOf(side, net) + in + list, std::prev(others.end())->second}, m_most);
        }
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
    }

    std::array<const FlatBoard*, 2> m_boards;
    std::vector<Probe> m_probes;
    std::size_t m_most;
    std::array<Partners, 2> m_partners;
};

}  // namespace

std::vector<Comparison> compareNets(const FlatBoard& a, const FlatBoard& b, const MatchedParts& parts,
                                    const AgreementRequest& request) {
    return NetComparer(a, b, probesOf(a, b, parts), request).run();
}

}  // namespace model
