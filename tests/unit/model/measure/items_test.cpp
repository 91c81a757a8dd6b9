// What a name stands for in measurements: a pin of several pads, several components of one designator. Their heights.
#include "model/measure/items.h"

#include <QtTest>
#include <algorithm>

#include "model/measure/separation.h"
#include "tests/unit/model/measure/measure_fixture.h"

using namespace model;
using namespace measuring;

namespace {

Separation measured(const BoardIndex& index, const MeasureItem& a, const MeasureItem& b) {
    base::Progress progress;
    return *separationOf(index, a, b, progress);
}

bool says(const Separation& separation, const char* text) {
    return std::ranges::any_of(separation.notes,
                               [&](const std::string& note) { return note.find(text) != std::string::npos; });
}

BoardElement own(ElementId element) {
    return {0, element};
}

}  // namespace

class ItemsTest : public QObject {
    Q_OBJECT

private slots:
    void aNameStandsForAllThatHasIt() {
        DocumentBuilder builder;
        addLayers(builder);
        const auto pin = [&](const char* name, Nm x) { return Pin{builder.string(name), {x, 0}, {}, {}, 0xffffffffu}; };
        const auto add = [&](const char* refdes, const std::vector<Pin>& pins) {
            Component part;
            part.refdes = refdes;
            part.placement.origin = pins.front().position;
            return builder.addComponent(part, pins);
        };
        static_cast<void>(add("J7", {pin("MP", 0), pin("MP", 10 * kMm), pin("1", 20 * kMm)}));
        const ComponentId first = add("R1", {pin("1", 30 * kMm)});
        static_cast<void>(add("R1", {pin("1", 50 * kMm)}));
        builder.beginLayer(LayerId{Top});
        for (const Nm x : {0, 10, 20, 30, 50}) {
            builder.addCircle({{x * kMm, 0}, kMm, 0}, of({}, kPad));
        }
        const ElementId far = builder.addCircle({{14 * kMm, 0}, kMm, 0}, {});
        const ElementId beyond = builder.addCircle({{54 * kMm, 0}, kMm, 0}, {});
        const auto index = indexed(builder.finish());
        const PinOfCopy mp{0, PinId{std::size_t{0}}};

        const Separation toPin = measured(*index, mp, own(far));
        QCOMPARE(toPin.main()->distance, 3.0 * kMm);
        QCOMPARE(toPin.main()->spacing.from.x, 10.5 * kMm);
        QVERIFY2(says(toPin, "pin J7.MP has 2 pads (0, 0 mm; 10, 0 mm): the nearest is taken"),
                 toPin.notes.back().c_str());
        const Separation within = measured(*index, own(ElementId{std::size_t{1}}), mp);
        QVERIFY(within.main() == nullptr && says(within, "is part of pin J7.MP"));
        QVERIFY(!says(measured(*index, PinOfCopy{0, PinId{std::size_t{2}}}, own(far)), "the nearest is taken"));

        for (const MeasureItem& r1 :
             {MeasureItem(PartOfCopy{0, first}), MeasureItem(PinOfCopy{0, PinId{std::size_t{3}}})}) {
            const Separation toPart = measured(*index, own(beyond), r1);
            QCOMPARE(toPart.main()->distance, 3.0 * kMm);
            QVERIFY2(says(toPart, "2 components are called R1 (30, 0 mm; 50, 0 mm): the nearest is taken"),
                     toPart.notes.back().c_str());
        }
    }

    /// Bodies of 2 mm on top; below they are 1 mm at most.
    void bodiesOfFlippedCopiesHaveTheirOwnHeight() {
        const auto addAll = [](DocumentBuilder& builder) {
            addLayers(builder);
            Layer layer;
            layer.type = LayerType::ComponentBody;
            layer.side = LayerSide::Top;
            layer.z = 2'300'000;
            layer.thickness = 3 * kMm;
            layer.opposite = LayerId{std::size_t{6}};
            builder.addLayer(layer);
            layer.side = LayerSide::Bottom;
            layer.z = -kMm;
            layer.thickness = kMm;
            layer.opposite = LayerId{std::size_t{5}};
            builder.addLayer(layer);
        };
        DocumentBuilder step;
        addAll(step);
        step.beginLayer(LayerId{std::size_t{5}});
        const ElementId body = step.addCircle({{0, 0}, kMm, 0}, {});
        step.addBody({body, {}, 2 * kMm});
        DocumentBuilder panel;
        addAll(panel);
        panel.addInstance({panel.addStep(step.finish()), {{0, 0}, 0.0, true}, true});
        const auto index = indexed(panel.finish());
        const Piece piece = piecesOf(*index, std::array{BoardElement{1, body}}).pieces.front();
        QCOMPARE(piece.layer, LayerId{std::size_t{6}});
        QCOMPARE(piece.z.bottom, -2 * kMm);
        QCOMPARE(piece.z.top, 0);
    }

    /// A board of one copper layer: that of a flipped copy is on the other side.
    void copperOfFlippedCopiesIsOnALayerOfItsOwn() {
        const auto add = [](DocumentBuilder& builder) {
            Layer layer;
            layer.type = LayerType::Signal;
            layer.side = LayerSide::Top;
            layer.z = kMm;
            layer.thickness = kMm / 10;
            builder.setBoardThickness(kMm);
            return builder.addLayer(layer);
        };
        DocumentBuilder step;
        const LayerId copper = add(step);
        step.beginLayer(copper);
        const ElementId pad = step.addCircle({{0, 0}, kMm, 0}, {});
        Layer drill;
        drill.type = LayerType::Drill;
        drill.spanTop = drill.spanBottom = copper;
        step.beginLayer(step.addLayer(drill));
        const ElementId hole = step.addCircle({{0, 0}, kMm / 2, kMm / 2}, flagged(kHole));
        DocumentBuilder panel;
        add(panel);
        panel.addLayer(drill);
        const std::uint32_t row = panel.addStep(step.finish());
        panel.addInstance({row, {{0, 0}}, false});
        panel.addInstance({row, {{5 * kMm, 0}}, false});
        panel.addInstance({row, {{10 * kMm, 0}, 0.0, true}, true});
        const auto index = indexed(panel.finish());
        const auto pieceOf = [&](const MeasureItem& item) { return piecesOf(*index, item).pieces.front(); };
        const Piece upright = pieceOf(BoardElement{1, pad});
        const Piece flipped = pieceOf(BoardElement{3, pad});
        QCOMPARE(flipped.layer, upright.layer);
        QCOMPARE(flipped.z.bottom, Nm{0});
        QVERIFY(!flipped.sharesLayerWith(upright));
        QVERIFY(upright.sharesLayerWith(pieceOf(BoardElement{2, pad})));
        for (const MeasureItem& item : {MeasureItem(BoardElement{1, hole}), MeasureItem(Location{{0, 0}, copper})}) {
            QVERIFY(pieceOf(item).sharesLayerWith(flipped));  // holes pass both sides
            QVERIFY(pieceOf(item).sharesLayerWith(upright));
        }
    }
};

QTEST_APPLESS_MAIN(ItemsTest)
#include "items_test.moc"
