// Areas and lengths against their polygons: discretised finely, the two agree to a part in 10,000.
#include "model/statistics/element_sizes.h"

#include <QtTest>
#include <numbers>

#include "model/board/document_builder.h"
#include "model/figures/element_polygons.h"
#include "model/geometry/boolean.h"
#include "model/geometry/discretise.h"

using namespace model;

namespace {

constexpr Nm kMm = 1'000'000;

double polygonArea(const Document& document, ElementId element) {
    return static_cast<double>(twiceArea(discretise(document, element, {500.0}))) / 2.0;
}

}  // namespace

class MeasuresTest : public QObject {
    Q_OBJECT

private slots:
    void knownSizes() {
        DocumentBuilder builder;
        builder.beginLayer(builder.addLayer({}));
        const ElementId line = builder.addLine({{0, 0}, {3 * kMm, 4 * kMm}, kMm, 0}, {});
        const ElementId ring = builder.addCircle({{0, 0}, 4 * kMm, 2 * kMm}, {});
        DocumentBuilder::Origin hole;
        hole.flags = kHole;
        const ElementId drill = builder.addCircle({{0, 0}, 2 * kMm, 2 * kMm}, hole);
        const Document& d = builder.soFar();
        const double pi = std::numbers::pi;
        QCOMPARE(lengthOf(d, line), 5e6);
        QCOMPARE(areaOf(d, line), 5e12 + pi / 4.0 * 1e12);
        QCOMPARE(lengthOf(d, ring), 0.0);
        QCOMPARE(areaOf(d, ring), pi * (4e12 - 1e12));
        QCOMPARE(areaOf(d, drill), pi * 1e12);
    }

    void copperIsSummedPerLayerWithItsCopies() {
        const auto twoSides = [](DocumentBuilder& builder) {
            for (const std::size_t opposite : {1U, 0U, 2U}) {
                Layer layer;
                layer.type = opposite < 2 ? LayerType::Signal : LayerType::SilkScreen;
                layer.opposite = LayerId{opposite};
                builder.addLayer(layer);
            }
        };
        const double disc = std::numbers::pi / 4.0 * 1e12;
        DocumentBuilder stepBuilder;
        twoSides(stepBuilder);
        stepBuilder.beginLayer(LayerId{0});
        stepBuilder.addCircle({{0, 0}, 2 * kMm, 0}, {});
        stepBuilder.beginLayer(LayerId{2});
        stepBuilder.addCircle({{0, 0}, 5 * kMm, 0}, {});
        DocumentBuilder builder;
        twoSides(builder);
        builder.beginLayer(LayerId{0});
        builder.addCircle({{0, 0}, kMm, 0}, {});
        const std::uint32_t step = builder.addStep(stepBuilder.finish());
        for (const bool isFlipped : {false, false, true}) {
            builder.addInstance({step, {}, isFlipped});
        }
        const std::vector<double> areas = copperAreas(*builder.finish());
        QCOMPARE(areas.size(), std::size_t{3});
        QCOMPARE(areas[0], disc * 9.0);  // its own and two copies of 4
        QCOMPARE(areas[1], disc * 4.0);  // the one turned over
        QCOMPARE(areas[2], 0.0);         // print is no copper
    }

    void areasAgreeWithPolygons() {
        DocumentBuilder builder;
        builder.beginLayer(builder.addLayer({}));
        DocumentBuilder::Origin square;
        square.flags = kSquarePen;
        const PathNode quarter{{2 * kMm, 0}, {0, 0}, EdgeKind::ArcCounterClockwise};
        ShapeSketch sketch;
        sketch.addCircle({0, 0}, 3 * kMm, false);
        sketch.addPolygon(std::array<Point, 3>{{{0, 0}, {kMm, 0}, {0, kMm}}}, true);
        const ElementId elements[] = {
            builder.addLine({{0, 0}, {3 * kMm, 4 * kMm}, kMm, 0}, {}),
            builder.addLine({{0, 0}, {3 * kMm, 4 * kMm}, kMm, 0}, square),
            builder.addArc({quarter, {0, 2 * kMm}, kMm}, {}),
            builder.addArc({quarter, {2 * kMm, 0}, kMm}, {}),
            builder.addCircle({{0, 0}, 4 * kMm, 2 * kMm}, {}),
            builder.addArea({builder.addShape(sketch), {{5, 5}, 30.0, true}}, {}),
        };
        for (const ElementId element : elements) {
            const double exact = areaOf(builder.soFar(), element);
            const double polygon = polygonArea(builder.soFar(), element);
            QVERIFY2(std::abs(exact - polygon) < exact * 2e-3,
                     qPrintable(QStringLiteral("%1: %2, %3").arg(element.value).arg(exact).arg(polygon)));
        }
    }

    void trailsAreTheSumOfTheirStrokesWithoutTheJoints() {
        DocumentBuilder builder;
        builder.beginLayer(builder.addLayer({}));
        const std::vector<PathNode> straight = {
            {{0, 0}, {}, EdgeKind::Line}, {{4 * kMm, 0}, {}, EdgeKind::Line}, {{9 * kMm, 0}, {}, EdgeKind::Line}};
        const ElementId trail = builder.addTrail(straight, kMm, {});
        const ElementId line = builder.addLine({{0, 0}, {9 * kMm, 0}, kMm, 0}, {});
        QCOMPARE(areaOf(builder.soFar(), trail), areaOf(builder.soFar(), line));
        QCOMPARE(lengthOf(builder.soFar(), trail), 9e6);
    }
};

QTEST_APPLESS_MAIN(MeasuresTest)
#include "element_sizes_test.moc"
