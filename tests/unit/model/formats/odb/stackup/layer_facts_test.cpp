#include "model/formats/odb/stackup/layer_facts.h"

#include <QtTest>

#include "tests/unit/model/formats/odb/odb_testing.h"

using model::LayerFacts;
using model::LayerType;
using model::odb::AttributeList;
using model::odb::MatrixLayer;
using model::odb::Unit;
using odb_testing::findDiagnostic;

namespace {

LayerFacts facts(LayerType type, const char* text, model::Diagnostics& diagnostics) {
    MatrixLayer layer;
    layer.type = type;
    return factsOf(AttributeList(text, "attrlist", Unit::Inch, diagnostics), layer);
}

}  // namespace

class LayerFactsTest : public QObject {
    Q_OBJECT

private slots:
    void copperSpeaksOfItselfAndOfWhatLiesUnderIt() {
        model::Diagnostics diagnostics;
        const LayerFacts found = facts(LayerType::Signal,
                                       ".copper_weight=2\n.layer_dielectric=0.01\n.dielectric_constant=4.5\n.loss_"
                                       "tangent=0.02\n.bulk_resistivity=16.8\n",
                                       diagnostics);
        QCOMPARE(*found.thicknessNm, 2 * base::kNmPerOunce);
        QCOMPARE(*found.material.copperOz, 2.0);
        QCOMPARE(*found.material.resistivity, 16.8);
        QVERIFY(!found.material.dielectricConstant);
        QCOMPARE(*found.belowNm, 254'000.0);
        QCOMPARE(*found.below.dielectricConstant, 4.5);
        QCOMPARE(*found.below.lossTangent, 0.02);
    }

    void copperInMillimetreFilesIsMicrometres() {
        model::Diagnostics diagnostics;
        const LayerFacts found =
            facts(LayerType::Mixed, "UNITS=MM\n.copper_weight=17.5\n.layer_dielectric=0.2\n", diagnostics);
        QCOMPARE(*found.thicknessNm, 17'500.0);
        QVERIFY(!found.material.copperOz);
        QCOMPARE(*found.belowNm, 200'000.0);
    }

    void dielectricsAndMasksSpeakOfThemselves() {
        for (const LayerType type : {LayerType::Dielectric, LayerType::SolderMask}) {
            model::Diagnostics diagnostics;
            const LayerFacts found = facts(
                type, "UNITS=MM\n.copper_weight=35\n.layer_dielectric=0.2\n.dielectric_constant=4.2\n", diagnostics);
            QCOMPARE(*found.thicknessNm, 200'000.0);
            QCOMPARE(*found.material.dielectricConstant, 4.2);
            QVERIFY(!found.belowNm);
        }
    }

    /// KiCad 10 writes ounces into mm files, and beside them how thick the copper is.
    void weightsThatNoCopperHasInMicrometresAreOunces() {
        model::Diagnostics diagnostics;
        const auto kicad =
            facts(LayerType::Signal, "UNITS=MM\n.layer_dielectric=0.0350\n.copper_weight=1.0\n", diagnostics);
        QCOMPARE(*kicad.thicknessNm, 35'000.0);
        QCOMPARE(*kicad.material.copperOz, 1.0);
        QVERIFY(!kicad.belowNm);
        const auto* entry = findDiagnostic(diagnostics, "taken as ounces");
        QVERIFY(entry != nullptr && entry->severity == model::Severity::Info);
        QCOMPARE(entry->line, 3U);
        const auto under =
            facts(LayerType::Signal, "UNITS=MM\n.layer_dielectric=0.2\n.copper_weight=0.5\n", diagnostics);
        QCOMPARE(*under.thicknessNm, 17'400.0);
        QCOMPARE(*under.belowNm, 200'000.0);
        const auto thin = facts(LayerType::Signal, "UNITS=MM\n.copper_weight=5\n", diagnostics);
        QCOMPARE(*thin.thicknessNm, 5'000.0);
        QVERIFY(!thin.material.copperOz);
    }

    void printAndPasteSpeakOfThemselves() {
        model::Diagnostics diagnostics;
        const auto thickness = [&](LayerType type, const char* text) {
            return facts(type, text, diagnostics).thicknessNm;
        };
        QCOMPARE(*thickness(LayerType::SilkScreen, ".layer_dielectric=0.0008\n.copper_weight=1\n"), 20'320.0);
        QCOMPARE(*thickness(LayerType::SolderPaste, "UNITS=MM\n.layer_dielectric=0.12\n"), 120'000.0);
        QVERIFY(!thickness(LayerType::SilkScreen, ".layer_dielectric=0\n"));
        QVERIFY(diagnostics.entries().empty());
    }

    /// 2.54 µm are Altium's "nothing known"; 254 µm are what a real job has on its dielectrics, too.
    void printAndPasteThatCannotBeAreReported_data() {
        QTest::addColumn<int>("type");
        QTest::addColumn<QString>("value");
        QTest::addColumn<QString>("message");
        const int print = static_cast<int>(LayerType::SilkScreen);
        const int paste = static_cast<int>(LayerType::SolderPaste);
        QTest::newRow("thin print") << print << "0.0001"
                                    << "too thin for silkscreen";
        QTest::newRow("thick print") << print << "0.01"
                                     << "too thick for silkscreen";
        QTest::newRow("thin paste") << paste << "0.0001"
                                    << "too thin for solder paste";
        QTest::newRow("thick paste") << paste << "0.1"
                                     << "too thick for solder paste";
        QTest::newRow("negative") << print << "-0.001"
                                  << "too thin for silkscreen";
    }
    void printAndPasteThatCannotBeAreReported() {
        QFETCH(int, type);
        QFETCH(QString, value);
        QFETCH(QString, message);
        model::Diagnostics diagnostics;
        const std::string text = "UNITS=INCH\n.layer_dielectric=" + value.toStdString() + "\n";
        QVERIFY(!facts(static_cast<LayerType>(type), text.c_str(), diagnostics).thicknessNm);
        const auto* entry = findDiagnostic(diagnostics, message.toStdString());
        QVERIFY(entry != nullptr && entry->severity == model::Severity::Info);
        QCOMPARE(entry->file, std::string("attrlist"));
        QCOMPARE(entry->line, 2U);
    }

    void silkscreenIsAsThickAsItsLayerSays() {
        odb_testing::Folder folder;
        odb_testing::writeSmallJob(folder, "UNITS=MM\n$0 r100\nP 1 1 0 P 0 0\n");
        folder.write("matrix/matrix", odb_testing::matrixOf({{"SILK_SCREEN", "PRINT"}, {"SIGNAL", "TOP"}}));
        folder.write("steps/board/layers/print/features", "UNITS=MM\n$0 r100\nP 1 1 0 P 0 0\n");
        folder.write("steps/board/layers/print/attrlist", "UNITS=MM\n.layer_dielectric=0.012\n");
        const auto document = odb_testing::read(folder.path());
        const model::Layer& print = odb_testing::layerOf(*document, "PRINT");
        QCOMPARE(print.thickness, 12'000);
        QCOMPARE(print.thicknessSource, model::Source::Job);
        QVERIFY(findDiagnostic(document->diagnostics, "surface layers is assumed: silk screen") == nullptr);
    }

    void zeroAndAirAreNotSet() {
        model::Diagnostics diagnostics;
        const LayerFacts found =
            facts(LayerType::Dielectric, ".layer_dielectric=0\n.dielectric_constant=1\n.loss_tangent=0\n", diagnostics);
        QVERIFY(!found.thicknessNm && !found.material.dielectricConstant && !found.material.lossTangent);
        QVERIFY(diagnostics.entries().empty());
    }

    void absurdMaterialsAreReportedAndLeftOut() {
        model::Diagnostics diagnostics;
        const LayerFacts found =
            facts(LayerType::Dielectric, ".dielectric_constant=-4\n.loss_tangent=3.5\n", diagnostics);
        QVERIFY(!found.material.dielectricConstant && !found.material.lossTangent);
        QVERIFY(findDiagnostic(diagnostics, ".dielectric_constant is absurd") != nullptr);
        QVERIFY(findDiagnostic(diagnostics, ".loss_tangent is absurd") != nullptr);
    }

    void aStepMayStateTheBoardsThickness() {
        const auto readWith = [](const std::string& jobs, const std::string& steps) {
            odb_testing::Folder folder;
            odb_testing::writeSmallJob(folder, "UNITS=MM\n$0 r100\nP 1 1 0 P 0 0\n");
            folder.write("matrix/matrix", odb_testing::matrixOf({{"SIGNAL", "TOP"}, {"SIGNAL", "BOT"}}));
            folder.write("steps/board/attrlist", "UNITS=MM\n" + steps);
            folder.write("misc/attrlist", "UNITS=MM\n" + jobs);
            return odb_testing::read(folder.path());
        };
        const auto alone = readWith("", ".board_thickness=2.0\n");
        QCOMPARE(alone->boardThickness, 2'000'000);
        QVERIFY(findDiagnostic(alone->diagnostics, "the step says") == nullptr);
        const auto both = readWith(".board_thickness=1.6\n", ".board_thickness=2.0\n");
        QCOMPARE(both->boardThickness, 1'600'000);
        const auto* entry = findDiagnostic(both->diagnostics, "the step says the board is 2000 µm thick");
        QVERIFY(entry != nullptr && entry->file.ends_with("/attrlist"));
        const auto same = readWith(".board_thickness=1.6\n", ".board_thickness=1.62\n");
        QVERIFY(findDiagnostic(same->diagnostics, "the step says") == nullptr);
    }

    void theMatrixNamesMaterials() {
        odb_testing::Folder folder;
        odb_testing::writeSmallJob(folder, "UNITS=MM\n$0 r100\nP 1 1 0 P 0 0\n");
        folder.write("matrix/matrix",
                     "STEP {\n COL=1\n NAME=BOARD\n}\n"
                     "LAYER {\n ROW=1\n CONTEXT=BOARD\n TYPE=SIGNAL\n NAME=TOP\n FORM=Flex\n CU_TOP=1\n}\n"
                     "LAYER {\n ROW=2\n CONTEXT=BOARD\n TYPE=DIELECTRIC\n NAME=D\n DIELECTRIC_TYPE=CORE\n "
                     "DIELECTRIC_NAME=FR-4\n FORM=None\n}\n"
                     "LAYER {\n ROW=3\n CONTEXT=BOARD\n TYPE=SIGNAL\n NAME=BOTTOM\n}\n");
        const auto document = odb_testing::read(folder.path());
        const auto& rows = document->stackup.rows;
        QCOMPARE(rows.size(), std::size_t{3});
        QCOMPARE(rows[0].material.form, "FLEX");
        QCOMPARE(rows[1].material.name, "FR-4");
        QCOMPARE(rows[1].material.type, "CORE");
        QVERIFY(rows[1].material.form.empty());
        const auto* unused = findDiagnostic(document->diagnostics, "CU_TOP is not used");
        QVERIFY(unused != nullptr && unused->line == 5);
    }
};

QTEST_APPLESS_MAIN(LayerFactsTest)
#include "layer_facts_test.moc"
