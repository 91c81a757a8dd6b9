// Outlines of pads, what pens cover, loops of outlines.
#include <QtTest>
#include <array>
#include <cmath>
#include <numbers>

#include "model/formats/kicad/shapes/chains.h"
#include "model/formats/kicad/shapes/pad_outlines.h"
#include "model/formats/kicad/shapes/regions.h"
#include "model/geometry/discretise.h"
#include "model/geometry/outlines.h"
#include "model/geometry/region.h"

using namespace model;
using formats::PadShape;
using kicad::PadForm;

namespace {

double areaOf(const ShapeSketch& sketch) {
    return static_cast<double>(twiceArea(polygonsOf(sketch, {Discretisation::kMinChordNm, false}))) / 2.0;
}

bool isNear(double a, double b) {
    return std::abs(a - b) <= 2e-4 * std::abs(b);
}

PadForm form(PadForm::Kind kind, double width, double height) {
    PadForm form;
    form.kind = kind;
    form.size = {width, height};
    return form;
}

kicad::ChainEdge edge(Point a, Point b) {
    return {{a, {}, EdgeKind::Line}, b};
}

}  // namespace

class ShapesTest : public QObject {
    Q_OBJECT

private slots:
    void roundRectanglesKeepTheRatioOfTheirRadius() {
        PadForm pad = form(PadForm::Kind::RoundRectangle, 650'000, 1'200'000);
        pad.radiusRatio = 0.1;
        const PadShape opening = shapeOf(pad, {50'000, 50'000});
        QCOMPARE(opening.width, 750'000);
        QCOMPARE(opening.height, 1'300'000);
        const double r = 75'000;
        QVERIFY(isNear(areaOf(opening.region), 750e3 * 1300e3 - (4 - std::numbers::pi) * r * r));
    }

    void rectanglesGetRoundCornersInOpenings() {
        const PadForm pad = form(PadForm::Kind::Rectangle, 1'000'000, 2'000'000);
        QVERIFY(isNear(areaOf(shapeOf(pad, {}).region), 2e12));
        const double r = 100'000;
        QVERIFY(isNear(areaOf(shapeOf(pad, {r, r}).region), 1.2e6 * 2.2e6 - (4 - std::numbers::pi) * r * r));
    }

    void ovalsThatAreRoundAreRound() {
        QCOMPARE(shapeOf(form(PadForm::Kind::Oval, 1'000, 1'000), {}).kind, PadShape::Kind::Round);
        QCOMPARE(shapeOf(form(PadForm::Kind::Oval, 2'000, 1'000), {}).kind, PadShape::Kind::Oval);
    }

    void paddingAwayAllOfAPadLeavesNothing() {
        QCOMPARE(shapeOf(form(PadForm::Kind::Circle, 1'000, 1'000), {-500, -500}).kind, PadShape::Kind::Nothing);
        QCOMPARE(shapeOf(form(PadForm::Kind::Rectangle, 1'000, 1'000), {-500, -500}).kind, PadShape::Kind::Nothing);
    }

    void trapezoidsAreWiderBelow() {
        PadForm pad = form(PadForm::Kind::Trapezoid, 1'000'000, 1'000'000);
        pad.delta = {0, 200'000};
        const ShapeSketch shape = shapeOf(pad, {}).region;
        QVERIFY(isNear(areaOf(shape), 1e12));
        QCOMPARE(boxOf(shape).min, (Point{-600'000, -500'000}));
        Nm top = 0;
        for (const PathNode& node : shape.contour(0)) {
            top = node.point.y > 0 ? std::max(top, node.point.x) : top;
        }
        QCOMPARE(top, 400'000);
    }

    void chamfersCutChosenCorners() {
        PadForm pad = form(PadForm::Kind::RoundRectangle, 1'000'000, 1'000'000);
        pad.chamferRatio = 0.2;
        pad.chamfers = 1;
        QVERIFY(isNear(areaOf(shapeOf(pad, {}).region), 1e12 - 0.5 * 2e5 * 2e5));
        pad.chamfers = kAllCorners;
        QVERIFY(isNear(areaOf(shapeOf(pad, {}).region), 1e12 - 4 * 0.5 * 2e5 * 2e5));
    }

    void grownRegionsHaveRoundCorners() {
        ShapeSketch square;
        addBox(square, 1e6, 1e6, false);
        const double r = 1e5;
        QVERIFY(isNear(areaOf(kicad::grown(square, r)), 1e12 + 4 * 1e6 * r + std::numbers::pi * r * r));
        QVERIFY(isNear(areaOf(kicad::grown(square, -r)), 0.8e6 * 0.8e6));
    }

    void grownRegionsCloseNarrowHolesAndInlets() {
        ShapeSketch ring;
        addBox(ring, 4e6, 4e6, false);
        addBox(ring, 1e6, 1e6, true);
        const double pi = std::numbers::pi;
        QVERIFY(isNear(areaOf(kicad::grown(ring, 2e5)), 16e12 + 16e6 * 2e5 + pi * 4e10 - 0.36e12));
        QVERIFY(isNear(areaOf(kicad::grown(ring, 6e5)), 16e12 + 16e6 * 6e5 + pi * 36e10));
        ShapeSketch comb;
        const std::array<Point, 8> points = {{{0, 0},
                                              {3'000'000, 0},
                                              {3'000'000, 3'000'000},
                                              {2'000'000, 3'000'000},
                                              {2'000'000, 1'000'000},
                                              {1'800'000, 1'000'000},
                                              {1'800'000, 3'000'000},
                                              {0, 3'000'000}}};
        comb.addPolygon(points, false);
        const ShapeSketch grown = kicad::grown(comb, 1.5e5);
        // The inlet is closed but for the notch between the two arcs at its mouth.
        const double half = 1e5;
        const double r = 1.5e5;
        const double notch =
            2 * (half * r - 0.5 * (half * std::sqrt(r * r - half * half) + r * r * std::asin(half / r)));
        QVERIFY(isNear(areaOf(grown), 9e12 + 12e6 * r + pi * r * r - notch));
        QCOMPARE(grown.contourCount(), std::size_t{1});
    }

    void pensCoverArcsExactly() {
        const PathNode half{{1'000'000, 0}, {}, EdgeKind::ArcCounterClockwise};
        const auto band = kicad::penAlong(half, {-1'000'000, 0}, 200'000);
        QCOMPARE(band.size(), std::size_t{1});
        const double pi = std::numbers::pi;
        QVERIFY(isNear(model::areaOf(band[0]), pi * 1e6 * 2e5 + pi * 1e5 * 1e5));
        const auto ring = kicad::penAlong(half, {1'000'000, 0}, 200'000);
        QVERIFY(isNear(model::areaOf(ring[0]), 2 * pi * 1e6 * 2e5));
        const PathNode tight{{50'000, 0}, {}, EdgeKind::ArcCounterClockwise};
        QVERIFY(areaOf(kicad::united(kicad::penAlong(tight, {-50'000, 0}, 200'000))) > pi * 1e5 * 1e5);
    }

    void outlinesAreChainedInAnyOrder() {
        const Point a{0, 0};
        const Point b{1'000'000, 0};
        const Point c{1'000'000, 1'000'000};
        const std::array edges{edge(b, c), edge(b, a), edge({1'000'400, 1'000'000}, a), edge(c, {5'000'000, 0})};
        const kicad::Chains chains = kicad::chained(edges, 1'000.0);
        QCOMPARE(chains.loops.size(), std::size_t{1});
        QCOMPARE(chains.loops[0].size(), std::size_t{3});
        QCOMPARE(chains.open, (std::vector<std::size_t>{3}));
        QCOMPARE(chains.widestJoint, 400.0);
    }

    void loopsInLoopsAreHolesAndIslands() {
        std::vector<std::vector<PathNode>> loops;
        for (const Nm half : {10'000'000, 1'000'000, 5'000'000}) {
            loops.push_back({{{-half, -half}, {}, EdgeKind::Line},
                             {{half, -half}, {}, EdgeKind::Line},
                             {{half, half}, {}, EdgeKind::Line},
                             {{-half, half}, {}, EdgeKind::Line}});
        }
        loops.push_back({{{30'000'000, 0}, {20'000'000, 0}, EdgeKind::ArcClockwise}});
        const ShapeSketch shape = kicad::nested(loops);
        QCOMPARE(shape.contourCount(), std::size_t{4});
        QVERIFY(isNear(areaOf(shape), 400e12 - 100e12 + 4e12 + std::numbers::pi * 1e14));
    }
};

QTEST_APPLESS_MAIN(ShapesTest)
#include "shapes_test.moc"
