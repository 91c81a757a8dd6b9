#include "model/formats/gerber/placement_shift.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdlib>
#include <tuple>

#include "model/base/median.h"

namespace model::gerber {

namespace {

constexpr Nm kMargin = 200'000;             ///< of the box around pins: those of a two-terminal part are on a line
constexpr Nm kReach = 20'000;               ///< of a place to a pin, or to the middle of pins, that is meant
constexpr std::size_t kMostParts = 500;     ///< that are looked at
constexpr std::size_t kMostShifts = 2'000;  ///< that are tried

/// In 64 bits: shifts lead beyond the largest coordinate, and files may count from beyond it.
struct Shift {
    std::int64_t x = 0;
    std::int64_t y = 0;
};

struct Part {
    Shift place;
    Box box;                     ///< around the pins, grown
    std::vector<Point> targets;  ///< where programs place parts: the middle of the pins, pins
};

Shift between(Shift from, Point to) {
    return {to.x - from.x, to.y - from.y};
}

bool isAt(Shift shift, Shift place, Point target) {
    const Shift own = between(place, target);
    return std::abs(own.x - shift.x) <= kReach && std::abs(own.y - shift.y) <= kReach;
}

std::vector<Part> partsFrom(std::span<const PlacedPins> placed) {
    std::vector<Part> parts;
    const std::size_t step = placed.size() / kMostParts + 1;
    for (std::size_t i = 0; i < placed.size(); i += step) {
        Part part{{std::llround(placed[i].place.x), std::llround(placed[i].place.y)}, {}, {}};
        for (const Point pin : placed[i].pins) {
            part.box.include(pin);
        }
        part.targets.push_back(part.box.middle());
        part.targets.insert(part.targets.end(), placed[i].pins.begin(), placed[i].pins.end());
        part.box = part.box.grownBy(kMargin);
        parts.push_back(std::move(part));
    }
    return parts;
}

struct Score {
    std::size_t inside = 0;
    std::size_t exact = 0;
};

Score scoreOf(const std::vector<Part>& parts, Shift shift) {
    Score score;
    for (const Part& part : parts) {
        const std::int64_t x = part.place.x + shift.x;
        const std::int64_t y = part.place.y + shift.y;
        if (x >= part.box.min.x && x <= part.box.max.x && y >= part.box.min.y && y <= part.box.max.y) {
            ++score.inside;
            const auto isMeant = [&](Point target) { return isAt(shift, part.place, target); };
            score.exact += std::ranges::any_of(part.targets, isMeant) ? 1 : 0;
        }
    }
    return score;
}

/// The middles of all parts first, then their pins in turn.
std::vector<Shift> likelyShifts(const std::vector<Part>& parts) {
    std::vector<Shift> shifts;
    bool isLeft = true;
    for (std::size_t i = 0; isLeft && shifts.size() < kMostShifts; ++i) {
        isLeft = false;
        for (const Part& part : parts) {
            if (i < part.targets.size()) {
                shifts.push_back(between(part.place, part.targets[i]));
                isLeft = true;
            }
        }
    }
    return shifts;
}

/// Off rounding: the median of what agrees with it.
Shift refined(const std::vector<Part>& parts, Shift shift) {
    std::vector<std::int64_t> xs{shift.x};
    std::vector<std::int64_t> ys{shift.y};
    for (const Part& part : parts) {
        for (const Point target : part.targets) {
            if (isAt(shift, part.place, target)) {
                xs.push_back(between(part.place, target).x);
                ys.push_back(between(part.place, target).y);
            }
        }
    }
    return {base::medianOf(xs), base::medianOf(ys)};
}

}  // namespace

std::optional<Point> placementShift(std::span<const PlacedPins> placed) {
    const std::vector<Part> parts = partsFrom(placed);
    const Score unshifted = scoreOf(parts, {});
    Score best = unshifted;
    Shift shift;
    for (const Shift candidate : likelyShifts(parts)) {
        const Score score = scoreOf(parts, candidate);
        if (std::tie(score.inside, score.exact) > std::tie(best.inside, best.exact)) {
            best = score;
            shift = candidate;
        }
    }
    if (2 * best.inside <= parts.size()) {
        return std::nullopt;
    }
    if (unshifted.inside == best.inside) {
        return Point{};
    }
    shift = refined(parts, shift);
    const bool isOnBoards = std::max(std::abs(shift.x), std::abs(shift.y)) <= base::kMaxCoordinate;
    return isOnBoards ? std::optional(Point{static_cast<Nm>(shift.x), static_cast<Nm>(shift.y)}) : std::nullopt;
}

}  // namespace model::gerber
