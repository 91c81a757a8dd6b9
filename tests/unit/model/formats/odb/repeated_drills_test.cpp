#include "model/formats/odb/repeated_drills.h"

#include <QtTest>

#include "model/board/holes.h"
#include "tests/unit/model/formats/odb/odb_testing.h"

using model::LayerType;
using namespace odb_testing;

namespace {

const std::string kHead = "UNITS=MM\n@0 .drill\n$0 r900\n$1 r300\n";
const std::string kVias = "P 10 10 1 P 0 0;0=2\nP 20 20 1 P 0 0;0=2\n";

/// Two layers of drills through the same copper.
std::shared_ptr<const model::Document> boardWith(const std::string& first, const std::string& second,
                                                 const std::string& end = "BOT") {
    const Folder folder;
    writeSmallJob(folder, "UNITS=MM\n$0 r1000\nP 10 10 0 P 0 0\nP 20 20 0 P 0 0\n");
    const auto drill = [](const char* name, const std::string& to) {
        return "LAYER {\n ROW=9\n CONTEXT=BOARD\n TYPE=DRILL\n NAME=" + std::string(name) +
               "\n START_NAME=TOP\n END_NAME=" + to + "\n}\n";
    };
    folder.write("matrix/matrix", matrixOf({{"SIGNAL", "TOP"}, {"SIGNAL", "IN"}, {"SIGNAL", "BOT"}}) +
                                      drill("PLATED", "BOT") + drill("TYPE_1B", end));
    folder.write("steps/board/layers/plated/features", kHead + first);
    folder.write("steps/board/layers/type_1b/features", kHead + second);
    return read(folder.path());
}

LayerType typeOf(const model::Document& board, const char* layer) {
    return board.layer(board.findLayer(layer)).type;
}

}  // namespace

class RepeatedDrillsTest : public QObject {
    Q_OBJECT

private slots:
    void holesListedTwiceAreDrilledOnce() {
        const auto board = boardWith("P 5 5 0 P 0 0;0=0\n" + kVias, kVias);
        QCOMPARE(typeOf(*board, "PLATED"), LayerType::Drill);
        QCOMPARE(typeOf(*board, "TYPE_1B"), LayerType::Document);
        std::size_t holes = 0;
        for (const model::DrillRow& row : model::drillTable(*board)) {
            holes += row.count;
        }
        QCOMPARE(holes, std::size_t{3});
        QVERIFY(findDiagnostic(board->diagnostics, "layer TYPE_1B has only holes that PLATED has too") != nullptr);
    }

    void ofTwoThatAreTheSameTheFirstStays() {
        const auto board = boardWith(kVias, kVias);
        QCOMPARE(typeOf(*board, "PLATED"), LayerType::Drill);
        QCOMPARE(typeOf(*board, "TYPE_1B"), LayerType::Document);
    }

    void otherHolesStay_data() {
        QTest::addColumn<QString>("second");
        QTest::addColumn<QString>("end");
        QTest::newRow("one more") << "P 10 10 1 P 0 0;0=2\nP 30 20 1 P 0 0;0=2\n"
                                  << "BOT";
        QTest::newRow("wider") << "P 10 10 0 P 0 0;0=2\n"
                               << "BOT";
        QTest::newRow("not plated") << "P 10 10 1 P 0 0;0=1\n"
                                    << "BOT";
        QTest::newRow("of another span") << "P 10 10 1 P 0 0;0=2\n"
                                         << "IN";
        QTest::newRow("none") << ""
                              << "BOT";
    }
    void otherHolesStay() {
        QFETCH(QString, second);
        QFETCH(QString, end);
        const auto board = boardWith(kVias, second.toStdString(), end.toStdString());
        QCOMPARE(typeOf(*board, "PLATED"), LayerType::Drill);
        QCOMPARE(typeOf(*board, "TYPE_1B"), LayerType::Drill);
    }
};

QTEST_APPLESS_MAIN(RepeatedDrillsTest)
#include "repeated_drills_test.moc"
