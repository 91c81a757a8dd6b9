#include "ui/element/net_facts.h"

#include <QtTest>

#include "model/board/document_builder.h"

using model::DocumentBuilder;

class NetFactsTest : public QObject {
    Q_OBJECT

private slots:
    void pinsLayersAndElementsAreListed() {
        DocumentBuilder builder;
        const model::NetId net = builder.addNet("GND");
        DocumentBuilder::Origin origin;
        origin.net = net;
        model::Layer layer;
        layer.name = "top";
        builder.beginLayer(builder.addLayer(layer));
        builder.addCircle({{}, 1'000'000, 0}, origin);
        builder.addCircle({{}, 1'000'000, 0}, origin);
        model::Pin pin;
        pin.name = builder.string("U5-3");  // as Altium writes it
        pin.net = net;
        model::Component component;
        component.refdes = "U5";
        builder.addComponent(component, std::span(&pin, 1));
        const auto document = builder.finish();
        const ui::Facts facts = ui::netFacts(model::unfoldCopies(*document), {0, net});
        const ui::Facts expected{{"Elements", "2"}, {"Pins", "1"}, {"", "U5.3"}, {"On top", "2"}};
        QCOMPARE(facts, expected);
    }

    void aNetWithoutCopperIsNoError() {
        DocumentBuilder builder;
        const model::NetId net = builder.addNet("NC");
        const auto document = builder.finish();
        const ui::Facts expected{{"Elements", "0"}, {"Pins", "0"}};
        QCOMPARE(ui::netFacts(model::unfoldCopies(*document), {0, net}), expected);
    }
};

QTEST_APPLESS_MAIN(NetFactsTest)
#include "net_facts_test.moc"
