// Gerber jobs of thirteen CAD systems (boards/formats): counts taken from the files themselves, and what each system is
// known for.
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>
#include <algorithm>
#include <filesystem>

#include "model/agreement/agreement.h"
#include "model/formats/registry.h"
#include "tests/locations.h"

namespace {

namespace fs = std::filesystem;

fs::path formatsFolder() {
    return locations::boards() / "formats";
}

std::shared_ptr<const model::Document> open(const fs::path& path, const std::string& step = "") {
    base::Progress progress;
    const auto board = model::readBoard(path, {step, false}, progress);
    return board ? *board : nullptr;
}

std::size_t copperOf(const model::Document& board) {
    return static_cast<std::size_t>(std::ranges::count_if(board.layers, &model::Layer::isCopper));
}

std::size_t holesOf(const model::Document& board) {
    return static_cast<std::size_t>(
        std::ranges::count_if(board.elements.flags, [](std::uint8_t flags) { return (flags & model::kHole) != 0; }));
}

bool isReported(const model::Document& board, const std::string& words) {
    return std::ranges::any_of(board.diagnostics.entries(),
                               [&](const auto& entry) { return entry.text.find(words) != std::string::npos; });
}

/// Where the boards of kicad-x2-tests say how they were written.
constexpr model::Box kWords{{86'000'000, -26'000'000}, {99'500'000, -20'500'000}};

QByteArray textOf(const model::Comparison& comparison) {
    std::string text = std::string(toString(comparison.aspect)) + " " + comparison.layers[0] + " " + comparison.note;
    if (comparison.region) {
        const model::Box box = comparison.region->box;
        text += " x " + std::to_string(box.min.x) + " to " + std::to_string(box.max.x) + ", y " +
                std::to_string(box.min.y) + " to " + std::to_string(box.max.y) + " nm";
    }
    for (const model::Difference& difference : comparison.differences) {
        text += "; " + difference.text;
    }
    return QByteArray::fromStdString(text);
}

}  // namespace

class GerberBoardsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        if (!fs::exists(formatsFolder())) {
            QSKIP("the folder of boards holds no formats/");
        }
    }

    void kicadBoardsHaveTheirNetsAndFootprints_data() {
        QTest::addColumn<QString>("name");
        for (const char* name : {"StickHub", "RoyalBlue54L-Feather", "kit-dev-coldfire-xilinx_5213",
                                 "multichannel_mixer", "flat_hierarchy", "custom_pads_test"}) {
            QTest::newRow(name) << name;
        }
    }
    void kicadBoardsHaveTheirNetsAndFootprints() {
        QFETCH(QString, name);
        QFile file(QString::fromStdString((formatsFolder() / "expected.json").string()));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QJsonObject expected =
            QJsonDocument::fromJson(file.readAll()).object()["kicad"].toObject()[name].toObject();
        const QJsonObject source = expected["kicad"].toObject();
        const fs::path folder = formatsFolder() / "kicad" / name.toStdString();
        const auto board = open(folder / (name.toStdString() + "-gerbers.zip"));
        QVERIFY(board != nullptr);
        QCOMPARE(static_cast<int>(board->nets.size()), source["nets_with_pad"].toInt());
        QCOMPARE(static_cast<int>(board->components.size()), source["distinct_refs"].toInt());
        QCOMPARE(static_cast<int>(copperOf(*board)), source["copper_layer_count"].toInt());
        const auto odb = open(folder / (name.toStdString() + "-odb.tgz"));
        QVERIFY(odb != nullptr);
        QCOMPARE(holesOf(*board), holesOf(*odb));
        QCOMPARE(board->board, odb->board);
    }

    void jobsOfOtherSystemsHaveTheirLayers_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<int>("copper");
        QTest::addColumn<int>("holes");
        QTest::newRow("Allegro") << "allegro" << 4 << 291;
        QTest::newRow("Altium") << "altium-composite-drill" << 14 << 4258;
        QTest::newRow("Eagle 9") << "eagle-newer" << 2 << 39;
        QTest::newRow("Fusion") << "fusion360" << 2 << 0;
        QTest::newRow("gEDA") << "geda" << 3 << 277;
        QTest::newRow("OrCAD") << "orcad" << 6 << 859;
        QTest::newRow("PADS") << "pads" << 4 << 606;
        QTest::newRow("DipTrace") << "diptrace" << 2 << 168;
        QTest::newRow("KiCad 5.99") << "kicad-x2-tests" << 2 << -1;
        QTest::newRow("Xpedition") << "siemens-2" << 2 << -1;
        QTest::newRow("Upverter") << "upverter" << 2 << 63;
        QTest::newRow("EasyEDA") << "easyeda" << 2 << 98;
    }
    void jobsOfOtherSystemsHaveTheirLayers() {
        QFETCH(QString, name);
        QFETCH(int, copper);
        QFETCH(int, holes);
        const auto board = open(formatsFolder() / "gerber" / (name.toStdString() + ".zip"));
        QVERIFY(board != nullptr);
        QCOMPARE(static_cast<int>(copperOf(*board)), copper);
        if (holes >= 0) {
            QCOMPARE(static_cast<int>(holesOf(*board)), holes);
        }
        QCOMPARE(board->diagnostics.count(model::Severity::Error), std::size_t{0});
        QVERIFY(!isReported(*board, "beside the copper"));
    }

    void copperBehindAGapInTheNumbersIsDoubted() {
        const auto board = open(formatsFolder() / "gerber" / "geda.zip");
        QVERIFY(board != nullptr);
        QVERIFY(isReported(*board, "The file is taken as inner copper 3, but no file as inner copper 2"));
    }

    void routedSlotsOfAllegroHaveTheSizeThatTheNetlistTells() {
        const auto board = open(formatsFolder() / "gerber" / "allegro.zip");
        QVERIFY(board != nullptr);
        const auto tool = std::ranges::find_if(board->tools, [&](const model::DrillTool& row) {
            return board->layer(row.layer).type == model::LayerType::Rout;
        });
        QVERIFY(tool != board->tools.end());
        QCOMPARE(tool->drillSize, 2'032'000);  // 80 mil
    }

    void layerPairsOfAltiumTellTheSpans() {
        const auto board = open(formatsFolder() / "gerber" / "altium-composite-drill.zip");
        QVERIFY(board != nullptr);
        for (const model::Layer& layer : board->layers) {
            if (layer.type == model::LayerType::Drill || layer.type == model::LayerType::Rout) {
                QVERIFY(board->layer(layer.spanTop).file.ends_with(".GTL"));
                QVERIFY(board->layer(layer.spanBottom).file.ends_with(".GBL"));
            }
        }
        QVERIFY(!isReported(*board, "the job has no image"));
    }

    void outlinesAreFoundAmongDrawingsAndFilms_data() {
        QTest::addColumn<QString>("name");
        QTest::addColumn<double>("width");
        QTest::addColumn<double>("height");
        QTest::newRow("Allegro: fabrication and assembly films") << "allegro" << 94.107 << 53.34;
        QTest::newRow("OrCAD: all films") << "orcad" << 228.6 << 228.6;
        QTest::newRow("PADS: none, so the box around the copper") << "pads" << 68.58 << 101.092;
    }
    void outlinesAreFoundAmongDrawingsAndFilms() {
        QFETCH(QString, name);
        QFETCH(double, width);
        QFETCH(double, height);
        const auto board = open(formatsFolder() / "gerber" / (name.toStdString() + ".zip"));
        QVERIFY(board != nullptr);
        QCOMPARE(static_cast<double>(board->board.width()) / 1e6, width);
        QCOMPARE(static_cast<double>(board->board.height()) / 1e6, height);
    }

    void aNetlistNamesTheNetsOfAllegro() {
        const auto board = open(formatsFolder() / "gerber" / "allegro.zip");
        QVERIFY(board != nullptr);
        QVERIFY(board->findNet("UNNAMED_2_CN2P_I277_N1").isValid());  // which the file calls m0000 in its records
        QVERIFY(!board->findNet("m0000").isValid());
        const auto named =
            std::ranges::count_if(board->netPoints, [](const auto& point) { return point.net.isValid(); });
        QVERIFY(named * 100 >= static_cast<std::ptrdiff_t>(board->netPoints.size()) * 99);
    }

    /// With X2 or with attributes in comments, with aperture macros or with regions. Each says in its silkscreen which
    /// one it is ("Configuration #3, [X] Use X2 format"): only there they differ.
    void spellingsOfABoardAreEqual_data() {
        QTest::addColumn<QString>("a");
        QTest::addColumn<QString>("b");
        const std::vector<const char*> steps = {"X2AP", "X2NOAP", "NOX2AP", "NOX2NOAP"};
        for (std::size_t a = 0; a < steps.size(); ++a) {
            for (std::size_t b = a + 1; b < steps.size(); ++b) {
                QTest::addRow("%s and %s", steps[a], steps[b]) << steps[a] << steps[b];
            }
        }
    }
    void spellingsOfABoardAreEqual() {
        QFETCH(QString, a);
        QFETCH(QString, b);
        const fs::path job = formatsFolder() / "gerber" / "kicad-x2-tests.zip";
        const auto first = open(job, a.toStdString());
        const auto other = open(job, b.toStdString());
        QVERIFY(first != nullptr && other != nullptr);
        QCOMPARE(other->job.step, b.toStdString());
        base::Progress progress;
        const auto agreement = model::compareBoards(*first, *other, {}, progress);
        QVERIFY(agreement.ok());
        QCOMPARE(agreement->shift, model::Point());
        std::size_t lists = 0;
        for (const model::Comparison& comparison : agreement->comparisons) {
            if (comparison.aspect == model::Aspect::Nets || comparison.aspect == model::Aspect::NetNames ||
                comparison.aspect == model::Aspect::Stackup) {
                // All pads are N/C, and no thickness is stated.
                QVERIFY2(comparison.accord == model::Accord::NotCompared, textOf(comparison));
            } else if (comparison.layers[0] == "F_Silkscreen") {
                QVERIFY(comparison.region && !comparison.region->box.isEmpty());
                QVERIFY2(kWords.holds(comparison.region->box.min) && kWords.holds(comparison.region->box.max),
                         textOf(comparison));
            } else {
                QVERIFY2(comparison.accord == model::Accord::Agree, textOf(comparison));
            }
            lists += comparison.counts[0] > 0 && comparison.counts[0] == comparison.counts[1] ? 1 : 0;
        }
        QCOMPARE(lists, std::size_t{4});  // holes, parts, pins, copper layers
        QCOMPARE(other->components.size(), first->components.size());
        for (std::size_t row = 0; row < first->components.size(); ++row) {
            const model::Component& part = first->components[row];
            const model::Component& same = other->components[row];
            QCOMPARE(same.refdes, part.refdes);
            QVERIFY2(std::abs(same.placement.origin.x - part.placement.origin.x) <= 1'000 &&
                         std::abs(same.placement.origin.y - part.placement.origin.y) <= 1'000,
                     part.refdes.c_str());
        }
    }
};

QTEST_APPLESS_MAIN(GerberBoardsTest)
#include "gerber_boards_test.moc"
