// IPC-2581 files of real writers, against counts taken from the files themselves and against the ODB++ form of the same
// board.
#include <QtTest>
#include <algorithm>
#include <map>
#include <set>

#include "model/formats/common/archive.h"
#include "model/formats/ipc2581/ipc_reader.h"
#include "model/formats/registry.h"
#include "tests/locations.h"

namespace {

using Board = std::shared_ptr<const model::Document>;

Board read(const std::filesystem::path& path) {
    base::Progress progress;
    const auto board = model::readBoard(path, {}, progress);
    return board ? *board : nullptr;
}

std::filesystem::path formats() {
    return locations::boards() / "formats";
}

std::filesystem::path kicadFile(const QString& board, const char* ending) {
    const std::filesystem::path folder = formats() / "kicad" / board.toStdString();
    const std::filesystem::path plain = folder / (board.toStdString() + ending);
    return std::filesystem::exists(plain) ? plain : std::filesystem::path(plain.string() + ".gz");
}

bool reports(const model::Document& board, const std::string& words) {
    return std::ranges::any_of(board.diagnostics.entries(),
                               [&](const model::Diagnostic& d) { return d.text.find(words) != std::string::npos; });
}

std::vector<model::Layer> copperOf(const model::Document& board) {
    std::vector<model::Layer> copper;
    std::ranges::copy_if(board.layers, std::back_inserter(copper), &model::Layer::isCopper);
    return copper;
}

std::uint64_t holesOf(const model::Document& board) {
    std::uint64_t count = 0;
    for (const model::Layer& layer : board.layers) {
        const bool isHoles = layer.type == model::LayerType::Drill || layer.type == model::LayerType::Rout;
        count += isHoles ? layer.featureCount : 0;
    }
    return count;
}

std::set<std::string> netNames(const model::Document& board) {
    std::set<std::string> names;
    for (const model::Net& net : board.nets) {
        names.insert(net.name);
    }
    return names;
}

/// Where the pins of each net are, in micrometres.
std::map<std::string, std::multiset<std::pair<long, long>>> pinsByNet(const model::Document& board) {
    std::map<std::string, std::multiset<std::pair<long, long>>> pins;
    for (const model::Pin& pin : board.pins) {
        if (pin.net.isValid()) {
            pins[board.nets[pin.net.row()].name].emplace(std::lround(pin.position.x / 1e3),
                                                         std::lround(pin.position.y / 1e3));
        }
    }
    return pins;
}

}  // namespace

class Ipc2581BoardsTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        if (locations::boards().empty() || !std::filesystem::exists(formats() / "ipc2581")) {
            QSKIP("COPPERSCOPE_BOARDS names no folder with formats/ipc2581");
        }
    }

    void countsAreThoseOfTheFile_data() {
        QTest::addColumn<int>("components");
        QTest::addColumn<int>("nets");
        QTest::addColumn<int>("netPoints");
        QTest::addColumn<int>("copper");
        QTest::addColumn<int>("holes");
        QTest::addColumn<int>("zones");
        QTest::newRow("DM0002-kicad9.0.5-revc.xml.gz") << 59 << 64 << 0 << 4 << 76 << 0;
        QTest::newRow("testcase3-revc-full.xml.gz") << 42 << 261 << 758 << 6 << 174 << 0;
        QTest::newRow("testcase5-revc-full.xml.gz") << 927 << 1077 << 9589 << 13 << 3073 << 0;
        QTest::newRow("testcase9-revc-full.xml.gz") << 60 << 79 << 542 << 6 << 165 << 0;
        QTest::newRow("testcase11-rdgflx-revc-full.xml.gz") << 78 << 116 << 666 << 6 << 181 << 9;
    }
    void countsAreThoseOfTheFile() {
        QFETCH(int, components);
        QFETCH(int, nets);
        QFETCH(int, netPoints);
        QFETCH(int, copper);
        QFETCH(int, holes);
        QFETCH(int, zones);
        const Board board = read(formats() / "ipc2581" / QTest::currentDataTag());
        QVERIFY(board);
        QCOMPARE(static_cast<int>(board->components.size()), components);
        QCOMPARE(static_cast<int>(board->nets.size()), nets);
        QCOMPARE(static_cast<int>(board->netPoints.size()), netPoints);
        QCOMPARE(static_cast<int>(copperOf(*board).size()), copper);
        QCOMPARE(static_cast<int>(holesOf(*board)), holes);
        QCOMPARE(static_cast<int>(board->zones.size()), zones);
        // Every point of the physical nets lies on copper of its net.
        QVERIFY(!reports(*board, "netlist point"));
        QVERIFY(std::ranges::all_of(board->netPoints, [](const model::NetPoint& p) { return p.net.isValid(); }));
    }

    void boardsAreThoseOfTheirOdbForm_data() {
        QTest::addColumn<int>("differingNets");
        QTest::newRow("StickHub") << 0;
        // 27 castellated pads beside their holes: the IPC-2581 form moves them without rotating by how much.
        QTest::newRow("RoyalBlue54L-Feather") << 27;
        QTest::newRow("custom_pads_test") << 0;
        QTest::newRow("flat_hierarchy") << 0;
        QTest::newRow("kit-dev-coldfire-xilinx_5213") << 0;
        QTest::newRow("microwave") << 0;
        QTest::newRow("multichannel_mixer") << 0;
    }
    void boardsAreThoseOfTheirOdbForm() {
        QFETCH(int, differingNets);
        const QString name = QTest::currentDataTag();
        const Board odb = read(kicadFile(name, "-odb.tgz"));
        const Board ipc = read(kicadFile(name, "-ipc2581c.xml"));
        const Board older = read(kicadFile(name, "-ipc2581b.xml"));
        QVERIFY(odb && ipc && older);
        QCOMPARE(netNames(*ipc), netNames(*odb));
        QCOMPARE(older->elementCounts(), ipc->elementCounts());
        QCOMPARE(holesOf(*ipc), holesOf(*odb));
        QCOMPARE(ipc->board.width(), odb->board.width());
        QCOMPARE(ipc->board.height(), odb->board.height());
        const std::vector<model::Layer> copper = copperOf(*ipc);
        const std::vector<model::Layer> expected = copperOf(*odb);
        QCOMPARE(copper.size(), expected.size());
        for (std::size_t i = 0; i < copper.size(); ++i) {
            QCOMPARE(QString::fromStdString(copper[i].name).toUpper(),
                     QString::fromStdString(expected[i].name).toUpper());
            if (name != "microwave") {  // its ODB++ form lacks two lines
                QCOMPARE(copper[i].featureCount, expected[i].featureCount);
            }
            QCOMPARE(copper[i].counts[static_cast<std::size_t>(model::ElementKind::Circle)],
                     expected[i].counts[static_cast<std::size_t>(model::ElementKind::Circle)]);
        }
        int differing = 0;
        const auto found = pinsByNet(*ipc);
        for (const auto& [net, pins] : pinsByNet(*odb)) {
            const auto same = found.find(net);
            differing += same == found.end() || same->second != pins ? 1 : 0;
        }
        QCOMPARE(differing, differingNets);
    }

    void partsOnTheBottomLieOnTheirPads() {
        for (const char* name : {"StickHub", "RoyalBlue54L-Feather", "multichannel_mixer"}) {
            const Board board = read(kicadFile(name, "-ipc2581c.xml"));
            QVERIFY(board);
            QVERIFY(!reports(*board, "do not lie where its package puts them"));
        }
    }
};

QTEST_APPLESS_MAIN(Ipc2581BoardsTest)
#include "ipc2581_boards_test.moc"
