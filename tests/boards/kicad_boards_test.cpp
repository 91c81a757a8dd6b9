// Boards of KiCad 4 to 10 (boards/formats), with the counts that were taken from their files by a script, and against
// their own ODB++ form: the same copper layers, nets, pins and holes.
#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QtTest>
#include <algorithm>
#include <filesystem>
#include <set>

#include "model/formats/registry.h"
#include "tests/locations.h"

namespace {

namespace fs = std::filesystem;
using namespace model;

fs::path folderOfFormats() {
    return locations::boards() / "formats";
}

std::shared_ptr<const Document> read(const fs::path& path) {
    base::Progress progress;
    const auto board = readBoard(path, {}, progress);
    return board ? *board : nullptr;
}

QJsonObject expected() {
    QFile file(QString::fromStdString((folderOfFormats() / "expected.json").string()));
    return file.open(QIODevice::ReadOnly) ? QJsonDocument::fromJson(file.readAll()).object()["kicad"].toObject()
                                          : QJsonObject();
}

std::size_t holesOf(const Document& board, bool viasOnly) {
    std::size_t count = 0;
    for (std::size_t i = 0; i < board.elements.size(); ++i) {
        const std::uint8_t flags = board.elements.flags[i];
        count += (flags & kHole) != 0 && (!viasOnly || (flags & kVia) != 0) ? 1 : 0;
    }
    return count;
}

std::set<std::string> netsWithPins(const Document& board) {
    std::set<std::string> names;
    for (const Pin& pin : board.pins) {
        if (pin.net.isValid()) {
            names.insert(board.nets[pin.net.row()].name);
        }
    }
    return names;
}

/// Where its holes are, and how wide.
std::multiset<std::array<Nm, 3>> placesOfHoles(const Document& board) {
    std::multiset<std::array<Nm, 3>> places;
    for (std::size_t i = 0; i < board.elements.size(); ++i) {
        if ((board.elements.flags[i] & kHole) != 0) {
            const Box box = board.boxOf(ElementId{i});
            // On a grid of 10 nm: ODB++ files of KiCad have six digits, rounded once more.
            places.insert(
                {(box.middle().x + 5) / 10, (box.middle().y + 5) / 10, static_cast<Nm>((box.width() + 50) / 100)});
        }
    }
    return places;
}

}  // namespace

class KicadBoardsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        if (!fs::exists(folderOfFormats())) {
            QSKIP("COPPERSCOPE_BOARDS names no folder with boards in other formats");
        }
    }

    void countsAreThoseOfTheFile_data() {
        QTest::addColumn<QJsonObject>("counts");
        const QJsonObject all = expected();
        for (auto board = all.begin(); board != all.end(); ++board) {
            QTest::newRow(board.key().toUtf8().constData()) << board.value().toObject()["kicad"].toObject();
        }
    }
    void countsAreThoseOfTheFile() {
        QFETCH(QJsonObject, counts);
        const std::string name = QTest::currentDataTag();
        const auto board = read(folderOfFormats() / "kicad" / name / (name + ".kicad_pcb"));
        QVERIFY(board);
        QCOMPARE(static_cast<int>(board->components.size()), counts["footprints"].toInt());
        QCOMPARE(static_cast<int>(board->pins.size()), counts["pads"].toInt());
        QCOMPARE(static_cast<int>(holesOf(*board, true)), counts["vias"].toInt());
        QCOMPARE(static_cast<int>(netsWithPins(*board).size()), counts["nets_with_pad"].toInt());
        QCOMPARE(static_cast<int>(std::ranges::count_if(board->layers, &Layer::isCopper)),
                 counts["copper_layer_count"].toInt());
        QCOMPARE(board->diagnostics.count(Severity::Error), std::size_t{0});
    }

    void theSameBoardAsItsOdb_data() {
        QTest::addColumn<QString>("name");
        const QJsonObject all = expected();
        for (const QString& name : all.keys()) {
            QTest::newRow(name.toUtf8().constData()) << name;
        }
    }
    void theSameBoardAsItsOdb() {
        QFETCH(QString, name);
        const fs::path folder = folderOfFormats() / "kicad" / name.toStdString();
        const auto ours = read(folder / (name.toStdString() + ".kicad_pcb"));
        const auto theirs = read(folder / (name.toStdString() + "-odb.tgz"));
        QVERIFY(ours && theirs);
        QCOMPARE(netsWithPins(*ours), netsWithPins(*theirs));
        QCOMPARE(holesOf(*ours, false), holesOf(*theirs, false));
        const auto a = placesOfHoles(*ours);
        const auto b = placesOfHoles(*theirs);
        std::vector<std::array<Nm, 3>> differing;
        std::ranges::set_difference(a, b, std::back_inserter(differing));
        QVERIFY2(differing.size() <= a.size() / 50, std::to_string(differing.size()).c_str());
        QCOMPARE(ours->board.width(), theirs->board.width());
        QCOMPARE(ours->board.height(), theirs->board.height());
    }

    void everyVersionIsRead_data() {
        QTest::addColumn<int>("components");
        QTest::addColumn<int>("pins");
        QTest::addColumn<int>("vias");
        QTest::newRow("v4_4_getting-to-blinky") << 7 << 21 << 2;
        QTest::newRow("v5_20171130_robotont-driver") << 30 << 135 << 37;
        QTest::newRow("v5.99_20190905_lime2-sata") << 10 << 37 << 12;
        QTest::newRow("v6_20211014_muvox") << 128 << 457 << 225;
        QTest::newRow("v7_20221018_led-blinker_NOLICENCE") << 9 << 20 << 0;
        QTest::newRow("v8_20240108_arduino-nano") << 34 << 188 << 44;
        QTest::newRow("v10_20260206_lvds-converter") << 13 << 76 << 0;
        QTest::newRow("v10_20260206_qfn-diffpair-escape") << 1 << 42 << 0;
    }
    void everyVersionIsRead() {
        QFETCH(int, components);
        QFETCH(int, pins);
        QFETCH(int, vias);
        const auto board =
            read(folderOfFormats() / "kicad-versions" / (std::string(QTest::currentDataTag()) + ".kicad_pcb"));
        QVERIFY(board);
        QCOMPARE(static_cast<int>(board->components.size()), components);
        QCOMPARE(static_cast<int>(board->pins.size()), pins);
        QCOMPARE(static_cast<int>(holesOf(*board, true)), vias);
        QCOMPARE(board->diagnostics.count(Severity::Error), std::size_t{0});
        QVERIFY(board->profile.isValid());
    }
};

QTEST_APPLESS_MAIN(KicadBoardsTest)
#include "kicad_boards_test.moc"
