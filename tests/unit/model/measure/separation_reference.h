#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>
#include <utility>
#include <vector>

#include "model/board/document_builder.h"
#include "tests/unit/model/hand_made.h"

/// Distances of elements in long double, by samples of their outlines and a search around the best: shares no code with
/// what is tested.
namespace measuring::reference {

using namespace model;
using namespace hand_made;

using Real = long double;

struct P {
    Real x = 0;
    Real y = 0;
};

/// A straight or circular piece of a curve, by a parameter from 0 to 1.
struct Curve {
    P a, b, centre;
    Real radius = 0;
    Real start = 0, sweep = 0;
    Real pen = 0;

    [[nodiscard]] P at(Real t) const {
        if (radius == 0) {
            return {a.x + (b.x - a.x) * t, a.y + (b.y - a.y) * t};
        }
        return {centre.x + radius * std::cos(start + sweep * t), centre.y + radius * std::sin(start + sweep * t)};
    }
};

inline Curve straight(P a, P b, Real pen = 0) {
    return {a, b, {}, 0, 0, 0, pen};
}

inline Curve arc(P centre, Real radius, Real start, Real sweep, Real pen = 0) {
    return {{}, {}, centre, radius, start, sweep, pen};
}

inline Real apart(P p, P q) {
    return std::hypot(p.x - q.x, p.y - q.y);
}

/// What the reference knows of an element: curves with pens, and whether they bound something.
struct Shape {
    std::vector<Curve> curves;
    bool isFilled = false;

    [[nodiscard]] bool holds(P p) const {
        Real rotated = 0;
        for (const Curve& curve : curves) {
            constexpr int kSteps = 400;
            P before = curve.at(0);
            for (int i = 1; i <= kSteps; ++i) {
                const P next = curve.at(Real(i) / kSteps);
                rotated += std::atan2((before.x - p.x) * (next.y - p.y) - (before.y - p.y) * (next.x - p.x),
                                      (before.x - p.x) * (next.x - p.x) + (before.y - p.y) * (next.y - p.y));
                before = next;
            }
        }
        return isFilled && std::abs(rotated) > std::numbers::pi_v<Real>;
    }
};

/// Least distance of two curves: all pairs of samples, then a search around the best ones with shrinking steps.
inline Real between(const Curve& c, const Curve& d) {
    constexpr int kSteps = 48;
    std::vector<std::pair<Real, std::pair<Real, Real>>> starts;
    for (int i = 0; i <= kSteps; ++i) {
        for (int j = 0; j <= kSteps; ++j) {
            starts.push_back(
                {apart(c.at(Real(i) / kSteps), d.at(Real(j) / kSteps)), {Real(i) / kSteps, Real(j) / kSteps}});
        }
    }
    std::partial_sort(starts.begin(), starts.begin() + 12, starts.end(),
                      [](const auto& x, const auto& y) { return x.first < y.first; });
    Real best = starts.front().first;
    for (int s = 0; s < 12; ++s) {
        auto [value, at] = starts[static_cast<std::size_t>(s)];
        for (Real step = Real(1) / kSteps; step > 1e-13L; step /= 2) {
            for (bool isBetter = true; isBetter;) {
                isBetter = false;
                for (const auto& [u, v] :
                     {std::pair<Real, Real>{1, 0}, {-1, 0}, {0, 1}, {0, -1}, {1, 1}, {-1, -1}, {1, -1}, {-1, 1}}) {
                    const Real t = std::clamp<Real>(at.first + u * step, 0, 1);
                    const Real w = std::clamp<Real>(at.second + v * step, 0, 1);
                    if (const Real next = apart(c.at(t), d.at(w)); next < value) {
                        value = next;
                        at = {t, w};
                        isBetter = true;
                    }
                }
            }
        }
        best = std::min(best, value);
    }
    return best - c.pen - d.pen;
}

inline Real between(const Shape& a, const Shape& b) {
    Real best = 1e18L;
    for (const Curve& c : a.curves) {
        for (const Curve& d : b.curves) {
            best = std::min(best, between(c, d));
        }
    }
    if (a.holds(b.curves.front().at(0)) || b.holds(a.curves.front().at(0))) {
        best = 0;
    }
    return std::max<Real>(best, 0);
}

inline P real(Point p) {
    return {Real(p.x), Real(p.y)};
}

inline Curve arcOf(Point from, Point centre, Point to, bool isClockwise, Real pen) {
    const P c = real(centre);
    const Real start = std::atan2(from.y - c.y, from.x - c.x);
    Real sweep = std::atan2(to.y - c.y, to.x - c.x) - start;
    const Real turn = 2 * std::numbers::pi_v<Real>;
    sweep = isClockwise ? (sweep >= 0 ? sweep - turn : sweep) : (sweep <= 0 ? sweep + turn : sweep);
    return arc(c, (apart(real(from), c) + apart(real(to), c)) / 2, start, sweep, pen);
}

inline constexpr const char* kKinds[] = {"line", "arc", "disc", "ring", "trail", "area", "round area", "square pen"};
inline constexpr std::size_t kKindCount = std::size(kKinds);

/// Makes elements at random, each with its reference.
class Maker {
public:
    Maker(DocumentBuilder& builder, unsigned seed) : m_builder(builder), m_random(seed) {}

    /// `around` ± 0.2 mm.
    std::pair<ElementId, Shape> make(std::size_t kind, Point around) {
        m_around = around;
        switch (kind) {
            case 0: return line();
            case 1: return arcTrack();
            case 2: return disc();
            case 3: return ring();
            case 4: return trail();
            case 5: return polygon();
            case 6: return roundArea();
            default: return squarePen();
        }
    }

private:
    Nm number(Nm from, Nm to) { return std::uniform_int_distribution<Nm>(from, to)(m_random); }
    Point point() { return {m_around.x + number(-200'000, 200'000), m_around.y + number(-200'000, 200'000)}; }
    Nm even(Nm from, Nm to) { return number(from, to) / 2 * 2; }

    std::pair<ElementId, Shape> line() {
        const Point a = point();
        const Point b = point();
        const Nm width = even(2'000, 60'000);
        return {m_builder.addLine({a, b, width, 0}, {}), {{straight(real(a), real(b), width / 2)}, false}};
    }
    std::pair<ElementId, Shape> arcTrack() {
        // Ends on the axes through the centre, so that both radii are equal.
        const Point centre = point();
        const Nm r = number(20'000, 150'000);
        const Point ends[4] = {
            {centre.x + r, centre.y}, {centre.x, centre.y + r}, {centre.x - r, centre.y}, {centre.x, centre.y - r}};
        const Point a = ends[number(0, 3)];
        const Point b = ends[number(0, 3)];
        const Nm width = even(2'000, 30'000);
        const bool isClockwise = number(0, 1) == 1;
        const EdgeKind way = isClockwise ? EdgeKind::ArcClockwise : EdgeKind::ArcCounterClockwise;
        return {m_builder.addArc({PathNode{a, centre, way}, b, width}, {}),
                {{arcOf(a, centre, b, isClockwise, width / 2)}, false}};
    }
    std::pair<ElementId, Shape> disc() {
        const Point centre = point();
        const Nm diameter = even(20'000, 200'000);
        return {m_builder.addCircle({centre, diameter, 0}, {}), {{circleAround(centre, diameter / 2)}, true}};
    }
    std::pair<ElementId, Shape> ring() {
        const Point centre = point();
        const Nm outer = even(100'000, 300'000);
        const Nm inner = even(20'000, 90'000);
        // The reference sees two circles around what is filled, not a stroke.
        return {
            m_builder.addCircle({centre, outer, inner}, {}),
            {{circleAround(centre, outer / 2), arc(real(centre), inner / 2, 0, -2 * std::numbers::pi_v<Real>)}, true}};
    }
    static Curve circleAround(Point centre, Nm radius) {
        return arc(real(centre), radius, 0, 2 * std::numbers::pi_v<Real>);
    }
    std::pair<ElementId, Shape> trail() {
        const std::array<Point, 4> points = {point(), point(), point(), point()};
        const Nm width = even(2'000, 40'000);
        std::vector<PathNode> nodes;
        Shape shape;
        for (std::size_t i = 0; i < points.size(); ++i) {
            nodes.push_back({points[i], {}, EdgeKind::Line});
            if (i > 0) {
                shape.curves.push_back(straight(real(points[i - 1]), real(points[i]), width / 2));
            }
        }
        return {m_builder.addTrail(nodes, width, {}), shape};
    }
    std::pair<ElementId, Shape> polygon() {
        // A star with a hole in the middle.
        const Point centre = point();
        std::vector<Point> corners;
        for (int i = 0; i < 7; ++i) {
            const double angle = 2 * std::numbers::pi * i / 7;
            const double r = number(80'000, 200'000);
            corners.push_back({centre.x + Nm(r * std::cos(angle)), centre.y + Nm(r * std::sin(angle))});
        }
        std::vector<Point> hole = {{centre.x - 20'000, centre.y - 20'000},
                                   {centre.x + 20'000, centre.y - 20'000},
                                   {centre.x, centre.y + 25'000}};
        ShapeSketch sketch;
        sketch.addPolygon(corners, false);
        sketch.addPolygon(hole, true);
        Shape shape;
        shape.isFilled = true;
        std::ranges::reverse(hole);
        for (const auto& loop : {corners, hole}) {
            for (std::size_t i = 0; i < loop.size(); ++i) {
                shape.curves.push_back(straight(real(loop[i]), real(loop[(i + 1) % loop.size()])));
            }
        }
        return {m_builder.addArea({m_builder.addShape(sketch), {}}, {}), shape};
    }
    std::pair<ElementId, Shape> roundArea() {
        // A half disc with a bite out of its straight side.
        const Point c = point();
        const Nm r = number(80'000, 200'000);
        const Nm bite = number(10'000, 60'000);
        ShapeSketch sketch;
        sketch.beginContour(false);
        sketch.addNode({{c.x, c.y - r}, c, EdgeKind::ArcCounterClockwise});
        sketch.addNode(Point{c.x, c.y + r});
        sketch.addNode({{c.x, c.y + bite}, c, EdgeKind::ArcClockwise});
        sketch.addNode(Point{c.x, c.y - bite});
        return {m_builder.addArea({m_builder.addShape(sketch), {}}, {}),
                {{arcOf({c.x, c.y - r}, c, {c.x, c.y + r}, false, 0),
                  straight(real({c.x, c.y + r}), real({c.x, c.y + bite})),
                  arcOf({c.x, c.y + bite}, c, {c.x, c.y - bite}, true, 0),
                  straight(real({c.x, c.y - bite}), real({c.x, c.y - r}))},
                 true}};
    }
    std::pair<ElementId, Shape> squarePen() {
        const Point a = point();
        const Point b = {a.x + number(10'000, 150'000), a.y};
        const Nm r = number(1'000, 30'000);
        const P corners[4] = {real({a.x - r, a.y - r}), real({b.x + r, a.y - r}), real({b.x + r, a.y + r}),
                              real({a.x - r, a.y + r})};
        Shape shape;
        shape.isFilled = true;
        for (int i = 0; i < 4; ++i) {
            shape.curves.push_back(straight(corners[i], corners[(i + 1) % 4]));
        }
        return {m_builder.addLine({a, b, 2 * r, 0}, of({}, kSquarePen)), shape};
    }

    DocumentBuilder& m_builder;
    std::mt19937 m_random;
    Point m_around;
};

}  // namespace measuring::reference
