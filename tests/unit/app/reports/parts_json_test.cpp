#include "app/reports/parts_json.h"

#include <QtTest>

#include "model/board/document_builder.h"
#include "model/geometry/outlines.h"

class PartsJsonTest : public QObject {
    Q_OBJECT

private slots:
    /// Of three components one stands on the board, one on an inner layer, and one has no body.
    void componentsNameTheInnerLayerThatTheyStandOn() {
        model::DocumentBuilder builder;
        model::Layer flex;
        flex.name = "FLEX";
        flex.type = model::LayerType::Signal;
        const model::LayerId inner = builder.addLayer(flex);
        model::ShapeSketch sketch;
        model::addBox(sketch, 1'000'000, 1'000'000, false);
        const model::ShapeId shape = builder.addShape(sketch);
        for (const model::LayerId on : {model::LayerId{}, inner}) {
            model::Layer bodies;
            bodies.type = model::LayerType::ComponentBody;
            bodies.isSynthetic = true;
            bodies.spanTop = on;
            builder.beginLayer(builder.addLayer(bodies));
            const model::ComponentId component = builder.addComponent({}, {});
            builder.addBody({builder.addArea({shape, {}}, {}), component, 1'000'000});
        }
        builder.addComponent({}, {});
        const auto board = builder.finish();
        const nlohmann::ordered_json list = app::componentsJson(*board)["list"];
        QCOMPARE(list.size(), std::size_t{3});
        QVERIFY(list[0]["mounting_layer"].is_null());
        QCOMPARE(list[1]["mounting_layer"].get<std::string>(), std::string("FLEX"));
        QVERIFY(list[2]["mounting_layer"].is_null() && list[2]["body"].is_null());
    }

    void componentsSayWhetherTheBillOfMaterialsListsThem() {
        model::DocumentBuilder builder;
        builder.addComponent({}, {});
        model::Component logo;
        logo.properties = builder.addProperties(
            std::vector<model::Property>{{builder.string("exclude_from_bom"), builder.string("yes")}});
        builder.addComponent(logo, {});
        const auto board = builder.finish();
        const nlohmann::ordered_json list = app::componentsJson(*board)["list"];
        QVERIFY(list[0]["in_bom"].get<bool>());
        QVERIFY(!list[1]["in_bom"].get<bool>());
    }
};

QTEST_APPLESS_MAIN(PartsJsonTest)
#include "parts_json_test.moc"
