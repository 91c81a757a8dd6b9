#include "model/body.h"

#include <QtTest>

#include "model/geometry/discretise.h"

using model::DocumentBuilder;
using model::ElementId;
using model::Layer;
using model::LayerType;

namespace {

/// Two copper layers 35 µm thick on either side of 1.53 mm, a 10 × 10 mm outline and one hole of 1 mm, plus one that
/// touches it.
std::shared_ptr<const model::Document> boardWithHoles() {
    DocumentBuilder builder;
    model::ShapeSketch outline;
    const model::Point corners[] = {{0, 0}, {10'000'000, 0}, {10'000'000, 10'000'000}, {0, 10'000'000}};
    outline.addPolygon(corners, false);
    builder.setProfile(builder.addShape(outline));
    Layer copper;
    copper.type = LayerType::Signal;
    copper.thickness = 35'000;
    copper.z = 1'565'000;
    builder.addLayer(copper);
    copper.z = 0;
    builder.addLayer(copper);
    Layer drill;
    drill.type = LayerType::Drill;
    drill.thickness = 1'600'000;
    builder.beginLayer(builder.addLayer(drill));
    DocumentBuilder::Origin hole;
    hole.flags = model::kHole;
    builder.addCircle({{5'000'000, 5'000'000}, 1'000'000, 1'000'000}, hole);
    builder.addLine({{2'000'000, 2'000'000}, {4'000'000, 2'000'000}, 1'000'000, 0}, hole);
    builder.addCircle({{10'000'000, 5'000'000}, 2'000'000, 2'000'000}, hole);  // a castellation
    drill.thickness = 800'000;
    builder.beginLayer(builder.addLayer(drill));
    builder.addCircle({{7'000'000, 8'000'000}, 500'000, 500'000}, hole);  // a blind hole leaves the slab whole
    model::addBody(builder);
    return builder.finish();
}

}  // namespace

class BodyTest : public QObject {
    Q_OBJECT

private slots:
    void bodyFillsTheSpaceBetweenTheOuterCopperLayers() {
        const auto document = boardWithHoles();
        const Layer& body = document->layers.back();
        QCOMPARE(body.type, LayerType::Body);
        QVERIFY(body.isSynthetic);
        QCOMPARE(body.z, 35'000);
        QCOMPARE(body.thickness, 1'530'000);
        QCOMPARE(body.elements.count, 1U);
    }

    void bodyIsTheOutlineMinusTheHoles() {
        const auto document = boardWithHoles();
        const ElementId body{document->layers.back().elements.first};
        const model::PolygonSet region = model::discretise(*document, body, {500.0, false});
        const double areaMm2 = static_cast<double>(model::twiceArea(region)) / 2e12;
        const double expected = 100.0 - M_PI * 0.25 - (2.0 + M_PI * 0.25) - M_PI / 2;
        QVERIFY(std::abs(areaMm2 - expected) < 0.05);
        QCOMPARE(region.polygons.size(), 1U);
        QCOMPARE(region.loopCount(), 3U);
    }

    void boardWithoutAnOutlineGetsNoBody() {
        DocumentBuilder builder;
        model::addBody(builder);
        QVERIFY(builder.finish()->layers.empty());
    }

    void bodyIsNotCountedAsAnElementOfTheJob() { QCOMPARE(boardWithHoles()->elementCounts()[4], 0U); }
};

QTEST_APPLESS_MAIN(BodyTest)
#include "body_test.moc"
