#include "model/formats/ipc2581/stack_holes.h"

#include <QtTest>

#include "tests/unit/model/formats/ipc2581/ipc_files.h"

using namespace ipc_files;
using model::Plating;
using model::Point;
using model::SubnetKind;
using model::formats::DrawnFeature;
using model::formats::DrawnJob;
using model::formats::kNoRow;

namespace {

std::string stack(const std::string& net, const std::string& place, const char* to = "B") {
    return "<PadStack net='" + net + "'><LayerHole name='h' diameter='0.3' platingStatus='VIA' " + place +
           "><Span fromLayer='T' toLayer='" + to + "'/></LayerHole><LayerPad layerRef='T'><Location " + place +
           "/><Circle diameter='0.6'/></LayerPad></PadStack>";
}

std::string hole(const std::string& place, const char* plating = "VIA") {
    return "<Set><Hole name='h' diameter='0.3' platingStatus='" + std::string(plating) + "' " + place + "/></Set>";
}

/// Layers of holes: G has no span; V passes T and I.
const char* const kLayers =
    "<Layer name='I' layerFunction='CONDUCTOR' side='INTERNAL'/>"
    "<Layer name='G' layerFunction='DRILL' side='INTERNAL'/>"
    "<Layer name='V' layerFunction='DRILL' side='INTERNAL'><Span fromLayer='I' toLayer='T'/></Layer>";

std::string drills(const char* layer, const std::string& sets) {
    return "<LayerFeature layerRef='" + std::string(layer) + "'>" + sets + "</LayerFeature>";
}

DrawnJob jobWith(const std::string& step) {
    return *parse(fileWith(step, {}, kLayers));
}

const char* const kHere = "x='5' y='7'";
const char* const kThere = "x='9' y='7'";

}  // namespace

class StackHolesTest : public QObject {
    Q_OBJECT

private slots:
    void holesThatALayerDrawsTooAreOne() {
        // As Altium writes a board: all of its holes on a drill guide, those of pads and vias in PadStacks, too.
        const DrawnJob job =
            jobWith(stack("A", kHere) + stack("No Net", kThere) +
                    drills("G", hole(kHere) + hole("x='9.000001' y='7'") + hole("x='2' y='2'", "NONPLATED")));
        const auto& holes = featuresOn(job, "G");
        QCOMPARE(holes.size(), std::size_t{3});
        QCOMPARE(job.steps[0].nets.size(), std::size_t{1});
        QCOMPARE(job.steps[0].nets[0].name, std::string("A"));
        QCOMPARE(holes[0].net, 0);
        QCOMPARE(holes[0].subnet, SubnetKind::Via);
        QCOMPARE(holes[1].net, kNoRow);
        QCOMPARE(holes[2].plating, Plating::NonPlated);
        QCOMPARE(layerNamed(job, "Drill T - B"), job.layers.size());
        const auto& guide = job.layers[layerNamed(job, "G")];
        QCOMPARE(guide.spanTop, static_cast<std::int32_t>(layerNamed(job, "T")));
        QCOMPARE(guide.spanBottom, static_cast<std::int32_t>(layerNamed(job, "B")));
        QVERIFY(reports(job, "a hole of a PadStack that a layer of holes draws too"));
    }

    void aLayerWithoutASpanHasThatOfItsHoles() {
        const DrawnJob job = jobWith(stack("A", kHere, "I") + drills("G", hole(kHere)));
        QCOMPARE(job.layers[layerNamed(job, "G")].spanBottom, static_cast<std::int32_t>(layerNamed(job, "I")));
        const DrawnJob mixed =
            jobWith(stack("A", kHere, "I") + stack("A", kThere) + drills("G", hole(kHere) + hole(kThere)));
        QCOMPARE(mixed.layers[layerNamed(mixed, "G")].spanBottom, kNoRow);
        QVERIFY(reports(mixed, "a layer of holes has no span, and its holes have several"));
    }

    void holesOfAnotherSpanOrSizeAreHolesOfTheirOwn() {
        const DrawnJob job = jobWith(stack("A", kHere) + drills("V", hole(kHere)));
        QCOMPARE(featuresOn(job, "V").size(), std::size_t{1});
        QCOMPARE(featuresOn(job, "V")[0].net, kNoRow);
        QCOMPARE(featuresOn(job, "Drill T - B").size(), std::size_t{1});
        std::string wider = hole(kHere);
        wider.replace(wider.find("0.3"), 3, "0.4");
        QCOMPARE(featuresOn(jobWith(stack("A", kHere) + drills("G", wider)), "Drill T - B").size(), std::size_t{1});
    }

    void thermalsThatJoinNothingAreReported() {
        const auto isReported = [](const char* thermal, const char* layer) {
            const std::string content =
                "<DictionaryStandard units='MILLIMETER'><EntryStandard id='A'><Circle diameter='0.6'/></EntryStandard>"
                "<EntryStandard id='F'><Circle diameter='" +
                std::string(thermal) + "'/></EntryStandard></DictionaryStandard>";
            const std::string stackDef =
                "<PadStackDef name='P'><PadstackHoleDef diameter='0.3' x='0' y='0'/>"
                "<PadstackPadDef layerRef='N' padUse='ANTIPAD'><StandardPrimitiveRef id='A'/></PadstackPadDef>"
                "<PadstackPadDef layerRef='N' padUse='THERMAL'><StandardPrimitiveRef id='F'/></PadstackPadDef>"
                "</PadStackDef>";
            const auto pad = [](const char* shape) {
                return "<Set><Pad padstackDefRef='P'><Location x='5' y='7'/><StandardPrimitiveRef id='" +
                       std::string(shape) + "'/></Pad></Set>";
            };
            const auto job =
                parse(fileWith(stackDef + drills(layer, pad("A") + pad("F")), content,
                               "<Layer name='N' layerFunction='PLANE' side='INTERNAL' polarity='NEGATIVE'/>"));
            return reports(*job, "a thermal on a negative layer is a circle wider than its hole");
        };
        QVERIFY(isReported("0.4", "N"));
        QVERIFY(!isReported("0.2", "N"));
        QVERIFY(!isReported("0.4", "T"));
    }

    void aLayerOfTheSameSpanComesFirst() {
        const DrawnJob job =
            jobWith(stack("A", kHere, "I") + drills("G", hole(kHere)) + drills("V", hole("x='5.002' y='7'")));
        QCOMPARE(featuresOn(job, "V")[0].net, 0);
        QCOMPARE(featuresOn(job, "G")[0].net, kNoRow);
    }
};

QTEST_APPLESS_MAIN(StackHolesTest)
#include "stack_holes_test.moc"
