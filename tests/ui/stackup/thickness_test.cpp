// Thicknesses are edited in the window, undone, redone, and kept in the session file beside the job.

#include <QDirIterator>
#include <QLineEdit>
#include <QStatusBar>
#include <QToolButton>
#include <QtTest>

#include "model/board/stackup.h"
#include "model/measure/items.h"
#include "tests/locations.h"
#include "tests/patience.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/table_view.h"
#include "ui/shell/message_bar.h"
#include "ui/stackup/stackup_panel.h"

using ui::ActionId;
using ui::StackupModel;
namespace fs = std::filesystem;

namespace {

/// All files of a folder with what is in them.
QMap<QString, QByteArray> contents(const fs::path& folder) {
    QMap<QString, QByteArray> files;
    QDirIterator all(QString::fromStdString(folder.string()), QDir::Files, QDirIterator::Subdirectories);
    while (all.hasNext()) {
        QFile file(all.next());
        files[file.fileName()] = file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray("unreadable");
    }
    return files;
}

}  // namespace

class ThicknessTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_fixture = std::make_unique<WindowFixture>();
        m_job = m_fixture->copyOfJob("everything");
        m_session = m_job.string() + ".copperscope.json";
        window().showPanel("stackup");
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(m_job.string())));
        window().actions()[ActionId::ViewIso].trigger();
    }
    void cleanup() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void aTypedThicknessIsSeenInEveryPlace() {
        const QImage before = m_fixture->picture();
        QCOMPARE(window().label("stackupSummary"), "5 of 9 thicknesses assumed");
        type("BOTTOM", "0.5 mm");
        QCOMPARE(rowOf("BOTTOM").thickness, 500'000);
        QCOMPARE(rowOf("BOTTOM").source, model::Source::Session);
        QCOMPARE(textOf("BOTTOM", StackupModel::Thickness), "500 µm");
        QCOMPARE(textOf("BOTTOM", StackupModel::From), "edited");
        QCOMPARE(textOf("CORE2", StackupModel::Thickness), "795.2 µm");  // the board is 1.6 mm thick, says the job
        const QString said = window().statusBar()->currentMessage();
        QVERIFY2(said.contains("changed too") && said.endsWith("CORE2"), qPrintable(said));
        QCOMPARE(window().label("stackupSummary"), "4 of 9 thicknesses assumed");
        QVERIFY(differingPixels(before, m_fixture->picture()) > 20);
    }

    void thicknessesAreShownAndTypedInTheUnitOfTheWindow() {
        while (window().workspace().unit() != ui::LengthUnit::Mil) {
            m_fixture->key(Qt::Key_Q);
        }
        QCOMPARE(textOf("CORE1", StackupModel::Thickness), "7.87 mil");
        QCOMPARE(cell("CORE1", StackupModel::Thickness).data(Qt::ToolTipRole).toString().section(',', 0, 0),
                 "7.87 mil (0.2 mm)");
        QVERIFY(textOf("CORE1", StackupModel::Cumulative).endsWith(" mil"));
        QVERIFY(textOf("Overall", StackupModel::Cumulative).endsWith(" mil"));
        type("CORE1", "7.87 mil");  // as it is shown: nothing is changed by that
        QCOMPARE(rowOf("CORE1").thickness, 200'000);
        QVERIFY(!window().actions()[ActionId::Undo].isEnabled());
        type("CORE1", "10");
        QCOMPARE(rowOf("CORE1").thickness, 254'000);
        type("CORE1", "35um");
        QCOMPARE(rowOf("CORE1").thickness, 35'000);
        QCOMPARE(textOf("CORE1", StackupModel::Thickness), "1.38 mil");
        m_fixture->key(Qt::Key_Q);
        QCOMPARE(textOf("CORE1", StackupModel::Thickness), "0.00138 in");
        type("CORE1", "0.01");
        QCOMPARE(rowOf("CORE1").thickness, 254'000);
        m_fixture->key(Qt::Key_Q);
        QCOMPARE(textOf("CORE1", StackupModel::Thickness), "254 µm");
        type("CORE1", "100");  // shown in µm, so typed in µm
        QCOMPARE(rowOf("CORE1").thickness, 100'000);
    }

    void whatIsTypedIntoASelectedThicknessIsNoCommand() {
        QTableView& table = window().stackupPanel().table();
        const QModelIndex at = cell("CORE1", StackupModel::Thickness);
        table.scrollTo(at);
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, table.visualRect(at).center());
        window().actions()[ActionId::ShowSideBySide].trigger();
        QVERIFY(QTest::qWaitForWindowActive(&window()));
        QTest::keyClick(&table, '3');
        auto* editor = table.viewport()->findChild<QLineEdit*>();
        QVERIFY(editor != nullptr);
        QTest::keyClicks(editor, "5um");
        QTest::keyClick(editor, Qt::Key_Return);
        QTRY_COMPARE(rowOf("CORE1").thickness, 35'000);
        QVERIFY(window().actions()[ActionId::ShowSideBySide].isChecked());
        // Where nothing can be typed, keys are commands as before.
        const QModelIndex name = cell("CORE1", StackupModel::Name);
        table.scrollTo(name);
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, table.visualRect(name).center());
        QTest::keyClick(&table, '3');
        QVERIFY(window().actions()[ActionId::ShowSolid].isChecked());
    }

    void undoAndRedoWalkThroughTheEdits() {
        const QImage first = m_fixture->picture();
        QVERIFY(!window().actions()[ActionId::Undo].isEnabled());
        type("CORE1", "2 mm");
        const QImage second = m_fixture->picture();
        type("CORE1", "4 mm");
        m_fixture->key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(rowOf("CORE1").thickness, 2'000'000);
        QCOMPARE(differingPixels(m_fixture->picture(), second), 0);
        m_fixture->key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(rowOf("CORE1").thickness, 200'000);
        QCOMPARE(rowOf("CORE1").source, model::Source::Job);
        QCOMPARE(differingPixels(m_fixture->picture(), first), 0);
        window().awaitFiles();
        QVERIFY(!fs::exists(m_session));
        QVERIFY(!window().actions()[ActionId::Undo].isEnabled());
        m_fixture->key(Qt::Key_Y, Qt::ControlModifier);
        QCOMPARE(differingPixels(m_fixture->picture(), second), 0);
        window().awaitFiles();
        QVERIFY(fs::exists(m_session));
    }

    void editsOutliveTheWindowAndTheJobIsNotWrittenTo() {
        const auto before = contents(m_job);
        type("CORE1", "12 mil");
        QVERIFY(fs::exists(m_session));
        QVERIFY(contents(m_job) == before);
        const QImage edited = m_fixture->picture();
        m_fixture->restart();
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(m_job.string())));
        QCOMPARE(differingPixels(m_fixture->picture(), edited), 0);  // heights on the device are those of a fresh board
        QCOMPARE(rowOf("CORE1").thickness, 304'800);
        QCOMPARE(rowOf("CORE1").source, model::Source::Session);
        QVERIFY(!window().messageBar().isVisible());
    }

    void savedMeasurementsFollowAndComeBack() {
        model::Measurement measurement;
        measurement.name = "A";
        measurement.step = window().document()->job.step;
        measurement.from.layer = "TOP";
        measurement.to.layer = "Inner Plane";
        measurement.dz = heightToInner();
        QVERIFY(model::session::saveMeasurements(m_job, *window().document(), {measurement}));
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(m_job.string())));
        type("CORE1", "0.4 mm");
        QCOMPARE(heightToInner(), measurement.dz + 200'000);
        QCOMPARE(window().measurements().measurements()[0].dz, heightToInner());
        m_fixture->restart();
        window().showPanel("stackup");
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(m_job.string())));
        QCOMPARE(window().measurements().measurements()[0].dz, heightToInner());
        type("CORE1", "0.3 mm");
        m_fixture->key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(heightToInner(), measurement.dz + 200'000);
        QCOMPARE(window().measurements().measurements()[0].dz, heightToInner());
        QVERIFY(!window().actions()[ActionId::Undo].isEnabled());
    }

    void selectionAndCameraStayOverAnEdit() {
        window().selection().select({{0, model::ElementId{0}}});
        m_fixture->key(Qt::Key_T);
        m_fixture->key(Qt::Key_Plus);
        const float zoom = window().views().solid().controller().camera().mmPerPixel(100.0F);
        type("CORE1", "0.4 mm");
        QCOMPARE(window().selection().selected().size(), std::size_t{1});
        QCOMPARE(window().views().solid().controller().camera().mmPerPixel(100.0F), zoom);
    }

    void resetTakesRowsBackInOneStep() {
        type("CORE1", "0.4 mm");
        type("TOP", "2 oz");
        window().stackupPanel().findChild<QToolButton*>("resetAll")->click();
        QCOMPARE(rowOf("CORE1").source, model::Source::Job);
        QCOMPARE(rowOf("TOP").source, model::Source::Job);
        window().awaitFiles();
        QVERIFY(!fs::exists(m_session));
        m_fixture->key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(rowOf("CORE1").thickness, 400'000);
        QCOMPARE(rowOf("TOP").thickness, 69'600);
    }

    void nonsenseIsRefusedInTheMessageBar() {
        QLineEdit& editor = begin("CORE1", "thick");
        QTRY_VERIFY(window().messageBar().isVisible());
        QVERIFY(window().error().contains("thick"));
        QCOMPARE(editor.text(), "thick");  // to be mended
        QTest::keyClick(&editor, Qt::Key_Escape);
        QTRY_VERIFY(window().stackupPanel().table().viewport()->findChild<QLineEdit*>() == nullptr);
        QCOMPARE(rowOf("CORE1").source, model::Source::Job);
        QVERIFY(!window().actions()[ActionId::Undo].isEnabled());
    }

    void aRefusalIsOverWithTheNextEdit() {
        QLineEdit& editor = begin("CORE1", "-5");
        QTRY_VERIFY(window().messageBar().isVisible());
        editor.selectAll();
        QTest::keyClicks(&editor, "0,4 mm");
        QTest::keyClick(&editor, Qt::Key_Return);
        QTRY_COMPARE(rowOf("CORE1").thickness, 400'000);
        QVERIFY(!window().messageBar().isVisible());
    }

    void thicknessesOfTheCommandLineAreNotKeptUntilEdited() {
        openWith({.path = m_job, .thicknesses = {"CORE1=0.3mm", "TOP=2oz"}});
        QCOMPARE(rowOf("CORE1").thickness, 300'000);
        type("TOP", "3 oz");
        openWith({.path = m_job});
        QCOMPARE(rowOf("CORE1").source, model::Source::Job);
        QCOMPARE(rowOf("TOP").thickness, 104'400);
    }

    void reloadKeepsThicknessesOfTheCommandLine() {
        openWith({.path = m_job, .thicknesses = {"CORE1=0.3mm"}});
        m_fixture->key(Qt::Key_F5);
        QTRY_VERIFY(!window().loader().isLoading());
        QCOMPARE(rowOf("CORE1").thickness, 300'000);
    }

    void aRowThatIsNotThereIsToldAndTheBoardStays() {
        openWith({.path = m_job, .thicknesses = {"CORE9=0.3mm"}});
        QVERIFY(window().messageBar().isVisible());
        QVERIFY(window().error().contains("CORE9"));
        QCOMPARE(rowOf("CORE1").source, model::Source::Job);
    }

    void withoutSessionNothingIsReadOrWritten() {
        type("CORE1", "0.4 mm");
        const auto before = contents(m_fixture->folder().toStdString());
        openWith({.path = m_job, .noSession = true});
        QCOMPARE(rowOf("CORE1").source, model::Source::Job);
        type("CORE1", "0.5 mm");
        QVERIFY(contents(m_fixture->folder().toStdString()) == before);
        m_fixture->key(Qt::Key_F5);
        QTRY_VERIFY(!window().loader().isLoading());
        QCOMPARE(rowOf("CORE1").thickness, 500'000);
    }

    void aSessionThatCannotBeWrittenIsToldAndTheEditCounts() {
        fs::create_directories(m_session / "inside");  // refuses the rename, whoever runs this
        type("CORE1", "0.4 mm");
        QCOMPARE(rowOf("CORE1").thickness, 400'000);
        QVERIFY(window().messageBar().isVisible());
        QVERIFY(window().error().contains(QString::fromStdString(m_session.string())));
        m_fixture->key(Qt::Key_F5);
        QTRY_VERIFY(!window().loader().isLoading());
        QCOMPARE(rowOf("CORE1").thickness, 400'000);
    }

    void aWindowThatIsClosedWritesFirstAndStaysOnceWhereItCannot() {
        set("CORE1", "0.4 mm");
        QVERIFY(window().close());
        QVERIFY(fs::exists(m_session));
        fs::remove(m_session);
        fs::create_directories(m_session / "inside");
        window().show();
        set("CORE1", "0.5 mm");
        QVERIFY(!window().close());
        QVERIFY(window().isVisible() && window().error().contains(QString::fromStdString(m_session.string())));
        QVERIFY(window().close());
    }

    /// Each knows of the other what it finds in the file when it saves.
    void thicknessesOfTwoWindowsAreAllKept() {
        const QString job = QString::fromStdString(m_job.string());
        auto other = std::make_unique<WindowFixture>();
        other->window().showPanel("stackup");
        QVERIFY(other->openAndWait(job));
        type("CORE1", "0.25 mm", other->window());
        QVERIFY(!other->window().messageBar().isVisible());
        type("CORE2", "0.3 mm");
        QVERIFY(window().messageBar().isVisible());
        QVERIFY2(window().error().contains("The thicknesses in the session file were changed outside this window") &&
                     window().error().contains("F5") && !window().error().contains("replaced"),
                 qPrintable(window().error()));
        type("TOP", "90 um", other->window());
        QVERIFY(other->window().messageBar().isVisible());
        window().activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window()));
        m_fixture->key(Qt::Key_Z, Qt::ControlModifier);  // takes back what was set here, and nothing else
        m_fixture->key(Qt::Key_Y, Qt::ControlModifier);
        m_fixture->key(Qt::Key_F5);
        QTRY_VERIFY(!window().loader().isLoading());
        QCOMPARE(rowOf("CORE1").thickness, 250'000);
        QCOMPARE(rowOf("CORE1").source, model::Source::Session);
        QCOMPARE(rowOf("CORE2").thickness, 300'000);
        QCOMPARE(rowOf("TOP").thickness, 90'000);
        // Of one layer the last word counts, and that is said where it was not seen before.
        type("CORE2", "0.5 mm", other->window());
        QVERIFY2(other->window().error().contains("replaced"), qPrintable(other->window().error()));
        QVERIFY(m_fixture->openAndWait(job));
        QCOMPARE(rowOf("CORE2").thickness, 500'000);
        QCOMPARE(validationErrorsOnClosing(other), 0U);
    }

    void whatOfASessionIsNotUsedIsTold() {
        QFile file(QString::fromStdString(m_session.string()));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write(
            R"({"copperscope_session": 1, "job": "everything", "thickness_nm": {"GONE": 5000, "CORE1": 300000}})");
        file.close();
        openWith({.path = m_job});
        QCOMPARE(rowOf("CORE1").thickness, 300'000);
        QVERIFY(window().messageBar().isVisible());
        QVERIFY(window().error().contains("GONE"));
    }

private:
    TestWindow& window() { return m_fixture->window(); }

    void openWith(model::OpenRequest request) {
        window().open(std::move(request));
        QVERIFY(QTest::qWaitFor([&] { return !window().loader().isLoading(); }, 60000));
    }

    double heightToInner() {
        const model::Document& board = *window().document();
        return model::heightBetween(board, board.findLayer("TOP"), board.findLayer("Inner Plane")).value_or(0.0);
    }

    const model::StackupRow& rowOf(const char* name) { return *model::findRow(window().document()->stackup, name); }

    QModelIndex cell(const QString& name, int column) { return cell(name, column, window()); }
    static QModelIndex cell(const QString& name, int column, TestWindow& window) {
        QAbstractItemModel& rows = window.stack();
        for (int row = 0; row < rows.rowCount(); ++row) {
            if (rows.index(row, StackupModel::Name).data().toString() == name) {
                return rows.index(row, column);
            }
        }
        qFatal("the stack has no such row");
    }

    QString textOf(const QString& name, int column) { return cell(name, column).data().toString(); }

    /// Double-clicks the thickness of a row, types and presses Enter.
    void type(const QString& row, const QString& text) { type(row, text, window()); }
    static void type(const QString& row, const QString& text, TestWindow& window) {
        begin(row, text, window);
        QTRY_VERIFY(window.stackupPanel().table().viewport()->findChild<QLineEdit*>() == nullptr);
        window.awaitFiles();
    }
    void set(const QString& row, const QString& text) {
        QVERIFY(window().stack().setData(cell(row, StackupModel::Thickness), text, Qt::EditRole));
    }
    /// As `type`; the editor may stay.
    QLineEdit& begin(const QString& row, const QString& text) { return begin(row, text, window()); }
    static QLineEdit& begin(const QString& row, const QString& text, TestWindow& window) {
        QTableView& table = window.stackupPanel().table();
        const QModelIndex at = cell(row, StackupModel::Thickness, window);
        table.scrollTo(at);
        const QPoint middle = table.visualRect(at).center();
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, middle);
        QTest::mouseDClick(table.viewport(), Qt::LeftButton, {}, middle);
        auto* editor = table.viewport()->findChild<QLineEdit*>();
        if (editor == nullptr) {
            qFatal("a double click opens an editor");
        }
        QTest::keyClicks(editor, text);
        QTest::keyClick(editor, Qt::Key_Return);
        return *editor;
    }

    std::unique_ptr<WindowFixture> m_fixture;
    fs::path m_job;
    fs::path m_session;
};

QTEST_MAIN(ThicknessTest)
#include "thickness_test.moc"
