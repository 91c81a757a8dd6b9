#include "model/formats/common/outline_gaps.h"

#include <algorithm>
#include <array>
#include <cstdio>
#include <iterator>
#include <limits>
#include <numeric>
#include <optional>
#include <utility>

#include "model/geometry/edges.h"
#include "model/geometry/vectors.h"

namespace model::formats {

namespace {

constexpr std::size_t kMostTracks = 5'000;  ///< of which chains are looked for
constexpr std::size_t kMostChains = 100;    ///< an outline has gaps, a drawing has ends everywhere
constexpr double kClearer = 1.5;            ///< another end is at least so many times as far away
constexpr double kMostOpen = 0.5;           ///< of what is drawn

double widthOf(const OutlineGap& gap) {
    return distance(gap.from, gap.to);
}

PathNode lineFrom(Point point) {
    PathNode node;
    node.point = point;
    return node;
}

/// Tracks in a row, with the gaps between them that are bridged.
struct Chain {
    std::vector<PathNode> nodes;
    Point end;
    std::vector<OutlineGap> gaps;
    double drawn = 0.0;  ///< length of its tracks, nm
    std::size_t trackCount = 0;

    [[nodiscard]] Point at(bool isEnd) const { return isEnd ? end : nodes.front().point; }

    void reverse() {
        std::vector<PathNode> back;
        Point start = end;
        for (auto node = nodes.rbegin(); node != nodes.rend(); ++node) {
            PathNode edge = *node;
            edge.point = start;
            edge.edge = reversed(node->edge);
            start = node->point;
            back.push_back(edge);
        }
        end = nodes.front().point;
        nodes = std::move(back);
    }

    /// Puts another chain behind the end, which must be where that begins or is bridged to it.
    void append(Chain other, bool isBridged) {
        if (isBridged) {
            gaps.push_back({end, other.nodes.front().point});
            nodes.push_back(lineFrom(end));
        }
        std::ranges::move(other.nodes, std::back_inserter(nodes));
        std::ranges::move(other.gaps, std::back_inserter(gaps));
        end = other.end;
        drawn += other.drawn;
        trackCount += other.trackCount;
    }

    [[nodiscard]] double open() const {
        return std::accumulate(gaps.begin(), gaps.end(), 0.0,
                               [](double sum, const OutlineGap& gap) { return sum + widthOf(gap); });
    }
};

Chain chainOf(const OutlineTrack& track) {
    return {{track.from}, track.to, {}, lengthOf(edgeOf(track.from, track.to)), 1};
}

/// Chains of tracks that meet, in whatever order and direction they come.
class Chaining {
public:
    Chaining(std::span<const OutlineTrack> tracks, double joint) : m_tracks(tracks), m_joint(joint) {
        m_isUsed.resize(tracks.size());
    }

    [[nodiscard]] std::vector<Chain> run() {
        std::vector<Chain> chains;
        for (std::size_t i = 0; i < m_tracks.size(); ++i) {
            if (!m_isUsed[i]) {
                m_isUsed[i] = true;
                Chain chain = chainOf(m_tracks[i]);
                extend(chain);
                chain.reverse();
                extend(chain);
                chains.push_back(std::move(chain));
            }
        }
        return chains;
    }

private:
    void extend(Chain& chain) {
        while (std::optional<Chain> next = nextFrom(chain.end)) {
            chain.append(std::move(*next), false);
        }
    }

    [[nodiscard]] std::optional<Chain> nextFrom(Point end) {
        for (std::size_t i = 0; i < m_tracks.size(); ++i) {
            const bool isForward = distance(m_tracks[i].from.point, end) <= m_joint;
            if (!m_isUsed[i] && (isForward || distance(m_tracks[i].to, end) <= m_joint)) {
                m_isUsed[i] = true;
                Chain next = chainOf(m_tracks[i]);
                if (!isForward) {
                    next.reverse();
                }
                return next;
            }
        }
        return std::nullopt;
    }

    std::span<const OutlineTrack> m_tracks;
    double m_joint;
    std::vector<bool> m_isUsed;
};

/// Bridges ends of chains that face each other.
class Bridging {
public:
    explicit Bridging(std::vector<Chain> chains) : m_chains(std::move(chains)) {}

    [[nodiscard]] std::vector<BridgedLoop> run() {
        while (const std::optional<Pair> pair = closestPair()) {
            pair->a.chain == pair->b.chain ? close(pair->a.chain) : join(*pair);
        }
        return std::move(m_loops);
    }

private:
    struct End {
        std::size_t chain = 0;
        bool isEnd = false;
        bool operator==(const End&) const = default;
    };
    struct Pair {
        End a;
        End b;
        double gap = 0.0;
    };
    /// The end that is nearest to another one, if it is so by far.
    struct Nearest {
        End end;
        double gap = std::numeric_limits<double>::max();
        double next = std::numeric_limits<double>::max();
        [[nodiscard]] bool isClear() const { return gap < next && gap * kClearer <= next; }
    };

    [[nodiscard]] Point at(End end) const { return m_chains[end.chain].at(end.isEnd); }

    [[nodiscard]] Nearest nearestTo(End end) const {
        Nearest nearest;
        for (std::size_t i = 0; i < 2 * m_chains.size(); ++i) {
            const End other{i / 2, i % 2 != 0};
            const double gap = other == end ? nearest.next : distance(at(end), at(other));
            if (gap < nearest.gap) {
                nearest.next = nearest.gap;
                nearest.gap = gap;
                nearest.end = other;
            } else {
                nearest.next = std::min(nearest.next, gap);
            }
        }
        return nearest;
    }

    [[nodiscard]] std::optional<Pair> closestPair() const {
        std::optional<Pair> best;
        for (std::size_t i = 0; i < 2 * m_chains.size(); ++i) {
            const End end{i / 2, i % 2 != 0};
            const Nearest nearest = nearestTo(end);
            const bool isBest = nearest.isClear() && (!best || nearest.gap < best->gap) && mayJoin(end, nearest);
            if (isBest && nearestTo(nearest.end).end == end && nearestTo(nearest.end).isClear()) {
                best = Pair{end, nearest.end, nearest.gap};
            }
        }
        return best;
    }

    [[nodiscard]] bool mayJoin(End end, const Nearest& nearest) const {
        const Chain& a = m_chains[end.chain];
        const Chain& b = m_chains[nearest.end.chain];
        const bool isOwn = end.chain == nearest.end.chain;
        return isOwn ? a.nodes.size() > 1 && a.open() + nearest.gap <= kMostOpen * a.drawn
                     : a.open() + b.open() + nearest.gap <= kMostOpen * (a.drawn + b.drawn);
    }

    void close(std::size_t row) {
        Chain chain = std::move(m_chains[row]);
        m_chains.erase(m_chains.begin() + static_cast<std::ptrdiff_t>(row));
        chain.gaps.push_back({chain.end, chain.nodes.front().point});
        chain.nodes.push_back(lineFrom(chain.end));
        m_loops.push_back({std::move(chain.nodes), std::move(chain.gaps), chain.trackCount});
    }

    void join(const Pair& pair) {
        Chain& first = m_chains[pair.a.chain];
        Chain second = std::move(m_chains[pair.b.chain]);
        if (!pair.a.isEnd) {
            first.reverse();
        }
        if (pair.b.isEnd) {
            second.reverse();
        }
        first.append(std::move(second), true);
        m_chains.erase(m_chains.begin() + static_cast<std::ptrdiff_t>(pair.b.chain));
    }

    std::vector<Chain> m_chains;
    std::vector<BridgedLoop> m_loops;
};

}  // namespace

std::vector<BridgedLoop> bridgedLoops(std::span<const OutlineTrack> tracks, double joint) {
    if (tracks.size() > kMostTracks) {
        return {};
    }
    std::vector<Chain> chains = Chaining(tracks, joint).run();
    return chains.size() <= kMostChains ? Bridging(std::move(chains)).run() : std::vector<BridgedLoop>();
}

std::string gapsText(const BridgedLoop& loop) {
    const OutlineGap widest = *std::ranges::max_element(loop.gaps, {}, widthOf);
    const std::size_t count = loop.gaps.size();
    std::array<char, 200> text{};
    std::snprintf(text.data(), text.size(),
                  count == 1 ? "by %.2f mm at (%.2f, %.2f) mm" : "by up to %.2f mm, most at (%.2f, %.2f) mm",
                  widthOf(widest) / 1e6, (double(widest.from.x) + widest.to.x) / 2e6,
                  (double(widest.from.y) + widest.to.y) / 2e6);
    return "the board's outline is open " + (count == 1 ? "" : "at " + std::to_string(count) + " locations, ") +
           text.data() + (count == 1 ? "; a straight line closes it" : "; straight lines close it");
}

}  // namespace model::formats
