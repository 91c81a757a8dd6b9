// Opens and shorts are found, listed and gone to; nets are inferred from the copper.

#include <QAbstractItemModelTester>
#include <QLineEdit>
#include <QStatusBar>
#include <QToolButton>
#include <QtTest>

#include "tests/locations.h"
#include "tests/patience.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/table_view.h"
#include "ui/shell/message_bar.h"

using ui::ActionId;
using ui::NetlistCheckModel;

class NetlistCheckTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_fixture = std::make_unique<WindowFixture>();
        QVERIFY(m_fixture->openAndWait(locations::kTestData + QStringLiteral("/odb/open_short")));
    }
    void cleanup() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void theCheckListsShortsOpensAndFloatingCopper() {
        QCOMPARE(summary(), "Not checked yet");
        check();
        QCOMPARE(summary(), "1 short, 1 open net, 1 piece of floating copper");
        QCOMPARE(rows(), (QStringList{"Short|A, B|Touch in 1 location|TOP|4.0000 mm|5.0000 mm|PCB",
                                      "Open|SPLIT|Part of the net: 1 piece, 1 pad or hole|TOP|2.0000 mm|2.0000 mm|PCB",
                                      "Open|SPLIT|Part of the net: 1 piece, 1 pad or hole|TOP|4.0000 mm|2.0000 mm|PCB",
                                      "Floating|LOOSE|Copper without a pad: 1 piece|BOTTOM|6.0000 mm|8.0000 mm|PCB"}));
        QAbstractItemModelTester tester(&window().netCheck(), QAbstractItemModelTester::FailureReportingMode::QtTest);
        window().actions()[ActionId::NextUnit].trigger();
        QVERIFY2(rows().first().contains("157.48 mil"), qPrintable(rows().first()));
    }

    void aClickGoesToThePlaceAndSelectsWhatTouches() {
        check();
        window().layers().hideAll();
        click(0);
        QCOMPARE(window().selection().selected().size(), std::size_t{2});
        QVERIFY(window().layers().effectiveStyles()[0].isVisible);
        for (ui::BoardView* view : window().views().both()) {
            const glm::vec3 target = view->controller().camera().target();
            // 4, 5 mm on a board of 10 mm; in perspective the near side takes more room, in 2D rulers take some.
            const float off = view == &window().views().flat() ? 10.0F * view->controller().mmPerPixel() : 1.0F;
            QVERIFY(std::abs(target.x + 1.0F) < off);
            QVERIFY(std::abs(target.y) < off);
        }
        click(3);
        QCOMPARE(window().selection().selected().size(), std::size_t{1});
        QVERIFY(window().layers().effectiveStyles()[1].isVisible);
    }

    void arrowKeysShowTheNextFinding() {
        check();
        click(0);
        window().table("netCheck").setFocus();
        QTest::keyClick(&window().table("netCheck"), Qt::Key_Down);
        const auto& found = window().netCheck();
        QCOMPARE(window().selection().selected(),
                 (std::vector<model::BoardElement>{{0, found.elementsOf(found.finding(1)).front()}}));
    }

    void onlyTheLayerOfWhatIsShownStandsOut() {
        check();
        const auto isFaint = [&](ui::BoardView& view, const char* layer) {
            return view.styles()[window().document()->findLayer(layer).row()].opacity < 0.5F;
        };
        click(3);  // on BOTTOM
        for (ui::BoardView* view : window().views().both()) {
            QVERIFY(isFaint(*view, "TOP") && !isFaint(*view, "BOTTOM"));
        }
        click(0);
        for (ui::BoardView* view : window().views().both()) {
            QVERIFY(!isFaint(*view, "TOP") && isFaint(*view, "BOTTOM"));
        }
        window().selection().select({});
        QVERIFY(!isFaint(window().views().flat(), "TOP") && !isFaint(window().views().flat(), "BOTTOM"));
        click(3);
        QVERIFY(isFaint(window().views().flat(), "TOP"));
        QVERIFY(m_fixture->openAndWait(locations::kTestData + QStringLiteral("/odb/open_short")));
        QVERIFY2(!isFaint(window().views().flat(), "TOP"), "another board has no finding that is shown");
    }

    void rowsAreFiltered() {
        check();
        QTest::keyClicks(window().panel("netCheck").findChild<QLineEdit*>(), "split");
        QCOMPARE(window().table("netCheck").model()->rowCount(), 2);
    }

    void netsFromTheCopperHaveNoOpensAndGoBack() {
        m_fixture->key(Qt::Key_I, Qt::ControlModifier | Qt::ShiftModifier);
        waitForBoard();
        QVERIFY(window().actions()[ActionId::InferNets].isChecked());
        QCOMPARE(window().document()->nets.size(), std::size_t{5});
        QCOMPARE(summary(), "Not checked yet");
        check();
        QCOMPARE(summary(), "nothing to compare: the nets follow from the copper, no floating copper");
        m_fixture->key(Qt::Key_F5);
        waitForBoard();
        QCOMPARE(window().document()->nets.size(), std::size_t{5});
        window().actions()[ActionId::InferNets].trigger();
        waitForBoard();
        QCOMPARE(window().document()->findNet("SPLIT").isValid(), true);
    }

    void cancelledInferenceKeepsTheJobsNets() {
        window().actions()[ActionId::InferNets].trigger();
        QVERIFY(window().loader().isLoading());
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(!window().loader().isLoading());
        QVERIFY(!window().actions()[ActionId::InferNets].isChecked());
        QVERIFY(window().document()->findNet("SPLIT").isValid());
    }

    void aCheckIsStoppedByEscapeAndByItsButton() {
        window().actions()[ActionId::CheckNets].trigger();
        QVERIFY(window().workspace().isWorking());
        QVERIFY(workBar().isVisible());
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(!window().workspace().isWorking());
        window().actions()[ActionId::CheckNets].trigger();
        workBar().findChild<QToolButton*>()->click();
        QVERIFY(!window().workspace().isWorking());
        QVERIFY(!workBar().isVisible());
        QTest::qWait(200);
        QCOMPARE(summary(), "Not checked yet");
    }

    void anotherBoardEndsTheCheck() {
        window().actions()[ActionId::CheckNets].trigger();
        QVERIFY(m_fixture->openAndWait(locations::kTestData + QStringLiteral("/odb/everything")));
        QVERIFY(!window().workspace().isWorking());
        QCOMPARE(summary(), "Not checked yet");
        QCOMPARE(window().netCheck().rowCount(), 0);
    }

private:
    TestWindow& window() { return m_fixture->window(); }

    QWidget& workBar() { return *window().findChild<QWidget*>("work"); }
    QString summary() { return window().panel("netCheck").findChild<QLabel*>()->text(); }

    void waitForBoard() {
        QVERIFY(window().loader().isLoading());
        QTRY_VERIFY(!window().loader().isLoading());
    }

    void check() {
        m_fixture->key(Qt::Key_N, Qt::ControlModifier | Qt::ShiftModifier);  // such a small check may be done by now
        QTRY_VERIFY(!window().workspace().isWorking());
    }

    void click(int row) {
        QTableView& table = window().table("netCheck");
        const QModelIndex at = table.model()->index(row, NetlistCheckModel::What);
        table.scrollTo(at);
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, table.visualRect(at).center());
    }

    QStringList rows() {
        const QAbstractItemModel& model = *window().table("netCheck").model();
        QStringList lines;
        for (int row = 0; row < model.rowCount(); ++row) {
            QStringList cells;
            for (int column = 0; column < model.columnCount(); ++column) {
                cells += model.index(row, column).data().toString();
            }
            lines += cells.join('|');
        }
        return lines;
    }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(NetlistCheckTest)
#include "netlist_check_test.moc"
