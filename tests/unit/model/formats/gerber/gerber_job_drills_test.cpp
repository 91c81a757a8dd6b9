// Holes of whole jobs: what drill files, netlists and pairs of layers together tell of them.

#include <QtTest>
#include <algorithm>
#include <map>
#include <numeric>

#include "model/board/holes.h"
#include "model/formats/gerber/gerber_reader.h"
#include "model/nets/net_statistics.h"
#include "tests/unit/model/formats/gerber/gerber_testing.h"

using namespace gerber_testing;

namespace {

/// How many holes of this size and kind there are.
std::uint32_t holesOf(const model::Document& board, model::Nm diameter, model::HoleKind kind) {
    std::uint32_t count = 0;
    for (const model::DrillRow& row : model::drillTable(board)) {
        count += row.diameter == diameter && row.kind == kind ? row.count : 0;
    }
    return count;
}

bool hasBackDrills(const model::Document& board) {
    return std::ranges::any_of(model::drillTable(board),
                               [](const model::DrillRow& row) { return row.span == model::HoleSpan::Backdrill; });
}

std::uint32_t viasOfNets(const model::Document& board) {
    const std::vector<std::uint32_t> counts = model::viaCounts(board);
    return std::accumulate(counts.begin(), counts.end(), 0U);
}

}  // namespace

class GerberJobDrillsTest : public QObject {
    Q_OBJECT

private slots:
    void functionsOfAperturesTellWhatHolesAre() {
        const std::string mixed =
            "%FSLAX46Y46*%%MOMM*%%TF.FileFunction,MixedPlating,1,2*%%TA.AperFunction,ViaDrill*%%ADD10C,0.8*%"
            "%TA.AperFunction,NonPlated,NPTH,MechanicalDrill*%%ADD11C,0.4*%%TD*%"
            "D10*X2000000Y2000000D03*D11*X8000000Y8000000D03*M02*";
        const Job job({{"b.gtl", image(kCopper)}, {"b.gbl", image(kCopper)}, {"b-drl.gbr", mixed}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QCOMPARE(holesOf(**board, 800'000, model::HoleKind::Via), 1U);
        QCOMPARE(holesOf(**board, 400'000, model::HoleKind::NonPlated), 1U);
    }

    /// Nothing that plating would join; a file may still say so.
    void holesOfASingleCopperLayerAreNotPlated() {
        const std::string head = "M48\nMETRIC\n";
        const std::string hits = "T1C0.8\nT2C0.4\n%\nT1\nX2.0Y2.0\nT2\nX8.0Y8.0\nM30\n";
        const auto platedOf = [&](const std::string& drills, bool isDouble) {
            std::map<std::string, std::string> files{{"b.gbl", image(kCopper)}, {"b.drl", drills}};
            if (isDouble) {
                files["b.gtl"] = image(kCopper);
            }
            const Job job(files);
            const Board board = job.open();
            std::uint32_t plated = 0;
            for (const model::DrillRow& row : model::drillTable(**board)) {
                plated += row.kind == model::HoleKind::NonPlated ? 0 : row.count;
            }
            return plated;
        };
        QCOMPARE(platedOf(head + hits, false), 0U);
        QCOMPARE(platedOf(head + hits, true), 2U);
        QCOMPARE(platedOf(head + ";TYPE=PLATED\n" + hits, false), 2U);
    }

    void sizesInCommentsMakeADrillFile() {
        const std::string drills =
            ";   Holesize 1. = 0.800000 Tolerance = +0.000000/-0.000000 PLATED MM Quantity = 2\n"
            ";   Holesize 2. = 1.000000 Tolerance = +0.000000/-0.000000 NON_PLATED MM Quantity = "
            "1\n%\nG90\nX000200000Y000200000\nX000800000\nM00\nX000800000Y000800000\nM30\n";
        const Job job({{"b.gtl", image(kCopper)}, {"b.gbl", image(kCopper)}, {"b-1-2.drl", drills}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QCOMPARE(holesOf(**board, 1'000'000, model::HoleKind::NonPlated), 1U);
        QVERIFY(!isReported(**board, "no part of a Gerber job"));
    }

    /// Ten digits: in the usual format, which the file does not deny, 20 m.
    void drillsBeyondAnyBoardAreReadInAnotherFormat() {
        const std::string drills =
            "M48\nT1C0.8\n%\nT1\nX0000200000Y0000200000\nX0000800000\nX0000800000Y0000800000\nM30\n";
        const Job job({{"b.gtl", image(kCopper)}, {"b.gbl", image(kCopper)}, {"b.drl", drills}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QCOMPARE(holesOf(**board, 800'000, model::HoleKind::Via) + holesOf(**board, 800'000, model::HoleKind::Plated),
                 3U);
    }

    void namesOfDrillFilesTellTheirSpans_data() {
        QTest::addColumn<QString>("through");
        QTest::addColumn<QString>("blind");
        QTest::addColumn<QString>("spans");
        QTest::newRow("Allegro") << "b-1-4.drl"
                                 << "b-1-2.drl"
                                 << "1-2 1-4 ";
        QTest::newRow("Eagle") << "b.drd.0116"
                               << "b.drd.1516"
                               << "1-4 3-4 ";
        QTest::newRow("versions") << "b-1-3.drl"
                                  << "b-1-2.drl"
                                  << "1-4 1-4 ";
    }
    /// Through if nothing in the job is drilled by its name from the top to the bottom.
    void namesOfDrillFilesTellTheirSpans() {
        QFETCH(QString, through);
        QFETCH(QString, blind);
        QFETCH(QString, spans);
        const std::string other = "M48\nMETRIC\nT1C0.3\n%\nT1\nX3.0Y2.0\nX4.0Y2.0\nX5.0Y2.0\nM30\n";
        const Job job({{"b.GTL", image(kCopper)},
                       {"b.G2L", image(kCopper)},
                       {"b.G15L", image(kCopper)},
                       {"b.GBL", image(kCopper)},
                       {through.toStdString(), kDrills},
                       {blind.toStdString(), other}});
        const Board board = job.open();
        QVERIFY(board.ok());
        std::string found;
        for (const model::Layer& layer : (*board)->layers) {
            const auto copper = [&](model::LayerId id) {
                int number = 0;
                for (std::uint32_t i = 0; i <= id.value; ++i) {
                    number += (*board)->layers[i].type == model::LayerType::Signal ? 1 : 0;
                }
                return std::to_string(number);
            };
            if (layer.type == model::LayerType::Drill) {
                found += layer.spanTop.isValid() ? copper(layer.spanTop) + "-" + copper(layer.spanBottom) + " " : "- ";
            }
        }
        QCOMPARE(QString::fromStdString(found), spans);
        QCOMPARE(isReported(**board, "nly the name of the drill file"), spans != "1-4 1-4 ");
    }

    /// Rows of vias agree with their pads one step further, too, and rounding divides the votes for the true shift.
    void rowsOfViasAreLaidOnTheirOwnPads() {
        std::string pads = "%ADD10C,0.5*%D10*";
        std::string drills = "M48\n;FILE_FORMAT=3:3\nMETRIC\nT1C0.4\n%\nT1\n";
        for (int i = 0; i < 40; ++i) {
            const int x = 1'000 + i / 4 * 805;
            const int y = 2'000 + i % 4 * 1'000;
            const int rounding = i % 2 == 0 ? 10 : -10;  // nm
            pads += "X" + std::to_string(x * 1'000 + rounding) + "Y" + std::to_string(y * 1'000) + "D03*\n";
            drills += QString::asprintf("X%06dY%06d\n", x + 100'000, y).toStdString();
        }
        const Job job({{"b.gtl", image(pads)}, {"b.gbl", image(pads)}, {"b.drl", drills + "M30\n"}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QVERIFY(isReported(**board, "moved by -100, 0 mm"));
    }

    /// A path around the board lies beside all copper in any format.
    void filesThatNoCopperTellAreReadLikeTheOthers() {
        const std::string drills = "M48\nINCH\nT1C0.03\n%\nT1\nX0020000Y0020000\nX0080000\nX0080000Y0080000\nM30\n";
        const std::string path =
            "M48\nINCH\nT1C0.1\n%\nT1\nG00X00020000Y00020000\nM15\nG01X00280000\nY00280000\nM16\nM30\n";
        const std::string pads = "%ADD10C,1.5*%D10*X5080000Y5080000D03*X20320000D03*Y20320000D03*\n";
        const Job job({{"b.gtl", image(pads)}, {"b.gbl", image(pads)}, {"a-npth.drl", path}, {"b.drl", drills}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QVERIFY(isReported(**board, "like another drill file of the job"));
        QVERIFY(!isReported(**board, "ost holes lie beside"));
    }

    /// Programs can write drills from another origin than images. The format that the file tells is not doubted then,
    /// though in another one the holes would lie on the board, too.
    void drillsFromAnotherOriginAreLaidOnTheirPads() {
        const std::string pads =
            "%ADD10C,1.5*%D10*X2000000Y2000000D03*X8000000D03*Y8000000D03*X3000000D03*X5000000Y4000000D03*\n";
        const std::string head = "M48\n;FILE_FORMAT=3:3\nMETRIC\nT1C0.8\n%\nT1\n";
        const std::string drills = head + "X052000Y042000\nX058000\nY048000\nX053000\nX055000Y044000\nM30\n";
        const std::string slot = head + "G00X054000Y043000\nM15\nG01X055000\nM16\nM30\n";
        const Job job({{"b.gtl", image(pads)},
                       {"b.gbl", image(pads)},
                       {"b.gko", image(kOutline)},
                       {"b.drl", drills},
                       {"a-slots.drl", slot}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QVERIFY(isReported(**board, "moved by -50, -40 mm"));
        QVERIFY(!isReported(**board, "ead as mm"));
        std::vector<model::Point> places;
        for (std::size_t row = 0; row < (*board)->elements.size(); ++row) {
            if (((*board)->elements.flags[row] & model::kHole) != 0) {
                places.push_back((*board)->boxOf(model::ElementId(static_cast<std::uint32_t>(row))).middle());
            }
        }
        std::ranges::sort(places, {}, [](model::Point p) { return std::pair(p.x, p.y); });
        QCOMPARE(places.size(), std::size_t{6});
        QCOMPARE(places.front(), (model::Point{2'000'000, 2'000'000}));
        QCOMPARE(places[2], (model::Point{4'500'000, 3'000'000}));
    }

    void filesOfBackDrillsTakeThePlatingOfTheirSpan() {
        const auto open = [](const std::string& backDrills) {
            const auto copper = [](const char* function) { return image(kCopper, function); };
            const Job job(
                {{"b.gtl", copper("Copper,L1,Top")},
                 {"b.g1", copper("Copper,L2,Inr")},
                 {"b.g2", copper("Copper,L3,Inr")},
                 {"b.gbl", copper("Copper,L4,Bot")},
                 {"b.drl",
                  "; #@! TF.FileFunction,Plated,1,4,PTH\nM48\nMETRIC\n; #@! TA.AperFunction,Plated,PTH,ViaDrill\n"
                  "T1C0.4\n%\nT1\nX2.0Y2.0\nM30\n"},
                 {"b-back.drl", backDrills}});
            return job.open();
        };
        const std::string back =
            "M48\nMETRIC\n; #@! TA.AperFunction,NonPlated,Blind,BackDrill\nT1C0.8\n%\nT1\nX2.0Y2.0\nM30\n";
        const Board board = open("; #@! TF.FileFunction,NonPlated,4,3,Blind\n" + back);
        QVERIFY(board.ok());
        QVERIFY(hasBackDrills(**board));
        QVERIFY(isReported(**board, "takes the plating"));

        const Board noSpan = open("; #@! TF.FileFunction,NonPlated\n" + back);
        QVERIFY(noSpan.ok());
        QVERIFY(!hasBackDrills(**noSpan));
        QCOMPARE(holesOf(**noSpan, 800'000, model::HoleKind::NonPlated), 1U);
        QVERIFY(isReported(**noSpan, "does not say which layers they pass"));
    }

    /// Altium tells in an export of layer pairs which copper layers the drills of a file pass.
    void layerPairsTellTheSpansOfDrills() {
        const std::string pairs =
            "Layer Pairs Export File for PCB: C:\\b.PcbDoc\r\n"
            "LayersSetName=Blind|DrillFile=B-Blind.TXT|DrillLayers=gtl,g1\r\n"
            "LayersSetName=Buried|DrillFile=b-buried.txt|DrillLayers=g1,g2\r\n"
            "LayersSetName=Lost|DrillFile=b-lost.txt|DrillLayers=gtl,g9\r\n"
            "LayersSetName=Broken|DrillFile=|DrillLayers=\r\n";
        const Job job({{"b.GTL", image(kCopper)},
                       {"b.G1", image(kCopper)},
                       {"b.G2", image(kCopper)},
                       {"b.GBL", image(kCopper)},
                       {"b-Blind.TXT", kDrills},
                       {"b-Buried.TXT", "M48\nMETRIC\nT1C0.5\n%\nT1\nX2.0Y2.0\nM30\n"},
                       {"b-Lost.TXT", "M48\nMETRIC\nT1C0.6\n%\nT1\nX8.0Y8.0\nM30\n"},
                       {"b.LDP", pairs}});
        const Board board = job.open();
        QVERIFY(board.ok());
        const auto spanOf = [&](const std::string& file) {
            const auto layer =
                std::ranges::find_if((*board)->layers, [&](const model::Layer& row) { return row.file == file; });
            if (layer == (*board)->layers.end()) {
                return std::pair<std::string, std::string>();
            }
            return std::pair((*board)->layer(layer->spanTop).file, (*board)->layer(layer->spanBottom).file);
        };
        QCOMPARE(spanOf("b-Blind.TXT"), (std::pair<std::string, std::string>("b.GTL", "b.G1")));
        QCOMPARE(spanOf("b-Buried.TXT"), (std::pair<std::string, std::string>("b.G1", "b.G2")));
        QCOMPARE(spanOf("b-Lost.TXT"), (std::pair<std::string, std::string>("b.GTL", "b.GBL")));
        QVERIFY(isReported(**board, "of which the job has no image"));
        QVERIFY(!isReported(**board, "no part of a Gerber job"));
    }

    /// The endings that it writes are those that it gives by itself, also where all files end in ".gbr". Planes are
    /// counted by themselves: beside them nothing tells which file is meant.
    void layerPairsCountFilesThatAllEndAlike() {
        const std::string buried = "LayersSetName=Buried|DrillFile=b-buried.txt|DrillLayers=g1,g2\r\n";
        const auto copper = [](int number) {
            return "G04 Layer_Physical_Order=" + std::to_string(number) + "*\n" + image(kCopper);
        };
        for (const bool arePlanesNamed : {false, true}) {
            const std::string planes = "LayersSetName=Lost|DrillFile=b-lost.txt|DrillLayers=gtl,gp1\r\n";
            const Job job({{"b_One.gbr", copper(1)},
                           {"b_Two.gbr", copper(2)},
                           {"b_Three.gbr", copper(3)},
                           {"b_Four.gbr", copper(4)},
                           {"b-Buried.TXT", kDrills},
                           {"b.LDP", buried + (arePlanesNamed ? planes : "")}});
            const Board board = job.open();
            QVERIFY(board.ok());
            QCOMPARE(isReported(**board, "of which the job has no image"), arePlanesNamed);
            const auto drills = std::ranges::find((*board)->layers, "b-Buried.TXT", &model::Layer::file);
            QVERIFY(drills != (*board)->layers.end());
            QCOMPARE((*board)->layer(drills->spanTop).file, std::string(arePlanesNamed ? "b_One.gbr" : "b_Two.gbr"));
            QCOMPARE((*board)->layer(drills->spanBottom).file,
                     std::string(arePlanesNamed ? "b_Four.gbr" : "b_Three.gbr"));
        }
    }

    /// Allegro says the format of neither. A slot that meets no pads would lie on the board ten times smaller, too.
    void routsThatSayNothingAreReadAsDrillsAre() {
        const Job job({{"b.GTL", image(kCopper)},
                       {"b.GBL", image(kCopper)},
                       {"b.drl",
                        ";   Holesize 1. = 31.5 Tolerance = +0/-0 PLATED MILS Quantity = 3\n%\nG90\n"
                        "T01\nX00079Y00079\nX00315Y00079\nX00315Y00315\nM30\n"},
                       {"b.rou", "%\nG90\nT01C0.03937\nG00X00118Y00197\nM15\nG01X00236Y00197\nM16\nM30\n"}});
        const Board board = job.open();
        QVERIFY(board.ok());
        const auto routs = std::ranges::find((*board)->layers, "b.rou", &model::Layer::file);
        QVERIFY(routs != (*board)->layers.end());
        const model::Box box = (*board)->boxOf(model::ElementId{routs->elements.first});
        QCOMPARE(box.width() / 10'000, (236 - 118) * 25'400 / 10'000 + 100);
        QVERIFY(isReported(**board, "ead as inch 2.3, trailing zeros kept, like another drill file of the job"));
    }

    void drillsOfAnotherBoardAreReported() {
        const auto holes = [](bool isOther) {
            std::string text = "M48\nMETRIC\nT1C0.4\n%\nT1\n";
            for (int i = 0; i < 20; ++i) {
                text += "X" + std::to_string(i) + ".0Y" +
                        (isOther ? std::to_string(2 + i * i % 7 % 3) + ".5\n" : std::to_string(2 + i % 3) + ".0\n");
            }
            return text + "M30\n";
        };
        std::string pads = "%ADD10C,0.8*%D10*";
        for (int i = 0; i < 20; ++i) {
            pads += "X" + std::to_string(i) + "000000Y" + std::to_string(2 + i % 3) + "000000D03*";
        }
        const Files files = {{"b.gtl", image(pads)}, {"b.gbl", image(pads)}, {"b.drl", holes(false)}};
        Files two = files;
        two["c.drl"] = holes(true);
        const Board alone = Job(files).open();
        const Board both = Job(two).open();
        QVERIFY(alone.ok() && both.ok());
        QVERIFY(!isReported(**alone, "may be of another board"));
        QVERIFY(isReported(**both, "may be of another board"));
    }

    /// CAM programs write drills as images of flashes, which end as those of Altium do.
    void imagesOfFlashesThatEndLikeDrillsAreHoles() {
        const std::string flashes = "%ADD10C,0.8*%D10*X2000000Y2000000D03*X8000000D03*";
        const auto holesIn = [](const std::string& name, const std::string& body) {
            const Job job({{"b.gtl", image(kCopper)}, {"b.gbl", image(kCopper)}, {name, image(body)}});
            const Board board = job.open();
            return board.ok() ? holesOf(**board, 800'000, model::HoleKind::Plated) : 0U;
        };
        QCOMPARE(holesIn("b.txt", flashes), 2U);
        QCOMPARE(holesIn("b.txt", flashes + "X0Y0D02*X1000000D01*"), 0U);
        QCOMPARE(holesIn("b.ger", flashes), 0U);
    }

    /// DipTrace writes its holes twice: exactly as images, of which one has those without plating, and rounded as
    /// drills.
    void holesOfTwoFormsAreDrilledOnce() {
        const auto holes = [](const std::string& function, const std::string& flashes) {
            return "%TF.FileFunction," + function + "*%\n%FSLAX46Y46*%\n%MOMM*%\n%ADD10C,0.8*%D10*" + flashes +
                   "M02*\n";
        };
        const Job job({{"b.GTL", image(kCopper)},
                       {"b.GBL", image(kCopper)},
                       {"b_Plated.gbr", holes("Plated,1,2,PTH,Drill", "X2007700Y2007500D03*X8007700D03*Y8007500D03*")},
                       {"b_NonPlated.gbr", holes("NonPlated,1,2,NPTH,Drill", "X5007700Y5007500D03*")},
                       {"b_All.drl", "M48\nMETRIC\nT1C0.8\n%\nT1\nX2.0Y2.0\nX8.0Y2.0\nX8.0Y8.0\nX5.0Y5.0\nM30\n"}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QVERIFY(isReported(**board, "nother file drills the same holes"));
        QCOMPARE(holesOf(**board, 800'000, model::HoleKind::NonPlated), 1U);
        QCOMPARE(holesOf(**board, 800'000, model::HoleKind::Plated), 3U);
    }

    /// A file with all holes beside one with the plated ones: what only the former has is drilled too.
    void holesThatOnlyOneOfTwoFilesHasStay() {
        const auto drills = [](const char* type, bool isAll) {
            std::string text = std::string("M48\n") + type + "METRIC\nT1C0.8\n%\nT1\n";
            for (int i = 0; i < 19; ++i) {
                text += "X" + std::to_string(2 + i % 5) + ".0Y" + std::to_string(2 + i / 5) + ".0\n";
            }
            return text + (isAll ? "X9.0Y9.0\n" : "") + "M30\n";
        };
        const Job job({{"b.GTL", image(kCopper)},
                       {"b.GBL", image(kCopper)},
                       {"all.drl", drills("", true)},
                       {"plated.drl", drills(";TYPE=PLATED\n", false)}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QVERIFY(isReported(**board, "nother file drills 19 of the 20 holes, too"));
        QCOMPARE(
            holesOf(**board, 800'000, model::HoleKind::NonPlated) + holesOf(**board, 800'000, model::HoleKind::Plated),
            20U);
    }

    /// Allegro writes routs without sizes of tools; its netlist has the holes.
    void aNetlistTellsTheSizesOfTools() {
        const std::string netlist =
            "P  UNITS CUST 1\n"
            "317A                J1    -1     D0800PA00X+002000Y+002000X1500Y0000R000 S0\n"
            "317A                J1    -2     D0800PA00X+008000Y+002000X1500Y0000R000 S0\n"
            "317B                J1    -3     D0800PA00X+008000Y+008000X1500Y0000R000 S0\n"
            "367                       -      D2000UA00X+005000Y+005000X4000Y2000R000 S3\n999\n";
        const Job job({{"b.GTL", image(kCopper)},
                       {"b.GBL", image(kCopper)},
                       {"b.drl", kDrills},
                       {"b.rou", "M48\nMETRIC,TZ\n%\nG90\nT01\nG00X004000Y005000\nM15\nG01X006000Y005000\nM16\nM30\n"},
                       {"b.ipc", netlist}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QVERIFY(isReported(**board, "size of a tool is that of the netlist's holes"));
        const auto tool = std::ranges::find_if(
            (*board)->tools, [&](const model::DrillTool& row) { return (*board)->layer(row.layer).file == "b.rou"; });
        QVERIFY(tool != (*board)->tools.end());
        QCOMPARE(tool->drillSize, 2'000'000);
        QVERIFY(!isReported(**board, "A tool has no size"));
    }

    void aToolWithoutASizeIsReportedWhereItDrills() {
        const Job job({{"b.GTL", image(kCopper)},
                       {"b.GBL", image(kCopper)},
                       {"b.drl", "M48\nMETRIC\nT1\n%\nT1\nX2.0Y2.0\nX8.0Y2.0\nX8.0Y8.0\nM30\n"}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QVERIFY(std::ranges::any_of((*board)->diagnostics.entries(), [](const auto& entry) {
            return entry.text.starts_with("A tool has no size, and no netlist tells it") && entry.file == "b.drl" &&
                   entry.line == 6;
        }));
        QVERIFY(!isReported(**board, "are taken to make vias"));
    }

    /// Holes of 0.4 mm in pads and one beside them, one of 0.3 mm beside pads, and one of 3 mm in pads.
    void toolsThatMostlyDrillPadsMakeVias() {
        const std::string drills =
            "M48\nMETRIC\nT1C0.4\nT2C3.0\nT3C0.3\n%\nT1\nX2.0Y2.0\nX5.0Y5.0\nX8.0Y2.0\nT2\nX8.0Y8.0\nT3\nX5.0Y6."
            "0\nM30\n";
        const Files copper = {{"b.GTL", image(kCopper)}, {"b.GBL", image(kCopper)}};
        for (const char* name : {"b-PTH.drl", "b.drl"}) {
            Files files = copper;
            files[name] = drills;
            const Job job(files);
            const Board board = job.open();
            QVERIFY(board.ok());
            QCOMPARE(holesOf(**board, 400'000, model::HoleKind::Via), 3U);
            QCOMPARE(holesOf(**board, 300'000, model::HoleKind::Plated), 1U);
            QCOMPARE(holesOf(**board, 3'000'000, model::HoleKind::Plated), 1U);
            QCOMPARE(viasOfNets(**board), 3U);
            QVERIFY(std::ranges::any_of((*board)->diagnostics.entries(), [name](const auto& entry) {
                return entry.text.find("are taken to make vias") != std::string::npos && entry.file == name &&
                       entry.line == 8;
            }));
        }
        Files files = copper;
        files["b-NPTH.drl"] = drills;
        const Job unplated(files);
        const Board board = unplated.open();
        QVERIFY(board.ok());
        QCOMPARE(holesOf(**board, 400'000, model::HoleKind::NonPlated), 3U);
        QVERIFY(!isReported(**board, "are taken to make vias"));
    }

    /// The netlist knows one of the holes as a pin; the others are none, and no vias either.
    void wherePinsAreKnownNoHoleIsTakenAsAVia() {
        const Job job(
            {{"b.GTL", image(kCopper)},
             {"b.GBL", image(kCopper)},
             {"b-PTH.drl", "M48\nMETRIC\nT1C0.4\n%\nT1\nX2.0Y2.0\nX8.0Y2.0\nX8.0Y8.0\nM30\n"},
             {"b.ipc",
              "P  UNITS CUST 1\n317A                J1    -1     D0400PA00X+002000Y+002000X1500Y0000R000 S0\n999\n"}});
        const Board board = job.open();
        QVERIFY(board.ok());
        QCOMPARE(holesOf(**board, 400'000, model::HoleKind::Component), 1U);
        QCOMPARE(holesOf(**board, 400'000, model::HoleKind::Plated), 2U);
        QVERIFY(!isReported(**board, "are taken to make vias"));
    }
};

QTEST_APPLESS_MAIN(GerberJobDrillsTest)
#include "gerber_job_drills_test.moc"
