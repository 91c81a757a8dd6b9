#include "model/agreement/hole_agreement.h"

#include "model/agreement/point_matcher.h"
#include "model/text/formatting.h"

namespace model {

namespace {

using Hole = FlatBoard::Hole;

bool isNear(Nm a, Nm b, Nm reach = kSamePlace) {
    return std::abs(std::int64_t{a} - b) <= reach;
}

bool isRound(const Hole& hole) {
    return isNear(hole.width, hole.height);
}

/// Slots may be polygons with chords for their ends, up to a pixel off at either.
bool isSameSize(const Hole& a, const Hole& b, Nm pixel) {
    const Nm reach = isRound(a) && isRound(b) ? kSamePlace : 2 * pixel;
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
std::string difference(const Hole& a, const Hole& b, Nm pixel) {
    const auto differs = [](const std::string& ours, const std::string& theirs) {
        return ours + " in A, " + theirs + " in B";
    };
    if (!isSameSize(a, b, pixel)) {
        return "a hole is " + differs(sizeText(a), sizeText(b));
    }
    if (a.isPlated != b.isPlated) {
        return "a hole of " + sizeText(a) + " is " +
               (a.isPlated ? differs("plated", "not plated") : differs("not plated", "plated"));
    }
    return isSameSpan(a, b) ? "" : "a hole of " + sizeText(a) + " passes " + differs(spanText(a), spanText(b));
}

std::string onlyIn(const char* board, const Hole& hole) {
    return std::string("only ") + board + " has a " + (hole.isPlated ? "plated" : "non-plated") + " hole of " +
           sizeText(hole);
}

}  // namespace

Comparison compareHoles(const FlatBoard& a, const FlatBoard& b, const AgreementRequest& request) {
    Comparison comparison;
    comparison.aspect = Aspect::Holes;
    comparison.counts = {a.holes.size(), b.holes.size()};
    PointMatcher matcher(locationsOf(b));
    for (const Hole& hole : a.holes) {
        const auto unlike = [&](std::size_t row) {
            const Hole& other = b.holes[row];
            return (isSameSize(hole, other, request.tolerance) ? 0 : 4) + (hole.isPlated == other.isPlated ? 0 : 2) +
                   (isSameSpan(hole, other) ? 0 : 1);
        };
        const auto found = b.holes.empty() ? std::nullopt : matcher.take(hole.middle, kSamePlace, unlike);
        if (found) {
            comparison.measure(hole.middle, b.holes[*found].middle);
        }
        const std::string text = found ? difference(hole, b.holes[*found], request.tolerance) : onlyIn("A", hole);
        if (!text.empty()) {
            comparison.add({text, hole.middle}, request.most);
        }
    }
    for (std::size_t row = 0; row < b.holes.size(); ++row) {
        if (!matcher.isTaken(row)) {
            comparison.add({onlyIn("B", b.holes[row]), b.holes[row].middle}, request.most);
        }
    }
    return comparison;
}

}  // namespace model
