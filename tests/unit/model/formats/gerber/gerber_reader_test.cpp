// Whole jobs: written into a folder and opened as any board is.

#include "model/formats/gerber/gerber_reader.h"

#include <QtTest>
#include <algorithm>

#include "model/nets/net_inference.h"
#include "tests/unit/model/formats/gerber/gerber_testing.h"

using namespace gerber_testing;

namespace {

std::size_t holesOf(const model::Document& board) {
    return static_cast<std::size_t>(
        std::ranges::count_if(board.elements.flags, [](std::uint8_t flags) { return (flags & model::kHole) != 0; }));
}

std::vector<std::string> namesOf(const model::Document& board) {
    std::vector<std::string> names;
    for (const model::Net& net : board.nets) {
        names.push_back(net.name);
    }
    std::ranges::sort(names);
    return names;
}

}  // namespace

class GerberReaderTest : public QObject {
    Q_OBJECT

private slots:
    void theJobsUnitIsThatOfMostDrawings() {
        const auto unitOf = [](const std::string& top, const std::string& bottom) {
            const auto drawing = [](const std::string& unit) {
                return "%MO" + unit + "*%%FSLAX26Y26*%%ADD10C,0.02*%D10*X1000000Y1000000D03*X2000000Y2000000D03*M02*";
            };
            const Job job(
                {{"b.gtl", drawing(top)}, {"b.gbl", drawing(bottom)}, {"b.gto", drawing("IN")}, {"b.drl", kDrills}});
            const Board board = job.open();
            return board.ok() ? (*board)->job.units : std::string("not read");
        };
        QCOMPARE(unitOf("IN", "IN"), std::string("INCH"));
        QCOMPARE(unitOf("IN", "MM"), std::string("INCH"));
        QCOMPARE(unitOf("MM", "MM"), std::string("MM"));
    }

    void aFolderIsABoard() {
        const Job job({{"b-F_Cu.gtl", image(kNamedCopper, "Copper,L1,Top")},
                       {"b-B_Cu.gbl", image(kNamedCopper, "Copper,L2,Bot")},
                       {"b-Edge_Cuts.gm1", image(kOutline, "Profile,NP")},
                       {"b-PTH.drl", kDrills}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QCOMPARE((*board)->board, (model::Box{{0, 0}, {10'000'000, 10'000'000}}));
        QCOMPARE(namesOf(**board), (std::vector<std::string>{"A", "B"}));
        QCOMPARE(holesOf(**board), std::size_t{3});
        QCOMPARE((*board)->components.size(), std::size_t{1});
        QCOMPARE((*board)->components[0].pinCount, 3U);
        QCOMPARE((*board)->components[0].mount, model::MountType::ThroughHole);
        for (std::size_t row = 0; row < (*board)->elements.size(); ++row) {
            if (((*board)->elements.flags[row] & model::kHole) != 0) {
                QVERIFY((*board)->elements.net[row].isValid());
                QVERIFY(((*board)->elements.flags[row] & model::kPlated) != 0);
            }
        }
        QVERIFY(isReported(**board, "no file places the components") ||
                isReported(**board, "No file places the components"));
    }

    void withoutNamesNetsFollowFromTheCopper() {
        const Job job({{"b.GTL", image(kCopper)}, {"b.GBL", image(kCopper)}, {"b.GKO", image(kOutline)}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QVERIFY(isReported(**board, "nets follow from the copper"));
        QCOMPARE((*board)->nets.size(), std::size_t{4});  // no holes: a joined pair and a pad on each side
        QVERIFY(isReported(**board, "by its name"));
        QVERIFY(isReported(**board, "nothing joins its 2 copper layers"));
        QVERIFY(model::areNetsOfCopper(**board));
    }

    void holesWithoutPlatingJoinNothing() {
        const auto reports = [](const std::string& drillFile, const std::string& drills) {
            const Job job({{"b-F_Cu.gtl", image(kNamedCopper, "Copper,L1,Top")},
                           {"b-B_Cu.gbl", image(kNamedCopper, "Copper,L2,Bot")},
                           {"b-Edge_Cuts.gm1", image(kOutline, "Profile,NP")},
                           {drillFile, drills}});
            const Board board = job.open();
            return board.ok() &&
                   isReported(**board, "a hole that may be plated, and nothing joins its 2 copper layers");
        };
        QVERIFY(reports("b-NPTH.drl", kDrills));
        QVERIFY(reports("b-PTH.drl", "M48\nMETRIC\nT1C0.8\n%\nM30\n"));
        QVERIFY(!reports("b-PTH.drl", kDrills));
    }

    void onlyBoardsOfSeveralCopperLayersMissTheirDrills() {
        const Job single({{"b.GTL", image(kCopper)}, {"b.GKO", image(kOutline)}});
        const Board one = single.open();
        QVERIFY(one.ok() && !isReported(**one, "drills is there"));
        const Job drilled({{"b.GTL", image(kCopper)}, {"b.GBL", image(kCopper)}, {"b.drl", kDrills}});
        const Board two = drilled.open();
        QVERIFY(two.ok() && !isReported(**two, "drills is there"));
    }

    void aNetlistNamesTheNetsWhereverItCountsFrom() {
        // 10 mm to the right and 10 mm up of the images.
        const std::string netlist =
            "P  UNITS CUST 0\n"
            "317SUPPLY           J1    -1    D0315PA00X+004724Y+004724X0591Y0000R000S3\n"
            "317SUPPLY           J1    -2    D0315PA00X+007087Y+004724X0591Y0000R000S3\n"
            "317OTHER            J1    -3    D0315PA00X+007087Y+007087X0591Y0000R000S3\n999\n";
        const Job job({{"b.GTL", image(kCopper)},
                       {"b.GBL", image(kCopper)},
                       {"b.GKO", image(kOutline)},
                       {"b.drl", kDrills},
                       {"b.ipc", netlist}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QVERIFY(isReported(**board, "another origin"));
        QCOMPARE(namesOf(**board), (std::vector<std::string>{"OTHER", "SUPPLY"}));
        QCOMPARE((*board)->components.size(), std::size_t{1});
        QCOMPARE((*board)->components[0].pinCount, 3U);
    }

    void aNetlistNamesPadsThatAreNotFlashedByTheirMiddle() {
        // The first pad is 2 mm to the right of where it is flashed, and the point in its middle; the last point lies
        // on two pads.
        const std::string copper =
            "%AMASIDE*21,1,2,1,2,0,0*%%ADD10ASIDE*%%ADD11C,1.5*%%ADD12R,3X3*%D10*X2000000Y2000000D03*D11*"
            "X8000000D03*Y8000000D03*D12*X2000000D03*X1500000Y8500000D03*";
        const std::string netlist =
            "P  UNITS CUST 1\n"
            "327A                J1    -1          A01X+004000Y+002000X2000Y1000R000S3\n"
            "327B                J1    -2          A01X+008000Y+002000X1500Y0000R000S3\n"
            "327C                J1    -3          A01X+008000Y+008000X1500Y0000R000S3\n"
            "327D                J1    -4          A01X+001200Y+008200X0100Y0000R000S3\n999\n";
        const Job job({{"b.GTL", image(copper)}, {"b.GKO", image(kOutline)}, {"b.ipc", netlist}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QVERIFY((*board)->findNet("A").isValid());
        QCOMPARE((*board)->components.size(), std::size_t{1});
        QCOMPARE((*board)->components[0].pinCount, 3U);
        QVERIFY(isReported(**board, "1 of 4 netlist points"));
    }

    /// A plane of 400,000 corners with 900 points on pads and as many beside them.
    void pointsOverLargePlanesFindTheirNet() {
        std::string copper = "%ADD10C,0.2*%D10*G36*X0Y0D02*G01*X20000000D01*Y19000000D01*";
        for (int i = 400'000; i > 0; --i) {
            copper += "X" + std::to_string(i * 50) + "Y" + (i % 2 == 0 ? "19000000" : "19400000") + "D01*\n";
        }
        copper += "X0Y19000000D01*Y0D01*G37*\n";
        std::string netlist = "P  UNITS CUST 1\n";
        for (int i = 0; i < 900; ++i) {
            const int x = 1000 + i % 30 * 600;
            const int y = 1000 + i / 30 * 600;
            copper += "X" + std::to_string(x * 1000) + "Y" + std::to_string(y * 1000) + "D03*\n";
            for (const int beside : {0, 300}) {
                netlist += QString::asprintf("327PLANE           J1    -%-4d       A01X+%06dY+%06dX0200Y0000R000S3\n",
                                             i + 1, x + beside, y)
                               .toStdString();
            }
        }
        const Job job({{"b.GTL", image(copper)}, {"b.GKO", image(kOutline)}, {"b.ipc", netlist + "999\n"}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QVERIFY((*board)->findNet("PLANE").isValid());
    }

    void drillsAreReadAsTheyFitTheCopper() {
        // Says inch, means mm.
        const std::string drills = "M48\nINCH\nT1C0.8\n%\nT1\nX2.0Y2.0\nX8.0Y2.0\nX8.0Y8.0\nM30\n";
        const Job job({{"b.GTL", image(kCopper)}, {"b.GBL", image(kCopper)}, {"b.drl", drills}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QVERIFY(isReported(**board, "which puts the holes on the copper"));
        const auto hole = std::ranges::find_if((*board)->elements.flags,
                                               [](std::uint8_t flags) { return (flags & model::kHole) != 0; });
        QVERIFY(hole != (*board)->elements.flags.end());
        const auto row = static_cast<std::size_t>(hole - (*board)->elements.flags.begin());
        QCOMPARE((*board)->circles[(*board)->elements.geometry[row]].centre, (model::Point{2'000'000, 2'000'000}));
    }

    void boardsOfOneFolderAreToldApart() {
        const Job job({{"one.top.gbr", image(kCopper)},
                       {"one.bottom.gbr", image(kCopper)},
                       {"two.bottom.gbr", image(kCopper)},
                       {"two.drl", kDrills}});
        const Board first = job.open();
        QVERIFY(first.ok());
        QCOMPARE((*first)->job.step, std::string("ONE"));
        QCOMPARE((*first)->job.steps, (std::vector<std::string>{"ONE", "TWO"}));
        QCOMPARE(holesOf(**first), std::size_t{0});
        QVERIFY(isReported(**first, "several boards"));
        const Board second = job.open("", {"two", false});
        QVERIFY(second.ok());
        QCOMPARE(holesOf(**second), std::size_t{3});
        const Board none = job.open("", {"three", false});
        QVERIFY(!none.ok());
        QCOMPARE(none.error().code, base::ErrorCode::BadUsage);
    }

    void twoFilesForOneLayerAreBothShown() {
        const Job job({{"b.GTL", image(kCopper)},
                       {"b-F_Cu.GTL", image(kCopper, "Copper,L1,Top")},
                       {"x/b.GTL", "no"},
                       {"b.GBL", image(kCopper)}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QVERIFY(isReported(**board, "no part of a Gerber job"));
    }

    void aJobFileTellsTheStackup() {
        const std::string jobFile =
            R"({"GeneralSpecs": {"ProjectId": {"Name": "proj"}, "BoardThickness": 0.8}, "FilesAttributes": [
            {"Path": "x1.gbr", "FileFunction": "Copper,L1,Top"}, {"Path": "x2.gbr", "FileFunction": "Copper,L2,Bot"}],
            "MaterialStackup": [{"Type": "Copper", "Thickness": 0.018, "Name": "F.Cu"},
            {"Type": "Dielectric", "Thickness": 0.764, "Material": "FR4", "Name": "core"},
            {"Type": "Copper", "Thickness": 0.018, "Name": "B.Cu"}]})";
        const Job job({{"x1.gbr", image(kCopper)}, {"x2.gbr", image(kCopper)}, {"b-job.gbrjob", jobFile}});
        for (const char* name : {"", "b-job.gbrjob"}) {
            const Board board = job.open(name);
            QVERIFY(board.ok());
            QCOMPARE((*board)->job.name, std::string("proj"));
            QCOMPARE((*board)->boardThickness, 800'000);
            QVERIFY((*board)->findLayer("core").isValid());
            QCOMPARE((*board)->layer((*board)->findLayer("F.Cu")).thickness, 18'000);
        }
    }

    void layersThatJobFilesNameAsTheirFilesKeepTheName() {
        const std::string jobFile =
            R"({"FilesAttributes": [
            {"Path": "b-top.gbr", "FileFunction": "Copper,L1,Top"}, {"Path": "b-low.gbr", "FileFunction": "Copper,L2,Bot"}],
            "MaterialStackup": [{"Type": "Copper", "Thickness": 0.018, "Name": "top"},
            {"Type": "Dielectric", "Thickness": 0.764}, {"Type": "Copper", "Thickness": 0.018}]})";
        const Job job({{"b-top.gbr", image(kCopper)}, {"b-low.gbr", image(kCopper)}, {"b-job.gbrjob", jobFile}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QVERIFY((*board)->findLayer("top").isValid());
        QVERIFY(!(*board)->findLayer("top (2)").isValid());
        QCOMPARE((*board)->layer((*board)->findLayer("top")).thickness, 18'000);
    }

    void aJobFileTellsTheColours() {
        const std::string jobFile =
            R"({"GeneralSpecs": {"ProjectId": {"Name": "proj"}}, "MaterialStackup": [
            {"Type": "Legend", "Color": "Black", "Name": "silk"},
            {"Type": "SolderMask", "Color": "Blue", "Material": "Ink", "Thickness": 0.01, "Name": "mask"},
            {"Type": "Copper", "Thickness": 0.018, "Color": "Red", "Name": "F.Cu"}]})";
        const Job job({{"b.GTL", image(kCopper)},
                       {"b.GTS", image(kCopper)},
                       {"b.GTO", image(kCopper)},
                       {"b-job.gbrjob", jobFile}});
        const Board board = job.open();
        QVERIFY(board.ok());
        const auto materialOf = [&](model::LayerType type) {
            for (const model::StackupRow& row : (*board)->stackup.rows) {
                if ((*board)->layer(row.layer).type == type) {
                    return row.material.name;
                }
            }
            return std::string("none");
        };
        QCOMPARE(materialOf(model::LayerType::SolderMask), std::string("Ink, Blue"));
        QCOMPARE(materialOf(model::LayerType::SilkScreen), std::string("Black"));
        QCOMPARE(materialOf(model::LayerType::Signal), std::string());
    }

    void pickAndPlaceFilesPlaceComponents() {
        const Job job({{"b-F_Cu.gtl", image(kNamedCopper, "Copper,L1,Top")},
                       {"b-B_Cu.gbl", image(kNamedCopper, "Copper,L2,Bot")},
                       {"b-pos.csv", "Ref,Val,Package,PosX,PosY,Rot,Side\n\"J1\",\"CON\",\"HDR\",5.0,5.0,90.0,top\n"}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QCOMPARE((*board)->components[0].part, std::string("CON"));
        QCOMPARE((*board)->components[0].placement.origin, (model::Point{5'000'000, 5'000'000}));
        QCOMPARE((*board)->components[0].placement.clockwiseDeg, 270.0);
        QCOMPARE((*board)->packages[0].name, std::string("HDR"));
    }

    void aDesignatorThatIsPlacedTwiceIsTold() {
        const auto told = [](const std::string& rows) {
            const Job job({{"b-F_Cu.gtl", image(kNamedCopper, "Copper,L1,Top")},
                           {"b-B_Cu.gbl", image(kNamedCopper, "Copper,L2,Bot")},
                           {"b-pos.csv", "Ref,Val,Package,PosX,PosY,Rot,Side\n" + rows}});
            const Board board = job.open();
            return board.ok() && std::ranges::any_of((*board)->diagnostics.entries(), [](const auto& entry) {
                       return entry.text.starts_with("Two components have one designator");
                   });
        };
        QVERIFY(told("J1,CON,HDR,5.0,5.0,90.0,top\nJ1,CON,HDR,8.0,5.0,90.0,top\n"));
        QVERIFY(!told("J1,CON,HDR,5.0,5.0,90.0,top\nJ2,CON,HDR,8.0,5.0,90.0,top\n"));
    }

    /// Rotated by 30° on the bottom: KiCad and X3 flip a part along the x axis, other programs along the y axis, which
    /// is half a turn more or less.
    void partsOnTheBottomAreRotatedAsTheirFileMeansIt_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<QString>("text");
        QTest::addColumn<double>("clockwiseDeg");
        QTest::newRow("KiCad, CSV") << "b-pos.csv"
                                    << "Ref,Val,Package,PosX,PosY,Rot,Side\nJ1,CON,HDR,5.0,5.0,30.0,bottom\n"
                                    << 210.0;
        QTest::newRow("KiCad, text") << "b-bottom.pos"
                                     << "## Unit = mm, Angle = deg.\n# Ref Val Package PosX PosY Rot Side\n"
                                        "J1 CON HDR 5.0 5.0 30.0 bottom\n"
                                     << 210.0;
        QTest::newRow("X3") << "b-pnp_bottom.gbr"
                            << "%TF.FileFunction,Component,L2,Bot*%%FSLAX46Y46*%%MOMM*%%TA.AperFunction,"
                               "ComponentMain*%%ADD10C,0.3*%%TO.C,J1*%%TO.CRot,30*%D10*X5000000Y5000000D03*M02*"
                            << 210.0;
        QTest::newRow("Eagle") << "b.csv"
                               << "Designator,Mid X,Mid Y,Rotation,Layer\nJ1,5.0,5.0,30.0,Bottom\n"
                               << 30.0;
    }
    void partsOnTheBottomAreRotatedAsTheirFileMeansIt() {
        QFETCH(QString, name);
        QFETCH(QString, text);
        QFETCH(double, clockwiseDeg);
        const Job job({{"b-F_Cu.gtl", image(kCopper, "Copper,L1,Top")},
                       {"b-B_Cu.gbl", image(kNamedCopper, "Copper,L2,Bot")},
                       {name.toStdString(), text.toStdString()}});
        const Board board = job.open();
        QVERIFY(board.ok());
        const model::Component& part = (*board)->components[0];
        QVERIFY(part.side == model::LayerSide::Bottom && part.placement.isMirrored);
        QCOMPARE(part.placement.origin, (model::Point{5'000'000, 5'000'000}));
        QCOMPARE(part.placement.clockwiseDeg, clockwiseDeg);
    }

    /// The place of J1 is 0.1 mm off the middle of its pins, which does not move the others.
    void placesFromAnotherOriginAreExact() {
        std::string copper = "%TA.AperFunction,SMDPad,CuDef*%%ADD10C,0.5*%%TD*%D10*";
        std::string table = "Ref,Val,Package,PosX,PosY,Rot,Side\n";
        for (const int part : {1, 2, 3}) {
            const std::string name = "J" + std::to_string(part);
            for (const int pin : {1, 2}) {
                copper += "%TO.P," + name + "," + std::to_string(pin) + "*%X" +
                          std::to_string(part * part * 2'000'000 + pin * 1'000'000) + "Y" +
                          std::to_string(part * 3'000'000) + "D03*";
            }
            const double x = part * part * 2.0 + 1.5 + (part == 1 ? 0.1 : 0.0);
            table += name + ",,," + std::to_string(x + 100.0) + "," + std::to_string(part * 3.0 - 50.0) + ",0,top\n";
        }
        const Job job({{"b-F_Cu.gtl", image(copper, "Copper,L1,Top")},
                       {"b-B_Cu.gbl", image(kCopper, "Copper,L2,Bot")},
                       {"b-pos.csv", table}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QVERIFY(isReported(**board, "places of components count from another origin") ||
                isReported(**board, "Places of components count from another origin"));
        QCOMPARE((*board)->components[0].placement.origin, (model::Point{3'600'000, 3'000'000}));
        QCOMPARE((*board)->components[1].placement.origin, (model::Point{9'500'000, 6'000'000}));
        QCOMPARE((*board)->components[2].placement.origin, (model::Point{19'500'000, 9'000'000}));
    }

    void partsThatNoFilePlacesLieInTheMiddleOfTheirPins() {
        const Job job(
            {{"b-F_Cu.gtl", image(kNamedCopper, "Copper,L1,Top")}, {"b-B_Cu.gbl", image(kCopper, "Copper,L2,Bot")}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QCOMPARE((*board)->components[0].placement.origin, (model::Point{5'000'000, 5'000'000}));
    }

    /// Zuken's names, and others that no CAD system has.
    void imagesAreFoundWhateverTheyAreCalled() {
        const Job zuken({{"Conductive-1.fph", image(kCopper)},
                         {"Conductive-2.fph", image(kCopper)},
                         {"Resist-A.fph", image(kCopper)}});
        const Board board = zuken.open();
        QVERIFY(board.ok());
        QCOMPARE((*board)->findLayer("Conductive-2").isValid(), true);
        const Job strange({{"one.abc", image(kCopper)}, {"two.abd", image(kCopper)}, {"notes.txt", "no board\n"}});
        QVERIFY(strange.open().ok());
        const Job none(Files{{"notes.abc", "no board\n"}});
        QVERIFY(!none.open().ok());
    }

    void aSingleImageIsABoard() {
        const Job job({{"alone.gbr", image(kCopper)}, {"alone.drl", kDrills}});
        const Board alone = job.open("alone.gbr");
        QVERIFY(alone.ok());
        QVERIFY((*alone)->layers[0].isCopper());
        QVERIFY(isReported(**alone, "taken as top copper"));
        const Board drills = job.open("alone.drl");
        QVERIFY(drills.ok());
        QCOMPARE(holesOf(**drills), std::size_t{3});
    }

    /// Drawings of Allegro begin with macros, which fill all that is looked at to tell what a file is.
    void anImageMayBeginWithManyMacros() {
        std::string macros;
        for (int i = 0; i < 400; ++i) {
            macros += "%AMM" + std::to_string(i) + "*1,1,1.5,0,0*%\n";
        }
        const Job job({{"drawing.art", std::string(kHead) + macros + "%ADD10M1*%D10*X0Y0D03*X5000000D03*M02*"}});
        QVERIFY(job.open("drawing.art").ok());
    }

    /// Programs draw outlines twice, in any direction.
    void outlinesMayBeDrawnThereAndBack() {
        const std::string twice = kOutline +
                                  "X0Y0D02*X0Y10000000D01*X0Y10000000D02*X10000000Y10000000D01*"
                                  "Y0D01*X10000000Y0D02*X0D01*\n";
        const Job job({{"b.GTL", image(kWideCopper)}, {"b.GKO", image(twice)}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QCOMPARE((*board)->board, (model::Box{{0, 0}, {10'000'000, 10'000'000}}));
        QVERIFY(!isReported(**board, "utline do not close"));
    }

    /// Wider than programs round. A circle within, which closes, is no board.
    void gapsOfTheOutlineAreClosedAndSaid() {
        const std::string open =
            "%ADD10C,0.1*%D10*X0Y0D02*X10000000D01*X10000000Y300000D02*Y10000000D01*X0D01*Y0D01*"
            "G75*G03*X5500000Y5000000D02*X5500000Y5000000I-500000J0D01*G01*\n";
        const Job job({{"b.GTL", image(kWideCopper)}, {"b.GKO", image(open)}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QCOMPARE((*board)->board, (model::Box{{0, 0}, {10'000'000, 10'000'000}}));
        QVERIFY(isReported(**board, "he board's outline is open by 0.30 mm at (10.00, 0.15) mm; a straight line"));
        QVERIFY(!isReported(**board, "utline do not close"));
    }

    void aFrameAroundTheBoardIsNoOutline() {
        const std::string frame =
            "X-5000000Y-5000000D02*X90000000D01*Y90000000D01*X-5000000D01*Y-5000000D01*"
            "X20000000Y20000000D02*X21000000D01*Y21000000D01*X20000000Y20000000D01*";
        const Job job({{"b.GTL", image(kCopper)}, {"b.GBL", image(kCopper)}, {"b.GKO", image(kOutline + frame)}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QCOMPARE((*board)->board, (model::Box{{0, 0}, {10'000'000, 10'000'000}}));
    }

    /// Allegro: the board is drawn on the fabrication film only, in a frame, with marks beside it on the copper.
    void aDrawingWithTheOutlineIsFoundBesideMarksOfFilms() {
        const std::string marks = "X-4000000Y-4000000D02*X-3000000D01*X14000000Y14000000D02*X15000000D01*";
        const std::string frame =
            "X-90000000Y-90000000D02*X90000000D01*Y90000000D01*X-90000000D01*Y-90000000D01*"
            "X40000000Y40000000D02*X80000000D01*Y80000000D01*X40000000D01*Y40000000D01*";
        const Job job({{"top.gtl", image(kWideCopper + marks)},
                       {"bottom.gbl", image(kWideCopper + marks)},
                       {"fab.gbr", image(kOutline + frame)}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QCOMPARE((*board)->board, (model::Box{{0, 0}, {10'000'000, 10'000'000}}));
        QVERIFY(isReported(**board, "named as the board's outline"));
    }

    /// Bodies of parts on assembly drawings are neither cut-outs nor islands.
    void partsOfADrawingAreNoCutouts() {
        const std::string parts =
            "X1000000Y1000000D02*X3000000D01*Y3000000D01*X1000000D01*Y1000000D01*"
            "X5000000Y5000000D02*X6000000D01*Y6000000D01*X5000000D01*Y5000000D01*"
            "X7000000Y-5000000D02*X9000000D01*Y9000000D01*X7000000D01*Y-5000000D01*";
        const Job job({{"top.gtl", image(kWideCopper)},
                       {"bottom.gbl", image(kWideCopper)},
                       {"assembly.gbr", image(kOutline + parts)}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QCOMPARE((*board)->board, (model::Box{{0, 0}, {10'000'000, 10'000'000}}));
        QCOMPARE((*board)->shapes.contoursOf((*board)->profile).size(), std::size_t{1});
    }

    /// OrCAD: every film draws the outline; no film is it. A pour around all pads that only copper draws is none.
    void theLoopThatFilmsDrawAlikeIsTheOutline() {
        const std::string pen = "%ADD15C,0.2*%D15*" + kOutline.substr(kOutline.find("X0Y0"));
        const Job job({{"top.gtl", image(kWideCopper + pen)},
                       {"bottom.gbl", image(kWideCopper + pen)},
                       {"mask.gts", image("%ADD10C,1.7*%D10*X2000000Y2000000D03*" + pen)}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QCOMPARE((*board)->board, (model::Box{{0, 0}, {10'000'000, 10'000'000}}));
        QVERIFY(isReported(**board, "draw alike"));

        const Job poured({{"top.gtl", image(kWideCopper + pen)},
                          {"bottom.gbl", image(kWideCopper + pen)},
                          {"mask.gts", image("%ADD10C,1.7*%D10*X2000000Y2000000D03*")}});
        const Board box = poured.open();
        QVERIFY(box.ok());
        QCOMPARE((*box)->board, (model::Box{{-100'000, -100'000}, {10'100'000, 10'100'000}}));
        QVERIFY(isReported(**box, "draws no outline"));
    }

    /// Allegro writes what the format has no record for, or other programs write as parameters, into comments.
    void commentsOfANetlistTellLongNamesAndTheThicknessOfTheBoard() {
        const std::string netlist =
            "C  Board Thickness(mils):  80.400000\nP  UNITS CUST 1\nC  NNAMEm0004 UNNAMED_3_CN8PA_I15_N3\n"
            "P  NNAME1 A_NAME_THAT_IS_TOO_LONG\n"
            "317m0004            J1    -1     D0800PA00X+002000Y+002000X1500Y0000R000 S0\n"
            "317NNAME1           J1    -3     D0800PA00X+008000Y+008000X1500Y0000R000 S0\n999\n";
        const Job job({{"b.GTL", image(kCopper)}, {"b.GBL", image(kCopper)}, {"b.drl", kDrills}, {"b.ipc", netlist}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QCOMPARE(namesOf(**board), (std::vector<std::string>{"A_NAME_THAT_IS_TOO_LONG", "UNNAMED_3_CN8PA_I15_N3"}));
        QCOMPARE(qRound((*board)->stackup.facts.boardNm.value_or(0.0)), 2'042'160);
        QVERIFY(std::ranges::any_of((*board)->diagnostics.entries(), [](const auto& entry) {
            return entry.text.starts_with("The thickness of the board is that of the netlist") && entry.line == 1;
        }));
    }

    /// Altium; where records have the short names as the table does, a net "1" is called so.
    void numbersOfANetlistStandForLongNames() {
        const auto netsOf = [](const std::string& second) {
            const std::string netlist =
                "P  UNITS CUST 1\nP  NNAME1     I2S_DAC_LOOP_D0\nP  NNAME2     I2S_DAC_LOOP_D1\n"
                "3171                J1    -1     D0800PA00X+002000Y+002000X1500Y0000R000 S0\n317" +
                second + "J1    -3     D0800PA00X+008000Y+008000X1500Y0000R000 S0\n999\n";
            const Job job(
                {{"b.GTL", image(kCopper)}, {"b.GBL", image(kCopper)}, {"b.drl", kDrills}, {"b.ipc", netlist}});
            const Board board = job.open();
            return board.ok() ? namesOf(**board) : std::vector<std::string>();
        };
        QCOMPARE(netsOf("2                "), (std::vector<std::string>{"I2S_DAC_LOOP_D0", "I2S_DAC_LOOP_D1"}));
        QCOMPARE(netsOf("NNAME2           "), (std::vector<std::string>{"1", "I2S_DAC_LOOP_D1"}));
    }

    void aThicknessThatNoBoardHasIsLeftAlone() {
        for (const char* thickness : {"1e30", "40000", "-1", "thick"}) {
            const std::string netlist =
                std::string("C  Board Thickness(mils):  ") + thickness + "\nP  UNITS CUST 1\n" +
                "317A                J1    -1     D0800PA00X+002000Y+002000X1500Y0000R000 S0\n999\n";
            const Job job(
                {{"b.GTL", image(kCopper)}, {"b.GBL", image(kCopper)}, {"b.drl", kDrills}, {"b.ipc", netlist}});
            const Board board = job.open();
            QVERIFY(board.ok());
            QVERIFY(!(*board)->stackup.facts.boardNm);
        }
    }

    void whatIsWrongInAnImageIsReported() {
        const Job job({{"top.gtl", image(kCopper + "Q7*\n")}, {"bottom.gbl", image(kCopper)}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QVERIFY(std::ranges::any_of((*board)->diagnostics.entries(),
                                    [](const auto& entry) { return entry.file == "top.gtl" && entry.line > 0; }));
    }
};

QTEST_APPLESS_MAIN(GerberReaderTest)
#include "gerber_reader_test.moc"
