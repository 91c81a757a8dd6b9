// What a cursor snaps to: every kind, the order of kinds, ties, hidden layers, copies.
#include "model/measure/snapping.h"

#include <QtTest>
#include <cmath>

#include "tests/unit/model/measure/measure_fixture.h"

using namespace model;
using namespace measuring;

namespace {

/// All layers visible, where the stack has them.
std::vector<PickLayer> layersOf(const Document& board) {
    std::vector<PickLayer> layers;
    for (const Layer& layer : board.layers) {
        layers.push_back({true, double(layer.z), double(layer.z) + layer.thickness});
    }
    return layers;
}

SnapPoint snap(DocumentBuilder& builder, PointD location, double reach) {
    const auto index = indexed(builder.finish());
    return Snapper(index).at(location, reach, layersOf(*index->board));
}

bool isAt(const SnapPoint& point, double x, double y) {
    return std::hypot(point.at.x - x, point.at.y - y) < 1e-3;
}

}  // namespace

class SnappingTest : public QObject {
    Q_OBJECT

private slots:
    void theBoardsEdgeIsSnappedToWhateverDrawsIt() {
        DocumentBuilder builder;
        addLayers(builder);
        ShapeSketch outline;
        outline.addPolygon(std::array{Point{0, 0}, Point{10 * kMm, 0}, Point{10 * kMm, 8 * kMm}, Point{0, 8 * kMm}},
                           false);
        builder.setProfile(builder.addShape(outline));
        builder.beginLayer(LayerId{Top});
        builder.addLine({{3 * kMm, -kMm}, {3 * kMm, kMm}, 200'000, 0}, of({}));  // copper across the edge
        builder.beginLayer(LayerId{Drawing});
        builder.addLine({{0, 0}, {10 * kMm, 0}, 200'000, 0}, of({}));  // the pen that draws the edge
        const auto index = indexed(builder.finish());
        Snapper snapper(index);
        const std::vector<PickLayer> layers = layersOf(*index->board);
        const SnapPoint side = snapper.at({7e6, -90'000}, 150'000, layers);
        QVERIFY(side.kind == SnapKind::Edge && isAt(side, 7e6, 0) && !side.element.element.isValid());
        const SnapPoint corner = snapper.at({10e6, 8e6 + 50'000}, 150'000, layers);
        QVERIFY(corner.kind == SnapKind::End && isAt(corner, 10e6, 8e6) && !corner.layer.isValid());
        QCOMPARE(snapper.at({3e6 + 110'000, 500'000}, 50'000, layers).layer, LayerId{Top});  // the copper's own side
        QCOMPARE(snapper.at({5e6 + 100'000, 4e6}, 50'000, layers).kind, SnapKind::Free);
        QVERIFY(nearestOnEdge(boardEdgeOf(*index->board), {7e6, 1e6}, 2e6) == PointD(7e6, 0));
        QVERIFY(!nearestOnEdge(boardEdgeOf(*index->board), {7e6, 3e6}, 2e6));
    }

    void whatCoversNothingIsFoundNearIt() {
        DocumentBuilder builder;
        addLayers(builder);
        builder.beginLayer(LayerId{Top});
        builder.addLine({{0, 0}, {10 * kMm, 0}, 200'000, 0}, of({}));
        const ElementId hairline = builder.addLine({{0, kMm}, {10 * kMm, kMm}, 0, 0}, of({}));
        const auto index = indexed(builder.finish());
        Snapper snapper(index);
        std::vector<PickLayer> layers = layersOf(*index->board);
        QVERIFY((snapper.emptyAt({5e6, 950'000}, 100'000, layers) == BoardElement{0, hairline}));
        QVERIFY(!snapper.emptyAt({5e6, 0}, 100'000, layers));
        QVERIFY(!snapper.emptyAt({4e12, -4e12}, 100'000, layers));  // farther than coordinates reach
        layers[Top].isVisible = false;
        QVERIFY(!snapper.emptyAt({5e6, 950'000}, 100'000, layers));
    }

    void everyKindIsFound_data() {
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::addColumn<int>("kind");
        QTest::addColumn<double>("atX");
        QTest::addColumn<double>("atY");
        const auto row = [](const char* name, double x, double y, SnapKind kind, double atX, double atY) {
            QTest::addRow("%s", name) << x * 1e6 << y * 1e6 << int(kind) << atX * 1e6 << atY * 1e6;
        };
        row("disc", 0.1, 0.1, SnapKind::Centre, 0, 0);
        row("end", 10.1, 0.1, SnapKind::End, 10, 0);
        row("middle", 15.1, 0.1, SnapKind::Middle, 15, 0);
        row("crossing", 13.1, 0.05, SnapKind::Crossing, 13, 0);
        row("rim", 17.03, 0.12, SnapKind::Edge, 17.03, 0.1);
        row("arc's end", 31.05, 0.05, SnapKind::End, 31, 0);
        row("arc's centre", 30.05, 0.02, SnapKind::ArcCentre, 30, 0);
        row("pad", 40.05, 0.1, SnapKind::Centre, 40, 0);
        row("side of an area", 52.6, 0.05, SnapKind::Edge, 52.6, 0);
        row("nothing", 70, 70, SnapKind::Free, 70, 70);
    }
    void everyKindIsFound() {
        QFETCH(double, x);
        QFETCH(double, y);
        QFETCH(int, kind);
        QFETCH(double, atX);
        QFETCH(double, atY);
        DocumentBuilder builder;
        addLayers(builder);
        builder.beginLayer(LayerId{Top});
        builder.addCircle({{0, 0}, kMm, 0}, {});
        builder.addLine({{10 * kMm, 0}, {20 * kMm, 0}, 200'000, 0}, {});
        builder.addLine({{13 * kMm, -4 * kMm}, {13 * kMm, 3 * kMm}, 200'000, 0}, {});
        builder.addArc({PathNode{{31 * kMm, 0}, {30 * kMm, 0}, EdgeKind::ArcCounterClockwise}, {29 * kMm, 0}, 200'000},
                       {});
        builder.addArea({builder.addShape(rectangle({-kMm, -kMm}, {kMm, kMm})), {{40 * kMm, 0}, 0, false}},
                        of({}, kPad));
        builder.addArea({builder.addShape(rectangle({50 * kMm, 0}, {60 * kMm, 5 * kMm})), {}}, {});
        const SnapPoint point = snap(builder, {x, y}, 300'000);
        QCOMPARE(toString(point.kind), toString(static_cast<SnapKind>(kind)));
        QVERIFY2(isAt(point, atX, atY), qPrintable(QString("%1, %2").arg(point.at.x).arg(point.at.y)));
    }

    void theKindDecidesBeforeTheDistance() {
        DocumentBuilder builder;
        addLayers(builder);
        builder.beginLayer(LayerId{Top});
        builder.addLine({{0, 0}, {9 * kMm, 0}, 100'000, 0}, {});
        const ElementId via = builder.addCircle({{400'000, 0}, 300'000, 0}, {});
        const SnapPoint point = snap(builder, {20'000, 0}, 500'000);
        QCOMPARE(point.kind, SnapKind::Centre);
        QCOMPARE(point.element.element, via);
        QCOMPARE(point.missedBy, 380'000.0);
    }

    void nettedPointsWinTies() {
        DocumentBuilder builder;
        addLayers(builder);
        const NetId net = builder.addNet("A");
        builder.beginLayer(LayerId{Top});
        const ElementId netted = builder.addCircle({{0, 0}, kMm, 0}, of(net));
        builder.beginLayer(LayerId{Drawing});
        builder.addCircle({{0, 0}, kMm, 0}, {});
        QCOMPARE(snap(builder, {10, 10}, 500'000).element.element, netted);
    }

    void ofEqualsTheNearerLayerCounts() {
        DocumentBuilder builder;
        addLayers(builder);
        builder.beginLayer(LayerId{Top});
        const ElementId top = builder.addCircle({{0, 0}, kMm, 0}, {});
        builder.beginLayer(LayerId{Bottom});
        const ElementId bottom = builder.addCircle({{0, 0}, kMm, 0}, {});
        const auto index = indexed(builder.finish());
        std::vector<PickLayer> layers = layersOf(*index->board);
        Snapper snapper(index);
        QCOMPARE(snapper.at({0, 0}, 1000, layers).element.element, top);
        QCOMPARE(snapper.at({0, 0}, 1000, layers, true).element.element, bottom);
        layers[Top].isVisible = false;
        QCOMPARE(snapper.at({0, 0}, 1000, layers).element.element, bottom);
        layers[Bottom].isVisible = false;
        QCOMPARE(snapper.at({0, 0}, 1000, layers).kind, SnapKind::Free);
    }

    void whatAPlaneCoversIsReachedBySkippingOnly() {
        DocumentBuilder builder;
        addLayers(builder);
        builder.beginLayer(LayerId{Top});
        builder.addArea({builder.addShape(rectangle({-5 * kMm, -5 * kMm}, {5 * kMm, 5 * kMm})), {}}, {});
        builder.beginLayer(LayerId{Bottom});
        const ElementId below = builder.addLine({{0, 0}, {3 * kMm, 0}, 200'000, 0}, {});
        builder.addCircle({{200'000, 0}, 100'000, 0}, {});
        const auto index = indexed(builder.finish());
        std::vector<PickLayer> layers = layersOf(*index->board);
        Snapper snapper(index);
        QCOMPARE(toString(snapper.at({0, 0}, 500'000, layers).kind), toString(SnapKind::Free));
        QCOMPARE(snapper.at({0, 0}, 500'000, layers, false, 1).element.element.value, below.value + 1);
        // Looked at from below, and through translucent copper, it is seen.
        QCOMPARE(toString(snapper.at({0, 0}, 500'000, layers, true).kind), toString(SnapKind::Centre));
        layers[Top].isSeenThrough = true;
        QCOMPARE(toString(snapper.at({0, 0}, 500'000, layers).kind), toString(SnapKind::Centre));
        // Beside the plane there is nothing over it.
        QCOMPARE(toString(snapper.at({kMm, 4'990'000}, 50'000, layers).kind), toString(SnapKind::Edge));
    }

    void skippingGoesFromTheBestToTheLastAndRoundAgain() {
        DocumentBuilder builder;
        addLayers(builder);
        builder.beginLayer(LayerId{Top});
        builder.addLine({{0, 0}, {3 * kMm, 0}, 200'000, 0}, {});
        const auto index = indexed(builder.finish());
        const std::vector<PickLayer> layers = layersOf(*index->board);
        Snapper snapper(index);
        const auto kind = [&](std::size_t skip) {
            return snapper.at({10'000, 90'000}, 150'000, layers, false, skip).kind;
        };
        QCOMPARE(toString(kind(0)), toString(SnapKind::End));
        QCOMPARE(toString(kind(1)), toString(SnapKind::Edge));
        QCOMPARE(toString(kind(2)), toString(SnapKind::End));
    }

    void theEdgeOfATrackWithinAPadIsNone() {
        DocumentBuilder builder;
        addLayers(builder);
        builder.beginLayer(LayerId{Top});
        const ElementId pad =
            builder.addArea({builder.addShape(rectangle({-kMm, -kMm}, {kMm, kMm})), {}}, of({}, kPad));
        builder.addLine({{0, 0}, {9 * kMm, 0}, 200'000, 0}, {});
        const auto index = indexed(builder.finish());
        const std::vector<PickLayer> layers = layersOf(*index->board);
        Snapper snapper(index);
        QCOMPARE(toString(snapper.at({500'000, 110'000}, 50'000, layers).kind), toString(SnapKind::Free));
        // Nor is the side of the pad where the track leaves it.
        QCOMPARE(toString(snapper.at({980'000, 50'000}, 40'000, layers).kind), toString(SnapKind::Free));
        QVERIFY(isAt(snapper.at({980'000, 510'000}, 50'000, layers), 1e6, 510'000));
        QCOMPARE(snapper.at({980'000, 510'000}, 50'000, layers).element.element, pad);
        QCOMPARE(toString(snapper.at({2 * kMm, 110'000}, 50'000, layers).kind), toString(SnapKind::Edge));
    }

    void copiesSnapWhereTheyLie() {
        DocumentBuilder builder;
        addLayers(builder);
        builder.beginLayer(LayerId{Top});
        builder.addLine({{10 * kMm, 0}, {20 * kMm, 0}, 200'000, 0}, {});
        const auto step = builder.finish();
        DocumentBuilder panel;
        addLayers(panel);
        panel.addInstance({panel.addStep(step), {{100 * kMm, 0}, 90.0, true}, true});
        const SnapPoint point = snap(panel, {100e6 + 50, -10e6 + 30}, 1000);
        QCOMPARE(point.kind, SnapKind::End);
        QVERIFY(isAt(point, 100e6, -10e6));
        QCOMPARE(point.layer, LayerId{Bottom});
        QCOMPARE(point.element.copy, 1U);
    }

    void placesAreMovedOntoStraightLines_data() {
        QTest::addColumn<double>("stepDeg");
        QTest::addColumn<double>("x");
        QTest::addColumn<double>("y");
        QTest::newRow("across") << 90.0 << 10.0 << 0.0;
        QTest::newRow("aslant") << 45.0 << 10.0 << 0.0;
        QTest::newRow("nothing to move") << 90.0 << 10.0 << 0.0;
        QTest::newRow("anywhere") << 360.0 << 10.0 << 0.0;
    }
    void placesAreMovedOntoStraightLines() {
        QFETCH(double, stepDeg);
        QFETCH(double, x);
        QFETCH(double, y);
        const PointD at = straightened({1e6, 2e6}, {1e6 + 10.0, 2e6 + (stepDeg == 45.0 ? 3.0 : 1.0)}, stepDeg);
        QVERIFY2(std::hypot(at.x - 1e6 - x, at.y - 2e6 - y) < 1e-6, qPrintable(QString("%1").arg(at.y - 2e6)));
    }
};

QTEST_APPLESS_MAIN(SnappingTest)
#include "snapping_test.moc"
