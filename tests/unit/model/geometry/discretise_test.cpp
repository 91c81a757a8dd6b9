#include "model/geometry/discretise.h"

#include <QtTest>
#include <cmath>
#include <numbers>

#include "model/board/document_builder.h"
#include "model/figures/element_polygons.h"
#include "model/geometry/boolean.h"

using model::Discretisation;
using model::DocumentBuilder;
using model::EdgeKind;
using model::ElementId;
using model::PathNode;
using model::Point;
using model::PolygonSet;

namespace {

double areaMm2(const PolygonSet& set) {
    return static_cast<double>(model::twiceArea(set)) / 2.0 / 1e12;
}

/// A document with one element, made by `add`.
template <class Add>
std::shared_ptr<const model::Document> withElement(Add add) {
    DocumentBuilder builder;
    builder.beginLayer(builder.addLayer({}));
    add(builder);
    return builder.finish();
}

}  // namespace

class DiscretiseTest : public QObject {
    Q_OBJECT

private slots:
    void chordsStayWithinTheTolerance_data() {
        QTest::addColumn<double>("tolerance");
        QTest::addColumn<double>("radius");
        for (const double tolerance : {500.0, 5000.0, 50000.0}) {
            for (const double radius : {50e3, 1e6, 50e6, 400e6}) {
                QTest::addRow("%g nm at r = %g nm", tolerance, radius) << tolerance << radius;
            }
        }
    }
    void chordsStayWithinTheTolerance() {
        QFETCH(double, tolerance);
        QFETCH(double, radius);
        const int chords = model::chordCount(radius, 2 * std::numbers::pi, true, {tolerance, false});
        const double sagitta = radius * (1 - std::cos(std::numbers::pi / chords));
        const double coarser = radius * (1 - std::cos(std::numbers::pi / (chords - 1)));
        QVERIFY(chords == 8 || sagitta <= tolerance);
        QVERIFY2(chords == 8 || coarser > tolerance, "one chord less would have done");
    }

    void paperSegmentsAreFixed() {
        const Discretisation paper{5000.0, true};
        QCOMPARE(model::chordCount(1e6, 2 * std::numbers::pi, true, paper), 50);
        QCOMPARE(model::chordCount(1e3, 0.1, false, paper), 20);
    }

    void capsuleOfThePaperHas42Vertices() {
        const auto document = withElement([](DocumentBuilder& b) {
            b.addLine({{0, 0}, {5'000'000, 1'000'000}, 200'000, 0}, {});
        });
        const PolygonSet set = model::discretise(*document, ElementId{0}, {5000.0, true});
        QCOMPARE(set.points.size(), 42U);
    }

    void strokesHaveTheAreaOfTheirPen() {
        const Discretisation fine{500.0, false};
        const double r = 0.1;
        const double cap = std::numbers::pi * r * r;
        const auto line = withElement([](DocumentBuilder& b) {
            b.addLine({{0, 0}, {3'000'000, 4'000'000}, 200'000, 0}, {});
        });
        QVERIFY(std::abs(areaMm2(model::discretise(*line, ElementId{0}, fine)) - (5 * 2 * r + cap)) < 1e-3);

        // Half a circle of radius 2 mm: the pen sweeps length × width plus its caps.
        const PathNode node{{2'000'000, 0}, {0, 0}, EdgeKind::ArcCounterClockwise};
        const auto arc = withElement([&](DocumentBuilder& b) { b.addArc({node, {-2'000'000, 0}, 200'000}, {}); });
        const double expected = std::numbers::pi * 2 * 2 * r + cap;
        QVERIFY(std::abs(areaMm2(model::discretise(*arc, ElementId{0}, fine)) - expected) < 3e-3);

        const auto ring = withElement([&](DocumentBuilder& b) { b.addArc({node, node.point, 200'000}, {}); });
        QVERIFY(std::abs(areaMm2(model::discretise(*ring, ElementId{0}, fine)) - 2 * std::numbers::pi * 2 * 2 * r) <
                6e-3);
    }

    void strokeIsTheSameRegionInBothDirections() {
        const PathNode forward{{2'000'000, 0}, {0, 0}, EdgeKind::ArcCounterClockwise};
        const PathNode backward{{0, 2'000'000}, {0, 0}, EdgeKind::ArcClockwise};
        const auto a = withElement([&](DocumentBuilder& b) { b.addArc({forward, backward.point, 300'000}, {}); });
        const auto c = withElement([&](DocumentBuilder& b) { b.addArc({backward, forward.point, 300'000}, {}); });
        const Discretisation how;
        const PolygonSet first = model::discretise(*a, ElementId{0}, how);
        const PolygonSet second = model::discretise(*c, ElementId{0}, how);
        QVERIFY(areaMm2(model::subtract(first, second)) < 1e-6);
        QVERIFY(areaMm2(model::subtract(second, first)) < 1e-6);
    }

    void penWiderThanTheArcStillSweepsADisc() {
        // Radius 0.05 mm, pen radius 0.2 mm: the region holds the disc of 0.2 around both ends.
        const PathNode node{{50'000, 0}, {0, 0}, EdgeKind::ArcCounterClockwise};
        const auto arc = withElement([&](DocumentBuilder& b) { b.addArc({node, {-50'000, 0}, 400'000}, {}); });
        const PolygonSet region = model::unite(model::discretise(*arc, ElementId{0}, {500.0, false}));
        QCOMPARE(region.polygons.size(), 1U);
        const double disc = std::numbers::pi * 0.2 * 0.2;
        // More than the straight stroke between the ends, less than one that also bulges by the arc's radius.
        QVERIFY(areaMm2(region) > disc + 0.1 * 0.4 - 1e-3);
        QVERIFY(areaMm2(region) < disc + (0.1 + 0.05) * 0.4);
    }

    void squarePenSweepsTheHullOfTwoSquares_data() {
        QTest::addColumn<int>("dx");
        QTest::addColumn<int>("dy");
        QTest::addRow("right") << 1000 << 0;
        QTest::addRow("down") << 0 << -1000;
        QTest::addRow("rising") << 1000 << 500;
        QTest::addRow("falling") << 1000 << -500;
        QTest::addRow("rising to the left") << -1000 << 300;
        QTest::addRow("dot") << 0 << 0;
    }
    void squarePenSweepsTheHullOfTwoSquares() {
        QFETCH(int, dx);
        QFETCH(int, dy);
        DocumentBuilder::Origin origin;
        origin.flags = model::kSquarePen;
        const auto document = withElement([&](DocumentBuilder& b) { b.addLine({{0, 0}, {dx, dy}, 200, 0}, origin); });
        const PolygonSet set = model::discretise(*document, ElementId{0}, {});
        // A square of side w swept along (dx, dy) covers w² + w (|dx| + |dy|).
        const long long area = 200LL * 200 + 200LL * (std::abs(dx) + std::abs(dy));
        QVERIFY(model::twiceArea(set) == 2 * area);
    }

    void loopsTurnToTheWindingOfTheirPlace() {
        PolygonSet set;
        set.beginPolygon();
        const Point clockwise[] = {{0, 0}, {0, 10}, {10, 10}, {10, 0}, {0, 0}};
        QVERIFY(set.addLoop(clockwise));
        QVERIFY(model::twiceArea(set.loop(0)) == 200);
        const Point inner[] = {{2, 2}, {4, 2}, {4, 4}};
        QVERIFY(set.addLoop(inner));
        QVERIFY(model::twiceArea(set.loop(1)) == -4);
        const Point flat[] = {{1, 1}, {1, 1}, {2, 2}};
        QVERIFY(!set.addLoop(flat));
        QCOMPARE(set.loopCount(), 2U);
    }

    void holesOfADrillAreFilledAndRingsAreNot() {
        DocumentBuilder::Origin hole;
        hole.flags = model::kHole | model::kPlated;
        const model::CircleGeometry circle{{0, 0}, 1'000'000, 900'000};
        const auto drill = withElement([&](DocumentBuilder& b) { b.addCircle(circle, hole); });
        const auto ring = withElement([&](DocumentBuilder& b) { b.addCircle(circle, {}); });
        QCOMPARE(model::discretise(*drill, ElementId{0}, {}).loopCount(), 1U);
        QCOMPARE(model::discretise(*ring, ElementId{0}, {}).loopCount(), 2U);
    }
};

QTEST_APPLESS_MAIN(DiscretiseTest)
#include "discretise_test.moc"
