// Exact gaps between elements of every kind, against fixtures worked out by hand and against dense sampling.
#include "model/figures/distance.h"

#include <QtTest>
#include <cmath>
#include <numbers>
#include <random>

#include "model/board/document_builder.h"
#include "model/figures/element_polygons.h"
#include "model/geometry/discretise.h"
#include "tests/unit/model/figures/element_spacing.h"

using model::ArcGeometry;
using model::DocumentBuilder;
using model::EdgeKind;
using model::ElementId;
using model::Nm;
using model::PathNode;
using model::Placement;
using model::Point;
using model::PointD;
using model::ShapeSketch;
using model::Spacing;

namespace {

constexpr Nm kMm = 1'000'000;

/// A document of one layer to which elements are added one by one.
class LayerGeometry {
public:
    LayerGeometry() { m_builder.beginLayer(m_builder.addLayer({})); }

    ElementId line(Point a, Point b, Nm width, std::uint8_t flags = 0) {
        DocumentBuilder::Origin origin;
        origin.flags = flags;
        return m_builder.addLine({a, b, width, 0}, origin);
    }
    ElementId arc(Point a, Point centre, Point b, Nm width, EdgeKind way = EdgeKind::ArcCounterClockwise) {
        return m_builder.addArc({PathNode{a, centre, way}, b, width}, {});
    }
    ElementId circle(Point centre, Nm diameter, Nm inner = 0) {
        return m_builder.addCircle({centre, diameter, inner}, {});
    }
    ElementId trail(const std::vector<Point>& points, Nm width) {
        std::vector<PathNode> nodes;
        for (const Point p : points) {
            nodes.push_back({p, {}, EdgeKind::Line});
        }
        return m_builder.addTrail(nodes, width, {});
    }
    ElementId area(const ShapeSketch& sketch, const Placement& placement = {}) {
        return m_builder.addArea({m_builder.addShape(sketch), placement}, {});
    }
    ElementId rectangle(Point min, Point max) {
        ShapeSketch sketch;
        addRectangle(sketch, min, max, false);
        return area(sketch);
    }
    static void addRectangle(ShapeSketch& sketch, Point min, Point max, bool isHole) {
        sketch.addPolygon(std::array<Point, 4>{{min, {max.x, min.y}, max, {min.x, max.y}}}, isHole);
    }
    [[nodiscard]] const model::Document& document() const { return m_builder.soFar(); }
    [[nodiscard]] double gap(ElementId a, ElementId b) const {
        const auto found = figure_testing::spacingBetween(document(), a, b);
        return found ? found->distance : -1.0;
    }

private:
    DocumentBuilder m_builder;
};

/// Elements of all kinds whose rightmost point is exactly (0, 0) and which lie left of it.
std::vector<std::pair<const char*, ElementId>> leftOfOrigin(LayerGeometry& s) {
    ShapeSketch round;
    round.addCircle({-kMm, 0}, kMm, false);
    ShapeSketch halfDisc;
    halfDisc.beginContour(false);
    halfDisc.addNode({{-kMm, -kMm}, {-kMm, 0}, EdgeKind::ArcCounterClockwise});
    halfDisc.addNode(Point{-kMm, kMm});
    ShapeSketch rotated;
    LayerGeometry::addRectangle(rotated, {-kMm, -2 * kMm}, {kMm, 0}, false);
    ShapeSketch flipped;
    LayerGeometry::addRectangle(flipped, {-kMm, 0}, {kMm, 2 * kMm}, false);
    return {{"dot", s.line({-kMm, 0}, {-kMm, 0}, 2 * kMm)},
            {"line", s.line({-5 * kMm, -3 * kMm}, {-100'000, 0}, 200'000)},
            {"standing line", s.line({-100'000, -3 * kMm}, {-100'000, 3 * kMm}, 200'000)},
            {"square pen", s.line({-5 * kMm, 0}, {-kMm, 0}, 2 * kMm, model::kSquarePen)},
            {"slanting square pen", s.line({-5 * kMm, -4 * kMm}, {-kMm, 0}, 2 * kMm, model::kSquarePen)},
            {"arc", s.arc({-2 * kMm, -kMm}, {-2 * kMm, 0}, {-2 * kMm, kMm}, 2 * kMm)},
            {"arc clockwise", s.arc({-2 * kMm, kMm}, {-2 * kMm, 0}, {-2 * kMm, -kMm}, 2 * kMm, EdgeKind::ArcClockwise)},
            {"full arc", s.arc({-kMm, 0}, {-2 * kMm, 0}, {-kMm, 0}, 2 * kMm)},
            {"circle", s.circle({-kMm, 0}, 2 * kMm)},
            {"ring", s.circle({-kMm, 0}, 2 * kMm, kMm)},
            {"trail", s.trail({{-5 * kMm, kMm}, {-100'000, 0}, {-5 * kMm, -2 * kMm}}, 200'000)},
            {"rectangle", s.rectangle({-3 * kMm, -kMm}, {0, kMm})},
            {"round area", s.area(round)},
            {"half disc", s.area(halfDisc)},
            {"turned area", s.area(rotated, {{0, 0}, 90.0, false})},
            {"mirrored area", s.area(flipped, {{0, 0}, 90.0, true})}};
}

ShapeSketch frame() {
    ShapeSketch sketch;
    LayerGeometry::addRectangle(sketch, {0, 0}, {10 * kMm, 10 * kMm}, false);
    LayerGeometry::addRectangle(sketch, {2 * kMm, 2 * kMm}, {8 * kMm, 8 * kMm}, true);
    return sketch;
}

/// The frame as KiCad writes it: one contour that walks in over a bridge of no width.
ShapeSketch keyhole() {
    ShapeSketch sketch;
    sketch.addPolygon(std::array<Point, 10>{{{0, 0},
                                             {10 * kMm, 0},
                                             {10 * kMm, 10 * kMm},
                                             {0, 10 * kMm},
                                             {0, 2 * kMm},
                                             {2 * kMm, 2 * kMm},
                                             {2 * kMm, 8 * kMm},
                                             {8 * kMm, 8 * kMm},
                                             {8 * kMm, 2 * kMm},
                                             {0, 2 * kMm}}},
                      false);
    return sketch;
}

double pointToPolygons(const model::PolygonSet& set, PointD p) {
    double best = 1e18;
    for (std::size_t l = 0; l < set.loopCount(); ++l) {
        const auto loop = set.loop(l);
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const PointD a = base::toDouble(loop[i]);
            const PointD b = base::toDouble(loop[(i + 1) % loop.size()]);
            const double dx = b.x - a.x;
            const double dy = b.y - a.y;
            const double t = std::clamp(((p.x - a.x) * dx + (p.y - a.y) * dy) / (dx * dx + dy * dy), 0.0, 1.0);
            best = std::min(best, std::hypot(p.x - a.x - t * dx, p.y - a.y - t * dy));
        }
    }
    return best;
}

/// Distance of two outlines made of chords, each corner of one against the other.
double outlineSpacing(const model::PolygonSet& a, const model::PolygonSet& b) {
    double best = 1e18;
    for (const Point p : a.points) {
        best = std::min(best, pointToPolygons(b, base::toDouble(p)));
    }
    for (const Point p : b.points) {
        best = std::min(best, pointToPolygons(a, base::toDouble(p)));
    }
    return best;
}

}  // namespace

class DistanceTest : public QObject {
    Q_OBJECT

private slots:
    void everyPairOfKindsTouchesAndPartsByOneNanometre() {
        LayerGeometry plane;
        const auto left = leftOfOrigin(plane);
        for (const auto& [nameA, a] : left) {
            for (const Nm shift : {0, 1, 1000}) {
                const ElementId wall = plane.rectangle({shift, -20 * kMm}, {kMm, 20 * kMm});
                const ElementId dot = plane.circle({shift + kMm, 0}, 2 * kMm);
                const ElementId ring = plane.circle({shift + 3 * kMm, 0}, 6 * kMm, 4 * kMm);
                const ElementId track = plane.line({shift + 50'000, -9 * kMm}, {shift + 50'000, 9 * kMm}, 100'000);
                for (const ElementId b : {wall, dot, ring, track}) {
                    const double gap = plane.gap(a, b);
                    QVERIFY2(
                        std::abs(gap - shift) < 1e-3,
                        qPrintable(
                            QString("%1 against element %2: %3, not %4").arg(nameA).arg(b.value).arg(gap).arg(shift)));
                    QCOMPARE(gap <= model::kTouchNm, shift == 0);
                    QVERIFY(std::abs(plane.gap(b, a) - gap) < 1e-6);
                }
            }
        }
    }

    void whatLiesInsideTouches() {
        LayerGeometry plane;
        const ElementId plate = plane.rectangle({0, 0}, {10 * kMm, 10 * kMm});
        const ElementId small = plane.circle({5 * kMm, 5 * kMm}, kMm);
        const ElementId inner = plane.rectangle({4 * kMm, 4 * kMm}, {6 * kMm, 6 * kMm});
        QCOMPARE(plane.gap(plate, small), 0.0);
        QCOMPARE(plane.gap(small, plate), 0.0);
        QCOMPARE(plane.gap(plate, inner), 0.0);
        const auto gap = figure_testing::spacingBetween(plane.document(), plate, inner);
        QVERIFY(gap->from.x == gap->to.x && gap->from.x >= 4 * kMm && gap->from.x <= 6 * kMm);
        // A stroke swallows whatever its pen covers.
        QCOMPARE(plane.gap(plane.line({0, 0}, {20 * kMm, 0}, 4 * kMm), plane.rectangle({kMm, 0}, {2 * kMm, kMm})), 0.0);
    }

    void holesKeepApart_data() {
        QTest::addColumn<bool>("isKeyhole");
        QTest::addRow("outline and hole") << false;
        QTest::addRow("keyhole") << true;
    }
    void holesKeepApart() {
        QFETCH(bool, isKeyhole);
        LayerGeometry plane;
        const ElementId plate = plane.area(isKeyhole ? keyhole() : frame());
        QCOMPARE(plane.gap(plate, plane.circle({5 * kMm, 5 * kMm}, 2 * kMm)), 2.0 * kMm);
        QCOMPARE(plane.gap(plate, plane.circle({3 * kMm, 5 * kMm}, 2 * kMm - 2)), 1.0);
        QCOMPARE(plane.gap(plate, plane.circle({3 * kMm, 5 * kMm}, 2 * kMm)), 0.0);
        QCOMPARE(plane.gap(plate, plane.circle({kMm, 5 * kMm}, 10)), 0.0);
        // On the bridge of the keyhole there is copper.
        QCOMPARE(plane.gap(plate, plane.circle({kMm, 2 * kMm}, 10)), 0.0);
        QCOMPARE(plane.gap(plate, plane.circle({kMm, 2 * kMm + 100}, 10)), 0.0);
        // A frame inside the hole, and one around everything.
        QCOMPARE(plane.gap(plate, plane.rectangle({3 * kMm, 3 * kMm}, {7 * kMm, 7 * kMm})), 1.0 * kMm);
    }

    void ringsAreHollow() {
        LayerGeometry plane;
        const ElementId ring = plane.circle({0, 0}, 10 * kMm, 8 * kMm);
        QCOMPARE(plane.gap(ring, plane.circle({0, 0}, 2 * kMm)), 3.0 * kMm);
        QVERIFY(std::abs(plane.gap(ring, plane.circle({3 * kMm, 0}, 2 * kMm)) - 0.0) < 1e-6);
        QVERIFY(std::abs(plane.gap(ring, plane.circle({3 * kMm - 1, 0}, 2 * kMm)) - 1.0) < 1e-6);
        QCOMPARE(plane.gap(ring, plane.line({-9 * kMm, 0}, {9 * kMm, 0}, 100)), 0.0);
    }

    void everyIslandOfAnAreaIsAFigure() {
        LayerGeometry plane;
        ShapeSketch sketch;
        LayerGeometry::addRectangle(sketch, {0, 0}, {kMm, kMm}, false);
        LayerGeometry::addRectangle(sketch, {5 * kMm, 0}, {6 * kMm, kMm}, false);
        const ElementId both = plane.area(sketch);
        model::FigureTable table;
        table.add(plane.document(), both);
        QCOMPARE(table.size(), std::size_t{2});
        QCOMPARE(plane.gap(both, plane.circle({5 * kMm + 500'000, 500'000}, 10)), 0.0);
        QCOMPARE(plane.gap(both, plane.circle({3 * kMm, 500'000}, kMm)), 1.5 * kMm);
    }

    void strokesWithoutWidthCoverNothing() {
        LayerGeometry plane;
        const ElementId thin = plane.line({0, 0}, {kMm, 0}, 0);
        QVERIFY(!figure_testing::spacingBetween(plane.document(), thin, thin));
    }

    void theLimitHidesWhatIsFartherAway() {
        LayerGeometry plane;
        const ElementId a = plane.circle({0, 0}, kMm);
        const ElementId b = plane.circle({2 * kMm, 0}, kMm);
        QVERIFY(!figure_testing::spacingBetween(plane.document(), a, b, kMm - 1.0));
        const auto gap = figure_testing::spacingBetween(plane.document(), a, b, double{kMm});
        QVERIFY(gap && gap->distance == kMm);
        QCOMPARE(gap->from.x, 500'000.0);
        QCOMPARE(gap->to.x, 1'500'000.0);
    }

    void arcsWithUnequalRadiiKeepTheirEnds() {
        LayerGeometry plane;
        // The radii differ by 3 nm, as rounding makes them.
        const ElementId arc = plane.arc({kMm, 0}, {0, 0}, {0, kMm + 3}, 100);
        QVERIFY(std::abs(plane.gap(arc, plane.circle({0, kMm + 3 + 50 + 50}, 100)) - 0.0) < 1e-3);
        QVERIFY(std::abs(plane.gap(arc, plane.circle({kMm + 101, 0}, 100)) - 1.0) < 1.6);
    }

    void edgesMeetWhereSamplingSaysTheyDo() {
        std::mt19937 random(7);
        std::uniform_int_distribution<Nm> place(-1000, 1000);
        int crossings = 0;
        for (int round = 0; round < 2000; ++round) {
            const auto point = [&] { return Point{place(random), place(random)}; };
            const auto edge = [&] {
                const Point a = point();
                const Point b = round % 5 == 0 ? a : point();
                PathNode node{a, {}, EdgeKind::Line};
                if (random() % 2 == 0) {
                    // A centre on the perpendicular bisector makes both radii equal up to rounding.
                    const double t = place(random) / 1000.0;
                    node.centre = a == b ? point()
                                         : Point{static_cast<Nm>((a.x + b.x) / 2 - t * (b.y - a.y)),
                                                 static_cast<Nm>((a.y + b.y) / 2 + t * (b.x - a.x))};
                    node.edge = random() % 2 == 0 ? EdgeKind::ArcClockwise : EdgeKind::ArcCounterClockwise;
                    if (node.centre == a) {
                        node.edge = EdgeKind::Line;
                    }
                }
                return std::pair(node, b);
            };
            const auto [nodeA, endA] = edge();
            const auto [nodeB, endB] = edge();
            const double exact = spacingBetween(model::edgeOf(nodeA, endA), model::edgeOf(nodeB, endB)).distance;
            const double sampled = sampledSpacing(nodeA, endA, nodeB, endB);
            crossings += exact == 0 ? 1 : 0;
            QVERIFY2(exact <= sampled + 2.0 && exact >= sampled - 20.0,
                     qPrintable(QString("round %1: %2, sampled %3").arg(round).arg(exact).arg(sampled)));
        }
        QVERIFY(crossings > 200 && crossings < 1800);
    }

    void largeFiguresAreSearchedAsSmallOnesAre() {
        // Stars with many holes: the tree of boxes must find what comparing all outlines finds.
        std::mt19937 random(11);
        for (int round = 0; round < 20; ++round) {
            LayerGeometry plane;
            const auto star = [&](Point centre) {
                ShapeSketch sketch;
                sketch.beginContour(false);
                const int count = 50 + static_cast<int>(random() % 200);
                for (int i = 0; i < count; ++i) {
                    const double angle = 2 * std::numbers::pi * i / count;
                    const double radius = (3.0 + static_cast<double>(random() % 1000) / 500.0) * kMm;
                    sketch.addNode(Point{centre.x + static_cast<Nm>(radius * std::cos(angle)),
                                         centre.y + static_cast<Nm>(radius * std::sin(angle))});
                }
                for (int i = 0; i < 40; ++i) {
                    const Nm x = centre.x + (i % 7 - 3) * 500'000;
                    const Nm y = centre.y + (i / 7 - 3) * 500'000;
                    sketch.addPolygon(std::array<Point, 3>{{{x, y}, {x + 200'000, y}, {x, y + 200'000}}}, true);
                }
                return sketch;
            };
            const ElementId a = plane.area(star({0, 0}));
            const ElementId b = plane.area(star({12 * kMm, static_cast<Nm>(random() % 3'000'000)}));
            const double expected =
                outlineSpacing(discretise(plane.document(), a, {}), discretise(plane.document(), b, {}));
            QVERIFY(std::abs(plane.gap(a, b) - expected) < 1e-3);
            // In a hole, between holes.
            QVERIFY(plane.gap(a, plane.circle({50'000, 50'000}, 1000)) > 0);
            QCOMPARE(plane.gap(a, plane.circle({-100'000, -100'000}, 1000)), 0.0);
        }
    }

    void insideAgreesWithTheWindingOfChords() {
        // A shape of arcs in both directions, asked at many points, some right on chords and corners.
        ShapeSketch sketch;
        sketch.beginContour(false);
        sketch.addNode({{0, 0}, {500, 0}, EdgeKind::ArcCounterClockwise});  // bulges down
        sketch.addNode({{1000, 0}, {1000, 500}, EdgeKind::ArcClockwise});   // bites in from the right
        sketch.addNode({{1000, 1000}, {500, 1000}, EdgeKind::ArcCounterClockwise});
        sketch.addNode({{0, 1000}, {0, 500}, EdgeKind::ArcClockwise});
        sketch.addCircle({500, 500}, 100, true);
        LayerGeometry plane;
        model::FigureTable table;
        table.add(plane.document(), plane.area(sketch));
        QCOMPARE(table.size(), std::size_t{1});
        const auto expected = [](double x, double y) {
            const auto in = [&](double cx, double cy, double r) { return std::hypot(x - cx, y - cy) < r; };
            const bool isInSquare = x > 0 && x < 1000 && y > 0 && y < 1000;
            const bool isBitten = in(1000, 500, 500) || in(0, 500, 500);
            const bool bulges = (in(500, 0, 500) && y <= 0) || (in(500, 1000, 500) && y >= 1000);
            return ((isInSquare && !isBitten) || bulges) && !in(500, 500, 100);
        };
        int inside = 0;
        for (int x = -100; x <= 1100; x += 25) {
            for (int y = -600; y <= 1600; y += 25) {
                const auto onArc = [&](double cx, double cy, double r) {
                    return std::abs(std::hypot(x - cx, y - cy) - r) < 1e-9;
                };
                if (onArc(500, 0, 500) || onArc(1000, 500, 500) || onArc(500, 1000, 500) || onArc(0, 500, 500) ||
                    onArc(500, 500, 100)) {
                    continue;
                }
                const bool isIn = model::isInside(table, 0, {double(x), double(y)});
                inside += isIn ? 1 : 0;
                QVERIFY2(isIn == expected(x, y), qPrintable(QString("%1, %2").arg(x).arg(y)));
            }
        }
        QVERIFY(inside > 500);
    }

private:
    static std::vector<PointD> samples(const PathNode& node, Point end) {
        std::vector<PointD> points;
        constexpr int kCount = 400;
        const double sweep = node.edge == EdgeKind::Line ? 0.0 : model::sweepOf(node, end);
        for (int i = 0; i <= kCount; ++i) {
            const double t = static_cast<double>(i) / kCount;
            if (node.edge == EdgeKind::Line) {
                points.push_back({node.point.x + t * (double(end.x) - node.point.x),
                                  node.point.y + t * (double(end.y) - node.point.y)});
                continue;
            }
            const PointD c = base::toDouble(node.centre);
            const double start = std::atan2(node.point.y - c.y, node.point.x - c.x);
            const double radius =
                (std::hypot(node.point.x - c.x, node.point.y - c.y) + std::hypot(end.x - c.x, end.y - c.y)) / 2;
            points.push_back({c.x + radius * std::cos(start + t * sweep), c.y + radius * std::sin(start + t * sweep)});
        }
        return points;
    }

    static double sampledSpacing(const PathNode& a, Point endA, const PathNode& b, Point endB) {
        double best = 1e18;
        const std::vector<PointD> second = samples(b, endB);
        for (const PointD p : samples(a, endA)) {
            for (std::size_t i = 0; i + 1 < second.size(); ++i) {
                const PointD q = second[i];
                const double dx = second[i + 1].x - q.x;
                const double dy = second[i + 1].y - q.y;
                const double squared = dx * dx + dy * dy;
                const double t =
                    squared > 0 ? std::clamp(((p.x - q.x) * dx + (p.y - q.y) * dy) / squared, 0.0, 1.0) : 0.0;
                const double x = p.x - q.x - t * dx;
                const double y = p.y - q.y - t * dy;
                best = std::min(best, x * x + y * y);
            }
        }
        return std::sqrt(best);
    }
};

QTEST_APPLESS_MAIN(DistanceTest)
#include "distance_test.moc"
