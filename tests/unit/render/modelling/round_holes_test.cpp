#include "render/modelling/round_holes.h"

#include <QtTest>
#include <cmath>
#include <numbers>

#include "model/board/document_builder.h"
#include "render/modelling/board_model.h"
#include "render/modelling/lets.h"

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
        QCOMPARE(shape.fields, std::vector<model::Box>{shape.holes[0].cell});
        const auto side = static_cast<double>(shape.holes[0].cell.width());
        QCOMPARE(static_cast<double>(model::twiceArea(shape.polygons)), 2.0 * (400.0 * kMm * kMm - side * side));
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

    void holesWithNothingBetweenThemShareAField() {
        ShapeSketch sketch = plate();
        double cells = 0.0;
        for (int i = 0; i < 16; ++i) {
            sketch.addCircle({(3 + 4 * (i % 4)) * kMm, (3 + 4 * (i / 4)) * kMm}, kMm / 2 + i * 10'000, true);
        }
        const PunchedShape shape = punched(sketch);
        QCOMPARE(shape.holes.size(), 16U);
        QCOMPARE(shape.fields.size(), 1U);
        QCOMPARE(shape.polygons.points.size(), 8U);
        for (const RoundHole& hole : shape.holes) {
            cells += static_cast<double>(hole.cell.width()) * static_cast<double>(hole.cell.height());
            const model::Box square = model::Box{hole.centre, hole.centre}.grownBy(render::cellAround(hole.radius));
            model::Box both = square;
            both.include(hole.cell);
            QCOMPARE(both, hole.cell);
        }
        const model::Box field = shape.fields[0];
        QCOMPARE(cells, static_cast<double>(field.width()) * static_cast<double>(field.height()));
    }

    void aSlotBetweenHolesPartsTheirField() {
        ShapeSketch sketch = plate();
        sketch.addCircle({5 * kMm, 5 * kMm}, kMm, true);
        sketch.addCircle({5 * kMm, 15 * kMm}, kMm, true);
        sketch.addCircle({15 * kMm, 15 * kMm}, kMm, true);
        sketch.addPolygon(
            std::vector<Point>{{9 * kMm, 9 * kMm}, {9 * kMm, 11 * kMm}, {11 * kMm, 11 * kMm}, {11 * kMm, 9 * kMm}},
            true);
        const PunchedShape shape = punched(sketch);
        QCOMPARE(shape.holes.size(), 3U);
        QCOMPARE(shape.fields.size(), 2U);
    }

    /// Reaches of a let are 16-bit numbers.
    void cellsReachNoFartherThanALetCanSay() {
        ShapeSketch sketch;
        sketch.addPolygon(std::vector<Point>{{0, 0}, {400 * kMm, 0}, {400 * kMm, 400 * kMm}, {0, 400 * kMm}}, false);
        sketch.addCircle({10 * kMm, 10 * kMm}, kMm, true);
        sketch.addCircle({390 * kMm, 380 * kMm}, 2 * kMm, true);
        const PunchedShape shape = punched(sketch);
        QCOMPARE(shape.holes.size(), 2U);
        QCOMPARE(shape.fields.size(), 2U);
        for (const RoundHole& hole : shape.holes) {
            QCOMPARE(hole.cell.width(), std::int64_t{2} * render::cellAround(hole.radius));
        }
    }

    /// Cells of a turned, mirrored area lie where the area has them.
    void letsFollowTheirArea_data() {
        QTest::addColumn<double>("angle");
        QTest::addColumn<bool>("isMirrored");
        for (const double angle : {0.0, 30.0, 90.0, 150.0, 180.0, 270.0, 300.0}) {
            for (const bool isMirrored : {false, true}) {
                QTest::addRow("%g %d", angle, isMirrored ? 1 : 0) << angle << isMirrored;
            }
        }
    }
    void letsFollowTheirArea() {
        QFETCH(double, angle);
        QFETCH(bool, isMirrored);
        ShapeSketch sketch = plate();
        sketch.addCircle({5 * kMm, 2 * kMm}, kMm, true);
        sketch.addCircle({9 * kMm, 7 * kMm}, 2 * kMm, true);
        DocumentBuilder builder;
        const model::ShapeId shape = builder.addShape(sketch);
        builder.beginLayer(builder.addLayer({}));
        const model::Placement placement{{3 * kMm, 4 * kMm}, angle, isMirrored};
        builder.addArea({shape, placement}, {});
        const auto document = builder.finish();
        const PunchedShape punched = render::punch(document->shapes, shape, {});
        const render::BoardModel model = build(*document);
        QCOMPARE(holeLets(model), 2U);
        for (const shader::Let& let : model.lets) {
            const RoundHole& hole = punched.holes[let.p5 > 1.5F ? 1 : 0];
            const glm::vec2 centre = render::toGpu(placement.apply(base::toDouble(hole.centre)), model.origin);
            QVERIFY(glm::length(glm::vec2(let.p0, let.p1) - centre) < 1e-5F);
            render::Box2 expected{glm::vec2(1e9F), glm::vec2(-1e9F)};
            for (const double x : {hole.cell.min.x, hole.cell.max.x}) {
                for (const double y : {hole.cell.min.y, hole.cell.max.y}) {
                    const glm::vec2 corner = render::toGpu(placement.apply(model::PointD{x, y}), model.origin);
                    expected = {glm::min(expected.min, corner), glm::max(expected.max, corner)};
                }
            }
            // Lets reach over their cell by 1 to 2 µm, at a slant by up to the diagonal of that.
            const render::Box2 box = render::boxOf(let);
            for (int axis = 0; axis < 2; ++axis) {
                QVERIFY(box.min[axis] < expected.min[axis] && box.min[axis] > expected.min[axis] - 0.0031F);
                QVERIFY(box.max[axis] > expected.max[axis] && box.max[axis] < expected.max[axis] + 0.0031F);
            }
        }
    }
};

QTEST_APPLESS_MAIN(RoundHolesTest)
#include "round_holes_test.moc"
