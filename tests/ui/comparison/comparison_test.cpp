// Two boards are compared, and what differs is listed, gone to and painted.

#include <QAbstractItemModelTester>
#include <QLabel>
#include <QLineEdit>
#include <QtTest>
#include <filesystem>
#include <fstream>

#include "tests/locations.h"
#include "tests/patience.h"
#include "tests/ui/window_fixture.h"
#include "ui/comparison/comparison_feature.h"

using ui::ActionId;
using ui::ComparisonFeature;
using ui::ComparisonModel;
using ui::DifferenceMarks;

namespace {

const QString kBoard = locations::kTestData + QStringLiteral("/odb/open_short");

}  // namespace

class ComparisonTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_fixture = std::make_unique<WindowFixture>();
        QVERIFY(m_fixture->openAndWait(kBoard));
        // The other board has a track more on top, in the empty corner, and one less on the bottom.
        const std::filesystem::path layers = m_fixture->copyOfJob("open_short") / "steps/pcb/layers";
        std::ofstream(layers / "top/features", std::ios::app) << "L 7 1 9 1 1 P 0\n";
        std::ofstream(layers / "bottom/features") << "UNITS=MM\n$0 r1000\n$1 r200\nP 2 8 0 P 0 0\nL 2 8 4 8 1 P 0\n";
    }
    void cleanup() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void differencesComeFirstWithTheirPlaces() {
        QCOMPARE(summary(), "Not compared yet");
        compareByTheMenu();
        QCOMPARE(summary(), "2 differences: copper 2. A is this board, B is open_short");
        const QStringList lines = rows();
        QCOMPARE(lines[0], "Copper|TOP|only in B 0.3840 mm²|6.9800 mm|0.9100 mm");
        QVERIFY2(lines[1].startsWith("Copper|BOTTOM|only in A 0.3"), qPrintable(lines[1]));
        QVERIFY2(lines.contains("Outline||the same||"), qPrintable(lines.join('\n')));
        QVERIFY2(std::ranges::any_of(lines, [](const QString& line) { return line.contains("not compared: "); }),
                 qPrintable(lines.join('\n')));
        QAbstractItemModelTester tester(&model(), QAbstractItemModelTester::FailureReportingMode::QtTest);
        window().actions()[ActionId::NextUnit].trigger();
        QVERIFY2(rows().first().contains("mil"), qPrintable(rows().first()));
    }

    void aBoardIsTheSameAsItself() {
        compare(kBoard);
        QCOMPARE(summary(), "No differences. A is this board, B is open_short");
        QVERIFY(marks().places().empty());
    }

    void aClickGoesToThePlaceAndPaintsWhatDiffers() {
        compare(otherBoard());
        QTRY_COMPARE(marks().places().size(), std::size_t{2});
        QVERIFY(!marks().chosen());
        window().layers().hideAll();
        click(0);
        const model::LayerId top = window().document()->findLayer("TOP");
        QVERIFY(marks().chosen() && marks().chosen()->layer == top);
        QVERIFY(window().layers().effectiveStyles()[top.row()].isVisible);
        const ui::CameraController& flat = window().views().flat().controller();
        QVERIFY(std::abs(flat.camera().target().x - 3.0F) < 0.3F);  // 8, 1 mm on a board of 10 mm
        QVERIFY(std::abs(flat.camera().target().y + 4.0F) < 0.3F);
        QTRY_VERIFY(pixelsLike(DifferenceMarks::kOnlyColours[1]) > 500);
        QCOMPARE(pixelsLike(DifferenceMarks::kOnlyColours[0]), 0);
        click(1);
        QTRY_VERIFY(pixelsLike(DifferenceMarks::kOnlyColours[0]) > 500);
        QCOMPARE(pixelsLike(DifferenceMarks::kOnlyColours[1]), 0);
    }

    void escapeEndsWhatIsShownAndTheFramesStay() {
        compare(otherBoard());
        click(0);
        QTRY_VERIFY(pixelsLike(DifferenceMarks::kOnlyColours[1]) > 500);
        const model::LayerId bottom = window().document()->findLayer("BOTTOM");
        const auto isFaint = [&] { return window().views().flat().styles()[bottom.row()].opacity < 0.5F; };
        QVERIFY(isFaint());
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(!marks().chosen());
        QVERIFY(!isFaint());
        QTRY_COMPARE(pixelsLike(DifferenceMarks::kOnlyColours[1]), 0);
        QCOMPARE(marks().places().size(), std::size_t{2});
    }

    void nothingIsPaintedWhileThePanelIsClosed() {
        compare(otherBoard());
        click(0);
        QTRY_VERIFY(pixelsLike(DifferenceMarks::kOnlyColours[1]) > 500);
        window().actions()[ActionId::ShowComparisonDock].trigger();
        QTRY_COMPARE(pixelsLike(DifferenceMarks::kOnlyColours[1]), 0);
        window().actions()[ActionId::ShowComparisonDock].trigger();
        QTRY_VERIFY(pixelsLike(DifferenceMarks::kOnlyColours[1]) > 500);
    }

    void framesAreThoseOfTheListedRows() {
        compare(otherBoard());
        QTRY_COMPARE(marks().places().size(), std::size_t{2});
        QTest::keyClicks(window().panel("comparison").findChild<QLineEdit*>(), "bottom");
        QTRY_COMPARE(marks().places().size(), std::size_t{1});
        QVERIFY(marks().places()[0].layer == window().document()->findLayer("BOTTOM"));
    }

    void aRowWithoutAPlaceEndsTheOneBefore() {
        compare(otherBoard());
        click(0);
        QVERIFY(marks().chosen());
        click(static_cast<int>(rows().indexOf("Outline||the same||")));
        QVERIFY(!marks().chosen());
    }

    void whatCannotBeReadIsSaidAndWhatWasFoundStays() {
        compare(otherBoard());
        compare(QStringLiteral("/does/not/exist.tgz"));
        QVERIFY2(window().error().contains("exist.tgz"), qPrintable(window().error()));
        QCOMPARE(model().rowCount(), rows().size());
        QVERIFY(summary().startsWith("2 differences"));
    }

    void anotherBoardEndsTheComparison() {
        compare(otherBoard());
        click(0);
        QVERIFY(m_fixture->openAndWait(locations::kTestData + QStringLiteral("/odb/everything")));
        QCOMPARE(summary(), "Not compared yet");
        QCOMPARE(model().rowCount(), 0);
        QTRY_VERIFY(marks().places().empty());
        QVERIFY(!marks().chosen());
    }

    void itIsStoppedByEscape() {
        feature().start(otherBoard());
        QVERIFY(window().workspace().isWorking());
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(!window().workspace().isWorking());
        QTest::qWait(200);
        QCOMPARE(summary(), "Not compared yet");
    }

private:
    TestWindow& window() { return m_fixture->window(); }
    ComparisonFeature& feature() { return window().find<ComparisonFeature>(); }
    DifferenceMarks& marks() { return window().find<DifferenceMarks>(); }
    ComparisonModel& model() { return window().find<ComparisonModel>(); }
    QString summary() { return window().panel("comparison").findChild<QLabel*>("summary")->text(); }
    QString otherBoard() { return QString::fromStdString(m_fixture->copyOfJob("open_short").string()); }

    void compare(const QString& path) {
        window().showPanel("comparison");
        feature().start(path);
        QTRY_VERIFY(!window().workspace().isWorking());
    }

    void compareByTheMenu() {
        window().actions()[ActionId::CompareFolder].trigger();
        window().nameFile(otherBoard());
        QTRY_VERIFY(!window().workspace().isWorking());
        QVERIFY(window().panel("comparison").isVisible());
    }

    void click(int row) {
        QTableView& table = window().table("comparison");
        const QModelIndex at = table.model()->index(row, ComparisonModel::What);
        table.scrollTo(at);
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, table.visualRect(at).center());
    }

    QStringList rows() {
        const QAbstractItemModel& table = *window().table("comparison").model();
        QStringList lines;
        for (int row = 0; row < table.rowCount(); ++row) {
            QStringList cells;
            for (int column = 0; column < table.columnCount(); ++column) {
                cells += table.index(row, column).data().toString();
            }
            lines += cells.join('|');
        }
        return lines;
    }

    /// In what the 2D view shows.
    int pixelsLike(const QColor& colour) {
        const QImage shown = window().views().flat().grabPicture()->convertToFormat(QImage::Format_RGB32);
        int count = 0;
        for (int y = 0; y < shown.height(); ++y) {
            for (int x = 0; x < shown.width(); ++x) {
                count += shown.pixel(x, y) == colour.rgb() ? 1 : 0;
            }
        }
        return count;
    }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(ComparisonTest)
#include "comparison_test.moc"
