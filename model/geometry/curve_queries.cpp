#include "model/geometry/curve_queries.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

#include "model/geometry/bernstein.h"
#include "model/geometry/nurbs.h"
#include "model/geometry/vectors.h"

namespace model {

namespace {

constexpr double kTiny = 1e-4;  ///< nm

/// The extent of points, in doubles.
struct Extent {
    PointD min{std::numeric_limits<double>::infinity(), std::numeric_limits<double>::infinity()};
    PointD max{-std::numeric_limits<double>::infinity(), -std::numeric_limits<double>::infinity()};

    void include(PointD p) {
        min = {std::min(min.x, p.x), std::min(min.y, p.y)};
        max = {std::max(max.x, p.x), std::max(max.y, p.y)};
    }
    [[nodiscard]] bool nearlyHolds(PointD p) const {
        return p.x >= min.x - kTiny && p.y >= min.y - kTiny && p.x <= max.x + kTiny && p.y <= max.y + kTiny;
    }
    [[nodiscard]] bool meets(const Extent& other) const {
        return min.x <= other.max.x && other.min.x <= max.x && min.y <= other.max.y && other.min.y <= max.y;
    }
};

Extent hullExtent(const Bezier& piece) {
    Extent extent;
    for (const Homogeneous& control : piece.controls()) {
        extent.include(projected(control));
    }
    return extent;
}

Edge chordOf(const Bezier& piece) {
    Edge chord;
    chord.a = piece.start();
    chord.b = piece.end();
    return chord;
}

}  // namespace

Box boxOf(std::span<const Bezier> pieces) {
    Extent extent;
    for (const Bezier& piece : pieces) {
        extent.include(piece.start());
        extent.include(piece.end());
    }
    const auto isInside = [&](const Bezier& piece) {
        return std::ranges::all_of(piece.controls(),
                                   [&](const Homogeneous& control) { return extent.nearlyHolds(projected(control)); });
    };
    const auto isFine = [&](const Bezier& piece) {
        extent.include(piece.start());
        extent.include(piece.end());
        return isInside(piece);
    };
    subdivide(pieces, isFine, [](const Bezier&) {});
    constexpr double kUnseen = 1e-3;
    return {{toNm(std::floor(extent.min.x + kUnseen)), toNm(std::floor(extent.min.y + kUnseen))},
            {toNm(std::ceil(extent.max.x - kUnseen)), toNm(std::ceil(extent.max.y - kUnseen))}};
}

namespace {

/// The integral over the curve of what `value` makes of a point and its derivatives, per unit of the parameter. Gauss's
/// rule of five points, halving where two halves differ from the whole by more than `tolerance`.
template <class Value>
double integral(const Bezier& piece, double tolerance, const Value& value) {
    constexpr std::array<double, 3> kAt = {0.0, 0.5384693101056831, 0.9061798459386640};
    constexpr std::array<double, 3> kWeight = {0.5688888888888889, 0.4786286704993665, 0.2369268850561891};
    const auto gauss = [&](double from, double to) {
        const double middle = (from + to) / 2;
        const double half = (to - from) / 2;
        double sum = kWeight[0] * value(piece.at(middle));
        for (std::size_t i = 1; i < 3; ++i) {
            sum += kWeight[i] * (value(piece.at(middle - half * kAt[i])) + value(piece.at(middle + half * kAt[i])));
        }
        return sum * half;
    };
    struct Open {
        double from;
        double to;
        double whole;
    };
    const double narrow = (piece.to() - piece.from()) * 1e-9;
    std::vector<Open> open{{piece.from(), piece.to(), gauss(piece.from(), piece.to())}};
    double sum = 0;
    while (!open.empty()) {
        const Open now = open.back();
        open.pop_back();
        const double middle = (now.from + now.to) / 2;
        const double before = gauss(now.from, middle);
        const double after = gauss(middle, now.to);
        if (std::abs(before + after - now.whole) <= tolerance || now.to - now.from <= narrow) {
            sum += before + after;
        } else {
            open.push_back({middle, now.to, after});
            open.push_back({now.from, middle, before});
        }
    }
    return sum;
}

/// Length of the control polygon: no curve is longer.
double hullLength(const Bezier& piece) {
    double sum = 0;
    for (std::size_t i = 0; i < piece.degree(); ++i) {
        sum += distance(projected(piece.controls()[i]), projected(piece.controls()[i + 1]));
    }
    return sum;
}

}  // namespace

double lengthOf(std::span<const Bezier> pieces) {
    double sum = 0;
    for (const Bezier& piece : pieces) {
        sum += integral(piece, std::max(1e-5, 1e-14 * hullLength(piece)),
                        [](const CurvePoint& p) { return length(p.first); });
    }
    return sum;
}

double areaUnder(std::span<const Bezier> pieces, PointD base) {
    double sum = 0;
    for (const Bezier& piece : pieces) {
        const PointD start = piece.start();
        const double size = hullLength(piece);
        // Seen from its own start, so that no digits are lost to a far base.
        sum += cross(minus(start, base), minus(piece.end(), base)) / 2;
        sum += integral(piece, std::max(1e-4 * size, 1e-15 * size * size),
                        [&](const CurvePoint& p) { return cross(minus(p.point, start), p.first) / 2; });
    }
    return sum;
}

namespace {

/// The search for the nearest point: parts of the curve that may still hold a nearer one than is known.
class NearestSearch {
public:
    NearestSearch(std::span<const Bezier> pieces, PointD p) : m_p(p) {
        m_best.distance = std::numeric_limits<double>::infinity();
        for (const Bezier& piece : pieces) {
            offer(piece.start(), piece.from());
            offer(piece.end(), piece.to());
        }
        for (const Bezier& piece : pieces) {
            approach(piece);
        }
        const auto isDone = [this](const Bezier& piece) { return isSettled(piece); };
        subdivide(pieces, isDone, [](const Bezier&) {});
    }

    [[nodiscard]] const OnCurve& best() const { return m_best; }

private:
    static constexpr double kSettled = 5e-4;  // nm

    void offer(PointD at, double parameter) {
        if (const double d = distance(at, m_p); d < m_best.distance) {
            m_best = {at, parameter, d};
        }
    }

    /// Newton's steps towards where the curve runs across the line to the point, from the middle of a piece.
    void approach(const Bezier& piece) {
        double parameter = (piece.from() + piece.to()) / 2;
        for (int step = 0; step < 8; ++step) {
            const CurvePoint now = piece.at(parameter);
            offer(now.point, parameter);
            const PointD delta = minus(now.point, m_p);
            const double slope = dot(now.first, now.first) + dot(delta, now.second);
            if (!(slope > 0)) {
                return;
            }
            const double next = std::clamp(parameter - dot(delta, now.first) / slope, piece.from(), piece.to());
            if (next == parameter) {
                return;
            }
            parameter = next;
        }
    }

    /// Can no point of the piece be nearer by more than kSettled? The hull lies no farther from the chord than its
    /// control points.
    bool isSettled(const Bezier& piece) {
        const double least = distance(nearestOn(chordOf(piece), m_p), m_p) - piece.hullBesideChord();
        if (least < m_best.distance - kSettled) {
            approach(piece);
        }
        return least >= m_best.distance - kSettled;
    }

    PointD m_p;
    OnCurve m_best;
};

}  // namespace

OnCurve nearestOn(std::span<const Bezier> pieces, PointD p) {
    return NearestSearch(pieces, p).best();
}

int windingAround(std::span<const Bezier> pieces, PointD p) {
    int winding = 0;
    // A piece whose hull does not hold the point winds around it as its chord does.
    const auto isBeside = [&](const Bezier& piece) {
        const double hull = piece.hullBesideChord();
        return hull < 1e-6 || distance(nearestOn(chordOf(piece), p), p) > hull;
    };
    subdivide(pieces, isBeside, [&](const Bezier& piece) { winding += windingAround(chordOf(piece), p); });
    return winding;
}

namespace {

constexpr double kTouching = 1e-6;  ///< nm
constexpr double kAlong = 1e3;      ///< nm: what coincides for longer than this does not cross there

double leastWeight(const Bezier& piece) {
    return std::ranges::min(piece.controls(), {}, &Homogeneous::w).w;
}

std::vector<Stretch> stretchesOn(const Bezier& piece, const Edge& edge) {
    const double weight = leastWeight(piece);
    if (edge.isArc()) {
        return rootsOf(besideCircle(piece, edge.centre, edge.radius), kTouching * 2 * edge.radius * weight * weight);
    }
    const PointD along = minus(edge.b, edge.a);
    const double full = length(along);
    return full > 0 ? rootsOf(besideLine(piece, edge.a, {along.x / full, along.y / full}), kTouching * weight)
                    : std::vector<Stretch>{};
}

/// Does a point that lies on the line or circle of an edge lie on the edge?
bool isOn(const Edge& edge, PointD p) {
    if (edge.isArc()) {
        return passes(edge, minus(p, edge.centre));
    }
    const PointD along = minus(edge.b, edge.a);
    const double ahead = dot(minus(p, edge.a), along);
    return ahead >= 0 && ahead <= dot(along, along);
}

}  // namespace

std::vector<OnCurve> crossingsOf(std::span<const Bezier> pieces, const Edge& edge) {
    std::vector<Stretch> stretches;  // of the curve's parameter; one that goes on in the next piece is one
    for (const Bezier& piece : pieces) {
        const auto parameterAt = [&](double t) {
            return t == 1.0 ? piece.to() : piece.from() + t * (piece.to() - piece.from());
        };
        for (const Stretch& stretch : stretchesOn(piece, edge)) {
            const Stretch own = {parameterAt(stretch.from), parameterAt(stretch.to)};
            if (!stretches.empty() && stretches.back().to == own.from) {
                stretches.back().to = own.to;
            } else {
                stretches.push_back(own);
            }
        }
    }
    std::vector<OnCurve> crossings;
    for (const Stretch& stretch : stretches) {
        const double parameter = (stretch.from + stretch.to) / 2;
        const PointD point = pointAt(pieces, parameter);
        const bool isAlong = distance(pointAt(pieces, stretch.from), pointAt(pieces, stretch.to)) > kAlong;
        if (!isAlong && isOn(edge, point)) {
            crossings.push_back({point, parameter, 0.0});
        }
    }
    return crossings;
}

namespace {

/// Do all control points lie farther from the line along a piece, on one side, than its own do?
bool isBesideStrip(const Bezier& piece, const Bezier& other) {
    const PointD chord = minus(piece.end(), piece.start());
    const double full = length(chord);
    if (full == 0) {
        return false;
    }
    const auto [least, most] = [&] {
        double low = 0;
        double high = 0;
        for (const Homogeneous& control : piece.controls()) {
            const double beside = cross(chord, minus(projected(control), piece.start())) / full;
            low = std::min(low, beside);
            high = std::max(high, beside);
        }
        return std::array{low, high};
    }();
    double low = std::numeric_limits<double>::infinity();
    double high = -low;
    for (const Homogeneous& control : other.controls()) {
        const double beside = cross(chord, minus(projected(control), piece.start())) / full;
        low = std::min(low, beside);
        high = std::max(high, beside);
    }
    return low > most + kTiny || high < least - kTiny;
}

bool areApart(const Bezier& a, const Bezier& b) {
    return !hullExtent(a).meets(hullExtent(b)) || isBesideStrip(a, b) || isBesideStrip(b, a);
}

void addIfNew(std::vector<PointD>& points, PointD p) {
    if (std::ranges::none_of(points, [&](PointD known) { return distance(known, p) < 1e-2; })) {
        points.push_back(p);
    }
}

}  // namespace

std::vector<PointD> crossingsOf(std::span<const Bezier> a, std::span<const Bezier> b) {
    // Curves that cross are parted in a few hundred steps; those that run along each other never are.
    constexpr int kMostSteps = 100000;
    std::vector<std::pair<Bezier, Bezier>> open;
    for (const Bezier& own : a) {
        for (const Bezier& other : b) {
            open.emplace_back(own, other);
        }
    }
    std::vector<PointD> crossings;
    for (int step = 0; step < kMostSteps && !open.empty(); ++step) {
        auto [own, other] = std::move(open.back());
        open.pop_back();
        if (areApart(own, other)) {
            continue;
        }
        const double ownBound = own.hullBesideChord();
        const double otherBound = other.hullBesideChord();
        if (std::max(ownBound, otherBound) <= kTiny) {
            for (const PointD p : crossingsOf(chordOf(own), chordOf(other))) {
                addIfNew(crossings, p);
            }
            continue;
        }
        Bezier& split = ownBound > otherBound ? own : other;
        const Bezier later = split.splitInMiddle();
        open.emplace_back(own, other);
        open.emplace_back(&split == &own ? later : own, &split == &own ? other : later);
    }
    return crossings;
}

}  // namespace model
