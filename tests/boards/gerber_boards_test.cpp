// Gerber jobs of thirteen CAD systems (boards/formats): counts taken from the files themselves, and what each system is
// known for.
#include <QFile>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>
#include <algorithm>
#include <filesystem>

#include "model/formats/gerber/image/image.h"
#include "model/formats/registry.h"
#include "model/text/whole_file.h"
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
        QVERIFY(board->findNet("m0000").isValid());
        const auto named =
            std::ranges::count_if(board->netPoints, [](const auto& point) { return point.net.isValid(); });
        QVERIFY(named * 100 >= static_cast<std::ptrdiff_t>(board->netPoints.size()) * 99);
    }

    void fourSpellingsOfABoardAreEqual() {
        const fs::path job = formatsFolder() / "gerber" / "kicad-x2-tests.zip";
        const auto first = open(job, "X2AP");
        QVERIFY(first != nullptr);
        for (const char* step : {"X2NOAP", "NOX2AP", "NOX2NOAP"}) {
            const auto other = open(job, step);
            QVERIFY(other != nullptr);
            QCOMPARE(other->job.step, std::string(step));
            QCOMPARE(other->board, first->board);
            QCOMPARE(holesOf(*other), holesOf(*first));
            QCOMPARE(other->components.size(), first->components.size());
            QCOMPARE(other->pins.size(), first->pins.size());
            QCOMPARE(other->nets.size(), first->nets.size());
            QCOMPARE(copperOf(*other), copperOf(*first));
        }
    }

    void conformanceFilesAreRead() {
        std::size_t files = 0;
        for (const auto& entry : fs::recursive_directory_iterator(formatsFolder() / "gerber-conformance")) {
            if (entry.path().extension() != ".gbr") {
                continue;
            }
            const auto text = model::readWholeFile(entry.path());
            QVERIFY(text.ok());
            const model::gerber::Image image = model::gerber::parseImage(*text, entry.path().filename().string());
            QVERIFY2(!image.features.empty(), entry.path().c_str());
            QCOMPARE(image.diagnostics.count(model::Severity::Error), std::size_t{0});
            ++files;
        }
        QCOMPARE(files, std::size_t{41});
    }
};

QTEST_APPLESS_MAIN(GerberBoardsTest)
#include "gerber_boards_test.moc"
