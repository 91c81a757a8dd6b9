#include "model/board/document_builder.h"

#include <QtTest>

using model::DocumentBuilder;
using model::ElementId;
using model::LayerId;

class DocumentBuilderTest : public QObject {
    Q_OBJECT

private slots:
    void elementsOfALayerAreConsecutive() {
        DocumentBuilder builder;
        model::Layer copper;
        copper.type = model::LayerType::Signal;
        const LayerId top = builder.addLayer(copper);
        const LayerId bottom = builder.addLayer(copper);
        builder.beginLayer(bottom);
        builder.addCircle({{0, 0}, 10, 0}, {});
        builder.addCircle({{5, 0}, 10, 0}, {});
        builder.beginLayer(top);
        builder.addLine({{0, 0}, {10, 0}, 4, 0}, {});
        const auto document = builder.finish();
        QCOMPARE(document->layer(bottom).elements.first, 0U);
        QCOMPARE(document->layer(bottom).elements.count, 2U);
        QCOMPARE(document->layer(top).elements.first, 2U);
        QCOMPARE(document->layer(top).counts[0], 1U);
        QCOMPARE(document->elementCounts()[2], 2U);
        QVERIFY((document->extent == model::Box{{-5, -5}, {12, 5}}));
    }

    void netsListTheirElementsInOrder() {
        DocumentBuilder builder;
        const model::NetId ground = builder.addNet("GND");
        const model::NetId power = builder.addNet("VCC");
        const model::NetId empty = builder.addNet("NC");
        builder.beginLayer(builder.addLayer({}));
        for (const model::NetId net : {power, ground, power, model::NetId{}, ground}) {
            DocumentBuilder::Origin origin;
            origin.net = net;
            builder.addCircle({{0, 0}, 10, 0}, origin);
        }
        const auto document = builder.finish();
        const auto rows = [&](model::NetId net) {
            std::vector<std::uint32_t> result;
            for (const ElementId element : document->elementsOf(net)) {
                result.push_back(element.value);
            }
            return result;
        };
        QCOMPARE(rows(ground), (std::vector<std::uint32_t>{1, 4}));
        QCOMPARE(rows(power), (std::vector<std::uint32_t>{0, 2}));
        QVERIFY(rows(empty).empty());
        QVERIFY(document->findNet("VCC") == power);
        QVERIFY(!document->findNet("vcc").isValid());
    }

    void layersAreFoundWhateverTheCase() {
        DocumentBuilder builder;
        model::Layer layer;
        layer.name = "TOP";
        builder.addLayer(layer);
        layer.name = "top";
        const LayerId small = builder.addLayer(layer);
        const auto document = builder.finish();
        QVERIFY(document->findLayer("Top").isValid());
        QVERIFY2(document->findLayer("top") == small, "what is written so to the letter goes before");
        QVERIFY(!document->findLayer("TO").isValid());
    }

    void trailsKeepAWidthPerEdge() {
        DocumentBuilder builder;
        builder.beginLayer(builder.addLayer({}));
        const model::PathNode nodes[] = {{{0, 0}, {}, {}}, {{100, 0}, {}, {}}, {{100, 100}, {}, {}}};
        const model::Nm widths[] = {10, 40};
        builder.addTrail(nodes, widths, {});
        const auto document = builder.finish();
        QCOMPARE(document->trails[0].width, 40);
        QCOMPARE(document->widthsOf(document->trails[0]).size(), 2U);
        // The wide edge reaches 20 to the left of x = 100 and beyond both its ends, the narrow one only 5 around (0,
        // 0).
        QVERIFY((document->boxOf(ElementId{0}) == model::Box{{-5, -20}, {120, 120}}));
    }

    void turnedAreasMeasureTheirTurnedBox() {
        DocumentBuilder builder;
        builder.beginLayer(builder.addLayer({}));
        model::ShapeSketch sketch;
        const model::Point corners[] = {{-10, -1}, {10, -1}, {10, 1}, {-10, 1}};
        sketch.addPolygon(corners, false);
        const model::ShapeId shape = builder.addShape(sketch);
        builder.addArea({shape, {{100, 100}, 90.0, false}}, {});
        const auto document = builder.finish();
        QVERIFY((document->boxOf(ElementId{0}) == model::Box{{99, 90}, {101, 110}}));
    }
};

QTEST_APPLESS_MAIN(DocumentBuilderTest)
#include "document_builder_test.moc"
