// The small structured files of a job: matrix, stephdr, info, attrlist, tools.
#include "model/formats/odb/features/tools.h"
#include "model/formats/odb/job_info.h"
#include "model/formats/odb/stackup/layer_facts.h"
#include "model/formats/odb/stackup/matrix.h"
#include "model/formats/odb/steps/step_header.h"
#include "model/formats/odb/text/structured_text.h"
#include "tests/unit/model/formats/odb/odb_testing.h"

using model::Diagnostics;
using model::LayerType;
using model::odb::Unit;
using odb_testing::findDiagnostic;

namespace {

std::vector<std::string> orderOf(const std::vector<std::pair<std::string, std::string>>& layers,
                                 Diagnostics& diagnostics) {
    const model::odb::Matrix matrix = model::odb::parseMatrix(odb_testing::matrixOf(layers), "matrix", diagnostics);
    std::vector<std::string> names;
    for (const std::size_t row : model::odb::physicalOrder(matrix.layers, "matrix", diagnostics)) {
        names.push_back(matrix.layers[row].name);
    }
    return names;
}

}  // namespace

class JobFilesTest : public QObject {
    Q_OBJECT

private slots:
    /// A layer of the board that the step lacks would pass every rule; a drawing or paste is no matter of rules.
    void layersWithoutFeaturesAreErrorsIfRulesLookAtThem() {
        const odb_testing::Folder folder;
        odb_testing::writeSmallJob(folder, "UNITS=MM\n");
        folder.write("matrix/matrix", odb_testing::matrixOf({{"SOLDER_PASTE", "SPT"},
                                                             {"SIGNAL", "TOP"},
                                                             {"SIGNAL", "BOTTOM"},
                                                             {"SOLDER_MASK", "SMB"},
                                                             {"DRILL", "DRILL"},
                                                             {"DOCUMENT", "NOTES"}}));
        folder.write("steps/board/layers/smb/attrlist", "");
        const auto board = odb_testing::read(folder.path());
        const auto severityOf = [&](const std::string& text) {
            const model::Diagnostic* found = findDiagnostic(board->diagnostics, text);
            return found != nullptr ? found->severity : model::Severity::Info;
        };
        const std::string why = " is in the matrix, but the step has no folder for it; it stays empty";
        QCOMPARE(severityOf("Layer BOTTOM" + why), model::Severity::Error);
        QCOMPARE(severityOf("Layer DRILL" + why), model::Severity::Error);
        QCOMPARE(severityOf("Layer SMB has no features file; it stays empty"), model::Severity::Error);
        QCOMPARE(severityOf("Layer SPT" + why), model::Severity::Warning);
        QCOMPARE(severityOf("Layer NOTES" + why), model::Severity::Warning);
    }

    void structuredTextTakesBlanksCommentsAndBlocks() {
        Diagnostics diagnostics;
        const auto text = model::odb::parseStructured(
            "# c\r\nA = 1\r\nB=\r\n\r\nBLOCK {\r\n  C=x=y \r\n}\r\nD=4\r\nOTHER{\n}\n", "f", diagnostics);
        QCOMPARE(text.top.value("a"), std::string_view("1"));
        QCOMPARE(text.top.value("B"), std::string_view(""));
        QCOMPARE(text.top.value("D"), std::string_view("4"));
        QCOMPARE(text.blocks.size(), std::size_t{2});
        QCOMPARE(text.blocks[0].name, std::string_view("BLOCK"));
        QCOMPARE(text.blocks[0].line, 5U);
        QCOMPARE(text.blocks[0].value("C"), std::string_view("x=y"));
        QCOMPARE(text.blocks[1].name, std::string_view("OTHER"));
        QVERIFY(diagnostics.entries().empty());
    }

    void structuredTextReportsWhatItCannotRead() {
        Diagnostics diagnostics;
        const auto text = model::odb::parseStructured("nonsense\nBLOCK {\nA=1\n", "f", diagnostics);
        QCOMPARE(text.blocks[0].value("A"), std::string_view("1"));
        QVERIFY(findDiagnostic(diagnostics, "neither KEY=value") != nullptr);
        const model::Diagnostic* cut = findDiagnostic(diagnostics, "not closed");
        QVERIFY(cut != nullptr && cut->severity == model::Severity::Error);
    }

    void matrixRowsAndColumnsDecideTheOrder() {
        Diagnostics diagnostics;
        const auto matrix = model::odb::parseMatrix(
            "STEP {\nCOL=2\nNAME=B\n}\nSTEP {\nCOL=1\nNAME=A\n}\n"
            "LAYER {\nROW=2\nTYPE=power_ground\nNAME=GND\nPOLARITY=NEGATIVE\n}\n"
            "LAYER {\nROW=1\nCONTEXT=MISC\nTYPE=DOCUMENT\nNAME=Two Words\n}\nLAYER "
            "{\nROW=3\nTYPE=NEW_TYPE\nNAME=X\n}\n",
            "matrix", diagnostics);
        QCOMPARE(matrix.steps, (std::vector<std::string>{"A", "B"}));
        QCOMPARE(matrix.layers[0].name, std::string("Two Words"));
        QCOMPARE(matrix.layers[0].context, model::LayerContext::Misc);
        QCOMPARE(matrix.layers[1].type, LayerType::PowerGround);
        QVERIFY(matrix.layers[1].isNegative);
        QCOMPARE(matrix.layers[2].type, LayerType::Other);
        QVERIFY(findDiagnostic(diagnostics, "layer X: unknown layer type") != nullptr);
    }

    void copperOfContextMiscIsADrawing() {
        const std::string misc =
            "LAYER {\nROW=8\nCONTEXT=MISC\nTYPE=SIGNAL\nNAME=OLD\nPOLARITY=NEGATIVE\n}\n"
            "LAYER {\nROW=9\nCONTEXT=MISC\nTYPE=DRILL\nNAME=MAP\n}\n";
        Diagnostics diagnostics;
        const auto matrix =
            model::odb::parseMatrix(odb_testing::matrixOf({{"SIGNAL", "TOP"}}) + misc, "matrix", diagnostics);
        QCOMPARE(matrix.layers[0].type, LayerType::Signal);
        QCOMPARE(matrix.layers[1].type, LayerType::Document);
        QVERIFY(!matrix.layers[1].isNegative);
        QCOMPARE(matrix.layers[2].type, LayerType::Document);
        QVERIFY(findDiagnostic(diagnostics, "are no part of the board and shown as drawings: OLD, MAP") != nullptr);
        const auto unsorted = model::odb::parseMatrix(misc, "matrix", diagnostics);
        QCOMPARE(unsorted.layers[0].type, LayerType::Signal);
        QCOMPARE(unsorted.layers[1].type, LayerType::Drill);
    }

    void physicalLayersComeFirstFromTheTop() {
        Diagnostics diagnostics;
        const auto order = orderOf({{"COMPONENT", "CT"},
                                    {"SILK_SCREEN", "SST"},
                                    {"SIGNAL", "TOP"},
                                    {"DIELECTRIC", "D"},
                                    {"SIGNAL", "BOT"},
                                    {"SOLDER_MASK", "SMB"},
                                    {"DRILL", "DR"},
                                    {"COMPONENT", "CB"}},
                                   diagnostics);
        QCOMPARE(order, (std::vector<std::string>{"SST", "TOP", "D", "BOT", "SMB", "CT", "DR", "CB"}));
        QVERIFY(diagnostics.entries().empty());
    }

    void copperListedAfterTheDrillsIsAnInnerLayer() {
        Diagnostics diagnostics;
        const auto order = orderOf({{"SILK_SCREEN", "SST"},
                                    {"SIGNAL", "TOP"},
                                    {"SIGNAL", "BOT"},
                                    {"SOLDER_MASK", "SMB"},
                                    {"DRILL", "DR"},
                                    {"SIGNAL", "MID1"},
                                    {"SIGNAL", "MID2"}},
                                   diagnostics);
        QCOMPARE(order, (std::vector<std::string>{"SST", "TOP", "MID1", "MID2", "BOT", "SMB", "DR"}));
        QVERIFY(findDiagnostic(diagnostics, "layer MID1: copper listed below") != nullptr);
    }

    void embeddedPartsLieBetweenCopper() {
        for (const char* type : {"MASK", "CONDUCTIVE_PASTE"}) {
            Diagnostics diagnostics;
            const auto order = orderOf({{"SIGNAL", "TOP"},
                                        {"DIELECTRIC", "D1"},
                                        {"SIGNAL", "L2"},
                                        {type, "RESISTORS"},
                                        {"DIELECTRIC", "D2"},
                                        {"SIGNAL", "L3"},
                                        {"SIGNAL", "BOT"},
                                        {"SOLDER_MASK", "SMB"}},
                                       diagnostics);
            QCOMPARE(order, (std::vector<std::string>{"TOP", "D1", "L2", "RESISTORS", "D2", "L3", "BOT", "SMB"}));
            QVERIFY(diagnostics.entries().empty());
        }
    }

    void aMatrixOfAnythingIsNoCrash() {
        const std::string text = odb_testing::readFile(odb_testing::dataJob("everything") / "matrix/matrix");
        for (std::size_t length = 0; length <= text.size(); ++length) {
            Diagnostics diagnostics;
            const std::vector<char> part(text.begin(), text.begin() + static_cast<std::ptrdiff_t>(length));
            const auto matrix = model::odb::parseMatrix({part.data(), part.size()}, "matrix", diagnostics);
            QVERIFY(matrix.layers.size() <= 15);
            QCOMPARE(model::odb::physicalOrder(matrix.layers, "matrix", diagnostics).size(), matrix.layers.size());
        }
    }

    void infoMayLackEverything() {
        Diagnostics diagnostics;
        const auto empty = model::odb::parseInfo("", "info", diagnostics);
        QVERIFY(empty.jobName.empty() && empty.version.empty() && !empty.unit);
        const auto info = model::odb::parseInfo(
            "JOB_NAME = x\nODB_VERSION_MAJOR=7\nODB_VERSION_MINOR=0\nODB_SOURCE=who\nUNITS=\n", "info", diagnostics);
        QCOMPARE(info.jobName, std::string("x"));
        QCOMPARE(info.version, std::string("7.0"));
        QCOMPARE(info.generator, std::string("who"));
        QVERIFY(!info.unit);
    }

    void stepHeaderReadsRepeatsInItsUnit() {
        Diagnostics diagnostics;
        const auto header = model::odb::parseStepHeader(
            "X_DATUM=1\nY_DATUM=2\nSTEP-REPEAT "
            "{\nNAME=a\nX=1\nY=-1\nDX=0.5\nDY=0\nNX=3\nNY=2\nANGLE=450\nMIRROR=YES\n}\n",
            "stephdr", Unit::Inch, diagnostics);
        QCOMPARE(header.datum, (model::Point{25'400'000, 50'800'000}));
        QCOMPARE(header.repeats.size(), std::size_t{1});
        QCOMPARE(header.repeats[0].pitch.x, 12'700'000);
        QCOMPARE(header.repeats[0].columns, 3);
        QCOMPARE(header.repeats[0].clockwiseDeg, 90.0);
        QVERIFY(header.repeats[0].isMirrored);
        QVERIFY(!header.repeats[0].isFlipped);
    }

    void absurdRepeatsAreLeftOut_data() {
        QTest::addColumn<QString>("block");
        QTest::newRow("too many") << "NAME=a\nNX=1000000\nNY=1000000\n";
        QTest::newRow("negative") << "NAME=a\nNX=-1\n";
        QTest::newRow("out of range") << "NAME=a\nDX=600\nNX=3\n";
        QTest::newRow("no name") << "NX=1\n";
        QTest::newRow("no number") << "NAME=a\nX=here\n";
    }
    void absurdRepeatsAreLeftOut() {
        QFETCH(QString, block);
        Diagnostics diagnostics;
        const auto header = model::odb::parseStepHeader("UNITS=MM\nSTEP-REPEAT {\n" + block.toStdString() + "}\n",
                                                        "stephdr", Unit::Millimetre, diagnostics);
        QVERIFY(header.repeats.empty());
        QCOMPARE(diagnostics.count(model::Severity::Error), std::size_t{1});
        QCOMPARE(diagnostics.entries()[0].line, 2U);
    }

    void attributesOfZeroAreUnset() {
        Diagnostics diagnostics;
        const std::string text = "UNITS=MM\n.copper_weight = 35\n.layer_dielectric=0\n.z0impedance=\n.loss_tangent=x\n";
        const model::odb::AttributeList list(text, "attrlist", Unit::Inch, diagnostics);
        QCOMPARE(list.unit(), Unit::Millimetre);
        QCOMPARE(list.number(".copper_weight"), std::optional(35.0));
        QVERIFY(!list.number(".layer_dielectric"));
        QVERIFY(!list.number(".z0impedance"));
        QVERIFY(diagnostics.entries().empty());
        QVERIFY(!list.number(".loss_tangent"));
        QCOMPARE(diagnostics.entries().size(), std::size_t{1});
    }

    void toolsAreMilsUnlessTheFileSaysOtherwise() {
        Diagnostics diagnostics;
        const auto mils = model::odb::parseTools(
            "THICKNESS=0\nTOOLS {\nNUM=1\nTYPE=VIA\nFINISH_SIZE=10\nDRILL_SIZE=12\n}\nTOOLS {\nNUM=2\nTYPE=NON_PLATED\n"
            "FINISH_SIZE=-9.84e-005\nDRILL_SIZE=0\n}\n",
            "tools", diagnostics);
        QCOMPARE(mils.size(), std::size_t{2});
        QCOMPARE(mils[0].finishedSize, 254'000);
        QCOMPARE(mils[0].drillSize, 304'800);
        QCOMPARE(mils[1].finishedSize, 0);
        QCOMPARE(mils[1].plating, model::Plating::NonPlated);
        const auto um = model::odb::parseTools("UNITS=MM\nTOOLS {\nNUM=1\nFINISH_SIZE=300\n}\n", "tools", diagnostics);
        QCOMPARE(um[0].finishedSize, 300'000);
    }
};

QTEST_APPLESS_MAIN(JobFilesTest)
#include "job_files_test.moc"
