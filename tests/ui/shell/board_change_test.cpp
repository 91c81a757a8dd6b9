// What is begun on one board, and what is shown of it, does not reach the next; what was edited of one that is read
// anew stays.

#include <QFileDialog>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QtTest>
#include <atomic>
#include <thread>

#include "tests/locations.h"
#include "tests/patience.h"
#include "tests/ui/window_fixture.h"
#include "ui/export/export_dialog.h"

using base::ErrorCode;
using model::OpenRequest;
using ui::ActionId;
using ui::LoadedBoard;

namespace {

std::atomic<bool> isHeld = false;

/// A board that was read is not delivered while boards are held.
base::Result<LoadedBoard> heldWork(const OpenRequest& request, base::Progress& progress) {
    base::Result<LoadedBoard> board = ui::loadBoard(request, progress);
    while (isHeld && !progress.isCancelled()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return board;
}

}  // namespace

class BoardChangeTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        isHeld = false;
        m_fixture = std::make_unique<WindowFixture>(heldWork);
        m_sample = m_fixture->copyOfSample();
        QVERIFY(m_fixture->openAndWait(m_sample));
    }
    void cleanup() {
        isHeld = false;
        QCOMPARE(validationErrorsOnClosing(m_fixture), 0U);
    }

    void dialogsGoWithTheirBoard() {
        beginOther();
        window().actions()[ActionId::ExportBoard].trigger();
        const QPointer<QDialog> dialog = window().findChild<ui::ExportDialog*>();
        QVERIFY(dialog && dialog->isVisible());
        arrive();
        QTRY_VERIFY(!dialog || !dialog->isVisible());
    }

    void theDialogThatOpensAnotherBoardStays() {
        beginOther();
        window().actions()[ActionId::OpenFile].trigger();
        const QPointer<QFileDialog> dialog = window().findChild<QFileDialog*>();
        QVERIFY(dialog && dialog->isVisible());
        arrive();
        QVERIFY(dialog && dialog->isVisible());
        dialog->reject();
    }

    void menusGoWithTheirBoard() {
        beginOther();
        QMenu menu(&window());
        menu.addAction("Only layer TOP");
        menu.popup(window().mapToGlobal(QPoint(50, 50)));
        QTRY_VERIFY(menu.isVisible());
        arrive();
        QVERIFY(!menu.isVisible());
    }

    void theSearchBoxListsTheBoardThatIsThere() {
        m_fixture->key(Qt::Key_F, Qt::ControlModifier);
        QTest::keyClicks(&window().searchBox().line(), "1pps_out");
        QVERIFY(window().searchBox().list().item(0)->text().startsWith("1PPS_OUT"));
        beginOther();
        arrive();
        QVERIFY(window().searchBox().isVisible());
        QVERIFY2(!window().searchBox().list().item(0)->text().startsWith("1PPS_OUT"), "it is on no net of this board");
        window().searchBox().close();
    }

    void editsMadeWhileItIsReadAnewStay() {
        isHeld = true;
        m_fixture->key(Qt::Key_F5);
        QTest::qWait(300);  // the file has been read
        window().actions()[ActionId::SaveView].trigger();
        const model::SetThicknesses set{{{"L02-INNER_LAYER", 70'000}}, {}};
        const auto thicker = model::session::applyThicknesses(window().workspace().board()->document, set.all());
        window().workspace().restack(thicker, set, true);
        arrive();
        QCOMPARE(window().find<ui::ViewListModel>().rowCount(), 1);
        QCOMPARE(window().workspace().board()->thicknesses, set);
        QCOMPARE(heightOf("L02-INNER_LAYER"), 70'000.0);
        m_fixture->key(Qt::Key_F5);  // now it is in the file
        QVERIFY(window().awaitWork());
        QCOMPARE(window().find<ui::ViewListModel>().rowCount(), 1);
    }

    void theCurrentLayerAndTheOneAloneStay() {
        const model::LayerId layer = window().document()->findLayer("L02-INNER_LAYER");
        window().workspace().setCurrentLayer(layer);
        m_fixture->key(Qt::Key_H);
        QCOMPARE(window().layers().soloLayer(), layer);
        m_fixture->key(Qt::Key_F5);
        QVERIFY(window().awaitWork());
        QCOMPARE(window().workspace().currentLayer(), layer);
        QCOMPARE(window().layers().soloLayer(), layer);
    }

    void aBoardsUnitIsNotTheUsers() {
        const ui::LengthUnit own = window().workspace().unit();
        m_fixture->key(Qt::Key_Q);
        const ui::LengthUnit ofBoard = window().workspace().unit();
        window().actions()[ActionId::SaveSession].trigger();
        while (window().workspace().unit() != own) {
            m_fixture->key(Qt::Key_Q);
        }
        QVERIFY(m_fixture->openAndWait(m_other));
        QVERIFY(window().workspace().unit() == own);
        QVERIFY(m_fixture->openAndWait(m_sample));
        QVERIFY(window().workspace().unit() == ofBoard);
        QVERIFY(m_fixture->settings().choice<ui::LengthUnit>() == own);
        QVERIFY(m_fixture->openAndWait(m_other));
        QVERIFY(window().workspace().unit() == own);
    }

    void closingAsksWhileAFileIsWritten() {
        ui::Background writing;
        window().workspace().watchWriting(writing, [] { return QString("board.step"); });
        writing.start(untilStopped, "Writing");
        window().close();
        QVERIFY(window().isVisible());
        const QPointer<QMessageBox> question = window().findChild<QMessageBox*>();
        QVERIFY(question && question->text().startsWith("board.step is still being written"));
        QTest::mouseClick(question->button(QMessageBox::Cancel), Qt::LeftButton);
        QVERIFY(window().isVisible() && writing.isRunning());
        window().close();
        const auto questions = window().findChildren<QMessageBox*>();
        QTest::mouseClick(questions.back()->button(QMessageBox::Close), Qt::LeftButton);
        QVERIFY(!window().isVisible());
        writing.cancel();
    }

    void aFileIsWrittenToItsEndWhileAnotherBoardIsOpened() {
        ui::Background writing;
        window().workspace().watchWriting(writing, [] { return QString("board.step"); });
        writing.start(untilStopped, "Writing");
        beginOther();
        isHeld = false;
        QTRY_VERIFY(window().document()->job.name != m_name);
        QVERIFY(writing.isRunning());
        QVERIFY(window().actions()[ActionId::Fit].isEnabled());
        QCOMPARE(window().workspace().fileAtWork(), QString("board.step"));
        QVERIFY2(window().actions()[ActionId::CancelLoading].isEnabled(), "there is something to stop");
        QVERIFY(window().workspace().cancelWork());
        QVERIFY(!writing.isRunning());
    }

private:
    static void untilStopped(base::Progress& progress) {
        while (!progress.isCancelled()) {
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        }
    }

    TestWindow& window() { return m_fixture->window(); }

    void beginOther() {
        m_name = window().document()->job.name;
        isHeld = true;
        window().open(std::filesystem::path(m_other.toStdString()));
    }
    void arrive() {
        isHeld = false;
        QVERIFY(window().awaitWork());
    }
    [[nodiscard]] double heightOf(const char* layer) {
        const model::Document& board = *window().document();
        const auto row = std::ranges::find(board.stackup.rows, board.findLayer(layer), &model::StackupRow::layer);
        return row != board.stackup.rows.end() ? static_cast<double>(row->thickness) : 0.0;
    }

    std::unique_ptr<WindowFixture> m_fixture;
    QString m_sample;
    QString m_other = QString(locations::kTestData) + "/odb/panel";
    std::string m_name;
};

QTEST_MAIN(BoardChangeTest)
#include "board_change_test.moc"
