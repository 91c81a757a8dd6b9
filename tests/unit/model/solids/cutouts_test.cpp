#include "model/solids/cutouts.h"

#include <QtTest>
#include <random>

#include "model/board/document_builder.h"
#include "model/figures/element_polygons.h"
#include "model/geometry/boolean.h"
#include "model/solids/region_distance.h"

using model::Cutouts;
using model::DocumentBuilder;
using model::EdgeKind;
using model::Nm;
using model::Point;
using model::PolygonSet;
using model::ShapeId;
using model::ShapeSketch;

namespace {

constexpr Nm kMm = 1'000'000;

/// A square outline and elements to cut out of it.
class Bench {
public:
    explicit Bench(Nm side = 100 * kMm) {
        const Point corners[] = {{0, 0}, {side, 0}, {side, side}, {0, side}};
        ShapeSketch sketch;
        sketch.addPolygon(corners, false);
        m_outline = m_builder.addShape(sketch);
        m_builder.beginLayer(m_builder.addLayer({}));
        m_origin.flags = model::kHole;
    }
    void circle(Point centre, Nm diameter) { m_builder.addCircle({centre, diameter, diameter}, m_origin); }
    void slot(Point a, Point b, Nm width) { m_builder.addLine({a, b, width, 0}, m_origin); }
    void area(const ShapeSketch& sketch, const model::Placement& placement = {}) {
        m_builder.addArea({m_builder.addShape(sketch), placement}, m_origin);
    }
    void trail(std::span<const model::PathNode> nodes, Nm width) { m_builder.addTrail(nodes, width, m_origin); }

    ShapeSketch result(const base::Progress& progress = {}) const {
        const model::Document& document = m_builder.soFar();
        Cutouts cutouts;
        for (std::size_t row = 0; row < document.elements.size(); ++row) {
            cutouts.add(document, model::ElementId{row});
        }
        return model::subtract(document.shapes, m_outline, cutouts, progress);
    }

    /// The same by booleans of everything.
    PolygonSet expected() const {
        const model::Document& document = m_builder.soFar();
        PolygonSet all;
        for (std::size_t row = 0; row < document.elements.size(); ++row) {
            all.append(model::discretise(document, model::ElementId{row}, {}));
        }
        return model::subtract(model::discretise(document.shapes, m_outline, {}), all);
    }

private:
    DocumentBuilder m_builder;
    ShapeId m_outline;
    DocumentBuilder::Origin m_origin;
};

PolygonSet polygonsOf(const ShapeSketch& sketch) {
    DocumentBuilder builder;
    const ShapeId shape = builder.addShape(sketch);
    return model::discretise(builder.shapes(), shape, {});
}

double areaMm2(const PolygonSet& set) {
    return static_cast<double>(model::twiceArea(set)) / 2e12;
}

bool isCircle(const ShapeSketch& sketch, std::size_t contour, Point centre, Nm radius) {
    const auto nodes = sketch.contour(contour);
    return nodes.size() == 1 && nodes[0].edge != EdgeKind::Line && nodes[0].centre == centre &&
           nodes[0].point.x - centre.x == radius && sketch.isHole(contour);
}

}  // namespace

class CutoutsTest : public QObject {
    Q_OBJECT

private slots:
    void holesThatKeepApartStayExact() {
        Bench bench;
        bench.circle({20 * kMm, 20 * kMm}, kMm);
        bench.slot({40 * kMm, 40 * kMm}, {50 * kMm, 40 * kMm}, 2 * kMm);
        const ShapeSketch sketch = bench.result();
        QCOMPARE(sketch.contourCount(), std::size_t{3});
        QCOMPARE(sketch.contour(0).size(), std::size_t{4});
        QVERIFY(isCircle(sketch, 1, {20 * kMm, 20 * kMm}, kMm / 2));
        const auto slot = sketch.contour(2);
        QCOMPARE(slot.size(), std::size_t{4});
        QCOMPARE(slot[0].centre, (Point{50 * kMm, 40 * kMm}));
        QCOMPARE(slot[0].point, (Point{50 * kMm, 39 * kMm}));
        QCOMPARE(slot[2].centre, (Point{40 * kMm, 40 * kMm}));
    }

    void ofHolesAtOnePlaceTheWidestIsKeptExact() {
        Bench bench;
        bench.circle({20 * kMm, 20 * kMm}, kMm);
        bench.circle({20 * kMm, 20 * kMm}, 3 * kMm);
        bench.circle({20 * kMm + 1000, 20 * kMm}, 2 * kMm);
        const ShapeSketch sketch = bench.result();
        QCOMPARE(sketch.contourCount(), std::size_t{2});
        QVERIFY(isCircle(sketch, 1, {20 * kMm, 20 * kMm}, 3 * kMm / 2));
    }

    void onlyHolesThatOverlapBecomePolygons() {
        Bench bench;
        bench.circle({20 * kMm, 20 * kMm}, 2 * kMm);
        bench.circle({21 * kMm, 20 * kMm}, 2 * kMm);
        bench.circle({60 * kMm, 20 * kMm}, 2 * kMm);
        const ShapeSketch sketch = bench.result();
        QCOMPARE(sketch.contourCount(), std::size_t{3});
        QVERIFY(sketch.contour(1).size() > 10);
        QVERIFY(isCircle(sketch, 2, {60 * kMm, 20 * kMm}, kMm));
        QCOMPARE(areaMm2(polygonsOf(sketch)), areaMm2(bench.expected()));
    }

    void aHoleAcrossTheOutlineIsACastellation() {
        Bench bench;
        bench.circle({100 * kMm, 50 * kMm}, 2 * kMm);
        bench.circle({20 * kMm, 20 * kMm}, kMm);
        const ShapeSketch sketch = bench.result();
        QCOMPARE(sketch.contourCount(), std::size_t{2});
        QVERIFY(isCircle(sketch, 1, {20 * kMm, 20 * kMm}, kMm / 2));
        QVERIFY(std::abs(areaMm2(polygonsOf(sketch)) - (10'000 - M_PI / 2 - M_PI / 4)) < 0.02);
    }

    void whatLiesOutsideChangesNothing() {
        Bench bench;
        bench.circle({150 * kMm, 50 * kMm}, 2 * kMm);
        QCOMPARE(bench.result().contourCount(), std::size_t{1});
    }

    void whatCoversTheOutlineLeavesNothing() {
        Bench bench(10 * kMm);
        bench.circle({5 * kMm, 5 * kMm}, 40 * kMm);
        QVERIFY(bench.result().isEmpty());
    }

    void aRoutedRingLeavesItsCore() {
        Bench bench;
        const Point corners[] = {
            {10 * kMm, 10 * kMm}, {30 * kMm, 10 * kMm}, {30 * kMm, 30 * kMm}, {10 * kMm, 30 * kMm}};
        std::vector<model::PathNode> nodes;
        for (const std::size_t i : {0U, 1U, 2U, 3U, 0U}) {
            nodes.push_back({corners[i], {}, EdgeKind::Line});
        }
        bench.trail(nodes, 2 * kMm);
        bench.circle({20 * kMm, 20 * kMm}, kMm);  // in the core
        const PolygonSet polygons = polygonsOf(bench.result());
        QCOMPARE(polygons.polygons.size(), std::size_t{2});
        QCOMPARE(areaMm2(polygons), areaMm2(bench.expected()));
    }

    void aPlacedAreaWithAHoleKeepsItsArcs() {
        Bench bench;
        ShapeSketch washer;
        washer.addCircle({5 * kMm, 0}, 3 * kMm, false);
        washer.addCircle({5 * kMm, 0}, kMm, true);
        bench.area(washer, {{50 * kMm, 50 * kMm}, 90.0, true});
        bench.circle({50 * kMm, 45 * kMm}, kMm);  // in the washer's hole
        const ShapeSketch sketch = bench.result();
        QCOMPARE(sketch.contourCount(), std::size_t{4});
        for (std::size_t i = 1; i < sketch.contourCount(); ++i) {
            QCOMPARE(sketch.contour(i).size(), std::size_t{1});
        }
        QCOMPARE(areaMm2(polygonsOf(sketch)), areaMm2(bench.expected()));
    }

    void areaIsConservedOverHolesOfAllKinds_data() {
        QTest::addColumn<unsigned>("seed");
        for (unsigned seed = 1; seed <= 12; ++seed) {
            QTest::addRow("%u", seed) << seed;
        }
    }
    void areaIsConservedOverHolesOfAllKinds() {
        QFETCH(unsigned, seed);
        std::mt19937 random(seed);
        const auto upTo = [&random](Nm most) { return static_cast<Nm>(random() % static_cast<unsigned>(most)); };
        const auto somewhere = [&] { return Point{upTo(120 * kMm) - 10 * kMm, upTo(120 * kMm) - 10 * kMm}; };
        Bench bench;
        for (int i = 0; i < 150; ++i) {
            const Point p = somewhere();
            const Point q{p.x + upTo(8 * kMm), p.y - upTo(8 * kMm)};
            switch (random() % 3) {
                case 0: bench.circle(p, upTo(4 * kMm) + 1000); break;
                case 1: bench.slot(p, q, upTo(2 * kMm) + 1000); break;
                default: {
                    ShapeSketch box;
                    const Point corners[] = {{0, 0}, {q.x - p.x + 1000, 0}, {q.x - p.x + 1000, kMm}, {0, kMm}};
                    box.addPolygon(corners, false);
                    bench.area(box, {p, static_cast<double>(random() % 360), random() % 2 == 0});
                }
            }
        }
        // Points of crossings are rounded to whole nanometres, here and there in another order.
        QVERIFY(std::abs(areaMm2(polygonsOf(bench.result())) - areaMm2(bench.expected())) < 1e-3);
    }

    void aCancelledCutGivesNothing() {
        Bench bench;
        bench.circle({20 * kMm, 20 * kMm}, kMm);
        base::Progress progress;
        progress.cancel();
        QVERIFY(bench.result(progress).isEmpty());
    }

    void distancesOfStretches() {
        QCOMPARE(model::segmentDistance({0, 0}, {10, 0}, {5, 3}, {5, 9}), 3.0);
        QCOMPARE(model::segmentDistance({0, 0}, {10, 0}, {5, -3}, {5, 9}), 0.0);
        QCOMPARE(model::segmentDistance({0, 0}, {0, 0}, {3, 4}, {3, 4}), 5.0);
        QCOMPARE(model::segmentDistance({0, 0}, {10, 10}, {20, 10}, {30, 10}), 10.0);
    }
};

QTEST_APPLESS_MAIN(CutoutsTest)
#include "cutouts_test.moc"
