// Gerber jobs that are wrong: each fault has a message with its file and, where a line is at fault, the line; the rest
// of the job is shown. Every file is also cut off at each of its characters by tests/fuzz.

#include <QtTest>
#include <algorithm>

#include "tests/unit/model/formats/gerber/gerber_testing.h"

using namespace gerber_testing;

namespace {

/// A row: what is put into a sound job of two copper layers, and the message.
struct Fault {
    const char* name;
    const char* file;
    std::string text;
    const char* message;
    std::uint32_t line;  ///< 0: of the whole file
};

const Fault kFaults[] = {
    // ---- images ----
    {"a block that draws itself", "b.GTS",
     std::string(kHead) +
         "%ADD10C,1*%\n%ABD20*%\nD10*\nX5000000Y5000000D03*\nD20*\nX0Y0D03*\n%AB*%\nD20*\nX0Y0D03*\nM02*\n",
     "an aperture that is not defined; what is drawn with it is left out", 7},
    {"blocks that draw each other", "b.GTS",
     std::string(kHead) + "%ABD20*%\nD21*\nX0Y0D03*\n%AB*%\n%ADD10C,1*%\n%ABD21*%\nD10*\nX5000000Y5000000D03*\nD20*"
                          "\nX0Y0D03*\n%AB*%\nD21*\nX0Y0D03*\nM02*\n",
     "an aperture that is not defined; what is drawn with it is left out", 4},
    {"a macro whose name nobody defines", "b.GTS",
     std::string(kHead) + "%AMA*1,1,$1,0,0*%\n%ADD10B,1*%\n%ADD11A,1*%\nD11*\nX5000000Y5000000D03*\nM02*\n",
     "an aperture of a macro that is not defined; it draws nothing", 4},
    {"a macro within itself", "b.GTS",
     std::string(kHead) + "%AMA*1,1,$1,0,0*A,1*%\n%ADD10A,1*%\nD10*\nX5000000Y5000000D03*\nM02*\n",
     "an aperture macro has a primitive that cannot be read; it was left out", 4},
    {"a macro that divides by nothing", "b.GTS",
     std::string(kHead) + "%AMA*$2=$1/0*1,1,$1,0,0*%\n%ADD10A,1*%\nD10*\nX5000000Y5000000D03*\nM02*\n",
     "an aperture macro has an expression that cannot be read; the variable was left as it is", 4},
    {"a coordinate with more digits than its format", "b.GTS",
     "%FSLAX24Y24*%\n%MOMM*%\n%ADD10C,1*%\nD10*\nX1234567Y50000D03*\nM02*\n",
     "a coordinate has more digits than the file's format (FS); it is read as it stands", 5},
    {"a coordinate beyond every board", "b.GTS",
     std::string(kHead) + "%ADD10C,1*%\nD10*\nX5000000Y5000000D03*\nX9999999999D03*\nM02*\n",
     "a coordinate is larger than any board (1.07 m); what is drawn there is left out", 6},
    {"a coordinate without digits", "b.GTS", std::string(kHead) + "%ADD10C,1*%\nD10*\nXY5000000D03*\nM02*\n",
     "a coordinate without digits; it is taken as 0", 5},
    {"an image without a unit", "b.GTS", "%FSLAX24Y24*%\n%ADD10C,.1*%\nD10*\nX2000Y2000D03*\nM02*\n",
     "the file does not say its unit (MO); taken as inch", 1},
    {"a rotation that is no number", "b.GTS",
     std::string(kHead) + "%ADD10C,1*%\n%LRhalf*%\nD10*\nX5000000Y5000000D03*\nM02*\n",
     "a polarity, mirroring, rotation or scale (LP, LM, LR, LS) that cannot be read; none applies", 4},
    {"a second file of one solder mask", "b_F_Mask.gbr",
     "%TF.FileFunction,Soldermask,Top*%\n" + std::string(kHead) + "%ADD10C,1*%\nD10*\nX5000000Y5000000D03*\nM02*\n",
     "another file claims the same top solder mask; both are shown", 0},
    {"copper layers that are not there", "b-In.gbr",
     "%TF.FileFunction,Copper,L6,Inr*%\n" + std::string(kHead) + "%ADD10C,1*%\nD10*\nX5000000Y5000000D03*\nM02*\n",
     "the file draws copper layer 6, but no file draws copper layer 2, 3, 4, 5", 0},
    {"images of a job file that are not there", "b.gbrjob",
     R"({"FilesAttributes": [{"Path": "b-Mask.gbr", "FileFunction": "Soldermask,Top"}]})",
     "the job file lists images that the job does not hold: b-mask.gbr", 0},
    {"an image without format and apertures", "b-Inner.gbr",
     "*\nX0Y0D02*\nD31*\nX5450Y9550D02*\nX19663Y9550D01*\nX19663Y12550*\nX22775*\nY19450*\nX5450*\nY17227*\nX6041*\n"
     "Y16952*\nX5765*\nY15220*\nX6041*\nM02*\n",
     "the image is of the old form of Gerber (RS-274-D), whose format and apertures are in another file", 0},
    // ---- drills ----
    {"drills without a unit", "b.drl", "M48\nT1C0.03\n%\nT1\nX01Y01\nM30\n",
     "the drill file does not say its unit; taken as", 0},
    {"drills in another unit than they say", "b.drl", "M48\nINCH\nT1C0.8\n%\nT1\nX2.0Y2.0\nX8.0Y2.0\nX8.0Y8.0\nM30\n",
     ", which puts the holes on the copper, not as inch", 0},
    {"a drill with more digits than its format", "b.drl",
     "M48\nMETRIC,TZ,00.00\nT1C0.8\n%\nT1\nX200Y200\nX1000200Y800\nM30\n",
     "a coordinate has more digits than the file's format; it is read as it stands", 7},
    {"a drill that is no number", "b.drl", "M48\nMETRIC\nT1C0.8\n%\nT1\nX2.0Y2.0\nX8.0.1Y2.0\nM30\n",
     "a coordinate that cannot be read; the record was left out", 7},
    // ---- netlists ----
    {"a netlist without a unit", "b.ipc",
     "317A                J1    -1     D0300PA00X+000787Y+000787X0600Y0000R000 S0\n317A                J1    -2     "
     "D0300PA00X+003150Y+000787X0600Y0000R000 S0\n317B                J1    -3     "
     "D0300PA00X+003150Y+003150X0600Y0000R000 S0\n999\n",
     "the netlist does not say its unit (P UNITS); taken as 0.0001 inch", 1},
    {"a record of a netlist without a place", "b.ipc",
     "P  UNITS CUST 1\n317A                J1    -1     D0800PA00X+002000Y+002000X1500Y0000R000 S0\n317A               "
     " J1    -2     D0800PA00X+00A000Y+002000X1500Y0000R000 S0\n317B                J1    -3     "
     "D0800PA00X+008000Y+008000X1500Y0000R000 S0\n999\n",
     "a record of the netlist without a place; it was left out", 3},
    {"a netlist of another board", "b.ipc",
     "P  UNITS CUST 1\n317A                J1    -1     D0800PA00X+900100Y+002300X1500Y0000R000 S0\n317A               "
     " J1    -2     D0800PA00X+300000Y+102700X1500Y0000R000 S0\n317B                J1    -3     "
     "D0800PA00X+008800Y+408900X1500Y0000R000 S0\n999\n",
     "the points of the netlist lie on no pads, wherever its origin is taken to be", 0},
    // ---- places of parts ----
    {"a row of a table without a place", "b-pos.csv",
     "Ref,Val,Package,PosX,PosY,Rot,Side\nJ1,CON,HDR,5.0,5.0,90.0,top\nJ2,CON,HDR,,5.0,90.0,top\n",
     "a row that places no component; it was left out", 3},
    {"a table without a unit", "b-pos.csv", "Ref,Val,Package,PosX,PosY,Rot,Side\nJ1,CON,HDR,5.0,5.0,90.0,top\n",
     "the table of places does not say its unit; taken as mm", 2},
    {"places of another board", "b-pos.csv", "Ref,Val,Package,PosX,PosY,Rot,Side\nJ1,CON,HDR,500.0,5.0,90.0,top\n",
     "the places of components do not lie on the board, and nothing tells the origin", 0},
};

const model::Diagnostic* find(const model::Document& board, const std::string& file, const std::string& words) {
    const auto& entries = board.diagnostics.entries();
    const auto found = std::ranges::find_if(entries, [&](const model::Diagnostic& entry) {
        // Messages begin with a capital.
        return entry.file == file && entry.text.find(words.substr(1)) != std::string::npos;
    });
    return found == entries.end() ? nullptr : &*found;
}

}  // namespace

class GerberBadInputTest : public QObject {
    Q_OBJECT

private slots:
    void faultsAreReportedAndTheRestIsShown_data() {
        QTest::addColumn<std::size_t>("row");
        for (std::size_t i = 0; i < std::size(kFaults); ++i) {
            QTest::newRow(kFaults[i].name) << i;
        }
    }
    void faultsAreReportedAndTheRestIsShown() {
        QFETCH(std::size_t, row);
        const Fault& fault = kFaults[row];
        Files files = {{"b.GTL", image(kCopper)}, {"b.GBL", image(kCopper)}, {"b.GTS", image(kCopper)}};
        const Job sound(files);
        files[fault.file] = fault.text;
        const Job job(files);
        const Board board = job.open();
        const Board without = sound.open();
        QVERIFY(board.ok() && without.ok());
        const model::Diagnostic* const message = find(**board, fault.file, fault.message);
        QVERIFY2(message != nullptr, fault.message);
        QCOMPARE(message->line, fault.line);
        QVERIFY(find(**without, fault.file, fault.message) == nullptr);
        for (const model::Layer& layer : (*without)->layers) {
            const model::LayerId same = (*board)->findLayer(layer.name);
            QVERIFY2(
                !layer.isCopper() || (same.isValid() && (*board)->layer(same).elements.count == layer.elements.count),
                layer.name.c_str());
        }
    }

    /// A board that lacks copper, mask, holes, silkscreen or outline is not all there: rules must know. Paste is not
    /// sent to everybody, and a file that was renamed is there.
    void missingImagesOfTheBoardAreErrors_data() {
        QTest::addColumn<QString>("function");
        QTest::addColumn<bool>("isError");
        QTest::newRow("copper") << "Copper,L4,Bot" << true;
        QTest::newRow("solder mask") << "Soldermask,Bot" << true;
        QTest::newRow("silkscreen") << "Legend,Bot" << true;
        QTest::newRow("outline") << "Profile,NP" << true;
        QTest::newRow("holes") << "Plated,1,2,PTH" << true;
        QTest::newRow("paste") << "SolderPaste,Bot" << false;
        QTest::newRow("a drawing") << "AssemblyDrawing,Bot" << false;
        QTest::newRow("renamed solder mask") << "Soldermask,Top" << false;
        QTest::newRow("renamed copper") << "Copper,L1,Top" << false;
    }
    void missingImagesOfTheBoardAreErrors() {
        QFETCH(QString, function);
        QFETCH(bool, isError);
        const std::string listed =
            "{\"FilesAttributes\": [{\"Path\": \"gone.gbr\", \"FileFunction\": \"" + function.toStdString() + "\"}]}";
        const Job job({{"b.GTL", image(kCopper)}, {"b.GTS", image(kCopper)}, {"b.gbrjob", listed}});
        const Board board = job.open();
        QVERIFY(board.ok());
        const model::Diagnostic* const message =
            find(**board, "b.gbrjob", "the job file lists images that the job does not hold: gone.gbr");
        QVERIFY(message != nullptr);
        QCOMPARE(message->severity, isError ? model::Severity::Error : model::Severity::Warning);
    }

    void copperThatIsSkippedIsAnError() {
        const Job job(
            {{"b.GTL", image(kCopper)}, {"b-Bot.gbr", "%TF.FileFunction,Copper,L4,Bot*%\n" + image(kCopper)}});
        const Board board = job.open();
        QVERIFY(board.ok());
        const model::Diagnostic* const message =
            find(**board, "b-Bot.gbr", "the file draws copper layer 4, but no file draws copper layer 2, 3");
        QVERIFY(message != nullptr);
        QCOMPARE(message->severity, model::Severity::Error);
    }

    /// Of a faulty image what can be read is there.
    void faultyImagesShowWhatCanBeRead() {
        for (const Fault& fault : kFaults) {
            const std::string file = fault.file;
            if (!file.starts_with("b.GTS")) {
                continue;
            }
            const Job job({{"b.GTL", image(kCopper)}, {"b.GBL", image(kCopper)}, {file, fault.text}});
            const Board board = job.open();
            QVERIFY2(board.ok(), fault.name);
            const auto& layers = (*board)->layers;
            const auto mask = std::ranges::find(layers, file, &model::Layer::file);
            QVERIFY2(mask != layers.end() && mask->featureCount == 1, fault.name);
        }
    }
};

QTEST_APPLESS_MAIN(GerberBadInputTest)
#include "gerber_bad_input_test.moc"
