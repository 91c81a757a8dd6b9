#include "model/section/intervals.h"

#include <algorithm>

namespace model {

Intervals united(std::vector<Interval> pieces) {
    std::erase_if(pieces, [](const Interval& piece) { return !(piece.from < piece.to); });
    std::ranges::sort(pieces, {}, &Interval::from);
    Intervals out;
    for (const Interval& piece : pieces) {
        if (out.empty() || piece.from > out.back().to) {
            out.push_back(piece);
        } else {
            out.back().to = std::max(out.back().to, piece.to);
        }
    }
    return out;
}

Intervals common(const Intervals& a, const Intervals& b) {
    return subtracted(a, subtracted(a, b));
}

Intervals subtracted(const Intervals& from, const Intervals& what) {
    Intervals out;
    for (const Interval& piece : from) {
        double start = piece.from;
        auto next = std::ranges::upper_bound(what, start, {}, &Interval::to);
        for (; next != what.end() && next->from < piece.to; ++next) {
            if (next->from > start) {
                out.push_back({start, next->from});
            }
            start = next->to;
        }
        if (start < piece.to) {
            out.push_back({start, piece.to});
        }
    }
    return out;
}

Intervals clipped(const Intervals& pieces, double from, double to) {
    Intervals out;
    for (const Interval& piece : pieces) {
        const Interval clipped{std::max(piece.from, from), std::min(piece.to, to)};
        if (clipped.from < clipped.to) {
            out.push_back(clipped);
        }
    }
    return out;
}

}  // namespace model
