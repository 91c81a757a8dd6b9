#include "curves.h"

#include <cmath>
#include <limits>

#include "model/base/assert.h"
#include "model/geometry/curve_edges.h"
#include "model/geometry/curve_queries.h"
#include "model/geometry/nurbs.h"

namespace fuzz {

namespace {

using model::Bezier;
using model::ControlPoint;
using model::Edge;
using model::Nurbs;
using model::NurbsView;
using model::PointD;

constexpr std::size_t kMostControls = 40;
constexpr int kMostInnerDegree = 36;  // beyond what is accepted
constexpr int kSamples = 17;
/// Sums of products of curves of a high degree and weights that differ by a million keep this part of their size.
constexpr double kRounding = 1e-6;

double number(char c) {
    switch (c) {
        case '\x01': return std::numeric_limits<double>::quiet_NaN();
        case '\x02': return std::numeric_limits<double>::infinity();
        default: return static_cast<signed char>(c - '@');
    }
}

Nurbs parse(std::string_view input) {
    Nurbs curve;
    if (input.size() < 2) {
        return curve;
    }
    curve.degree = static_cast<unsigned char>(input[0] - '0') % kMostInnerDegree;
    const double unit = 1 << (static_cast<unsigned char>(input[1]) % 22);
    input.remove_prefix(2);
    const std::string_view steps = input.substr(0, std::min(input.find('\n'), input.size()));
    input.remove_prefix(std::min(steps.size() + 1, input.size()));
    for (; input.size() >= 3 && curve.controls.size() < kMostControls; input.remove_prefix(3)) {
        curve.controls.push_back({{number(input[0]) * unit, number(input[1]) * unit}, std::exp2(number(input[2]) / 8)});
    }
    const std::size_t ends = static_cast<std::size_t>(curve.degree) + 1;
    curve.knots.assign(ends, 0.0);
    double knot = 0.0;
    for (const char step : steps) {
        knot += number(step) / 16;
        curve.knots.push_back(knot);
    }
    curve.knots.insert(curve.knots.end(), ends, knot + 1);
    return curve;
}

double sizeOf(const NurbsView& curve) {
    double size = 1.0;
    for (const ControlPoint& control : curve.controls) {
        size = std::max({size, std::abs(control.at.x), std::abs(control.at.y)});
    }
    return size;
}

void checkEdges(const NurbsView& curve, double tolerance) {
    const std::vector<Edge> edges = model::edgesOf(curve);
    for (std::size_t i = 1; i < edges.size(); ++i) {
        ASSERT(edges[i].a == edges[i - 1].b);
    }
    if (!edges.empty()) {
        const PointD start = model::pointOn(curve, curve.from());
        ASSERT(std::hypot(edges.front().a.x - start.x, edges.front().a.y - start.y) <= tolerance);
        ASSERT(edges.front().isCurveStart && edges.back().isCurveEnd);
    }
}

void checkQueries(const NurbsView& curve, double tolerance) {
    const std::vector<Bezier> pieces = model::bezierPieces(curve);
    const base::Box box = boxOf(pieces);
    const double length = lengthOf(pieces);
    ASSERT(std::isfinite(length) && std::isfinite(areaUnder(pieces, {0, 0})));
    PointD last = model::pointOn(curve, curve.from());
    double chords = 0.0;
    for (int i = 0; i < kSamples; ++i) {
        const double at = curve.from() + (curve.to() - curve.from()) * i / (kSamples - 1);
        const PointD p = model::pointOn(curve, at);
        ASSERT(p.x >= box.min.x - tolerance && p.x <= box.max.x + tolerance);
        ASSERT(p.y >= box.min.y - tolerance && p.y <= box.max.y + tolerance);
        ASSERT(nearestOn(pieces, p).distance <= tolerance);
        chords += std::hypot(p.x - last.x, p.y - last.y);
        last = p;
    }
    ASSERT(chords <= length + kSamples * tolerance);
}

void checkParts(const NurbsView& curve, double tolerance) {
    const double middle = curve.from() + (curve.to() - curve.from()) / 2;
    const Nurbs before = model::partOf(curve, curve.from(), middle);
    const Nurbs after = model::partOf(curve, middle, curve.to());
    const PointD a = model::pointOn(before.view(), before.view().to());
    const PointD b = model::pointOn(after.view(), after.view().from());
    ASSERT(std::hypot(a.x - b.x, a.y - b.y) <= tolerance);
    const std::vector<Bezier> pieces = model::bezierPieces(curve);
    const Edge line{{-1e9, -1e8}, {1e9, 1e8}, {}, 0.0, 0.0};
    static_cast<void>(crossingsOf(pieces, line));
    static_cast<void>(crossingsOf(model::bezierPieces(before.view()), model::bezierPieces(after.view())));
    static_cast<void>(windingAround(pieces, a));
}

}  // namespace

void curves(std::string_view input) {
    const Nurbs curve = parse(input);
    if (!model::faultIn(curve.view()).empty()) {
        return;
    }
    const double tolerance = 1.0 + kRounding * sizeOf(curve.view());
    checkEdges(curve.view(), tolerance);
    checkQueries(curve.view(), tolerance);
    checkParts(curve.view(), tolerance);
}

}  // namespace fuzz
