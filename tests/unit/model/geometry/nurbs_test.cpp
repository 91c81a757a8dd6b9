#include "model/geometry/nurbs.h"

#include <QtTest>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "model/geometry/curve_edges.h"
#include "model/geometry/curve_queries.h"
#include "model/geometry/vectors.h"
#include "tests/unit/model/geometry/some_curves.h"

using model::Bezier;
using model::Edge;
using model::Nurbs;
using model::PointD;
using model::testing::circleCurve;
using model::testing::randomCurve;
using model::testing::samplesOf;

namespace {

/// A basis function by its recursive definition, as a reference.
double basis(const Nurbs& curve, std::size_t i, int degree, double u) {
    const std::vector<double>& t = curve.knots;
    if (degree == 0) {
        const bool isLast = u == t.back() && t[i] < t[i + 1] && t[i + 1] == t.back();
        return (t[i] <= u && u < t[i + 1]) || isLast ? 1.0 : 0.0;
    }
    const auto p = static_cast<std::size_t>(degree);
    const double a = t[i + p] > t[i] ? (u - t[i]) / (t[i + p] - t[i]) * basis(curve, i, degree - 1, u) : 0.0;
    const double b = t[i + p + 1] > t[i + 1]
                         ? (t[i + p + 1] - u) / (t[i + p + 1] - t[i + 1]) * basis(curve, i + 1, degree - 1, u)
                         : 0.0;
    return a + b;
}

PointD byDefinition(const Nurbs& curve, double u) {
    double x = 0;
    double y = 0;
    double w = 0;
    for (std::size_t i = 0; i < curve.controls.size(); ++i) {
        const double share = basis(curve, i, curve.degree, u) * curve.controls[i].weight;
        x += share * curve.controls[i].at.x;
        y += share * curve.controls[i].at.y;
        w += share;
    }
    return {x / w, y / w};
}

double distanceToPolyline(PointD p, const std::vector<PointD>& points) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        Edge side;
        side.a = points[i];
        side.b = points[i + 1];
        least = std::min(least, model::distance(model::nearestOn(side, p), p));
    }
    return least;
}

Edge lineBetween(PointD a, PointD b) {
    Edge line;
    line.a = a;
    line.b = b;
    return line;
}

int crossingsOfPolyline(const std::vector<PointD>& points, const Edge& edge) {
    int count = 0;
    for (std::size_t i = 0; i + 1 < points.size(); ++i) {
        count += static_cast<int>(model::crossingsOf(lineBetween(points[i], points[i + 1]), edge).size());
    }
    return count;
}

}  // namespace

class NurbsTest : public QObject {
    Q_OBJECT

private slots:
    void aRationalCircleIsACircle() {
        const Nurbs circle = circleCurve({3e6, -2e6}, 1e6);
        QCOMPARE(model::faultIn(circle.view()), std::string());
        double most = 0;
        for (const PointD p : samplesOf(circle, 10001)) {
            most = std::max(most, std::abs(model::distance(p, {3e6, -2e6}) - 1e6));
        }
        QVERIFY2(most / 1e6 < 1e-14, qPrintable(QString::number(most)));
        const auto pieces = model::bezierPieces(circle.view());
        QCOMPARE(pieces.size(), 4U);
        QVERIFY(std::abs(model::lengthOf(pieces) - 2e6 * std::numbers::pi) < 1e-3);
        QVERIFY(std::abs(model::areaUnder(pieces, {7e6, 7e6}) / (std::numbers::pi * 1e12) - 1) < 1e-11);
        QVERIFY((model::boxOf(pieces) == model::Box{{2'000'000, -3'000'000}, {4'000'000, -1'000'000}}));
    }

    void pointsAreThoseOfTheDefinition_data() {
        QTest::addColumn<int>("degree");
        for (const int degree : {1, 2, 3, 5, 8, 15, 16, 20}) {
            QTest::addRow("degree %d", degree) << degree;
        }
    }
    void pointsAreThoseOfTheDefinition() {
        QFETCH(int, degree);
        std::mt19937_64 random(static_cast<unsigned>(degree));
        const Nurbs curve = randomCurve(random, degree, degree + 4, 1e6);
        QCOMPARE(model::faultIn(curve.view()), std::string());
        const auto pieces = model::bezierPieces(curve.view());
        for (int i = 0; i <= (degree > 8 ? 3 : 100); ++i) {
            const double share = static_cast<double>(i) / (degree > 8 ? 3 : 100);
            const double u = i == (degree > 8 ? 3 : 100) ? curve.view().to() : curve.view().to() * share;
            const PointD expected = byDefinition(curve, u);
            const double off = model::distance(model::pointOn(curve.view(), u), expected);
            QVERIFY2(off < 1e-6, qPrintable(QString::number(off)));
            QVERIFY(model::distance(model::pointAt(pieces, u), expected) < 1e-4);
        }
    }

    void derivativesAreThoseOfDifferences() {
        std::mt19937_64 random(5);
        for (const int degree : {1, 2, 3, 6, 17}) {
            const Nurbs curve = randomCurve(random, degree, degree + 3, 1e6);
            const auto pieces = model::bezierPieces(curve.view());
            const double u = curve.view().to() * 0.37;
            const double h = 1e-4;
            const PointD before = model::pointOn(curve.view(), u - h);
            const PointD after = model::pointOn(curve.view(), u + h);
            const auto found = model::derivativesOn(curve.view(), u);
            const PointD first = {(after.x - before.x) / (2 * h), (after.y - before.y) / (2 * h)};
            const PointD second = {(after.x - 2 * found.point.x + before.x) / (h * h),
                                   (after.y - 2 * found.point.y + before.y) / (h * h)};
            QVERIFY(model::distance(found.first, first) < 1e-4 * model::length(first));
            QVERIFY(model::distance(found.second, second) < 1e-3 * (model::length(second) + model::length(first)));
            const auto piece = std::ranges::find_if(pieces, [&](const Bezier& b) { return u < b.to(); });
            QVERIFY(model::distance(piece->at(u).first, found.first) < 1e-6 * model::length(first));
            QVERIFY(model::distance(piece->at(u).second, found.second) < 1e-6 * (model::length(found.second) + 1));
        }
    }

    void halvesArePiecesOfTheCurve() {
        std::mt19937_64 random(8);
        Bezier before = model::bezierPieces(randomCurve(random, 5, 6, 1e6).view()).front();
        const Bezier whole = before;
        const Bezier after = before.splitInMiddle();
        QCOMPARE(before.to(), after.from());
        QCOMPARE(after.to(), whole.to());
        for (int i = 0; i <= 20; ++i) {
            const double u = whole.from() + (whole.to() - whole.from()) * i / 20;
            const Bezier& half = u <= before.to() ? before : after;
            QVERIFY(model::distance(half.at(u).point, whole.at(u).point) < 1e-6);
        }
    }

    void aPartIsTheSameCurve() {
        std::mt19937_64 random(11);
        for (const int degree : {1, 2, 3, 7}) {
            const Nurbs curve = randomCurve(random, degree, degree + 6, 1e6);
            const double from = curve.view().to() * 0.21;
            const double to = curve.view().to() * 0.83;
            const Nurbs part = model::partOf(curve.view(), from, to);
            QCOMPARE(model::faultIn(part.view()), std::string());
            QVERIFY(part.knots.size() > 2 * static_cast<std::size_t>(degree + 1));
            for (int i = 0; i <= 50; ++i) {
                const double u = from + (to - from) * i / 50;
                QVERIFY(model::distance(model::pointOn(part.view(), u), model::pointOn(curve.view(), u)) < 1e-5);
            }
        }
    }

    void chordsStayWithinTheTolerance_data() {
        QTest::addColumn<int>("degree");
        QTest::addColumn<double>("tolerance");
        for (const int degree : {2, 3, 4, 9}) {
            for (const double tolerance : {1.0, 500.0, 50000.0}) {
                QTest::addRow("degree %d, %g nm", degree, tolerance) << degree << tolerance;
            }
        }
    }
    void chordsStayWithinTheTolerance() {
        QFETCH(int, degree);
        QFETCH(double, tolerance);
        std::mt19937_64 random(static_cast<unsigned>(degree));
        const Nurbs curve = randomCurve(random, degree, degree + 5, 2e6);
        const auto pieces = model::bezierPieces(curve.view());
        const std::vector<PointD> points = model::chordPoints(pieces, tolerance);
        double most = 0;
        for (const PointD p : samplesOf(curve, 2001)) {
            most = std::max(most, distanceToPolyline(p, points));
        }
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            const Edge chord = lineBetween(points[i], points[i + 1]);
            for (const double share : {0.25, 0.5, 0.75}) {
                const PointD p = model::pointAt(chord, model::lengthOf(chord) * share);
                most = std::max(most, model::nearestOn(pieces, p).distance);
            }
        }
        QVERIFY2(most <= tolerance, qPrintable(QString::number(most)));
        QVERIFY2(most > tolerance / 8, "far finer than needed");
    }

    void noChordStandsForMoreThanTheMostBend() {
        const auto pieces = model::bezierPieces(circleCurve({0, 0}, 1e3).view());
        QCOMPARE(model::chordPoints(pieces, 5e3).size(), 5U);
        QCOMPARE(model::chordPoints(pieces, 5e3, std::numbers::pi / 4 + 1e-9).size(), 9U);
    }

    void edgesStayWithinAQuarterNanometre_data() {
        QTest::addColumn<int>("degree");
        QTest::addColumn<double>("size");
        for (const int degree : {1, 2, 3, 5, 9, 20}) {
            for (const double size : {1e3, 1e6, 1e8}) {
                QTest::addRow("degree %d, %g nm", degree, size) << degree << size;
            }
        }
    }
    void edgesStayWithinAQuarterNanometre() {
        QFETCH(int, degree);
        QFETCH(double, size);
        std::mt19937_64 random(static_cast<unsigned>(degree));
        const Nurbs curve = randomCurve(random, degree, degree + 4, size);
        const auto pieces = model::bezierPieces(curve.view());
        const std::vector<Edge> edges = model::edgesAlong(pieces, model::kMeasured);
        QVERIFY(edges.front().a == pieces.front().start());
        QVERIFY(edges.back().b == pieces.back().end());
        double most = 0;
        for (std::size_t i = 0; i < edges.size(); ++i) {
            QVERIFY(i == 0 || edges[i - 1].b == edges[i].a);
            for (const double share : {0.13, 0.25, 0.4, 0.75, 0.9}) {
                if (i % (edges.size() / 50 + 1) != 0) {
                    break;
                }
                const PointD p = model::pointAt(edges[i], model::lengthOf(edges[i]) * share);
                most = std::max(most, model::nearestOn(pieces, p).distance);
            }
        }
        for (const PointD p : samplesOf(curve, 497)) {
            double least = size;
            for (const Edge& edge : edges) {
                least = std::min(least, model::distance(model::nearestOn(edge, p), p));
            }
            most = std::max(most, least);
        }
        QVERIFY2(most <= model::kMeasured, qPrintable(QString::number(most)));
        QVERIFY2(static_cast<double>(edges.size()) < 200 * std::cbrt(size / 1e3),
                 qPrintable(QString::number(edges.size())));
    }

    void edgesBeginAndEndInTheVeryControlPoints() {
        std::mt19937_64 random(71);
        for (int round = 0; round < 50; ++round) {
            Nurbs curve = randomCurve(random, 3, 6, 1e9);
            for (auto* end : {&curve.controls.front().at, &curve.controls.back().at}) {
                *end = {std::round(end->x), std::round(end->y)};  // integers, as nodes are
            }
            const std::vector<Edge> edges = model::edgesOf(curve.view());
            QVERIFY(edges.front().a == curve.controls.front().at);
            QVERIFY(edges.back().b == curve.controls.back().at);
            QVERIFY(edges.front().startsThere() && edges.back().endsThere());
            QVERIFY(edges.size() > 1 && !edges.front().endsThere() && !edges.back().startsThere());
        }
    }

    void aCircleIsMeasuredByFewArcs() {
        const auto pieces = model::bezierPieces(circleCurve({1e8, 1e8}, 4e6).view());
        const std::vector<Edge> edges = model::edgesAlong(pieces, model::kMeasured);
        QCOMPARE(edges.size(), 4U);
        for (const Edge& edge : edges) {
            QVERIFY(std::abs(edge.radius - 4e6) < 1e-3);
            QVERIFY(!edge.isClockwise);
        }
    }

    void theNearestPointIsThatOfDenseSamples() {
        std::mt19937_64 random(3);
        for (const int degree : {1, 2, 3, 5}) {
            const Nurbs curve = randomCurve(random, degree, degree + 5, 1e6);
            const auto pieces = model::bezierPieces(curve.view());
            const std::vector<PointD> samples = samplesOf(curve, 20001);
            for (int i = 0; i < 40; ++i) {
                std::uniform_real_distribution<double> place(-1e6, 1e6);
                const PointD p = {place(random), place(random)};
                const model::OnCurve found = model::nearestOn(pieces, p);
                QVERIFY(model::distance(model::pointOn(curve.view(), found.parameter), found.point) < 1e-5);
                QVERIFY(std::abs(model::distance(found.point, p) - found.distance) < 1e-6);
                // The chords between samples lie within two nanometres of the curve, but at the corners of
                // degree 1.
                const double expected = distanceToPolyline(p, samples);
                QVERIFY2(std::abs(found.distance - expected) < (degree == 1 ? 600.0 : 2.0),
                         qPrintable(QString::number(found.distance - expected)));
            }
        }
    }

    void allPointsOfACircleAreNearestToItsCentre() {
        const auto pieces = model::bezierPieces(circleCurve({0, 0}, 1e5).view());
        QVERIFY(std::abs(model::nearestOn(pieces, {0, 0}).distance - 1e5) < 1e-3);
    }

    void linesAndArcsCrossWhereDenseSamplesDo() {
        std::mt19937_64 random(21);
        std::uniform_real_distribution<double> place(-6e5, 6e5);
        int all = 0;
        for (int round = 0; round < 40; ++round) {
            const Nurbs curve = randomCurve(random, 2 + round % 4, 9, 1e6);
            const auto pieces = model::bezierPieces(curve.view());
            const std::vector<PointD> samples = samplesOf(curve, 20001);
            Edge edge = lineBetween({place(random), place(random)}, {place(random), place(random)});
            if (round % 2 == 1) {
                edge.centre = {place(random), place(random)};
                edge.radius = model::distance(edge.a, edge.centre);
                const double other = model::distance(edge.b, edge.centre);
                edge.b = {edge.centre.x + (edge.b.x - edge.centre.x) / other * edge.radius,
                          edge.centre.y + (edge.b.y - edge.centre.y) / other * edge.radius};
            }
            const auto crossings = model::crossingsOf(pieces, edge);
            for (const model::OnCurve& crossing : crossings) {
                QVERIFY(model::distance(model::nearestOn(edge, crossing.point), crossing.point) < 1e-4);
                QVERIFY(model::distance(model::pointOn(curve.view(), crossing.parameter), crossing.point) < 1e-5);
            }
            QCOMPARE(static_cast<int>(crossings.size()), crossingsOfPolyline(samples, edge));
            all += static_cast<int>(crossings.size());
        }
        QVERIFY(all > 30);
    }

    void aLineTouchesACircleOnce() {
        const auto pieces = model::bezierPieces(circleCurve({0, 0}, 1e6).view());
        const auto touching = model::crossingsOf(pieces, lineBetween({-2e6, 1e6}, {3e6, 1e6}));
        QCOMPARE(touching.size(), 1U);
        QVERIFY(model::distance(touching[0].point, {0, 1e6}) < 5.0);
        QVERIFY(model::crossingsOf(pieces, lineBetween({-2e6, 1e6 + 1}, {3e6, 1e6 + 1})).empty());
        const Nurbs straight{1, {0, 0, 1, 1}, {{{0, 0}, 1}, {{1e6, 0}, 1}}};
        QVERIFY(model::crossingsOf(model::bezierPieces(straight.view()), lineBetween({-1e6, 0}, {2e6, 0})).empty());
    }

    void curvesCrossWhereDenseSamplesDo() {
        std::mt19937_64 random(31);
        std::size_t all = 0;
        for (int round = 0; round < 8; ++round) {
            const Nurbs first = randomCurve(random, 3, 6, 1e6);
            const Nurbs second = randomCurve(random, 2, 5, 1e6);
            const auto a = model::bezierPieces(first.view());
            const auto b = model::bezierPieces(second.view());
            const auto crossings = model::crossingsOf(a, b);
            for (const PointD p : crossings) {
                QVERIFY(model::nearestOn(a, p).distance < 1e-3 && model::nearestOn(b, p).distance < 1e-3);
            }
            int expected = 0;
            const std::vector<PointD> other = samplesOf(second, 1201);
            const std::vector<PointD> own = samplesOf(first, 1201);
            for (std::size_t i = 0; i + 1 < other.size(); ++i) {
                expected += crossingsOfPolyline(own, lineBetween(other[i], other[i + 1]));
            }
            QCOMPARE(static_cast<int>(crossings.size()), expected);
            all += crossings.size();
        }
        QVERIFY(all > 5);
    }

    void windingIsThatOfDenseSamples() {
        std::mt19937_64 random(41);
        std::uniform_real_distribution<double> place(-5e5, 5e5);
        int wound = 0;
        for (int round = 0; round < 5; ++round) {
            Nurbs curve = randomCurve(random, 3, 9, 1e6);
            curve.controls.back() = curve.controls.front();  // closed
            const auto pieces = model::bezierPieces(curve.view());
            const std::vector<PointD> samples = samplesOf(curve, 20001);
            for (int i = 0; i < 40; ++i) {
                const PointD p = {place(random), place(random)};
                int expected = 0;
                for (std::size_t k = 0; k + 1 < samples.size(); ++k) {
                    expected += model::windingAround(lineBetween(samples[k], samples[k + 1]), p);
                }
                QCOMPARE(model::windingAround(pieces, p), expected);
                wound += expected != 0 ? 1 : 0;
            }
        }
        QVERIFY2(wound > 10, qPrintable(QString::number(wound)));
    }

    void lengthAreaAndBoxAreThoseOfDenseSamples() {
        std::mt19937_64 random(51);
        for (const int degree : {1, 2, 3, 6}) {
            const Nurbs curve = randomCurve(random, degree, degree + 4, 1e6);
            const auto pieces = model::bezierPieces(curve.view());
            const std::vector<PointD> samples = samplesOf(curve, 200'001);
            double length = 0;
            double area = 0;
            PointD least = samples[0];
            PointD most = samples[0];
            for (std::size_t i = 0; i + 1 < samples.size(); ++i) {
                length += model::distance(samples[i], samples[i + 1]);
                area += model::cross(samples[i], samples[i + 1]) / 2;
                least = {std::min(least.x, samples[i + 1].x), std::min(least.y, samples[i + 1].y)};
                most = {std::max(most.x, samples[i + 1].x), std::max(most.y, samples[i + 1].y)};
            }
            QVERIFY2(
                std::abs(model::lengthOf(pieces) - length) < 50.0,
                qPrintable(QString::number(model::lengthOf(pieces) - length)));  // samples cut the corners of degree 1
            QVERIFY(std::abs(model::areaUnder(pieces, {0, 0}) - area) < 1e7);
            const model::Box box = model::boxOf(pieces);
            const double missed = degree == 1 ? 300.0 : 1.1;
            QVERIFY(box.min.x <= least.x + 1e-3 && box.min.x > least.x - missed);
            QVERIFY(box.max.y >= most.y - 1e-3 && box.max.y < most.y + missed);
            QVERIFY(box.min.y <= least.y + 1e-3 && box.max.x >= most.x - 1e-3);
        }
    }

    void whatIsNoCurveIsToldInWords_data() {
        QTest::addColumn<int>("degree");
        QTest::addColumn<QList<double>>("knots");
        QTest::addColumn<QList<double>>("weights");
        QTest::addColumn<QString>("fault");
        const double nan = std::numeric_limits<double>::quiet_NaN();
        using Numbers = QList<double>;
        QTest::addRow("degree 0") << 0 << Numbers{0, 1} << Numbers{1} << "of a degree";
        QTest::addRow("degree 31") << 31 << Numbers(64, 0.0) << Numbers(32, 1.0) << "of a degree";
        QTest::addRow("few points") << 2 << Numbers{0, 0, 0, 1, 1} << Numbers{1, 1} << "fewer control points";
        QTest::addRow("few knots") << 1 << Numbers{0, 0, 1} << Numbers{1, 1} << "not as many";
        QTest::addRow("falling") << 1 << Numbers{0, 0, -1, 1, 1} << Numbers{1, 1, 1} << "do not rise";
        QTest::addRow("no number") << 1 << Numbers{0, 0, nan, 1, 1} << Numbers{1, 1, 1} << "do not rise";
        QTest::addRow("all equal") << 1 << Numbers{2, 2, 2, 2} << Numbers{1, 1} << "all equal";
        QTest::addRow("open") << 1 << Numbers{0, 1, 2, 3} << Numbers{1, 1} << "not clamped";
        QTest::addRow("broken") << 1 << Numbers{0, 0, 1, 1, 2, 2} << Numbers{1, 1, 1, 1} << "more often";
        QTest::addRow("long start") << 1 << Numbers{0, 0, 0, 1, 1} << Numbers{1, 1, 1} << "more often";
        QTest::addRow("weight 0") << 1 << Numbers{0, 0, 1, 1} << Numbers{1, 0} << "not above 0";
        QTest::addRow("weight below 0") << 1 << Numbers{0, 0, 1, 1} << Numbers{1, -1} << "not above 0";
        QTest::addRow("far weights") << 1 << Numbers{0, 0, 1, 1} << Numbers{1, 1e7} << "a million";
        QTest::addRow("corner") << 1 << Numbers{0, 0, 1, 2, 2} << Numbers{1, 1, 1} << "";
    }
    void whatIsNoCurveIsToldInWords() {
        QFETCH(int, degree);
        QFETCH(QList<double>, knots);
        QFETCH(QList<double>, weights);
        QFETCH(QString, fault);
        Nurbs curve{degree, {knots.begin(), knots.end()}, {}};
        for (const double weight : weights) {
            curve.controls.push_back({{100.0 * static_cast<double>(curve.controls.size()), 0}, weight});
        }
        const QString found = QString::fromStdString(model::faultIn(curve.view()));
        QVERIFY2(fault.isEmpty() ? found.isEmpty() : found.contains(fault), qPrintable(found));
    }

    void curvesWithoutExtentAndWithCuspsAreWalkedToTheirEnd() {
        const Nurbs dot{2, {0, 0, 0, 1, 1, 1}, {{{5, 5}, 1}, {{5, 5}, 2}, {{5, 5}, 1}}};
        const auto none = model::bezierPieces(dot.view());
        QVERIFY(model::edgesAlong(none, model::kMeasured).empty());
        QCOMPARE(model::lengthOf(none), 0.0);
        QCOMPARE(model::chordPoints(none, 1.0, 0.5).size(), 2U);
        QCOMPARE(model::nearestOn(none, {5, 8}).distance, 3.0);
        // A cubic whose tangent turns back in a cusp, and one that runs back over itself on a line.
        const Nurbs cusp{3, {0, 0, 0, 0, 1, 1, 1, 1}, {{{0, 0}, 1}, {{1e6, 1e6}, 1}, {{0, 1e6}, 1}, {{1e6, 0}, 1}}};
        const Nurbs line{2, {0, 0, 0, 1, 1, 1}, {{{0, 0}, 1}, {{2e6, 0}, 1}, {{1e6, 0}, 1}}};
        for (const Nurbs& curve : {cusp, line}) {
            const auto pieces = model::bezierPieces(curve.view());
            const std::vector<Edge> edges = model::edgesAlong(pieces, model::kMeasured);
            double length = 0;
            for (const Edge& edge : edges) {
                length += model::lengthOf(edge);
            }
            QVERIFY(std::abs(length - model::lengthOf(pieces)) < 1.0);
            for (const PointD p : samplesOf(curve, 501)) {
                double least = 1e6;
                for (const Edge& edge : edges) {
                    least = std::min(least, model::distance(model::nearestOn(edge, p), p));
                }
                QVERIFY(least <= model::kMeasured);
            }
        }
    }
};

QTEST_APPLESS_MAIN(NurbsTest)
#include "nurbs_test.moc"
