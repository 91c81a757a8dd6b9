// Designators on top of bodies: where, how large, and which way up.
#include "model/packages/designator.h"

#include <QtTest>

using model::BodyPlan;
using model::Box;
using model::Component;
using model::LayerSide;
using model::Nm;
using model::PointD;
using model::PrintedCharacter;

namespace {

constexpr Nm kMm = 1'000'000;

BodyPlan planOf(Nm width, Nm height) {
    BodyPlan plan;
    plan.box = plan.label = {{-width / 2, -height / 2}, {width / 2, height / 2}};
    return plan;
}

Component componentAt(double clockwise, LayerSide side) {
    Component component;
    component.refdes = "U12";
    component.package = model::PackageId{0};
    component.side = side;
    component.placement = {{10 * kMm, 20 * kMm}, clockwise, side == LayerSide::Bottom};
    return component;
}

/// Where text runs to, as seen from the side of the board it is on.
PointD directionOf(const PrintedCharacter& printed) {
    const model::Placement rotation{{}, printed.placement.clockwiseDeg, printed.placement.isMirrored};
    PointD along = rotation.apply(PointD{1.0, 0.0});
    along.x = printed.placement.isMirrored ? -along.x : along.x;
    return along;
}

}  // namespace

class DesignatorTest : public QObject {
    Q_OBJECT

private slots:
    void textRunsAlongTheBodyAndIsReadFromBelowOrFromTheRight_data() {
        QTest::addColumn<double>("clockwise");
        QTest::addColumn<bool>("isBottom");
        for (const bool isBottom : {false, true}) {
            for (const double clockwise : {0.0, 30.0, 90.0, 180.0, 270.0, 315.0}) {
                QTest::addRow("%g %s", clockwise, isBottom ? "bottom" : "top") << clockwise << isBottom;
            }
        }
    }
    void textRunsAlongTheBodyAndIsReadFromBelowOrFromTheRight() {
        QFETCH(double, clockwise);
        QFETCH(bool, isBottom);
        const Component component = componentAt(clockwise, isBottom ? LayerSide::Bottom : LayerSide::Top);
        const BodyPlan plan = planOf(10 * kMm, 4 * kMm);
        const auto printed = model::printDesignator(component, plan);
        QCOMPARE(printed.size(), std::size_t{3});
        const Box body = component.placement.boxOf(plan.box);
        for (const PrintedCharacter& character : printed) {
            const PointD along = directionOf(character);
            QVERIFY(along.x > 1e-6 || along.y > 1.0 - 1e-6);
            QVERIFY(body.holds(character.placement.origin));
            QCOMPARE(character.placement.isMirrored, isBottom);
        }
        // Along the longer side of the body: from the first to the last character.
        const PointD a = base::toDouble(printed.front().placement.origin);
        const PointD b = base::toDouble(printed.back().placement.origin);
        const PointD side = model::Placement{{}, clockwise, isBottom}.apply(PointD{1.0, 0.0});
        QVERIFY(std::abs((b.x - a.x) * side.y - (b.y - a.y) * side.x) < 10.0);
    }

    void textIsAsLargeAsItFits() {
        const Component component = componentAt(0.0, LayerSide::Top);
        const auto heightOn = [&](Nm width, Nm height) {
            const auto printed = model::printDesignator(component, planOf(width, height));
            return printed.empty() ? 0 : printed.front().height;
        };
        QVERIFY(heightOn(20 * kMm, 20 * kMm) > heightOn(5 * kMm, 5 * kMm));
        QVERIFY(heightOn(5 * kMm, 5 * kMm) > heightOn(kMm, kMm / 2));
        QVERIFY(heightOn(kMm, kMm / 2) > 0);
        QCOMPARE(heightOn(kMm / 10, kMm / 10), 0);
        // As well upright as lying.
        QCOMPARE(heightOn(2 * kMm, 6 * kMm), heightOn(6 * kMm, 2 * kMm));
    }

    void whatHasNoNameHasNoPrint() {
        Component component = componentAt(0.0, LayerSide::Top);
        component.refdes.clear();
        QVERIFY(model::printDesignator(component, planOf(kMm, kMm)).empty());
        component.refdes = "U1";
        QVERIFY(model::printDesignator(component, {}).empty());
    }

    void charactersAreStrokesOfTheirHeight() {
        Box box;
        const model::PolygonSet strokes = model::characterStrokes('B', kMm);
        for (const model::Point p : strokes.points) {
            box.include(p);
        }
        QVERIFY(strokes.polygons.size() > 3);
        QVERIFY(std::abs(box.height() - kMm) < kMm / 4);
        QVERIFY(model::characterStrokes(U'\u00e9', kMm).polygons.empty());
        QVERIFY(model::characterStrokes(' ', kMm).polygons.empty());
    }
};

QTEST_APPLESS_MAIN(DesignatorTest)
#include "designator_test.moc"
