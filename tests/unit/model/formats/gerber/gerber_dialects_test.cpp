// Whole jobs as particular programs write them: names, planes, places.

#include <QtTest>
#include <algorithm>
#include <array>
#include <cstdio>
#include <cstdlib>

#include "model/formats/gerber/gerber_reader.h"
#include "model/formats/gerber/placements.h"
#include "model/geometry/outlines.h"
#include "tests/unit/model/formats/gerber/gerber_testing.h"

using namespace gerber_testing;

namespace {

const std::string kNetlist =
    "317SUPPLY           J1    -1     D0315PA00X+000787Y+000787X0591Y0000R000 S3\n"
    "317SUPPLY           J1    -2     D0315PA00X+003150Y+000787X0591Y0000R000 S3\n"
    "317OTHER            J1    -3     D0315PA00X+003150Y+003150X0591Y0000R000 S3\n999\n";

std::size_t holesOf(const model::Document& board) {
    return static_cast<std::size_t>(
        std::ranges::count_if(board.elements.flags, [](std::uint8_t flags) { return (flags & model::kHole) != 0; }));
}

}  // namespace

class GerberDialectsTest : public QObject {
    Q_OBJECT

private slots:
    void theLowestCopperIsNotCalledInner() {
        const Job job({{"art001.pho", image(kCopper)}, {"art002.pho", image(kCopper)}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QVERIFY((*board)->findLayer("bottom copper 2").isValid());
        QVERIFY(isReported(**board, "taken as bottom copper 2"));
    }

    /// Allegro keeps what it wrote before as "top.art,1".
    void olderVersionsAreNotRead() {
        const Job job({{"Top.art", image(kCopper)},
                       {"Top.art,1", image(kCopper)},
                       {"Top.art,2", image(kCopper)},
                       {"bottom.art", image(kCopper)},
                       {"b.drl", kDrills},
                       {"b.drl,1", kDrills}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QCOMPARE(std::ranges::count((*board)->layers, model::LayerType::Signal, &model::Layer::type), 2);
        QCOMPARE(std::ranges::count((*board)->layers, model::LayerType::Drill, &model::Layer::type), 1);
        QVERIFY(isReported(**board, "n older version of Top.art"));
        const Job alone({{"top.art,1", image(kCopper)}});
        QVERIFY(alone.open().ok());
    }

    /// Boards in large drawings: 1.5 m to the right of the origin.
    void jobsThatLieFarOutAreMoved() {
        const std::string copper =
            "%ADD10C,1.5*%D10*X1502000000Y2000000D03*X1508000000D03*Y8000000D03*X1502000000D03*X1505000000D03*\n";
        const std::string drills = "M48\nMETRIC\nT1C0.8\n%\nT1\nX1502.0Y2.0\nX1508.0Y2.0\nX1508.0Y8.0\nM30\n";
        const Job job({{"b.GTL", image(copper)}, {"b.GBL", image(copper)}, {"b.drl", drills}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QVERIFY(isReported(**board, "moved by -1500, 0 mm"));
        QVERIFY(!isReported(**board, "eft out"));
        QCOMPARE((*board)->board.min.x, 1'250'000);
        QCOMPARE(holesOf(**board), std::size_t{3});
    }

    /// Proteus draws the edge of the board in a file of drills without plating.
    void theEdgeOfTheBoardIsNoSlot() {
        const std::string edge =
            "%TA.AperFunction,Profile*%%ADD10C,0.2*%%TD*%D10*X0Y0D02*X10000000D01*Y10000000D01*X0D01*Y0D01*\n";
        const Job job({{"top.gbr", image(kWideCopper, "Copper,L1,Top")},
                       {"bottom.gbr", image(kWideCopper, "Copper,L2,Bot")},
                       {"mechanical 1.gbr", image(edge, "NonPlated,1,2,NPTH")}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QCOMPARE(holesOf(**board), std::size_t{0});
        QCOMPARE((*board)->board, (model::Box{{0, 0}, {10'000'000, 10'000'000}}));
    }

    void theMaskThatTellsNoSideIsTheOtherOne() {
        const auto sideOf = [](const Files& files) {
            const Board board = Job(files).open();
            const auto layer = board.ok() ? (*board)->findLayer("b_soldermask") : model::LayerId();
            return layer.isValid() ? (*board)->layer(layer).side : model::LayerSide::Inner;
        };
        const std::string mask = image(kCopper, "Soldermask,Top");
        const Files two = {
            {"b_top.gbr", image(kCopper)}, {"a_mask_top.gbr", mask}, {"b_soldermask.gbr", image(kCopper)}};
        QCOMPARE(static_cast<int>(sideOf(two)), static_cast<int>(model::LayerSide::Bottom));
    }

    void wordsOfOneFileAreNoBoard() {
        const Job job({{"TOP.gbr", image(kCopper, "Copper,L1,Top")},
                       {"PAST_TOP.gbr", image(kCopper, "Paste,Top")},
                       {"PAST_BOT.gbr", image(kCopper, "Paste,Bot")},
                       {"SOLD_TOP.gbr", image(kCopper, "Soldermask,Top")}});
        const Board board = job.open();
        QVERIFY(board.ok());
        for (const char* name : {"TOP", "PAST_TOP", "PAST_BOT", "SOLD_TOP"}) {
            QVERIFY2(std::ranges::find((*board)->layers, name, &model::Layer::name) != (*board)->layers.end(), name);
        }
    }

    /// "GND2" may be the second ground; where the numbers of all are places of their own, they are meant so.
    void numbersInNamesOrderInnerLayers() {
        const auto film = [](const std::string& etch) { return "G04 Layer:  ETCH/" + etch + "*\n" + image(kCopper); };
        const auto copperOf = [&](const std::vector<std::string>& inner) {
            Files files = {{"TOP.art", film("TOP")}, {"BOTTOM.art", film("BOTTOM")}};
            for (const std::string& name : inner) {
                files[name + ".art"] = film(name);
            }
            const Board board = Job(files).open();
            std::string order;
            for (const model::Layer& layer : board.ok() ? (*board)->layers : std::vector<model::Layer>()) {
                order += layer.type == model::LayerType::Signal ? layer.name + " " : "";
            }
            const bool isNumbered = board.ok() && isReported(**board, "by the number in it");
            return QString::fromStdString(order + (isNumbered ? "numbered" : "by name"));
        };
        QCOMPARE(copperOf({"GND2", "SIG03", "SIG04", "GND5"}), QString("TOP GND2 SIG03 SIG04 GND5 BOTTOM numbered"));
        QCOMPARE(copperOf({"SIG3", "GND2"}), QString("TOP GND2 SIG3 BOTTOM numbered"));
        QCOMPARE(copperOf({"SIG1", "GND2"}), QString("TOP GND2 SIG1 BOTTOM by name"));
        QCOMPARE(copperOf({"SIG", "GND3"}), QString("TOP GND3 SIG BOTTOM by name"));
    }

    /// gEDA numbers groups of layers, of which one may hold jumpers; numbers of Eagle need not follow each other.
    void innerCopperBehindAGapIsDoubted() {
        const auto warningOn = [](const std::vector<std::string>& inner) {
            Files files = {{"amp.top.gbr", image(kCopper)}, {"amp.bottom.gbr", image(kCopper)}};
            for (const std::string& name : inner) {
                files[name] = image(kCopper);
            }
            const Board board = Job(files).open();
            std::string warning;
            for (const auto& entry : board.ok() ? (*board)->diagnostics.entries() : std::vector<model::Diagnostic>()) {
                const bool isIt = entry.severity == model::Severity::Warning &&
                                  entry.text.find("order of copper layers is doubtful") != std::string::npos;
                warning += isIt ? entry.file + ": " + entry.text.substr(0, entry.text.find(':')) : "";
            }
            return QString::fromStdString(board.ok() ? warning : "not opened");
        };
        QCOMPARE(warningOn({"amp.group3.gbr"}),
                 "amp.group3.gbr: The file is taken as inner copper 3, but no file as inner copper 2");
        QCOMPARE(warningOn({"amp.G1", "amp.G3"}),
                 "amp.G3: The file is taken as inner copper 3, but no file as inner copper 2");
        QCOMPARE(warningOn({"amp.group2.gbr", "amp.group3.gbr"}), QString());
        QCOMPARE(warningOn({"amp.G1", "amp.G2"}), QString());
        QCOMPARE(warningOn({"amp.G2L", "amp.G15L"}), QString());
    }

    /// Internal planes of Protel and Altium draw what is left out, unless their attribute says otherwise.
    void internalPlanesAreNegative() {
        const auto isNegative = [](const std::string& polarity) {
            const std::string plane = polarity + image("%ADD10C,1*%D10*X5000000Y5000000D03*");
            const Job job({{"b.GTL", image(kWideCopper)},
                           {"b.GP1", plane},
                           {"b.GBL", image(kWideCopper)},
                           {"b.GKO", image(kOutline)}});
            const Board board = job.open();
            return board.ok() && std::ranges::any_of((*board)->layers, &model::Layer::isNegative);
        };
        QVERIFY(isNegative(""));
        QVERIFY(isNegative("%TF.FilePolarity,Negative*%"));
        QVERIFY(!isNegative("%TF.FilePolarity,Positive*%"));
    }

    /// Layers that users add to their designs are often called by their side, as copper may be.
    void namesWithASideOnlyAreDrawingsBesideNamedCopper() {
        const auto copperOf = [](const Files& files) {
            const Board board = Job(files).open();
            return board.ok() ? std::ranges::count((*board)->layers, model::LayerType::Signal, &model::Layer::type) : 0;
        };
        const Files notes = {{"x_NOTES_TOP.gbr", image(kCopper)}, {"x_NOTES_BOTTOM.gbr", image(kCopper)}};
        QCOMPARE(copperOf(notes), 2);
        Files files = notes;
        files["x_Copper_Top.gbr"] = image(kCopper);
        files["x_Copper_Bottom.gbr"] = image(kCopper);
        QCOMPARE(copperOf(files), 2);
        files = notes;
        files["x.GTL"] = image(kCopper);
        files["x.GBL"] = image(kCopper);
        QCOMPARE(copperOf(files), 2);
        const Files pads = {
            {"art001.pho", image(kCopper)}, {"art002.pho", image(kCopper)}, {"chk_bot.pho", image(kCopper)}};
        QCOMPARE(copperOf(pads), 2);
        const Files names = {{"Top.gbr", image(kCopper)}, {"Ln1_Cu.gbr", image(kCopper)}, {"Bot.gbr", image(kCopper)}};
        QCOMPARE(copperOf(names), 3);
    }

    /// "b_dimension" is the outline of Eagle, and of others a drawing with dimensions.
    void aNamedOutlineBesideThePadsYieldsToADrawingAroundThem() {
        const std::string boxes =
            "%ADD10C,0.1*%D10*X500000Y500000D02*X3000000D01*Y3000000D01*X500000D01*Y500000D01*"
            "X500000Y5000000D02*X6000000D01*Y9500000D01*X500000D01*Y5000000D01*";
        const Job job({{"b.GTL", image(kWideCopper)},
                       {"b.GBL", image(kWideCopper)},
                       {"x_DIMENSION.gbr", image(boxes)},
                       {"x_Mechanical_1.gbr", image(kOutline)}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QCOMPARE((*board)->board, (model::Box{{0, 0}, {10'000'000, 10'000'000}}));
        QVERIFY(isReported(**board, "does not enclose all pads"));
    }

    /// What is wrong with the named file is said although a drawing has the outline.
    void aNamedOutlineThatIsOpenYieldsToADrawingAroundTheCopper() {
        const std::string open = "%ADD10C,0.1*%D10*X0Y0D02*X10000000D01*X0Y10000000D02*X10000000D01*";
        const Job job({{"b.GTL", image(kWideCopper)},
                       {"b.GBL", image(kWideCopper)},
                       {"b.GKO", image(open)},
                       {"x_Mechanical_1.gbr", image(kOutline)}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QCOMPARE((*board)->board, (model::Box{{0, 0}, {10'000'000, 10'000'000}}));
        QVERIFY(isReported(**board, "draws no closed loop of its size; taken from this one"));
        QVERIFY(isReported(**board, "do not close"));
    }

    /// Films of negative planes have frames of drawings around them.
    void negativesDoNotTellHowLargeABoardIs() {
        const std::string plane =
            "G04 Layer:  ETCH/GND*\nG04 Mode:      Negative*\n" +
            image("%ADD10C,1*%D10*X5000000Y5000000D03*X-60000000Y-60000000D02*X90000000D01*Y90000000D01*");
        const Job job({{"b.GTL", image(kWideCopper)},
                       {"gnd.art", plane},
                       {"b.GBL", image(kWideCopper)},
                       {"b.GKO", image(kOutline)}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QCOMPARE((*board)->board, (model::Box{{0, 0}, {10'000'000, 10'000'000}}));
    }

    /// Tables of fixed width: names of columns with blanks, and values and packages with blanks.
    void placesAreReadFromTablesWithBlanks_data() {
        QTest::addColumn<QString>("table");
        QTest::newRow("Altium")
            << "Designator Footprint      Mid X     Mid Y     Ref X     Ref Y TB  Rotation Comment\n\n"
               "R1         RES 0402         5mm       2mm       1mm       1mm  T     90.00 220uF, 4V\n"
               "R2         RES0402          3mm       4mm       1mm       1mm  B      0.00\n";
        QTest::newRow("Allegro") << "UUNITS = MICRONS\n"
                                    "R1                   5000.0        2000.0       90    RES0402\n"
                                    "R2                   3000.0        4000.0        0  m RES0402\n";
        QTest::newRow("gEDA") << "# PcbXY Version 1.0\n# RefDes, Description, Value, X, Y, rotation, top/bottom\n"
                                 "# X,Y in mils.  rotation in degrees.\n# ----------\n"
                                 "R1,\"0402\",\"10k\",196.85039,78.74016,90,top\n"
                                 "R2,\"0402\",\"1k\",118.11024,157.48031,0,bottom\n";
        QTest::newRow("DesignSpark") << "Units:          thou (precision 0)\n\n"
                                        "Name      Component    Side     Centre X    Centre Y  Rotation\n"
                                        "--------------------------------------------------------------\n"
                                        "R1        R 10k        Top     196.85039    78.74016     90.00\n"
                                        "R2        R            Bottom  118.11024   157.48031      0.00\n";
    }
    void placesAreReadFromTablesWithBlanks() {
        QFETCH(QString, table);
        model::Diagnostics diagnostics;
        const auto file = model::gerber::parsePlacements(table.toStdString(), "places.txt", diagnostics);
        QVERIFY(diagnostics.entries().empty());
        QCOMPARE(file.parts.size(), std::size_t{2});
        QCOMPARE(file.parts[0].refdes, std::string("R1"));
        QVERIFY(file.saysUnit);
        QCOMPARE(model::rounded(file.parts[0].position), (model::Point{5'000'000, 2'000'000}));
        QCOMPARE(file.parts[0].rotationDeg, 90.0);
        QCOMPARE(model::rounded(file.parts[1].position), (model::Point{3'000'000, 4'000'000}));
        QVERIFY(file.parts[1].side == model::LayerSide::Bottom);
        QVERIFY(!file.parts[0].value.empty() || !file.parts[0].package.empty());
    }

    void aRowOfVeryManyWordsTakesNoTime() {
        std::string row = "R1 R";
        for (int i = 0; i < 2'000'000; ++i) {  // an hour, if words are taken out one by one
            row += " x";
        }
        model::Diagnostics diagnostics;
        const auto file = model::gerber::parsePlacements("Ref Val X(mm) Y(mm) Rot Side\n" + row + " 5 2 90 Top\n",
                                                         "places.txt", diagnostics);
        QCOMPARE(file.parts.size(), std::size_t{1});
        QCOMPARE(file.parts[0].value.size(), std::size_t{4'000'001});
        QCOMPARE(file.parts[0].rotationDeg, 90.0);
    }

    /// Allegro fills lines with blanks, the empty first one too, and lists each padstack of a board in a comment.
    void netlistsAreFoundBehindAnyNumberOfComments() {
        std::string netlist = std::string(78, ' ') + "\n";
        for (int i = 0; i < 400; ++i) {
            netlist += "C  PAD" + std::to_string(i) + "               TOP       BOTTOM\n";
        }
        netlist += "P  TOL    0 1 000001 000001\n" + kNetlist;
        const Job job({{"b.GTL", image(kCopper)}, {"b.GBL", image(kCopper)}, {"ipc.txt", netlist}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QVERIFY(std::ranges::find((*board)->nets, "SUPPLY", &model::Net::name) != (*board)->nets.end());
        QVERIFY(isReported(**board, "does not say its unit (P UNITS); taken as 0.0001 inch"));
        QVERIFY(!isReported(**board, "nets follow from the copper"));
        QCOMPARE((*board)->components.size(), std::size_t{1});
    }

    /// Reports of Allegro and others give numbers alone. Taken as mm, most of these would lie beyond any board.
    void unitsOfPlacesAreThoseThatLayThemOnTheirPins_data() {
        QTest::addColumn<double>("nmPerUnit");
        QTest::addColumn<double>("origin");
        QTest::addColumn<QString>("unit");
        QTest::newRow("mm") << 1e6 << 0.0 << "taken as mm";
        QTest::newRow("mil") << 25.4e3 << 0.0 << "taken as mil";
        QTest::newRow("inch") << 25.4e6 << 0.0 << "taken as inch";
        QTest::newRow("mil, from another origin") << 25.4e3 << 9e8 << "taken as mil";
    }
    void unitsOfPlacesAreThoseThatLayThemOnTheirPins() {
        QFETCH(double, nmPerUnit);
        QFETCH(double, origin);
        QFETCH(QString, unit);
        std::string copper = "%ADD10C,0.5*%D10*";
        std::string netlist = "P  UNITS CUST 1\n";
        std::string table = "REFDES,COMP_VALUE,SYM_X,SYM_Y,SYM_ROTATE,SYM_MIRROR\n";
        for (const int part : {1, 2, 3, 4}) {
            const int middle = part * part * 5;  // mm, in x and y
            for (const int pin : {1, 2}) {
                const int x = middle * 1'000 - 1'500 + pin * 1'000;  // um
                copper += "X" + std::to_string(x) + "000Y" + std::to_string(middle) + "000000D03*";
                std::array<char, 81> record{};
                (void)std::snprintf(record.data(), record.size(),
                                    "327NET%d%d            R%d    -%d          A01X+%06dY+%06dX0500Y0000R000 S0\n",
                                    part, pin, part, pin, x, middle * 1'000);
                netlist += record.data();
            }
            const std::string place = std::to_string((middle * 1e6 + origin) / nmPerUnit);
            table += "R" + std::to_string(part) + ",10K," + place + "," + place + ",90.000,NO\n";
        }
        const Job job(
            {{"b.GTL", image(copper)}, {"b.GBL", image(kCopper)}, {"b.ipc", netlist + "999\n"}, {"placed.txt", table}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QVERIFY(isReported(**board, "he table of places does not say its unit; " + unit.toStdString()));
        QCOMPARE((*board)->components.size(), std::size_t{4});
        const model::Point at = (*board)->components[3].placement.origin;
        QVERIFY(std::abs(at.x - 80'000'000) < 100 && std::abs(at.y - 80'000'000) < 100);
    }

    /// Eagle's lists name neither columns nor unit; their endings are the sides.
    void partsToMountLieOnTheSideOfTheirList() {
        const std::string pads = "%ADD10C,0.5*%D10*X5000000Y2000000D03*X3000000Y4000000D03*X8000000Y8000000D03*";
        const Job job({{"b.GTL", image(pads)},
                       {"b.GBL", image(pads)},
                       {"b.mnt", "R1 5.00 2.00  90 10k R0402\nC3 8.00 8.00 0 100nF 16V C0603\n"},
                       {"b.mnb", "R2 3.00 4.00 180  R0402\n"}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QCOMPARE((*board)->components.size(), std::size_t{3});
        const auto part = [&](const std::string& refdes) {
            return *std::ranges::find((*board)->components, refdes, &model::Component::refdes);
        };
        QCOMPARE(part("R1").placement.origin, (model::Point{5'000'000, 2'000'000}));
        QVERIFY(part("R1").side == model::LayerSide::Top && part("R2").side == model::LayerSide::Bottom);
        QCOMPARE(part("R1").part, std::string("10k"));
        QVERIFY(isReported(**board, "he table of places does not say its unit; taken as mm"));
    }

    /// A folder within may hold what the images were made of.
    void aFolderWithinIsAnotherBoardWhereItsLayersAreThereTwice() {
        const Job job({{"b-L1-copper-top.gtl", image(kCopper)},
                       {"b-L2-plane.g1", image(kCopper, "Copper,L2,Inr")},
                       {"b-L3-copper.g2", image(kCopper)},
                       {"b-L4-copper-bottom.gbl", image(kCopper)},
                       {"parts/b-L2-clearances.gbr", image(kCopper)},
                       {"parts/b-L2A-pads.gbr", image(kCopper)}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QCOMPARE(std::ranges::count((*board)->layers, model::LayerType::Signal, &model::Layer::type), 4);
        QVERIFY(!isReported(**board, "claims the same copper layer"));
        QVERIFY(!isReported(**board, "but no file draws copper layer"));
    }
};

QTEST_APPLESS_MAIN(GerberDialectsTest)
#include "gerber_dialects_test.moc"
