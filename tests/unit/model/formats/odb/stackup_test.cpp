#include "model/board/stackup.h"

#include <QtTest>

#include "model/board/stackup_checks.h"
#include "model/solids/restack.h"
#include "tests/unit/model/formats/odb/odb_testing.h"

using model::Diagnostics;
using model::Layer;
using model::LayerFacts;
using model::LayerId;
using model::LayerSide;
using model::LayerType;
using model::Source;

using odb_testing::findDiagnostic;

namespace {

struct Stack {
    std::vector<Layer> layers;
    model::StackupFacts facts;
    model::Stackup built;
    Diagnostics diagnostics;
    model::Nm thickness = 0;

    Stack& add(LayerType type, const char* name, LayerFacts hint = {}) {
        Layer layer;
        layer.type = type;
        layer.name = name;
        layers.push_back(layer);
        facts.layers.push_back(std::move(hint));
        return *this;
    }
    Stack& copper(const char* name, std::optional<double> nm = {}, std::optional<double> below = {}) {
        return add(LayerType::Signal, name, {nm, below, {}, {}});
    }
    Stack& dielectric(const char* name, std::optional<double> nm = {}) {
        return add(LayerType::Dielectric, name, {nm, {}, {}, {}});
    }
    Stack& build(std::optional<double> board = {}) {
        facts.boardNm = board;
        built = model::buildStackup(layers, facts, diagnostics);
        thickness = model::thicknessOf(built);
        model::Document document;
        document.layers = layers;
        document.stackup = built;
        model::reportStackup(document, diagnostics);
        return *this;
    }
    const Layer& operator[](std::size_t i) const { return layers[i]; }
};

}  // namespace

class StackupTest : public QObject {
    Q_OBJECT

private slots:
    void withoutAnyNumberTheDefaultsAreShared() {
        Stack stack;
        stack.copper("top").dielectric("d1").copper("mid").dielectric("d2").copper("bottom").build();
        QCOMPARE(stack.thickness, model::kDefaultBoard);
        QCOMPARE(stack[4].z, 0);
        QCOMPARE(stack[4].thickness, model::kDefaultCopper);
        QCOMPARE(stack[3].z, model::kDefaultCopper);
        QCOMPARE(stack[1].thickness, (1'600'000 - 3 * 35'000) / 2);
        QCOMPARE(stack[1].thicknessSource, Source::Assumed);
        QCOMPARE(stack[0].z + stack[0].thickness, 1'600'000);
        QVERIFY(findDiagnostic(stack.diagnostics, "assumed board of 1600.0 µm") != nullptr);
        QVERIFY(findDiagnostic(stack.diagnostics, "3 copper layer(s)") != nullptr);
    }

    void theBoardsThicknessIsShared() {
        Stack stack;
        stack.copper("top", 20'000).copper("bottom", 20'000).build(1'000'000);
        QCOMPARE(stack.thickness, 1'000'000);
        QCOMPARE(stack[0].z, 980'000);
        QCOMPARE(stack[0].thicknessSource, Source::Job);
    }

    void dielectricsGivenOnCopperLieBelowIt() {
        // As the job with 14 layers and no dielectric rows has it.
        Stack stack;
        stack.copper("top", 35'000, 91'440)
            .copper("mid", 35'000, 127'000)
            .copper("bottom", 35'000, 25'400)
            .build(288'440);
        QCOMPARE(stack[1].z, 35'000 + 127'000);
        QCOMPARE(stack[0].z, 35'000 + 127'000 + 35'000 + 91'440);
        QCOMPARE(stack.thickness, 35'000 * 3 + 127'000 + 91'440);  // nothing lies below the bottom copper
    }

    void aRowWinsOverTheNumberOnTheCopper() {
        Stack stack;
        stack.copper("top", 35'000, 500'000).dielectric("d", 300'000).copper("bottom", 35'000).build();
        QCOMPARE(stack.thickness, 370'000);
    }

    void whatIsEmbeddedIsNoDielectric() {
        Stack stack;
        stack.copper("top", 35'000, 500'000)
            .add(LayerType::Mask, "resistors", {20'000, {}, {}, {}})
            .copper("bottom", 35'000)
            .build();
        QCOMPARE(stack.thickness, 570'000);
        QCOMPARE(stack[0].z, 535'000);
        QCOMPARE(stack[1].z, 35'000);
        QCOMPARE(stack[1].side, LayerSide::Inner);
    }

    void severalDielectricsBetweenTwoCoppersAddUp() {
        Stack stack;
        stack.copper("top", 30'000)
            .dielectric("p1", 100'000)
            .dielectric("p2", 120'000)
            .copper("bottom", 30'000)
            .build();
        QCOMPARE(stack[2].z, 30'000);
        QCOMPARE(stack[1].z, 150'000);
        QCOMPARE(stack[0].z, 250'000);
    }

    void absurdNumbersAreClampedAndReported() {
        Stack stack;
        stack.copper("top", 13'780'000).dielectric("d", 300'000).copper("bottom", 10).build();
        QCOMPARE(stack[0].thickness, 500'000);
        QCOMPARE(stack[2].thickness, 1'000);
        QVERIFY(findDiagnostic(stack.diagnostics, "layer top: the job's thickness of 13780.0 µm is absurd") != nullptr);
        QVERIFY(findDiagnostic(stack.diagnostics, "layer bottom") != nullptr);
    }

    void whatReplacesAnAbsurdNumberIsAssumedAndNotJudged() {
        Stack stack;
        stack.copper("top", 35'000).dielectric("d", 100).copper("mid", 100).dielectric("e", 300'000);
        stack.copper("bottom", 35'000).build(370'200);
        for (const std::size_t replaced : {std::size_t{1}, std::size_t{2}}) {
            QCOMPARE(stack[replaced].thickness, 1'000);
            QCOMPARE(stack[replaced].thicknessSource, Source::Assumed);
        }
        QCOMPARE(stack[3].thicknessSource, Source::Job);
        QCOMPARE(model::copperWeightOf(stack.built.rows[2])->source, Source::Assumed);
        QVERIFY(findDiagnostic(stack.diagnostics, "foils are") == nullptr);
        QVERIFY(findDiagnostic(stack.diagnostics, "none is made that is thinner") == nullptr);
        Stack board;
        board.copper("top", 35'000).dielectric("d").copper("bottom", 35'000).build(1e12);
        QCOMPARE(board[1].thicknessSource, Source::Assumed);
        Stack single;
        single.copper("top", 35'000).build(1e12);
        QCOMPARE(single.built.rows[1].source, Source::Assumed);
    }

    void negativeAndMissingNumbersAreNoThickness() {
        Stack stack;
        stack.copper("top", 0.0).dielectric("d", -5.0).copper("bottom", 35'000).build(1e12);
        QCOMPARE(stack[0].thickness, model::kDefaultCopper);
        QCOMPARE(stack[1].thickness, 1'000);
        QVERIFY(stack.thickness > 0);
    }

    void aBoardTooThinForItsLayersIsReported() {
        Stack stack;
        stack.copper("top").dielectric("d").copper("bottom").build(50'000);
        QCOMPARE(stack[1].thickness, model::kLeastDielectric);
        QVERIFY(findDiagnostic(stack.diagnostics, "no room") != nullptr);
    }

    void aSumThatContradictsTheBoardIsReported() {
        Stack stack;
        stack.copper("top", 35'000).dielectric("d", 500'000).copper("bottom", 35'000).build(1'600'000);
        QCOMPARE(stack.thickness, 570'000);
        QVERIFY(findDiagnostic(stack.diagnostics, "add up to 570 µm") != nullptr);
        Stack close;
        close.copper("top", 35'000).dielectric("d", 500'000).copper("bottom", 35'000).build(572'000);
        QVERIFY(findDiagnostic(close.diagnostics, "add up") == nullptr);  // what an ounce is differs
        Stack withMask;
        withMask.copper("top", 35'000).dielectric("d", 500'000).copper("bottom", 35'000).build(600'000);
        const auto* message = findDiagnostic(withMask.diagnostics, "add up");
        QVERIFY(message != nullptr && message->severity == model::Severity::Info);
    }

    void copperTakesWhatKnownDielectricsLeave() {
        Stack stack;
        stack.copper("top", {}, 100'000).copper("mid", {}, 200'000).copper("bottom").build(405'600);
        QCOMPARE(stack[0].thickness, 35'200);
        QCOMPARE(stack[2].thickness, 35'200);
        QCOMPARE(stack[0].thicknessSource, Source::Derived);
        QCOMPARE(stack.thickness, 405'600);
        Stack noRoom;
        noRoom.copper("top", {}, 100'000).copper("bottom").build(90'000);
        QCOMPARE(noRoom[0].thickness, model::kDefaultCopper);
        QCOMPARE(noRoom[0].thicknessSource, Source::Assumed);
    }

    void rowsNameEveryMaterialFromTheTop() {
        Stack stack;
        stack.add(LayerType::SolderMask, "smt", {12'000, {}, {}, {}});
        LayerFacts top{35'000, 100'000, {}, {}};
        top.material.copperOz = 1.0;
        top.below.dielectricConstant = 4.5;
        stack.add(LayerType::Signal, "TOP", top).copper("MID", 17'000);
        LayerFacts core{300'000, {}, {}, {}};
        core.material.name = "FR-4";
        stack.add(LayerType::Dielectric, "core", core).copper("BOTTOM", 35'000).build();
        const auto& rows = stack.built.rows;
        const std::vector<std::string> names = {"smt", "TOP", "below TOP", "MID", "core", "BOTTOM"};
        QCOMPARE(rows.size(), names.size());
        for (std::size_t i = 0; i < names.size(); ++i) {
            QCOMPARE(rows[i].name, names[i]);
            QVERIFY(i < 1 || rows[i].z + rows[i].thickness == rows[i - 1].z);
        }
        QVERIFY(!rows[2].layer.isValid());
        QCOMPARE(rows[2].thickness, 100'000);
        QCOMPARE(rows[2].source, Source::Job);
        QCOMPARE(*rows[2].material.dielectricConstant, 4.5);
        QCOMPARE(rows[4].material.name, "FR-4");
        QCOMPARE(rows[0].thickness, 12'000);
        QCOMPARE(model::copperWeightOf(rows[1])->oz, 1.0);
        QCOMPARE(model::copperWeightOf(rows[1])->source, Source::Job);
        QCOMPARE(model::copperWeightOf(rows[3])->oz, 17'000 / base::kNmPerOunce);
        QCOMPARE(model::copperWeightOf(rows[3])->source, Source::Derived);
        QVERIFY(!model::copperWeightOf(rows[4]));
        QVERIFY(model::findRow(stack.built, "BELOW top") == &rows[2]);
        QVERIFY(model::findRow(stack.built, "drill") == nullptr);
    }

    void aNameListedTwiceStaysTellable() {
        Stack stack;
        stack.copper("top", 35'000)
            .dielectric("ply", 1'000)
            .dielectric("PLY", 2'000)
            .dielectric("ply (2)", 3'000)
            .copper("bottom", 35'000);
        stack.facts.set = {{"ply (2)", 50'000}};
        stack.build();
        QCOMPARE(stack.built.rows[2].name, "PLY (2)");
        QCOMPARE(stack.built.rows[3].name, "ply (2) (2)");
        QCOMPARE(stack[1].thickness, 1'000);
        QCOMPARE(stack[2].thickness, 50'000);
        QCOMPARE(stack[3].thickness, 3'000);
    }

    void whatTheUserSetsCountsMost() {
        Stack stack;
        stack.copper("top", 35'000).copper("mid").dielectric("d", 300'000).copper("bottom", 35'000);
        stack.facts.set = {{"BELOW TOP", 80'000}, {"mid", 70'000}, {"nowhere", 5'000}};
        stack.build(1'000'000);
        QCOMPARE(stack.built.rows[1].thickness, 80'000);
        QCOMPARE(stack.built.rows[1].source, Source::Session);
        QCOMPARE(stack[1].thickness, 70'000);
        QCOMPARE(stack[1].thicknessSource, Source::Session);
        QCOMPARE(model::copperWeightOf(stack.built.rows[2])->source, Source::Session);
        QCOMPARE(stack.thickness, 35'000 + 80'000 + 70'000 + 300'000 + 35'000);
        QVERIFY(findDiagnostic(stack.diagnostics, "gives no thickness") == nullptr);
        QVERIFY(findDiagnostic(stack.diagnostics, "add up to 520 µm") != nullptr);
    }

    void whatTheUserSetsLeavesTheCopperAlone() {
        const auto build = [](std::vector<model::ThicknessOverride> set) {
            Stack stack;
            stack.copper("top").dielectric("a", 400'000).copper("mid").dielectric("b", 495'000).copper("bottom");
            stack.facts.set = std::move(set);
            stack.build(1'000'000);
            return std::vector{stack[0].thickness, stack[2].thickness, stack[4].thickness};
        };
        QCOMPARE(build({}), (std::vector<model::Nm>{35'000, 35'000, 35'000}));  // shares of what is left
        QCOMPARE(build({{"a", 100'000}}), (std::vector<model::Nm>{35'000, 35'000, 35'000}));
        QCOMPARE(build({{"mid", 70'000}}), (std::vector<model::Nm>{35'000, 70'000, 35'000}));
    }

    void theRestSharesWhatTheUserLeaves() {
        Stack stack;
        stack.copper("top", 50'000).dielectric("a").copper("mid", 50'000).dielectric("b").copper("bottom", 50'000);
        stack.facts.set = {{"a", 100'000}};
        stack.build(1'000'000);
        QCOMPARE(stack[3].thickness, 1'000'000 - 150'000 - 100'000);
        QCOMPARE(stack[3].thicknessSource, Source::Derived);
        QCOMPARE(stack.thickness, 1'000'000);
    }

    void thinMasksArePlaceholders() {
        Stack stack;
        stack.add(LayerType::SolderMask, "mask", {2'540, {}, {}, {}});
        stack.copper("top", 35'000).dielectric("d", 300'000).copper("bottom", 35'000).build();
        QCOMPARE(stack[0].thickness, model::kDefaultMask);
        QCOMPARE(stack[0].thicknessSource, Source::Assumed);
        QVERIFY(findDiagnostic(stack.diagnostics, "too thin for a solder mask") != nullptr);
    }

    void onlyWhatTheJobDoesNotStateIsReportedAsAssumed() {
        Stack stack;
        stack.add(LayerType::SilkScreen, "sst").add(LayerType::SolderMask, "smt", {17'780, {}, {}, {}});
        stack.copper("top", 35'000).dielectric("d", 300'000).copper("bottom", 35'000);
        stack.add(LayerType::SolderMask, "smb", {17'780, {}, {}, {}}).add(LayerType::SilkScreen, "ssb").build();
        QCOMPARE(findDiagnostic(stack.diagnostics, "surface layers")->text,
                 std::string("Thickness of surface layers is assumed: silk screen 15.0 µm"));
        Stack stated;
        stated.add(LayerType::SolderMask, "smt", {17'780, {}, {}, {}}).copper("top", 35'000).build();
        QVERIFY(findDiagnostic(stated.diagnostics, "surface layers") == nullptr);
    }

    void restackingGivesWhatReadingWouldHaveGiven() {
        const auto document = odb_testing::read(odb_testing::dataJob("everything"));
        const auto nmOf = [](const model::Document& d, const char* row) {
            return model::findRow(d.stackup, row)->thickness;
        };
        const auto changed = model::restack(*document, {{"CORE1", 123'000}, {"core2", 456'000}});
        QCOMPARE(nmOf(*changed, "CORE1"), 123'000);
        QCOMPARE(nmOf(*changed, "CORE2"), 456'000);
        QCOMPARE(model::findRow(changed->stackup, "CORE2")->source, Source::Session);
        const model::Nm grown = 123'000 + 456'000 - nmOf(*document, "CORE1") - nmOf(*document, "CORE2");
        QVERIFY(grown < 0);
        QCOMPARE(changed->layers.front().z - document->layers.front().z, grown);
        QCOMPARE(changed->boardThickness - document->boardThickness, grown);
        const auto substrate = [](const model::Document& d) {
            model::Nm sum = 0;
            for (const Layer& layer : d.layers) {
                sum += layer.type == LayerType::Body ? layer.thickness : 0;
            }
            return sum;
        };
        QCOMPARE(substrate(*changed) - substrate(*document), grown);
        QVERIFY(findDiagnostic(changed->diagnostics, "dielectric(s) without a thickness") == nullptr);
        // and back: everything as it was, messages included
        const auto back = model::restack(*changed, {});
        QCOMPARE(back->diagnostics.entries().size(), document->diagnostics.entries().size());
        for (std::size_t row = 0; row < document->layers.size(); ++row) {
            QCOMPARE(back->layers[row].z, document->layers[row].z);
            QCOMPARE(back->layers[row].thickness, document->layers[row].thickness);
            QCOMPARE(back->layers[row].thicknessSource, document->layers[row].thicknessSource);
        }
    }

    void aRestackedBoardSharesItsTables() {
        const auto panel = odb_testing::read(odb_testing::dataJob("panel"));
        QVERIFY(!panel->steps.empty());
        const std::string row = panel->stackup.rows.front().name;
        const auto changed = model::restack(*panel, {{row, 99'000}});
        const auto isShared = [](const model::Document& a, const model::Document& b) {
            return a.elements.kind.sharesRowsWith(b.elements.kind) && a.elements.net.sharesRowsWith(b.elements.net) &&
                   a.lines.sharesRowsWith(b.lines) && a.areas.sharesRowsWith(b.areas) &&
                   a.shapes.nodes.sharesRowsWith(b.shapes.nodes) && a.nets.sharesRowsWith(b.nets) &&
                   a.netElements.sharesRowsWith(b.netElements) && a.pins.sharesRowsWith(b.pins) &&
                   a.strings.sharesRowsWith(b.strings) && a.attributeSets.sharesRowsWith(b.attributeSets);
        };
        QVERIFY(isShared(*panel, *changed));
        for (std::size_t step = 0; step < panel->steps.size(); ++step) {
            QVERIFY(panel->steps[step] != changed->steps[step]);
            QVERIFY(isShared(*panel->steps[step], *changed->steps[step]));
        }
        QVERIFY(model::findRow(panel->stackup, row)->thickness != 99'000);
        QCOMPARE(model::findRow(changed->stackup, row)->thickness, 99'000);
    }

    void surfaceLayersLieOutsideOfTheCopper() {
        Stack stack;
        stack.add(LayerType::SilkScreen, "sst").add(LayerType::SolderPaste, "spt").add(LayerType::SolderMask, "smt");
        stack.copper("top", 35'000).dielectric("d", 930'000).copper("bottom", 35'000);
        stack.add(LayerType::SolderMask, "smb").add(LayerType::SilkScreen, "ssb").build();
        QCOMPARE(stack[2].z, 1'000'000);
        QCOMPARE(stack[1].z, 1'000'000);
        QCOMPARE(stack[0].z, 1'000'000 + model::kDefaultMask);
        QCOMPARE(stack[0].side, LayerSide::Top);
        QCOMPARE(stack[6].z, -model::kDefaultMask);
        QCOMPARE(stack[7].z, -model::kDefaultMask - model::kDefaultSilk);
        QCOMPARE(stack[7].side, LayerSide::Bottom);
    }

    void printBeginsWhereTheMaskUnderItEnds() {
        Stack stack;
        stack.add(LayerType::SilkScreen, "sst").add(LayerType::SolderMask, "smt", {10'000, {}, {}, {}});
        stack.copper("top", 35'000).dielectric("d", 930'000).copper("bottom", 35'000);
        stack.add(LayerType::SilkScreen, "ssb");
        stack.add(LayerType::SolderMask, "smb", {50'000, {}, {}, {}}).build();  // listed outside of the print
        QCOMPARE(stack[0].z, 1'010'000);
        QCOMPARE(stack[5].z, -50'000 - model::kDefaultSilk);
        stack.facts.set = {{"smt", 60'000}};
        stack.build();
        QCOMPARE(stack[0].z, 1'060'000);
    }

    void drillsReachFromFaceToFaceOfTheirSpan() {
        Stack stack;
        stack.copper("top", 30'000)
            .dielectric("d1", 100'000)
            .copper("mid", 30'000)
            .dielectric("d2", 100'000)
            .copper("bottom", 30'000);
        stack.add(LayerType::Drill, "blind");
        stack.layers.back().spanTop = LayerId{std::size_t{0}};
        stack.layers.back().spanBottom = LayerId{std::size_t{2}};
        stack.build();
        QCOMPARE(stack[5].z, 130'000);
        QCOMPARE(stack[5].thickness, 160'000);
        QCOMPARE(stack[5].side, LayerSide::Through);
    }

    void aSingleCopperLayerLiesOnItsLaminate() {
        Stack stack;
        stack.add(LayerType::SilkScreen, "silk").copper("only", 35'000).add(LayerType::SolderMask, "below");
        stack.add(LayerType::Drill, "drill");
        stack.layers.back().spanTop = stack.layers.back().spanBottom = LayerId{std::size_t{1}};
        stack.build(1'500'000);
        QCOMPARE(stack[1].side, LayerSide::Top);
        QCOMPARE(stack[1].z, 0);
        QCOMPARE(stack.thickness, 1'500'000);
        QCOMPARE(stack[0].z, 35'000);  // no mask there: on the copper
        QCOMPARE(stack[2].z, -1'500'000 - model::kDefaultMask);
        QCOMPARE(stack[3].z, -1'500'000);
        QCOMPARE(stack[3].thickness, 1'535'000);
    }

    void aSingleCopperLayerAtTheBottomLiesUnderItsSubstrate_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<LayerSide>("side");
        QTest::newRow("by the job's word") << "only" << LayerSide::Bottom;
        QTest::newRow("by its name") << "BOT" << LayerSide::None;
    }
    void aSingleCopperLayerAtTheBottomLiesUnderItsSubstrate() {
        QFETCH(QString, name);
        QFETCH(LayerSide, side);
        Stack stack;
        stack.add(LayerType::SilkScreen, "silk").copper(qPrintable(name), 35'000).add(LayerType::SolderMask, "below");
        stack.layers[1].side = side;
        stack.add(LayerType::Drill, "drill");
        stack.layers.back().spanTop = stack.layers.back().spanBottom = LayerId{std::size_t{1}};
        stack.build(1'500'000);
        QCOMPARE(stack[1].side, LayerSide::Bottom);
        QCOMPARE(stack[1].z, 0);
        QCOMPARE(stack.thickness, 1'500'000);
        QCOMPARE(stack.built.rows[1].name, "above " + name.toStdString());
        QCOMPARE(stack[0].z, 1'535'000);
        QCOMPARE(stack[2].z, -model::kDefaultMask);
        QCOMPARE(stack[3].z, 0);
        QCOMPARE(stack[3].thickness, 1'535'000);
    }

    void dielectricsOfTheJobAreTheSubstrateOfASingleCopperLayer() {
        Stack top;
        top.copper("copper", 35'000).dielectric("glue", 100'000).dielectric("base").build(1'500'000);
        QCOMPARE(top.built.rows.size(), std::size_t{3});
        QCOMPARE(top[0].side, LayerSide::Top);
        QCOMPARE(top[1].z, -100'000);
        QCOMPARE(top[2].thickness, 1'500'000 - 135'000);
        QCOMPARE(top[2].z, -(1'500'000 - 35'000));
        QCOMPARE(top.thickness, 1'500'000 - 35'000);
        Stack bottom;
        bottom.dielectric("base", 1'000'000).copper("copper", 35'000).add(LayerType::SolderMask, "mask").build();
        QCOMPARE(bottom[1].side, LayerSide::Bottom);
        QCOMPARE(bottom[0].z, 35'000);
        QCOMPARE(bottom[2].z, -model::kDefaultMask);
        QCOMPARE(bottom.thickness, 1'000'000);
    }

    void documentLayersArePlanesOnTheirSide() {
        Stack stack;
        stack.copper("top")
            .copper("bottom")
            .add(LayerType::Document, "Assembly Bottom")
            .add(LayerType::Document, "F.FAB")
            .build();
        QVERIFY(stack[2].z < 0);
        QVERIFY(stack[3].z > stack.thickness);
        QCOMPARE(stack[3].thickness, 0);
    }

    void thousandsOfAbsurdLayersStayInRange() {
        Stack stack;
        for (int i = 0; i < 5000; ++i) {
            stack.dielectric("d", 1e12).copper("c", 1e12);
        }
        stack.build();
        QVERIFY(stack.thickness > 0);
        QVERIFY(stack.thickness <= base::kMaxCoordinate);
    }

    void nothingIsAStackToo() {
        Stack stack;
        stack.add(LayerType::Document, "doc").add(LayerType::SilkScreen, "silk").add(LayerType::Drill, "drill").build();
        QCOMPARE(stack.thickness, 0);
        Stack empty;
        QCOMPARE(empty.build().thickness, 0);
    }
};

QTEST_APPLESS_MAIN(StackupTest)
#include "stackup_test.moc"
