#include "model/geometry/bezier.h"

#include <algorithm>
#include <cmath>

#include "model/base/assert.h"
#include "model/geometry/nurbs.h"
#include "model/geometry/scratch.h"
#include "model/geometry/vectors.h"

namespace model {

namespace {

double distanceToSegment(PointD p, PointD a, PointD b) {
    const PointD along = minus(b, a);
    const double squared = dot(along, along);
    const double t = squared > 0 ? std::clamp(dot(minus(p, a), along) / squared, 0.0, 1.0) : 0.0;
    return length(minus(p, {a.x + along.x * t, a.y + along.y * t}));
}

}  // namespace

CurvePoint rationalDerivatives(const Homogeneous& value, const Homogeneous& first, const Homogeneous& second) {
    CurvePoint result;
    result.point = projected(value);
    result.first = {(first.x - first.w * result.point.x) / value.w, (first.y - first.w * result.point.y) / value.w};
    result.second = {(second.x - 2 * first.w * result.first.x - second.w * result.point.x) / value.w,
                     (second.y - 2 * first.w * result.first.y - second.w * result.point.y) / value.w};
    return result;
}

Bezier::Bezier(std::vector<Homogeneous> controls, double from, double to)
    : m_controls(std::move(controls)), m_from(from), m_to(to) {
    ASSERT(m_controls.size() >= 2);
}

CurvePoint Bezier::at(double parameter) const {
    const double t = (parameter - m_from) / (m_to - m_from);
    const double n = static_cast<double>(degree()) / (m_to - m_from);
    Scratch<Homogeneous, kMostFixedDegree + 1> points(m_controls.size());
    for (std::size_t i = 0; i < m_controls.size(); ++i) {
        points[i] = m_controls[i];
    }
    Homogeneous first{};
    Homogeneous second{};
    for (std::size_t left = degree(); left > 0; --left) {
        if (left == 2) {
            const Homogeneous turn = difference(difference(points[2], points[1]), difference(points[1], points[0]));
            second = scaled(turn, n * (n - 1 / (m_to - m_from)));
        }
        if (left == 1) {
            first = scaled(difference(points[1], points[0]), n);
        }
        for (std::size_t i = 0; i < left; ++i) {
            points[i] = between(points[i], points[i + 1], t);
        }
    }
    return rationalDerivatives(points[0], first, second);
}

Bezier Bezier::splitInMiddle() {
    std::vector<Homogeneous> after(m_controls.size());
    // De Casteljau: the first points of all steps are the half before the middle, the last ones the half after it.
    for (std::size_t left = degree(); left > 0; --left) {
        after[left] = m_controls.back();
        for (std::size_t i = degree(); i > degree() - left; --i) {
            m_controls[i] = between(m_controls[i - 1], m_controls[i], 0.5);
        }
    }
    after[0] = m_controls.back();
    const double middle = m_from + (m_to - m_from) / 2;
    Bezier later(std::move(after), middle, m_to);
    m_to = middle;
    return later;
}

double Bezier::hullBesideChord() const {
    double most = 0;
    for (std::size_t i = 1; i + 1 < m_controls.size(); ++i) {
        most = std::max(most, distanceToSegment(projected(m_controls[i]), start(), end()));
    }
    return most;
}

double Bezier::boundOnChord() const {
    const double hull = hullBesideChord();
    const PointD chord = minus(end(), start());
    const double squared = dot(chord, chord);
    double heaviest = 0;
    for (std::size_t i = 1; i + 1 < m_controls.size(); ++i) {
        const double ahead = dot(minus(projected(m_controls[i]), start()), chord);
        if (!(ahead >= 0 && ahead <= squared)) {
            return hull;
        }
        heaviest = std::max(heaviest, m_controls[i].w);
    }
    // The ends lie on the chord and have at least the share 2^(1 - degree) of the basis functions between them.
    const double share = std::ldexp(1.0, 1 - static_cast<int>(degree()));
    const double inner = heaviest * (1 - share);
    return hull * inner / (inner + std::min(m_controls.front().w, m_controls.back().w) * share);
}

double Bezier::bend() const {
    double sum = 0;
    PointD last = {0, 0};
    for (std::size_t i = 0; i < degree(); ++i) {
        const PointD side = minus(projected(m_controls[i + 1]), projected(m_controls[i]));
        if (side != PointD{0, 0}) {
            sum += last != PointD{0, 0} ? std::abs(std::atan2(cross(last, side), dot(last, side))) : 0.0;
            last = side;
        }
    }
    return sum;
}

bool Bezier::runsAlongChord() const {
    const PointD chord = minus(end(), start());
    PointD last = start();
    for (const Homogeneous& control : m_controls) {
        const PointD next = projected(control);
        if (dot(minus(next, last), chord) < 0) {
            return false;
        }
        last = next;
    }
    return dot(chord, chord) > 0;
}

void subdivide(std::span<const Bezier> pieces, const std::function<bool(const Bezier&)>& isFine,
               const std::function<void(const Bezier&)>& visit) {
    std::vector<Bezier> open(pieces.rbegin(), pieces.rend());
    while (!open.empty()) {
        const double middle = open.back().from() + (open.back().to() - open.back().from()) / 2;
        const bool canHalve = open.back().from() < middle && middle < open.back().to();
        if (!canHalve || isFine(open.back())) {
            visit(open.back());
            open.pop_back();
        } else {
            Bezier before = std::move(open.back());
            open.back() = before.splitInMiddle();
            open.push_back(std::move(before));
        }
    }
}

std::vector<PointD> chordPoints(std::span<const Bezier> pieces, double tolerance, double mostBend) {
    constexpr double kDot = 1.0;  // nm: what is no larger has no direction to bend
    const auto isFine = [&](const Bezier& piece) {
        const double hull = piece.boundOnChord();
        const bool isDot = hull <= kDot && distance(piece.start(), piece.end()) <= kDot;
        return hull <= tolerance && (isDot || piece.bend() <= mostBend);
    };
    std::vector<PointD> points{pieces.front().start()};
    subdivide(pieces, isFine, [&](const Bezier& piece) { points.push_back(piece.end()); });
    return points;
}

PointD pointAt(std::span<const Bezier> pieces, double parameter) {
    const auto found = std::ranges::find_if(pieces, [&](const Bezier& piece) { return parameter <= piece.to(); });
    return (found != pieces.end() ? *found : pieces.back()).at(parameter).point;
}

}  // namespace model
