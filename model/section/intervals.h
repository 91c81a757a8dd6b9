#pragma once

#include <vector>

namespace model {

/// A piece of a line, in nanometres along it.
struct Interval {
    double from = 0.0;
    double to = 0.0;
    bool operator==(const Interval&) const = default;
};

/// Pieces of one line: each longer than nothing, in rising order, apart from each other.
using Intervals = std::vector<Interval>;

/// The locations that at least one of the pieces covers. They may come in any order, overlap, and be empty or turned
/// round (which counts as nothing). Pieces that touch become one.
[[nodiscard]] Intervals united(std::vector<Interval> pieces);
/// What both of them cover.
[[nodiscard]] Intervals common(const Intervals& a, const Intervals& b);
/// What `from` covers and `what` does not.
[[nodiscard]] Intervals subtracted(const Intervals& from, const Intervals& what);
/// What lies between two locations.
[[nodiscard]] Intervals clipped(const Intervals& pieces, double from, double to);

}  // namespace model
