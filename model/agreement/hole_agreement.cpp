#include "model/agreement/hole_agreement.h"

#include <algorithm>
#include <cmath>

#include "model/agreement/point_matcher.h"
#include "model/geometry/vectors.h"
#include "model/text/formatting.h"

namespace model {

namespace {

using Hole = FlatBoard::Hole;

/// Drill files in inches have four decimals: places and sizes in them are rounded to multiples of this.
constexpr Nm kTenthOfMil = 2'540;

bool isNear(Nm a, Nm b, Nm reach = kSamePlace) {
    return std::abs(std::int64_t{a} - b) <= reach;
}

bool isRound(const Hole& hole) {
    return isNear(hole.width, hole.height);
}

/// By how much a job may have rounded its holes: nothing if any of their sizes is no multiple, or none tells.
Nm roundingOf(const FlatBoard& board) {
    const bool isRounded = std::ranges::all_of(board.holes, [](const Hole& hole) {
        const Nm rest = hole.width % kTenthOfMil;
        return !isRound(hole) || std::min(rest, kTenthOfMil - rest) <= 1;
    });
    return isRounded && std::ranges::any_of(board.holes, isRound) ? kTenthOfMil / 2 : 0;
}

/// How far two numbers of holes may be apart. The ends of slots may be polygons with chords, up to a pixel off at
/// either.
struct Reach {
    Nm location = kSamePlace;
    Nm hole = kSamePlace;  ///< sizes of round holes
    Nm slot = kSamePlace;  ///< and of others
};

bool isSameSize(const Hole& a, const Hole& b, Reach reaches) {
    const Nm reach = isRound(a) && isRound(b) ? reaches.hole : reaches.slot;
    return isNear(a.width, b.width, reach) && isNear(a.height, b.height, reach);
}

bool isSameSpan(const Hole& a, const Hole& b) {
    return a.top == b.top && a.bottom == b.bottom;
}

std::string sizeText(const Hole& hole) {
    const std::string width = fixedText(base::toMm(hole.width), 3);
    return (isRound(hole) ? width : width + " x " + fixedText(base::toMm(hole.height), 3)) + " mm";
}

std::string spanText(const Hole& hole) {
    return hole.top < 0 ? "no known copper"
                        : "copper " + std::to_string(hole.top + 1) + " to " + std::to_string(hole.bottom + 1);
}

/// What of two holes at one location differs; empty if nothing does.
std::string difference(const Hole& a, const Hole& b, Reach reach) {
    const auto differs = [](const std::string& ours, const std::string& theirs) {
        return ours + " in A, " + theirs + " in B";
    };
    if (!isSameSize(a, b, reach)) {
        return "a hole is " + differs(sizeText(a), sizeText(b));
    }
    if (a.isPlated != b.isPlated) {
        return "a hole of " + sizeText(a) + " is " +
               (a.isPlated ? differs("plated", "not plated") : differs("not plated", "plated"));
    }
    return isSameSpan(a, b) ? "" : "a hole of " + sizeText(a) + " passes " + differs(spanText(a), spanText(b));
}

std::string kindText(const Hole& hole) {
    return std::string(hole.isPlated ? "plated" : "non-plated") + " hole of " + sizeText(hole);
}

class HoleComparer {
public:
    HoleComparer(const FlatBoard& a, const FlatBoard& b, Nm reach, const AgreementRequest& request)
        : m_a(a),
          m_b(b),
          m_request(request),
          m_reach{reach + roundingOf(a) + roundingOf(b), kSamePlace + roundingOf(a) + roundingOf(b),
                  2 * request.tolerance},
          m_matcher(b.holes.empty() ? std::vector<Point>() : locationsOf(b)) {}

    Comparison run() {
        m_found.aspect = Aspect::Holes;
        m_found.counts = {m_a.holes.size(), m_b.holes.size()};
        std::vector<const Hole*> elsewhere;
        for (const Hole& hole : m_a.holes) {
            if (!compareAtItsPlace(hole)) {
                elsewhere.push_back(&hole);
            }
        }
        // Only what no other hole lies at may have been moved.
        for (const Hole* hole : elsewhere) {
            if (!compareNearby(*hole)) {
                add("only A has a " + kindText(*hole), *hole);
            }
        }
        for (std::size_t row = 0; row < m_b.holes.size(); ++row) {
            if (!m_matcher.isTaken(row)) {
                add("only B has a " + kindText(m_b.holes[row]), m_b.holes[row]);
            }
        }
        return std::move(m_found);
    }

private:
    void add(const std::string& text, const Hole& at) { m_found.add({text, at.middle}, m_request.most); }

    [[nodiscard]] int unlike(const Hole& hole, const Hole& other) const {
        return (isSameSize(hole, other, m_reach) ? 0 : 4) + (hole.isPlated == other.isPlated ? 0 : 2) +
               (isSameSpan(hole, other) ? 0 : 1);
    }

    bool compareAtItsPlace(const Hole& hole) {
        const auto found = m_matcher.take(hole.middle, m_reach.location,
                                          [&](std::size_t row) { return unlike(hole, m_b.holes[row]); });
        if (!found) {
            return false;
        }
        const Hole& other = m_b.holes[*found];
        m_found.measure(hole.middle, other.middle);
        const std::string text = difference(hole, other, m_reach);
        if (!text.empty()) {
            add(text, hole);
        }
        return true;
    }

    /// One that is like it in all else and less than its width away is taken for the same hole, moved.
    bool compareNearby(const Hole& hole) {
        const auto found = m_matcher.take(hole.middle, std::min(hole.width, hole.height),
                                          [&](std::size_t row) { return unlike(hole, m_b.holes[row]) == 0 ? 0 : -1; });
        if (found) {
            const Point other = m_b.holes[*found].middle;
            m_found.measure(hole.middle, other);
            const double by = distance(hole.middle, other);
            add("a " + kindText(hole) + " is moved by " + fixedText(base::toMm(by), 4) + " mm", hole);
        }
        return found.has_value();
    }

    const FlatBoard& m_a;
    const FlatBoard& m_b;
    const AgreementRequest& m_request;
    Reach m_reach;
    PointMatcher m_matcher;
    Comparison m_found;
};

}  // namespace

Comparison compareHoles(const FlatBoard& a, const FlatBoard& b, Nm reach, const AgreementRequest& request) {
    return HoleComparer(a, b, reach, request).run();
}

}  // namespace model
