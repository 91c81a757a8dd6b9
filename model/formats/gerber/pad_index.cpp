#include "model/formats/gerber/pad_index.h"

#include <algorithm>
#include <iterator>
#include <tuple>
#include <unordered_map>

#include "model/base/median.h"
#include "model/formats/common/shift.h"

namespace model::gerber {

namespace {

constexpr std::size_t kVoters = 200;
constexpr std::size_t kMostPads = 20'000;
constexpr std::int64_t kVoteGrid = 20'000;
constexpr double kEnough = 0.5;
constexpr std::size_t kCandidates = 200;

/// How many pairs of a pad and a point are about so far apart, and how far the first of them.
struct Votes {
    int count = 0;
    Point first;
};

/// Every n-th, so that there are at most `most`.
template <class T>
std::vector<T> thinned(std::span<const T> items, std::size_t most) {
    const std::size_t step = items.size() / most + 1;
    std::vector<T> result;
    for (std::size_t i = 0; i < items.size(); i += step) {
        result.push_back(items[i]);
    }
    return result;
}

}  // namespace

PadIndex::PadIndex(std::vector<IndexedPad> pads) : m_pads(std::move(pads)) {
    std::ranges::stable_sort(m_pads, {}, [](const IndexedPad& pad) { return pad.position.x; });
    for (const IndexedPad& pad : m_pads) {
        m_box.include(pad.position);
    }
}

std::size_t PadIndex::firstFrom(std::int64_t x) const {
    const auto first =
        std::ranges::lower_bound(m_pads, x, {}, [](const IndexedPad& pad) { return std::int64_t{pad.position.x}; });
    return static_cast<std::size_t>(first - m_pads.begin());
}

bool PadIndex::has(Point p, Nm reach) const {
    bool isThere = false;
    visit(p, reach, [&](const IndexedPad&) { isThere = true; });
    return isThere;
}

double PadIndex::share(std::span<const Point> points, Point shift, Nm reach) const {
    const auto hits = std::ranges::count_if(points, [&](Point p) { return has(formats::moved(p, shift), reach); });
    return points.empty() ? 0.0 : static_cast<double>(hits) / static_cast<double>(points.size());
}

std::optional<Point> PadIndex::shiftOf(std::span<const Point> points, Nm reach) const {
    const std::vector<Point> voters = thinned(points, kVoters);
    if (voters.empty() || m_pads.empty()) {
        return std::nullopt;
    }
    if (share(voters, {}, reach) >= kEnough) {
        return Point{};
    }
    const std::vector<Point> shifts = likelyShifts(voters);
    const auto shareOf = [&](Point shift) { return share(voters, shift, reach); };
    const auto best = std::ranges::max_element(shifts, {}, shareOf);
    if (best == shifts.end() || shareOf(*best) < kEnough) {
        return std::nullopt;
    }
    return refined(*best, voters, reach);
}

std::vector<Point> PadIndex::likelyShifts(std::span<const Point> voters) const {
    std::unordered_map<std::uint64_t, Votes> votes;
    for (const IndexedPad& pad : thinned(std::span<const IndexedPad>(m_pads), kMostPads)) {
        for (const Point p : voters) {
            const std::int64_t dx = std::int64_t{pad.position.x} - p.x;
            const std::int64_t dy = std::int64_t{pad.position.y} - p.y;
            if (std::max(std::abs(dx), std::abs(dy)) > base::kMaxCoordinate) {
                continue;
            }
            const auto key = (static_cast<std::uint64_t>(dx / kVoteGrid + (1 << 20)) << 32) |
                             static_cast<std::uint64_t>(dy / kVoteGrid + (1 << 20));
            Votes& vote = votes[key];
            if (vote.count++ == 0) {
                vote.first = {static_cast<Nm>(dx), static_cast<Nm>(dy)};
            }
        }
    }
    std::vector<Votes> ranked;
    std::ranges::transform(votes, std::back_inserter(ranked), [](const auto& vote) { return vote.second; });
    const std::size_t count = std::min(ranked.size(), kCandidates);
    std::ranges::partial_sort(
        ranked, ranked.begin() + static_cast<std::ptrdiff_t>(count), [](const Votes& a, const Votes& b) {
            return std::tuple(b.count, a.first.x, a.first.y) < std::tuple(a.count, b.first.x, b.first.y);
        });
    std::vector<Point> shifts;
    for (std::size_t i = 0; i < count; ++i) {
        shifts.push_back(ranked[i].first);
    }
    return shifts;
}

Point PadIndex::refined(Point shift, std::span<const Point> voters, Nm reach) const {
    std::vector<Nm> xs;
    std::vector<Nm> ys;
    for (const Point p : voters) {
        visit(formats::moved(p, shift), reach, [&](const IndexedPad& pad) {
            xs.push_back(pad.position.x - p.x);
            ys.push_back(pad.position.y - p.y);
        });
    }
    return xs.empty() ? shift : Point{base::medianOf(xs), base::medianOf(ys)};
}

}  // namespace model::gerber
