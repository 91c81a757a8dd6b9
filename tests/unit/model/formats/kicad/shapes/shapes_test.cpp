// Outlines of pads, what pens cover, loops of outlines.
#include <QtTest>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "model/formats/kicad/shapes/chains.h"
#include "model/formats/kicad/shapes/dashes.h"
#include "model/formats/kicad/shapes/largest_outline.h"
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

kicad::ChainEdge reversed(const kicad::ChainEdge& edge) {
    const EdgeKind kind = edge.from.edge == EdgeKind::ArcClockwise          ? EdgeKind::ArcCounterClockwise
                          : edge.from.edge == EdgeKind::ArcCounterClockwise ? EdgeKind::ArcClockwise
                                                                            : EdgeKind::Line;
    return {{edge.to, edge.from.centre, kind}, edge.from.point};
}

/// A tower of a wide and a narrower box that share an edge, leads of three lines each that end on a side of the body,
/// the mark of pin 1 within it, a divider, and a corner that is 2 µm off.
std::vector<kicad::ChainEdge> bodyWithTab() {
    return {edge({-3000, -1675}, {3000, -1675}), edge({3000, -1675}, {3000, 2575}), edge({-3000, 2573}, {-3000, -1675}),
            edge({-3000, 2575}, {3000, 2575}),   edge({3000, 2575}, {3000, 4575}),  edge({3000, 4575}, {-3000, 4575}),
            edge({-3000, 4575}, {-3000, 2575}),  edge({-3000, 0}, {-5000, 0}),      edge({-5000, 0}, {-5000, 500}),
            edge({-5000, 500}, {-3000, 500}),    edge({-2000, -1675}, {-1500, -9}), edge({-1500, -9}, {-1000, -1675}),
            edge({-3000, 1000}, {3000, 1000})};
}

/// In nm as bodyWithTab() has it in µm.
std::vector<kicad::ChainEdge> inMicrometres(std::vector<kicad::ChainEdge> edges) {
    for (kicad::ChainEdge& each : edges) {
        for (Point* p : {&each.from.point, &each.from.centre, &each.to}) {
            *p = {p->x * 1000, p->y * 1000};
        }
    }
    return edges;
}

std::vector<std::array<std::int64_t, 5>> nodesOf(const ShapeSketch& sketch) {
    std::vector<std::array<std::int64_t, 5>> nodes;
    for (std::size_t i = 0; i < sketch.contourCount(); ++i) {
        for (const PathNode& node : sketch.contour(i)) {
            nodes.push_back(
                {node.point.x, node.point.y, node.centre.x, node.centre.y, static_cast<std::int64_t>(node.edge)});
        }
    }
    return nodes;
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
        // Cut by nothing: sharp, whatever the others are.
        pad.chamferRatio = 0.0;
        pad.radiusRatio = 0.2;
        pad.chamfers = 3;
        QVERIFY(isNear(areaOf(shapeOf(pad, {}).region), 1e12 - (2 - std::numbers::pi / 2) * 2e5 * 2e5));
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

    void edgesThatAreDrawnAgainCountOnce() {
        const Point a{0, 0};
        const Point b{1'000'000, 0};
        const Point c{0, 1'000'000};
        const kicad::ChainEdge arc{{b, {0, 0}, EdgeKind::ArcCounterClockwise}, c};
        const kicad::ChainEdge back{{c, {1, 0}, EdgeKind::ArcClockwise}, b};  // as KiCad's three points give it
        const kicad::ChainEdge circle{{{200'000, 100'000}, {100'000, 100'000}, EdgeKind::ArcClockwise},
                                      {200'000, 100'000}};
        const std::array edges{edge(a, b), edge(b, a), arc, back, edge(c, a), edge(c, {9, 9}), circle, circle};
        const kicad::Chains chains = kicad::chained(edges, 1'000.0);
        QCOMPARE(chains.repeated, std::size_t{4});
        QVERIFY(chains.open.empty());
        QCOMPARE(chains.loops.size(), std::size_t{2});
        QCOMPARE(chains.loops[0].size(), std::size_t{1});
        QCOMPARE(chains.loops[1].size(), std::size_t{3});
    }

    /// The other way around the same circle, and the chord of an arc.
    void edgesOfOtherFormBetweenTheSameEndsAreKept() {
        const Point a{0, 0};
        const Point b{1'000'000, 0};
        const kicad::ChainEdge upper{{b, {500'000, 0}, EdgeKind::ArcCounterClockwise}, a};
        const kicad::ChainEdge lower{{a, {500'000, 0}, EdgeKind::ArcCounterClockwise}, b};
        const kicad::Chains disc = kicad::chained(std::array{upper, lower}, 1'000.0);
        QCOMPARE(disc.repeated, std::size_t{0});
        QCOMPARE(disc.loops.size(), std::size_t{1});
        const kicad::Chains half = kicad::chained(std::array{upper, edge(a, b)}, 1'000.0);
        QCOMPARE(half.repeated, std::size_t{0});
        QCOMPARE(half.loops.size(), std::size_t{1});
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

    void bodiesHoldWhatSharesCornersWithThem() {
        const ShapeSketch body = kicad::largestOutline(inMicrometres(bodyWithTab()), 10'000);
        QCOMPARE(boxOf(body).min, (Point{-3'000'000, -1'675'000}));
        QCOMPARE(boxOf(body).max, (Point{3'000'000, 4'575'000}));
        QVERIFY(isNear(areaOf(body), 6e6 * 6.25e6));
    }

    void bodiesAreTheSameInAnyOrderOfTheirLines() {
        std::vector<kicad::ChainEdge> edges = inMicrometres(bodyWithTab());
        // A bow over the tab, a line that covers part of another one, and a circle of its own.
        edges.push_back(
            {{{3'000'000, 4'575'000}, {0, 4'575'000}, EdgeKind::ArcCounterClockwise}, {-3'000'000, 4'575'000}});
        edges.push_back(edge({1'000'000, 2'575'000}, {3'000'000, 2'575'000}));
        edges.push_back({{{500'000, 0}, {0, 0}, EdgeKind::ArcClockwise}, {500'000, 0}});
        const auto expected = nodesOf(kicad::largestOutline(edges, 10'000));
        QVERIFY(!expected.empty());
        QCOMPARE(boxOf(kicad::largestOutline(edges, 10'000)).max.y, 7'575'000);
        std::mt19937 random(7);
        for (int i = 0; i < 200; ++i) {
            std::ranges::shuffle(edges, random);
            for (kicad::ChainEdge& each : edges) {
                each = random() % 2 == 0 ? each : reversed(each);
            }
            QCOMPARE(nodesOf(kicad::largestOutline(edges, 10'000)), expected);
        }
    }

    void ofBodiesOfOneSizeTheLeftOneIsTaken() {
        std::vector<kicad::ChainEdge> edges;
        for (const Nm x : {0, 5'000'000}) {
            edges.push_back(edge({x, 0}, {x + 1'000'000, 0}));
            edges.push_back(edge({x + 1'000'000, 0}, {x, 1'000'000}));
            edges.push_back(edge({x, 1'000'000}, {x, 0}));
        }
        QCOMPARE(boxOf(kicad::largestOutline(edges, 10'000)).min.x, 0);
        std::ranges::reverse(edges);
        QCOMPARE(boxOf(kicad::largestOutline(edges, 10'000)).min.x, 0);
    }

    void linesThatCloseNothingAreNoBody() {
        const std::vector<kicad::ChainEdge> edges = {edge({0, 0}, {1'000'000, 0}), edge({1'000'000, 0}, {0, 1'000'000}),
                                                     edge({0, 20'000}, {0, 1'000'000})};
        QVERIFY(kicad::largestOutline(edges, 10'000).isEmpty());
    }

    void tanglesOfLinesAreNotTakenApart() {
        // A star of lines that all cross each other, which would fall into millions of pieces.
        constexpr int kCorners = 4001;
        std::vector<Point> corners;
        for (int i = 0; i < kCorners; ++i) {
            const double angle = 2 * std::numbers::pi * (i * 2000 % kCorners) / kCorners;
            corners.push_back({static_cast<Nm>(2e7 * std::cos(angle)), static_cast<Nm>(2e7 * std::sin(angle))});
        }
        std::vector<kicad::ChainEdge> edges;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            edges.push_back(edge(corners[i], corners[(i + 1) % corners.size()]));
        }
        const Box star = boxOf(kicad::largestOutline(edges, 10'000));
        QVERIFY(star.width() > 39'000'000 && star.height() > 39'000'000);
    }

    /// By lines that KiCad 9 plots with a pen of 0.2 mm.
    void dashesAreThoseOfKicad() {
        const auto ends = [](kicad::LineStyle style, Nm length) {
            std::vector<Nm> all;
            for (const auto& [from, to] : kicad::dashesOf(edge({0, 0}, {length, 0}), 200'000.0, style, {})) {
                all.insert(all.end(), {from.point.x / 10'000, to.x / 10'000});
            }
            return all;
        };
        using kicad::LineStyle;
        QCOMPARE(ends(LineStyle::Solid, 5'000'000), (std::vector<Nm>{0, 500}));
        QCOMPARE(ends(LineStyle::Dash, 7'000'000), (std::vector<Nm>{0, 220, 300, 520, 600, 700}));
        QCOMPARE(ends(LineStyle::Dot, 2'000'000), (std::vector<Nm>{0, 4, 84, 88, 168, 172}));
        QCOMPARE(ends(LineStyle::DashDot, 5'000'000), (std::vector<Nm>{0, 220, 300, 304, 384, 500}));
        QCOMPARE(ends(LineStyle::DashDotDot, 5'000'000), (std::vector<Nm>{0, 220, 300, 304, 384, 388, 468, 500}));
        QCOMPARE(ends(LineStyle::Dash, 0), (std::vector<Nm>{0, 0}));
        QCOMPARE(ends(LineStyle::Dot, 2'000'000'000).size(), std::size_t{2});  // too many
        QCOMPARE(kicad::dashesOf(edge({0, 0}, {9'000'000, 0}), 200'000.0, LineStyle::Dash, {5.0, 1.0}).size(),
                 std::size_t{8});
        QVERIFY(kicad::lineStyleOf("dash_dot") == LineStyle::DashDot);
        QVERIFY(kicad::lineStyleOf("default") == LineStyle::Solid);
    }

    void dashesOfArcsRunClockwise() {
        const kicad::ChainEdge half = {{{-5'000'000, 0}, {0, 0}, EdgeKind::ArcCounterClockwise}, {5'000'000, 0}};
        const auto strokes = kicad::dashesOf(half, 200'000.0, kicad::LineStyle::Dash, {});
        QCOMPARE(strokes.size(), std::size_t{6});
        QCOMPARE(strokes.front().from.point, (Point{5'000'000, 0}));
        QCOMPARE(strokes.front().to, (Point{4'523'758, -2'129'697}));
        QCOMPARE(strokes.back().to, (Point{-5'000'000, 0}));
        QVERIFY(std::ranges::all_of(strokes, [](const kicad::ChainEdge& stroke) {
            return stroke.from.edge == EdgeKind::ArcClockwise && stroke.from.point != stroke.to;
        }));
        const kicad::ChainEdge circle = {{{0, 3'000'000}, {0, 0}, EdgeKind::ArcClockwise}, {0, 3'000'000}};
        const auto around = kicad::dashesOf(circle, 200'000.0, kicad::LineStyle::Dash, {});
        QCOMPARE(around.size(), std::size_t{7});
        QCOMPARE(around.front().from.point, (Point{3'000'000, 0}));
        QCOMPARE(kicad::dashesOf(circle, 2'000'000.0, kicad::LineStyle::Dash, {}).size(), std::size_t{1});
    }

    void arcsShorterThanAJointAreNoCircles() {
        const std::vector<kicad::ChainEdge> edges = {
            {{{5'000'000, 0}, {0, 0}, EdgeKind::ArcCounterClockwise}, {5'000'000, 4'000}}};
        QVERIFY(kicad::largestOutline(edges, 10'000).isEmpty());
        QVERIFY(kicad::chained(edges, 10'000).loops.empty());
    }
};

QTEST_APPLESS_MAIN(ShapesTest)
#include "shapes_test.moc"
