#include "model/formats/common/routed_cutouts.h"

#include <QtTest>

#include "model/geometry/loops/edge_loops.h"
#include "model/solids/shells/area_shell.h"
#include "tests/unit/model/formats/odb/odb_testing.h"

using namespace odb_testing;

namespace {

/// A board of 100 mm by 100 mm with a layer of routed slots and copper on its top.
std::shared_ptr<const model::Document> boardWith(const std::string& routed, const std::string& copper = {}) {
    const Folder folder;
    writeSmallJob(folder, "UNITS=MM\n$0 r1000\nP 90 90 0 P 0 0\n" + copper);
    folder.write("matrix/matrix", matrixOf({{"SIGNAL", "TOP"}, {"ROUT", "ROUT"}}));
    folder.write("steps/board/layers/rout/features", "UNITS=MM\n$0 r200\n$1 r0\n" + routed);
    return read(folder.path());
}

/// A path along a square of 20 mm around (50, 50).
const std::string kSquare = "L 40 40 60 40 0 P 0\nL 60 40 60 60 0 P 0\nL 60 60 40 60 0 P 0\nL 40 60 40 40.05 0 P 0\n";

const char* const kMessage = "a closed routed path cuts a piece without copper out of the board";

bool isHole(const model::Document& board, model::ElementId element) {
    return (board.elements.flags[element.row()] & model::kHole) != 0;
}

/// Of the board within its outline, in mm².
double areaOf(const model::Document& board) {
    double area = 0.0;
    for (const model::EdgeLoops& region : model::areaOutlines(board.shapes, board.profile)) {
        area += model::areaOf(region);
    }
    return area / 1e12;
}

}  // namespace

class RoutedCutoutsTest : public QObject {
    Q_OBJECT

private slots:
    void whatAClosedPathEnclosesFallsOut() {
        const auto board = boardWith(kSquare);
        QCOMPARE(qRound(areaOf(*board)), 10'000 - 400);
        const model::Diagnostic* message = findDiagnostic(board->diagnostics, kMessage);
        QVERIFY(message != nullptr);
        QCOMPARE(message->line, 4U);
        QVERIFY(message->element.isValid());
    }

    void circlesAreClosedPaths() {
        const auto board = boardWith("A 60 50 60 50 50 50 0 P 0 Y\n");
        QVERIFY(std::abs(areaOf(*board) - (10'000 - 314.159)) < 0.01);
    }

    void whatHoldsCopperStays_data() {
        QTest::addColumn<QString>("copper");
        QTest::newRow("a pad") << "P 41 41 0 P 0 0\n";
        QTest::newRow("a pour that covers it") << "S P 0\nOB 20 20 I\nOS 80 20\nOS 80 80\nOS 20 80\nOS 20 20\nOE\nSE\n";
    }
    void whatHoldsCopperStays() {
        QFETCH(QString, copper);
        const auto board = boardWith(kSquare, copper.toStdString());
        QCOMPARE(qRound(areaOf(*board)), 10'000);
        QVERIFY(findDiagnostic(board->diagnostics, kMessage) == nullptr);
    }

    void aPourAroundItDoesNotKeepIt() {
        const auto board = boardWith(kSquare,
                                     "S P 0\nOB 20 20 I\nOS 80 20\nOS 80 80\nOS 20 80\nOS 20 20\nOE\nOB 39 39 H\n"
                                     "OS 39 61\nOS 61 61\nOS 61 39\nOS 39 39\nOE\nSE\n");
        QCOMPARE(qRound(areaOf(*board)), 10'000 - 400);
    }

    /// Two openings in a pour: one has an island within, and of both the pour is asked.
    void islandsInOpeningsOfPoursKeepTheirPieces() {
        const auto square = [](int x, int y, int side, char kind) {
            const auto corner = [](int px, int py) { return std::to_string(px) + " " + std::to_string(py) + "\n"; };
            const int far = y + side;
            // Islands clockwise, holes counter-clockwise.
            return std::string("OB ") + std::to_string(x) + " " + std::to_string(y) + " " + kind + "\n" +
                   (kind == 'I'
                        ? "OS " + corner(x, far) + "OS " + corner(x + side, far) + "OS " + corner(x + side, y)
                        : "OS " + corner(x + side, y) + "OS " + corner(x + side, far) + "OS " + corner(x, far)) +
                   "OS " + corner(x, y) + "OE\n";
        };
        const auto path = [](int x) {
            const std::string left = std::to_string(x);
            const std::string right = std::to_string(x + 10);
            return "L " + left + " 45 " + right + " 45 0 P 0\nL " + right + " 45 " + right + " 55 0 P 0\nL " + right +
                   " 55 " + left + " 55 0 P 0\nL " + left + " 55 " + left + " 45 0 P 0\n";
        };
        const auto board =
            boardWith(path(25) + path(65), "S P 0\n" + square(10, 10, 78, 'I') + square(23, 43, 14, 'H') +
                                               square(63, 43, 14, 'H') + square(69, 49, 2, 'I') + "SE\n");
        QCOMPARE(qRound(areaOf(*board)), 10'000 - 100);
    }

    void compensatedPathsCutBesideTheOutline() {
        // As Altium writes a board with a cut-out: paths along both, with compensation, each ended by a dot.
        const std::string head = "@0 .comp\n@1 .feed\n";
        const auto path = [](const std::string& corners, const char* tail) {
            std::string text = corners;
            for (std::size_t at = 0; (at = text.find('\n', at)) != std::string::npos;
                 at += std::string(tail).size() + 1) {
                text.insert(at, tail);
            }
            return text;
        };
        const std::string inner =
            "L 40 40 60 40 0 P 0\nL 60 40 60 60 0 P 0\nL 60 60 40 60 0 P 0\nL 40 60 40 40 0 P 0\n"
            "L 40 40 40 40 0 P 0\n";
        const std::string outer =
            "L 0 0 100 0 0 P 0\nL 100 0 100 100 0 P 0\nL 100 100 0 100 0 P 0\n"
            "L 0 100 0 0 0 P 0\n";
        const std::string slot = "L 10 80 30 80 0 P 0\n";
        const auto board = boardWith(head + path(inner + outer + slot, " ;0=2 1=200"));
        QCOMPARE(qRound(areaOf(*board)), 10'000 - 400);
        const model::Layer& layer = board->layer(board->findLayer("ROUT"));
        double cut = 0.0;
        int holes = 0;
        for (std::uint32_t i = 0; i < layer.elements.count; ++i) {
            const model::ElementId id{layer.elements.first + i};
            holes += isHole(*board, id) ? 1 : 0;
            cut += squareMillimetres(*board, id);
        }
        // Half of the pen's 0.2 mm along 4 * 20 mm within the cut-out and 4 * 100 mm around the board; all of the slot.
        const double expected = (80 * 0.1 - 4 * 0.01) + (400 * 0.1 + 3.1416 * 0.01) + (20 * 0.2 + 3.1416 * 0.01);
        QVERIFY2(std::abs(cut - expected) < 0.05, QByteArray::number(cut).constData());
        QCOMPARE(holes, 1);  // the slot
        QVERIFY(findDiagnostic(board->diagnostics, "a routed path with compensation is the edge of what stays") !=
                nullptr);
        const auto without = boardWith(head + path(outer, " ;0=0 1=200"));
        QVERIFY(findDiagnostic(without->diagnostics, "with compensation") == nullptr);
    }

    /// Neither a profile nor copper that one could be made up around.
    void withoutAnOutlineNoPathIsItsContour() {
        const Folder folder;
        writeSmallJob(folder, "UNITS=MM\n");
        std::filesystem::remove(folder.path() / "steps/board/profile");
        folder.write("matrix/matrix", matrixOf({{"SIGNAL", "TOP"}, {"ROUT", "ROUT"}}));
        folder.write("steps/board/layers/rout/features",
                     "UNITS=MM\n$0 r0\n$1 r200\nL 0 0 10 0 0 P 0\nL 10 0 20 0 1 P 0\n");
        const auto board = read(folder.path());
        QVERIFY(!board->profile.isValid());
        QVERIFY(findDiagnostic(board->diagnostics, "a routed path") == nullptr);
        const model::Range elements = board->layer(board->findLayer("ROUT")).elements;
        QCOMPARE(elements.count, 2U);
        for (std::uint32_t i = 0; i < elements.count; ++i) {
            QVERIFY(isHole(*board, model::ElementId{elements.first + i}));
        }
    }

    /// The board as programs draw it for the router: with a pen on the outline or beside it, or without a width.
    void contoursOfTheBoardAreNoHoles_data() {
        QTest::addColumn<QString>("routed");
        QTest::addColumn<bool>("isSlot");
        QTest::newRow("on the outline") << "L 0 0 100 0 0 P 0\nL 100 0 100 100 0 P 0\nL 100 100 0 100 0 P 0\n"
                                           "L 0 100 0 0 0 P 0\n"
                                        << false;
        QTest::newRow("beside it") << "L -0.1 -0.1 100.1 -0.1 0 P 0\nL 100.1 -0.1 100.1 100.1 0 P 0\n"
                                      "L 100.1 100.1 -0.1 100.1 0 P 0\nL -0.1 100.1 -0.1 -0.1 0 P 0\n"
                                   << false;
        QTest::newRow("in pieces") << "L 0 0 100 0 0 P 0\nL 100 50 100 100 0 P 0\n" << false;
        QTest::newRow("across the board") << "L 0 0 100 100 0 P 0\n" << true;
        QTest::newRow("beside it, within") << "L 0.1 0.1 99.9 0.1 0 P 0\n" << true;
        QTest::newRow("without a width, with round corners")
            << "L 5 0 95 0 1 P 0\nA 95 0 100 5 95 5 1 P 0 N\nL 100 5 100 100 1 P 0\nL 100 100 0 100 1 P 0\n"
               "L 0 100 0 5 1 P 0\nA 0 5 5 0 5 5 1 P 0 N\n"
            << false;
        QTest::newRow("without a width, across") << "L 0 50 100 50 1 P 0\n" << true;
    }
    void contoursOfTheBoardAreNoHoles() {
        QFETCH(QString, routed);
        QFETCH(bool, isSlot);
        const auto board = boardWith(routed.toStdString());
        QCOMPARE(qRound(areaOf(*board)), 10'000);
        const model::Range elements = board->layer(board->findLayer("ROUT")).elements;
        QVERIFY(elements.count > 0);
        for (std::uint32_t i = 0; i < elements.count; ++i) {
            QCOMPARE(isHole(*board, model::ElementId{elements.first + i}), isSlot);
        }
        QCOMPARE(findDiagnostic(board->diagnostics, "a routed path") == nullptr, isSlot);
    }

    void otherPathsCutNothingOut_data() {
        QTest::addColumn<QString>("routed");
        QTest::newRow("open") << "L 40 40 60 40 0 P 0\nL 60 40 60 60 0 P 0\nL 60 60 40 60 0 P 0\n";
        QTest::newRow("around the board") << "L 0 0 100 0 0 P 0\nL 100 0 100 100 0 P 0\nL 100 100 0 100 0 P 0\n"
                                             "L 0 100 0 0 0 P 0\n";
        QTest::newRow("off the board") << "A 210 50 210 50 200 50 0 P 0 Y\n";
    }
    void otherPathsCutNothingOut() {
        QFETCH(QString, routed);
        const auto board = boardWith(routed.toStdString());
        QCOMPARE(qRound(areaOf(*board)), 10'000);
    }
};

QTEST_APPLESS_MAIN(RoutedCutoutsTest)
#include "routed_cutouts_test.moc"
