// Shapes with NURBS edges: how sketches and tables keep, copy and place them.
#include "model/geometry/curve_table.h"

#include <QtTest>

#include "model/geometry/curve_queries.h"
#include "model/geometry/discretise.h"
#include "model/geometry/nesting.h"
#include "model/geometry/slits.h"
#include "model/geometry/vectors.h"
#include "tests/unit/model/geometry/some_curves.h"

using namespace model;
using model::testing::circleCurve;

namespace {

constexpr Nm kMm = 1'000'000;

/// A disc whose outline is one NURBS edge.
void addDisc(ShapeSketch& sketch, Point centre, Nm radius, bool isHole) {
    const Point start{centre.x + radius, centre.y};
    sketch.beginContour(isHole);
    sketch.addCurve(start, circleCurve(base::toDouble(centre), radius).view(), start);
}

}  // namespace

class CurveTableTest : public QObject {
    Q_OBJECT

private slots:
    void copiesShareUntilOneIsChanged() {
        CurveTable table;
        QCOMPARE(table.size(), 0U);
        QCOMPARE(table.add(circleCurve({0, 0}, 10).view()), 0U);
        CurveTable copy = table;
        QVERIFY(copy[0].knots.data() == table[0].knots.data());
        const Nurbs line{1, {0, 0, 1, 1}, {{{1, 2}, 1}, {{3, 4}, 0.5}}};
        QCOMPARE(copy.add(line.view()), 1U);
        QCOMPARE(table.size(), 1U);
        QCOMPARE(copy.size(), 2U);
        QCOMPARE(copy[1].degree, 1);
        QVERIFY(std::ranges::equal(copy[1].knots, line.knots));
        QVERIFY(std::ranges::equal(copy[1].controls, line.controls));
        QVERIFY(std::ranges::equal(copy[0].controls, table[0].controls));
    }

    void shapesOfOneTableKeepTheirOwnCurves() {
        ShapeTable table;
        for (const Nm radius : {kMm, 2 * kMm, 3 * kMm}) {
            ShapeSketch sketch;
            addDisc(sketch, {radius, 0}, radius, false);
            addDisc(sketch, {radius, 0}, radius / 2, true);
            const ShapeId shape = table.add(sketch);
            QVERIFY((table.shapes[shape.row()].box == Box{{0, -radius}, {2 * radius, radius}}));
        }
        const auto nodes = table.nodesOf(table.contoursOf(ShapeId{1U})[1]);
        QCOMPARE(nodes.size(), 1U);
        QVERIFY(std::abs(lengthOf(bezierPieces(nodes.curveAt(0))) - 2 * std::numbers::pi * kMm) < 1e-3);
    }

    void placedCurvesAreTheSameCurvesElsewhere() {
        ShapeSketch sketch;
        addDisc(sketch, {kMm, 0}, kMm, false);
        for (const Placement& placement :
             {Placement{{5, 6}, 0, false}, Placement{{-7 * kMm, 3}, 30, false}, Placement{{0, 9}, 123.4, true}}) {
            ShapeSketch moved;
            moved.append(sketch, placement);
            const PathNodes path = moved.contour(0);
            QVERIFY(path[0].edge == EdgeKind::Curve);
            QVERIFY(path.curveAt(0).controls.front().at == base::toDouble(path[0].point));
            QVERIFY(path.curveAt(0).controls.back().at == base::toDouble(path[0].point));
            const PointD centre = placement.apply(PointD{1e6, 0});
            for (int i = 0; i <= 100; ++i) {
                QVERIFY(std::abs(distance(pointOn(path.curveAt(0), 0.04 * i), centre) - 1e6) < 1.0);
            }
        }
    }

    void smallDiscsStayRound() {
        ShapeTable table;
        ShapeSketch sketch;
        addDisc(sketch, {0, 0}, 1'000, false);
        const PolygonSet set = discretise(table, table.add(sketch), {});
        QCOMPARE(set.polygons.size(), 1U);
        QVERIFY(set.points.size() >= 8);
        const PolygonSet paper = discretise(table, ShapeId{0U}, {5000.0, true});
        QCOMPARE(paper.points.size(), 80U);  // 20 for each quarter
    }

    void holesNestAndSlitsHealAsWithoutCurves() {
        // Two islands, then the holes of both.
        ShapeSketch sketch;
        addDisc(sketch, {0, 0}, kMm, false);
        addDisc(sketch, {5 * kMm, 0}, kMm, false);
        addDisc(sketch, {0, 0}, kMm / 2, true);
        addDisc(sketch, {5 * kMm, 0}, kMm / 4, true);
        const ShapeSketch nested = nestHoles(sketch);
        QVERIFY(nested.isHole(1) && !nested.isHole(2) && nested.isHole(3));
        QVERIFY((boxOfPath(nested.contour(1), true) == Box{{-kMm / 2, -kMm / 2}, {kMm / 2, kMm / 2}}));

        // A square whose hole, a disc, is joined to its outline by a slit: the way there and back is straight.
        ShapeSketch slit;
        const Point left{-kMm, 0};
        slit.beginContour(false);
        for (const Point corner : {Point{-3 * kMm, -3 * kMm}, Point{3 * kMm, -3 * kMm}, Point{3 * kMm, 3 * kMm},
                                   Point{-3 * kMm, 3 * kMm}, Point{-3 * kMm, 0}}) {
            slit.addNode(corner);
        }
        Nurbs hole = circleCurve({0, 0}, -1e6);  // from the left
        std::ranges::reverse(hole.controls);     // clockwise
        slit.addCurve(left, hole.view(), left);
        slit.addNode(left);
        slit.addNode(Point{-3 * kMm, 0});
        const auto healed = healSlits(slit);
        QVERIFY(healed.has_value());
        QCOMPARE(healed->contourCount(), 2U);
        QVERIFY(!healed->isHole(0) && healed->isHole(1));
        QVERIFY(healed->contour(1)[0].edge == EdgeKind::Curve);
        QVERIFY((boxOfPath(healed->contour(1), true) == Box{{-kMm, -kMm}, {kMm, kMm}}));
    }
};

QTEST_APPLESS_MAIN(CurveTableTest)
#include "curve_table_test.moc"
