#include "ui/element/element_facts.h"

#include <QtTest>

#include "model/board/document_builder.h"

using namespace ui;
using model::BoardElement;
using model::ElementId;

namespace {

std::shared_ptr<const model::BoardIndex> indexed(std::shared_ptr<const model::Document> document) {
    base::Progress progress;
    return *model::indexBoard(std::move(document), progress);
}

}  // namespace

class ElementFactsTest : public QObject {
    Q_OBJECT

private slots:
    void lengthsAreShortAndExact() {
        QCOMPARE(lengthText(250'000, LengthUnit::Millimetre), "0.25 mm");
        QCOMPARE(lengthText(254'000, LengthUnit::Mil), "10 mil");
        QCOMPARE(lengthText(25'400'000, LengthUnit::Inch), "1 in");
        QCOMPARE(lengthText(0, LengthUnit::Millimetre), "0 mm");
        QCOMPARE(lengthText(-100'000'000, LengthUnit::Millimetre), "-100 mm");
        QCOMPARE(lengthInBoth(254'000, LengthUnit::Millimetre), "0.254 mm (10 mil)");
        QCOMPARE(lengthInBoth(254'000, LengthUnit::Inch), "0.01 in (0.254 mm)");
        QCOMPARE(positionText(1'500'000, -250'000, LengthUnit::Millimetre), "1.5000, -0.2500 mm");
        QCOMPARE(areaText(2e12, LengthUnit::Millimetre), "2 mm²");
        QCOMPARE(areaText(25.4e6 * 25.4e6, LengthUnit::Mil), "1 in²");
    }

    void unitsGoRound() {
        LengthUnit unit = LengthUnit::Millimetre;
        for (const char* name : {"mil", "in", "mm"}) {
            unit = nextUnit(unit);
            QCOMPARE(unitName(unit), name);
        }
    }

    void everyKindTellsItsSizesLayerNetAndSource() {
        model::DocumentBuilder builder;
        model::Layer layer;
        layer.name = "top";
        layer.file = "steps/pcb/layers/top/features";
        builder.beginLayer(builder.addLayer(layer));
        model::DocumentBuilder::Origin origin;
        origin.net = builder.addNet("GND");
        origin.symbol = builder.symbol("r250");
        origin.line = 42;
        builder.addLine({{0, 0}, {3'000'000, 4'000'000}, 250'000, 0}, origin);
        origin.flags = model::kPad;
        builder.addCircle({{1'000'000, 0}, 2'000'000, 0}, origin);
        origin.flags = model::kHole | model::kPlated;
        builder.addCircle({{1'000'000, 0}, 500'000, 450'000}, origin);
        model::Pin pin;
        pin.name = builder.string("7");
        pin.position = {1'000'000, 0};
        pin.net = origin.net;
        model::Component component;
        component.refdes = "U1";
        builder.addComponent(component, std::span(&pin, 1));
        const auto document = builder.finish();
        const auto index = indexed(document);
        const auto fact = [&](std::size_t row, const char* name) {
            for (const auto& [key, value] : factsOf(*index, {0, ElementId{row}}, LengthUnit::Millimetre)) {
                if (key == QLatin1String(name)) {
                    return value;
                }
            }
            return QString();
        };
        QCOMPARE(fact(0, "Kind"), "Line");
        QCOMPARE(fact(0, "Layer"), "top");
        QCOMPARE(fact(0, "Net"), "GND");
        QCOMPARE(fact(0, "Symbol"), "r250");
        QCOMPARE(fact(0, "Width"), "0.25 mm (9.84 mil)");
        QCOMPARE(fact(0, "Length"), "5 mm (196.85 mil)");
        QCOMPARE(fact(0, "Read from"), "steps/pcb/layers/top/features:42");
        QCOMPARE(fact(0, "Pin"), "");
        QCOMPARE(fact(1, "Kind"), "Pad (circle)");
        QCOMPARE(fact(1, "Area"), "3.1416 mm²");
        QCOMPARE(fact(1, "Pin"), "U1.7");
        QVERIFY(fact(1, "Component").startsWith("U1"));
        QCOMPARE(fact(2, "Kind"), "Plated hole (circle)");
        QCOMPARE(summaryOf(*index, {0, ElementId{std::size_t{0}}}, LengthUnit::Millimetre),
                 "Line, 0.25 mm wide · top · GND");
        QCOMPARE(summaryOf(*index, {0, ElementId{std::size_t{1}}}, LengthUnit::Millimetre),
                 "Pad (circle), 2 mm across · top · GND · U1.7");
    }

    void whatIsInsideAHoleSaysWhetherItIsAssumed() {
        for (const model::Nm drilled : {500'000, 450'000}) {
            model::DocumentBuilder builder;
            model::Layer layer;
            layer.type = model::LayerType::Drill;
            model::DrillTool tool;
            tool.layer = builder.addLayer(layer);
            tool.drillSize = 500'000;
            tool.finishedSize = drilled;  // as drilled: how thick the plating is nobody says
            builder.addTool(tool);
            builder.beginLayer(tool.layer);
            model::DocumentBuilder::Origin origin;
            origin.flags = model::kHole | model::kPlated;
            builder.addCircle({{0, 0}, 500'000, 450'000}, origin);
            const auto document = builder.finish();
            const auto facts = factsOf(*indexed(document), {0, ElementId{std::size_t{0}}}, LengthUnit::Millimetre);
            const auto fact = [&](const char* name) {
                const auto found = std::ranges::find(facts, QLatin1String(name), &Facts::value_type::first);
                return found != facts.end() ? found->second : QString();
            };
            QCOMPARE(fact("Inner diameter"), drilled == 500'000
                                                 ? "0.45 mm (17.72 mil) (assumed, usual plating of 0.025 mm)"
                                                 : "0.45 mm (17.72 mil)");
            QCOMPARE(fact("Finished size"), drilled == 500'000 ? "0.5 mm (19.69 mil)" : "0.45 mm (17.72 mil)");
        }
    }

    void elementsOfFlippedCopiesAreToldWhereTheyLie() {
        const auto addLayers = [](model::DocumentBuilder& builder) {
            for (const std::size_t opposite : {1, 0}) {
                model::Layer layer;
                layer.name = opposite == 1 ? "top" : "bottom";
                layer.type = model::LayerType::Signal;
                layer.opposite = model::LayerId{opposite};
                layer.file = "features of " + layer.name;
                builder.addLayer(layer);
            }
        };
        model::DocumentBuilder card;
        addLayers(card);
        card.beginLayer(model::LayerId{std::size_t{0}});
        model::DocumentBuilder::Origin origin;
        origin.line = 7;
        card.addCircle({{10'000'000, 1'000'000}, 2'000'000, 0}, origin);
        model::DocumentBuilder builder;
        addLayers(builder);
        const std::uint32_t step = builder.addStep(card.finish());
        builder.addInstance({step, {{100'000'000, 0}, 0.0, false}, false});
        builder.addInstance({step, {{200'000'000, 0}, 0.0, true}, true});
        const auto panel = builder.finish();
        const auto index = indexed(panel);
        const auto fact = [&](std::uint32_t copy, const char* name) {
            const Facts facts = factsOf(*index, {copy, ElementId{std::size_t{0}}}, LengthUnit::Millimetre);
            const auto found = std::ranges::find(facts, QLatin1String(name), &Facts::value_type::first);
            return found != facts.end() ? found->second : QString();
        };
        QCOMPARE(fact(1, "Layer"), "top");
        QCOMPARE(fact(1, "Centre"), "110.0000, 1.0000 mm");
        QCOMPARE(fact(2, "Layer"), "bottom");
        QCOMPARE(fact(2, "Centre"), "190.0000, 1.0000 mm");
        QCOMPARE(fact(2, "Read from"), "features of top:7");  // its record is where the step has it
        QCOMPARE(summaryOf(*index, {2, ElementId{std::size_t{0}}}, LengthUnit::Millimetre),
                 "Circle, 2 mm across · bottom");
    }

    /// StickHub: a pad for mounting a connector, above a capacitor that is on the bottom and of its net.
    void padsAreNotThoseOfComponentsOnTheFarSide() {
        model::DocumentBuilder builder;
        const model::NetId gnd = builder.addNet("GND");
        const std::vector<model::PackagePin> packagePins(1);
        const model::PackageId package = builder.addPackage({}, packagePins);
        for (const auto& [refdes, side] : {std::pair{"J3", model::LayerSide::Top}, {"C1", model::LayerSide::Bottom}}) {
            model::Component part;
            part.refdes = refdes;
            part.side = side;
            part.mount = model::MountType::Surface;
            part.package = package;
            model::Pin pin;
            pin.name = builder.string("1");
            pin.net = gnd;
            pin.packagePin = 0;
            builder.addComponent(part, std::span(&pin, 1));
            model::Layer layer;
            layer.side = side;
            layer.type = model::LayerType::Signal;
            builder.beginLayer(builder.addLayer(layer));
            model::DocumentBuilder::Origin origin;
            origin.net = gnd;
            origin.flags = model::kPad;
            builder.addCircle({{0, 0}, 1'000'000, 0}, origin);
        }
        const auto index = indexed(builder.finish());
        for (const std::size_t row : {0, 1}) {
            const BoardElement pad{0, ElementId{row}};
            QVERIFY(summaryOf(*index, pad, LengthUnit::Millimetre).endsWith(row == 0 ? "GND · J3.1" : "GND · C1.1"));
            const Facts facts = factsOf(*index, pad, LengthUnit::Millimetre);
            QCOMPARE(std::ranges::count(facts, QString("Component"), &Facts::value_type::first), 1);
        }
    }

    void heightsOfBodiesSayWhetherTheyAreAssumed() {
        model::DocumentBuilder builder;
        model::Layer layer;
        layer.type = model::LayerType::ComponentBody;
        builder.beginLayer(builder.addLayer(layer));
        model::ShapeSketch square;
        square.addCircle({0, 0}, 1'000'000, false);
        const model::ShapeId shape = builder.addShape(square);
        for (const model::Source source : {model::Source::Job, model::Source::Assumed}) {
            const model::ComponentId component = builder.addComponent({}, {});
            builder.addBody({builder.addArea({shape, {}}, {}), component, 1'200'000, source});
        }
        const auto document = builder.finish();
        const auto index = indexed(document);
        const auto height = [&](std::size_t row) {
            QString text;
            for (const auto& [key, value] : factsOf(*index, {0, ElementId{row}}, LengthUnit::Millimetre)) {
                text = key == QLatin1String("Height") ? value : text;
            }
            return text;
        };
        QVERIFY(height(0).startsWith("1.2 mm") && !height(0).contains("assumed"));
        QVERIFY(height(1).startsWith("1.2 mm") && height(1).contains("assumed"));
        QVERIFY(summaryOf(*index, {0, ElementId{std::size_t{0}}}, LengthUnit::Millimetre).startsWith("Body · "));
    }
};

QTEST_APPLESS_MAIN(ElementFactsTest)
#include "element_facts_test.moc"
