#pragma once

#include <cstdint>

#include "model/base/point.h"

/// The two predicates of every triangulation in plain integers: no rounding, no filter, no special case.
///
/// Coordinates are at most 2^30 in size, and a triangulation's bounding corners reach an eighth of the extent further,
/// so two points differ by S <= 1.25 * 2^31 in each axis:
///  - orient: twice the area of a triangle in a square of side S, so at most S^2 < 2^63;
///  - in-circle: at most S^4 < 2^126 in size, although a lift (squared distance) needs all 64 bits unsigned.
namespace tri {

using base::Point;
using Int128 = __int128;

/// Twice the signed area of (a, b, c): > 0 if they turn counter-clockwise, 0 if they are collinear.
constexpr std::int64_t orient(Point a, Point b, Point c) {
    return (std::int64_t{b.x} - a.x) * (std::int64_t{c.y} - a.y) -
           (std::int64_t{b.y} - a.y) * (std::int64_t{c.x} - a.x);
}

/// Points that differ by less than this in each axis have lifts (squared distances) that fit into 63 bits.
inline constexpr std::int64_t kCompactExtent = std::int64_t{1} << 31;

/// For a counter-clockwise triangle (a, b, c): > 0 if d lies inside its circumscribed circle, 0 if it lies on it. For
/// points within kCompactExtent (2.1 m: any board) `Lift` may be a signed 64-bit number, which makes every product a
/// single multiplication of the processor.
template <class Lift = std::uint64_t>
constexpr Int128 inCircle(Point a, Point b, Point c, Point d) {
    const std::int64_t ax = std::int64_t{a.x} - d.x, ay = std::int64_t{a.y} - d.y;
    const std::int64_t bx = std::int64_t{b.x} - d.x, by = std::int64_t{b.y} - d.y;
    const std::int64_t cx = std::int64_t{c.x} - d.x, cy = std::int64_t{c.y} - d.y;
    const auto lift = [](std::int64_t x, std::int64_t y) {
        return Int128{static_cast<Lift>(static_cast<Lift>(x * x) + static_cast<Lift>(y * y))};
    };
    // Each product fits into 128 bits signed (2^64 * 2^62.7), and so does the sum of two of them.
    return lift(ax, ay) * (bx * cy - by * cx) + lift(bx, by) * (cx * ay - cy * ax) + lift(cx, cy) * (ax * by - ay * bx);
}

/// A point as seen from another one, lifted; what many in-circle tests about one point have in common. For `Lift`
/// see inCircle.
template <class Lift>
struct Seen {
    std::int64_t x;
    std::int64_t y;
    Lift lift;

    static constexpr Seen from(Point eye, Point p) {
        const std::int64_t x = std::int64_t{p.x} - eye.x, y = std::int64_t{p.y} - eye.y;
        return {x, y, static_cast<Lift>(static_cast<Lift>(x * x) + static_cast<Lift>(y * y))};
    }
};

/// Twice the signed area of (eye, a, b).
template <class Lift>
constexpr std::int64_t orientation(const Seen<Lift>& a, const Seen<Lift>& b) {
    return a.x * b.y - a.y * b.x;
}

/// -inCircle(eye, a, b, d) from what is seen from the eye: the same number, its terms in another order.
template <class Lift>
constexpr Int128 outsideCircleOfEye(const Seen<Lift>& a, const Seen<Lift>& b, const Seen<Lift>& d, std::int64_t turnAB,
                                    std::int64_t turnBD, std::int64_t turnAD) {
    return Int128{a.lift} * turnBD - Int128{b.lift} * turnAD + Int128{d.lift} * turnAB;
}

/// A point with the number that breaks ties between points on one circle.
struct Site {
    Point at;
    std::uint32_t id;
};

/// For a counter-clockwise triangle (a, b, c) with d on its circle: is d inside after every site was lifted by an
/// infinitesimal amount, the lowest id by far the most (simulation of simplicity)? Never a tie for four different
/// points, which makes the Delaunay triangulation unique. Lifting a site changes the determinant by its cofactor; three
/// points of a circle are never collinear, so the lowest id decides.
constexpr bool isInPerturbedCircleOnCircle(const Site& a, const Site& b, const Site& c, const Site& d) {
    const std::uint32_t low = a.id < b.id ? a.id : b.id;
    const std::uint32_t lowest = low < c.id ? low : c.id;
    if (d.id < lowest) {
        return false;  // its cofactor is -orient(a, b, c)
    }
    const Point& p = lowest == a.id ? b.at : (lowest == b.id ? c.at : a.at);
    const Point& q = lowest == a.id ? c.at : (lowest == b.id ? a.at : b.at);
    return orient(p, q, d.at) > 0;
}

/// inCircle > 0, or isInPerturbedCircleOnCircle where it is 0.
constexpr bool isInPerturbedCircle(const Site& a, const Site& b, const Site& c, const Site& d) {
    const Int128 exact = inCircle(a.at, b.at, c.at, d.at);
    return exact != 0 ? exact > 0 : isInPerturbedCircleOnCircle(a, b, c, d);
}

}  // namespace tri
