#include "render/round_holes.h"

#include <QtTest>
#include <cmath>
#include <numbers>

#include "model/document_builder.h"
#include "render/board_model.h"

using model::DocumentBuilder;
using model::EdgeKind;
using model::Point;
using model::ShapeSketch;
using render::PunchedShape;
using render::RoundHole;

namespace {

constexpr model::Nm kMm = 1'000'000;

ShapeSketch plate() {
    ShapeSketch sketch;
    sketch.addPolygon(std::vector<Point>{{0, 0}, {20 * kMm, 0}, {20 * kMm, 20 * kMm}, {0, 20 * kMm}}, false);
    return sketch;
}

PunchedShape punched(const ShapeSketch& sketch) {
    DocumentBuilder builder;
    const model::ShapeId shape = builder.addShape(sketch);
    builder.beginLayer(builder.addLayer({}));
    builder.addArea({shape, {}}, {});
    return render::punch(builder.finish()->shapes, shape, {});
}

render::BoardModel build(const model::Document& document) {
    base::Progress progress;
    return std::move(*render::buildBoardModel(document, {}, progress));
}

std::size_t holeLets(const render::BoardModel& model) {
    return static_cast<std::size_t>(std::ranges::count_if(
        model.lets, [](const shader::Let& let) { return (let.meta & shader::kLetKindMask) == shader::kLetHole; }));
}

}  // namespace

class RoundHolesTest : public QObject {
    Q_OBJECT

private slots:
    void aHoleThatStandsAloneLeavesItsCell() {
        ShapeSketch sketch = plate();
        sketch.addCircle({5 * kMm, 6 * kMm}, kMm, true);
        const PunchedShape shape = punched(sketch);
        QCOMPARE(shape.holes.size(), 1U);
        QCOMPARE(shape.holes[0].centre, (Point{5 * kMm, 6 * kMm}));
        QCOMPARE(shape.holes[0].radius, kMm);
        QCOMPARE(shape.polygons.points.size(), 8U);
        const double cell = 2.0 * shape.holes[0].cell;
        QCOMPARE(static_cast<double>(model::twiceArea(shape.polygons)), 2.0 * (400.0 * kMm * kMm - cell * cell));
    }

    void aCircleOfTwoArcsIsOneToo() {
        ShapeSketch sketch = plate();
        sketch.beginContour(true);
        sketch.addNode({{4 * kMm, 5 * kMm}, {5 * kMm, 5 * kMm}, EdgeKind::ArcClockwise});
        sketch.addNode({{6 * kMm, 5 * kMm}, {5 * kMm, 5 * kMm}, EdgeKind::ArcClockwise});
        QCOMPARE(punched(sketch).holes.size(), 1U);
    }

    void aHalfCircleIsNone() {
        ShapeSketch sketch = plate();
        sketch.beginContour(true);
        sketch.addNode({{4 * kMm, 5 * kMm}, {5 * kMm, 5 * kMm}, EdgeKind::ArcClockwise});
        sketch.addNode({{6 * kMm, 5 * kMm}, {}, EdgeKind::Line});
        QCOMPARE(punched(sketch).holes.size(), 0U);
    }

    void whatComesCloseStaysChords_data() {
        QTest::addColumn<Point>("second");
        QTest::addColumn<std::size_t>("holes");
        QTest::newRow("far") << Point{8 * kMm, 5 * kMm} << std::size_t{2};
        QTest::newRow("cells touch") << Point{7 * kMm + 50'000, 5 * kMm} << std::size_t{0};
        QTest::newRow("one in the other") << Point{5 * kMm, 5 * kMm} << std::size_t{0};
        QTest::newRow("at the edge") << Point{19 * kMm, 10 * kMm} << std::size_t{1};
        QTest::newRow("outside") << Point{40 * kMm, 10 * kMm} << std::size_t{1};
    }
    void whatComesCloseStaysChords() {
        QFETCH(Point, second);
        QFETCH(std::size_t, holes);
        ShapeSketch sketch = plate();
        sketch.addCircle({5 * kMm, 5 * kMm}, kMm, true);
        sketch.addCircle(second, kMm, true);
        QCOMPARE(punched(sketch).holes.size(), holes);
    }

    void cellsHaveNoWalls() {
        ShapeSketch sketch = plate();
        sketch.addCircle({5 * kMm, 5 * kMm}, kMm, true);
        DocumentBuilder builder;
        const model::ShapeId shape = builder.addShape(sketch);
        builder.beginLayer(builder.addLayer({}));
        builder.addArea({shape, {}}, {});
        const render::BoardModel model = build(*builder.finish());
        QCOMPARE(holeLets(model), 1U);
        std::size_t walls = 0;
        for (std::uint32_t i = 0; i < model.next.size(); ++i) {
            walls += model.next[i] != i ? 1 : 0;
        }
        QCOMPARE(walls, 4U);
    }

    void aShapePlacedTwiceSharesItsTriangles() {
        ShapeSketch sketch = plate();
        sketch.addCircle({5 * kMm, 5 * kMm}, kMm, true);
        DocumentBuilder builder;
        const model::ShapeId shape = builder.addShape(sketch);
        builder.beginLayer(builder.addLayer({}));
        builder.addArea({shape, {}}, {});
        builder.addArea({shape, {{30 * kMm, 0}, 0.0, false}}, {});
        QCOMPARE(holeLets(build(*builder.finish())), 0U);
    }

    /// A cell of a turned, mirrored area lies where the area has it.
    void letsFollowTheirArea() {
        ShapeSketch sketch = plate();
        sketch.addCircle({5 * kMm, 2 * kMm}, kMm, true);
        DocumentBuilder builder;
        const model::ShapeId shape = builder.addShape(sketch);
        builder.beginLayer(builder.addLayer({}));
        const model::Placement placement{{3 * kMm, 4 * kMm}, 30.0, true};
        builder.addArea({shape, placement}, {});
        const auto document = builder.finish();
        const render::BoardModel model = build(*document);
        QCOMPARE(holeLets(model), 1U);
        const shader::Let& let = model.lets[0];
        const model::PointD centre = placement.apply(model::PointD{5e6, 2e6});
        const glm::vec2 expected = render::toGpu(centre, model.origin);
        QVERIFY(glm::length(glm::vec2(let.p0, let.p1) - expected) < 1e-5F);
        const model::PointD corner = placement.apply(model::PointD{6e6, 2e6});
        const glm::vec2 along = glm::normalize(render::toGpu(corner, model.origin) - expected);
        // Sides come in four directions.
        const float turn = std::abs(glm::dot(along, glm::vec2(let.p2, let.p3)));
        QVERIFY(turn < 1e-4F || turn > 1.0F - 1e-4F);
    }
};

QTEST_APPLESS_MAIN(RoundHolesTest)
#include "round_holes_test.moc"
