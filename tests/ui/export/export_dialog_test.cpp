// File, Export: choices that follow the format, what is written in the background and what is said about it.

#include "ui/export/export_dialog.h"

#include <QCheckBox>
#include <QComboBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMessageBox>
#include <QPushButton>
#include <QRegularExpression>
#include <QStatusBar>
#include <QToolButton>
#include <QtTest>
#include <algorithm>

#include "tests/patience.h"
#include "tests/ui/window_fixture.h"
#include "ui/export/export_feature.h"

using ui::ActionId;

class ExportDialogTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_fixture = std::make_unique<WindowFixture>();
        QVERIFY(m_fixture->openAndWait(m_fixture->copyOfSample()));
        QVERIFY(QDir(m_fixture->folder()).mkdir("out"));
        m_fixture->settings().setLastFolder(folder());
    }
    void cleanup() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void printingBeginsWithPdf() {
        open();
        part<QComboBox>("exportFormat").setCurrentIndex(static_cast<int>(rowOf("STEP")));
        dialog().reject();
        QTRY_VERIFY(window().findChild<ui::ExportDialog*>() == nullptr);
        m_fixture->key(Qt::Key_P, Qt::ControlModifier);
        QVERIFY(QTest::qWaitForWindowExposed(&dialog()));
        QVERIFY(dialog().format().isPdf);
        QVERIFY2(path().endsWith(".pdf"), qPrintable(path()));
    }

    void onlyWhatTheFormatKnowsIsEnabled() {
        open();
        for (std::size_t row = 0; row < model::exportFormats().size(); ++row) {
            const model::ExportFormat& format = model::exportFormats()[row];
            chooseFormat(row);
            for (const char* name : {"exportNets", "exportArea", "exportMinHole", "outerOnly", "merge"}) {
                QCOMPARE(part<QWidget>(name).isEnabled(), format.isSolid);
            }
            QCOMPARE(box("onePart").isEnabled(), format.isTree);
            QCOMPARE(box("writtenOut").isEnabled(), format.isStep);
            QCOMPARE(box("polylines").isEnabled(), format.isStep);
            QCOMPARE(box("onePage").isEnabled(), format.isPdf);
            QCOMPARE(box("mirrored").isEnabled(), format.isPdf);
            QVERIFY(part<QWidget>("exportLayers").isEnabled());
            QCOMPARE(model::exportFormatOf(path().toStdString()), &format);
        }
    }

    void whatIsDisabledDoesNotCount() {
        open();
        chooseFormat(rowOf("STEP"));
        click(box("outerOnly"));
        part<QDoubleSpinBox>("exportMinHole").setValue(0.4);
        QVERIFY(dialog().request().choice.isOuterOnly);
        QCOMPARE(dialog().request().choice.minHole, 400'000);
        chooseFormat(rowOf("DXF"));
        QVERIFY(!dialog().request().choice.isOuterOnly);
        QCOMPARE(dialog().request().choice.minHole, 0);
    }

    void whatIsDisabledShowsNothingThatIsNotDoneAndComesBack() {
        open();
        chooseFormat(rowOf("STEP"));
        auto& area = part<QComboBox>("exportArea");
        area.setCurrentIndex(1);
        QVERIFY2(area.currentText().endsWith(", uncut"), qPrintable(area.currentText()));
        part<QDoubleSpinBox>("exportMinHole").setValue(0.4);
        part<QComboBox>("exportNets").setCurrentIndex(2);
        click(box("merge"));
        chooseFormat(rowOf("PDF"));
        QCOMPARE(area.currentText(), "Whole board");
        QCOMPARE(part<QDoubleSpinBox>("exportMinHole").text(), "None");
        QCOMPARE(part<QComboBox>("exportNets").currentText(), "All nets");
        QVERIFY(!box("merge").isChecked());
        click(box("onePage"));
        chooseFormat(rowOf("STEP"));
        QCOMPARE(area.currentIndex(), 1);
        QCOMPARE(part<QDoubleSpinBox>("exportMinHole").value(), 0.4);
        QCOMPARE(part<QComboBox>("exportNets").currentIndex(), 2);
        QVERIFY(box("merge").isChecked() && !box("onePage").isChecked());
    }

    void whatDoesNotApplyIsRememberedToo() {
        open();
        chooseFormat(rowOf("STEP"));
        click(box("merge"));
        part<QDoubleSpinBox>("exportMinHole").setValue(0.4);
        click(button("&Copper"));
        chooseFormat(rowOf("DXF"));
        click(exportButton());
        QVERIFY(waitUntilWritten());
        open();
        QVERIFY(!box("merge").isChecked());
        chooseFormat(rowOf("STEP"));
        QVERIFY(box("merge").isChecked());
        QCOMPARE(part<QDoubleSpinBox>("exportMinHole").value(), 0.4);
    }

    void theFileIsProposedBesideTheLastFolderAndItsEndingChoosesTheFormat() {
        open();
        chooseFormat(rowOf("DXF"));
        QCOMPARE(path(), folder() + "/sample.dxf");
        auto& line = part<QLineEdit>("exportFile");
        line.selectAll();
        QTest::keyClicks(&line, "rev1.2.pdf");  // beside the last folder
        QCOMPARE(QString::fromUtf8(dialog().format().name.data()), QString("PDF"));
        QCOMPARE(dialog().path(), folder() + "/rev1.2.pdf");
        line.selectAll();
        QTest::keyClicks(&line, "rev1.2");
        QCOMPARE(dialog().path(), folder() + "/rev1.2.pdf");
    }

    void beforeTheFirstExportFilesAreProposedBesideTheBoard() {
        m_fixture = std::make_unique<WindowFixture>();
        const QString board = m_fixture->copyOfSample();
        QVERIFY(m_fixture->openAndWait(board));
        open();
        QCOMPARE(QFileInfo(dialog().path()).path(), QFileInfo(board).path());
        dialog().reject();
        window().actions()[ActionId::ExportStackup].trigger();
        auto* named = window().findChild<QFileDialog*>();
        QVERIFY(named != nullptr);
        QCOMPARE(named->directory().path(), QFileInfo(board).path());
    }

    void laterFilesAreProposedWhereTheLastOneWasNamed() {
        QVERIFY(QDir(m_fixture->folder()).mkdir("elsewhere"));
        const QString elsewhere = m_fixture->folder() + "/elsewhere";
        window().save(ActionId::ExportStackup, elsewhere + "/stackup.csv");
        open();
        QCOMPARE(QFileInfo(dialog().path()).path(), elsewhere);
        dialog().reject();
        window().actions()[ActionId::ExportStackup].trigger();
        auto* named = window().findChild<QFileDialog*>();
        QVERIFY(named != nullptr);
        QCOMPARE(named->directory().path(), elsewhere);
    }

    void theLeastHoleIsTypedWithPointOrComma() {
        open();
        auto& box = part<QDoubleSpinBox>("exportMinHole");
        for (const char* typed : {"0.3", "0,3"}) {
            box.setValue(1.0);
            auto* line = box.findChild<QLineEdit*>();
            line->selectAll();
            QTest::keyClicks(line, typed);
            QCOMPARE(box.value(), 0.3);
        }
    }

    void buttonsSetTheLayers() {
        open();
        const model::Document& board = *window().document();
        click(button("&Copper"));
        std::vector<model::LayerId> layers = dialog().request().choice.layers;
        QVERIFY(layers.size() >= 2);
        QVERIFY(std::ranges::all_of(layers, [&](auto layer) { return board.layer(layer).isCopper(); }));
        click(button("&All"));
        QCOMPARE(dialog().request().choice.layers.size(),
                 static_cast<std::size_t>(part<QListWidget>("exportLayers").count()));
        window().layers().showOnly({board.layer(layers.front()).name});
        dialog().reject();
        open();
        click(button("&Visible"));
        layers.resize(1);
        QVERIFY(dialog().request().choice.layers == layers);
    }

    void withoutALayerThereIsNothingToExport() {
        open();
        click(button("&Copper"));
        auto& list = part<QListWidget>("exportLayers");
        QVERIFY(exportButton().isEnabled());
        for (int row = 0; row < list.count(); ++row) {
            if (list.item(row)->checkState() == Qt::Checked) {
                list.setCurrentRow(row);
                QTest::keyClick(&list, Qt::Key_Space);
            }
        }
        QVERIFY(dialog().request().choice.layers.empty());
        QVERIFY(!exportButton().isEnabled());
        QVERIFY(problem().contains("layer"));
    }

    void netsAreAllThoseOfTheSelectionOrTyped() {
        const std::string name = window().document()->nets[netWithAName()].name;
        open();
        chooseFormat(rowOf("STEP"));
        auto& which = part<QComboBox>("exportNets");
        QVERIFY(dialog().request().choice.nets.empty());
        QVERIFY(!(which.model()->flags(which.model()->index(1, 0)) & Qt::ItemIsEnabled));  // nothing is selected
        which.setCurrentIndex(2);
        QVERIFY(!exportButton().isEnabled());
        QTest::keyClicks(&part<QLineEdit>("exportNetNames"), "no such net");
        QCOMPARE(problem(), QString("There is no net no such net"));
        part<QLineEdit>("exportNetNames").setText(QString::fromStdString(name) + ", ");
        QVERIFY(exportButton().isEnabled());
        QVERIFY(dialog().request().choice.nets == std::vector{name});
        dialog().reject();
        window().selection().setNets({{0, model::NetId{netWithAName()}}});
        open();
        part<QComboBox>("exportNets").setCurrentIndex(1);
        QVERIFY(dialog().request().choice.nets == std::vector{name});
    }

    void theAreaIsWhatThe2dViewShows() {
        open();
        chooseFormat(rowOf("STEP"));
        part<QComboBox>("exportArea").setCurrentIndex(1);
        const std::optional<base::Box> fitted = dialog().request().choice.window;
        QVERIFY(fitted && fitted->meets(window().document()->board));
        dialog().reject();
        window().views().flat().controller().show({0.0F, 0.0F, 0.0F}, {1.0F, 1.0F, 0.0F});
        open();
        part<QComboBox>("exportArea").setCurrentIndex(1);
        const std::optional<base::Box> near = dialog().request().choice.window;
        QVERIFY(near && near->max.x - near->min.x < (fitted->max.x - fitted->min.x) / 2);
        dialog().reject();
        window().actions()[ActionId::ShowSolid].trigger();
        open();
        const auto& area = part<QComboBox>("exportArea");
        QVERIFY(!(area.model()->flags(area.model()->index(1, 0)) & Qt::ItemIsEnabled));
    }

    void theSizeIsEstimatedAMomentAfterAChange() {
        open();
        chooseFormat(rowOf("STEP"));
        QTRY_VERIFY2(estimate().startsWith("About "), qPrintable(estimate()));
        const QString all = estimate();
        click(box("outerOnly"));
        QCOMPARE(estimate(), QString("Estimating the size …"));
        QTRY_VERIFY2(estimate().startsWith("About "), qPrintable(estimate()));
        QVERIFY(estimate() != all);
        chooseFormat(rowOf("DXF"));
        QTRY_VERIFY(estimate().contains("once it is written"));
    }

    void drawingsAndSolidsAreWrittenAndTheirSizeSaid() {
        for (const char* format : {"DXF", "STEP", "STL"}) {
            open();
            chooseFormat(rowOf(format));
            const QString file = path();
            click(button("&Copper"));
            click(exportButton());
            QVERIFY(window().workspace().isWorking());
            QVERIFY(waitUntilWritten());
            QVERIFY(!window().messageBar().isVisible());
            QVERIFY2(status().startsWith("Saved " + file + ": "), qPrintable(status()));
            const QString what = status().mid(("Saved " + file + ": ").size());
            QVERIFY2(what.contains("B"), qPrintable(what));
            QVERIFY2(!what.contains(QRegularExpression("[0-9]{4}")), qPrintable(what));  // 1,234
            QVERIFY2(!what.contains(" 0 placed"), qPrintable(what));                     // STL places none
            QVERIFY(QFileInfo(file).size() > 10000);
        }
    }

    void enterExports() {
        open();
        chooseFormat(rowOf("DXF"));
        QTest::keyClick(&part<QLineEdit>("exportFile"), Qt::Key_Return);
        QVERIFY(window().workspace().isWorking());
        QVERIFY(waitUntilWritten());
        QVERIFY(QFileInfo::exists(folder() + "/sample.dxf"));
    }

    void anExistingFileIsReplacedOnlyIfTheUserSaysSo() {
        open();
        chooseFormat(rowOf("SVG"));
        const QString file = path();
        QFile there(file);
        QVERIFY(there.open(QIODevice::WriteOnly) && there.write("mine") == 4);
        there.close();
        click(exportButton());
        auto* question = dialog().findChild<QMessageBox*>();
        QVERIFY(question != nullptr && question->text().contains("sample.svg"));
        click(*question->button(QMessageBox::Cancel));
        QVERIFY(dialog().isVisible() && !window().workspace().isWorking());
        QCOMPARE(QFileInfo(file).size(), 4);
        QTRY_VERIFY(dialog().findChild<QMessageBox*>() == nullptr);
        click(exportButton());
        click(*dialog().findChild<QMessageBox*>()->button(QMessageBox::Yes));
        QVERIFY(waitUntilWritten());
        QVERIFY(QFileInfo(file).size() > 1000);
    }

    void whereNothingCanBeWrittenTheUserIsTold() {
        open();
        chooseFormat(rowOf("SVG"));
        auto& line = part<QLineEdit>("exportFile");
        line.setText(folder() + "/no/such/folder/a.svg");
        QVERIFY(!exportButton().isEnabled());
        QCOMPARE(problem(), "There is no folder " + folder() + "/no/such/folder");
        line.setText(folder());  // a folder with the ending of the format
        QVERIFY(QDir(folder()).mkdir("a.svg"));
        line.setText(folder() + "/a.svg");
        QVERIFY(problem().endsWith("is a folder"));
        line.setText("/proc/self/a.svg");  // looks writable to an administrator
        if (exportButton().isEnabled()) {
            click(exportButton());
            QVERIFY(waitUntilWritten());
            QVERIFY(window().messageBar().isVisible());
            QVERIFY2(window().error().contains("/proc/self/a.svg"), qPrintable(window().error()));
        } else {
            QVERIFY(problem().startsWith("Nothing can be written into /proc/self"));
        }
    }

    void choicesAreRemembered() {
        open();
        chooseFormat(rowOf("STEP"));
        click(box("merge"));
        click(button("&Copper"));
        part<QDoubleSpinBox>("exportMinHole").setValue(0.35);
        const auto layers = dialog().request().choice.layers;
        click(exportButton());
        QVERIFY(waitUntilWritten());
        m_fixture->restart();
        QVERIFY(m_fixture->openAndWait(m_fixture->copyOfSample()));
        open();
        QCOMPARE(&dialog().format(), &model::exportFormats()[rowOf("STEP")]);
        const model::SolidChoice choice = dialog().request().choice;
        QVERIFY(choice.isMerged && !choice.isOnePart);
        QVERIFY(choice.layers == layers);
        QCOMPARE(choice.minHole, 350'000);
        QCOMPARE(path(), folder() + "/sample.step");
    }

    void whatIsCancelledLeavesNoFile() {
        open();
        chooseFormat(rowOf("STEP"));
        click(exportButton());
        QVERIFY(window().workspace().isWorking());
        click(*window().findChild<QWidget*>("work")->findChild<QToolButton*>());  // of the status line
        QVERIFY(!window().workspace().isWorking());
        QVERIFY2(status().startsWith("Stopped: ") && status().endsWith("was not written"), qPrintable(status()));
        QTest::qWait(2000);  // the thread winds down
        QTRY_COMPARE(QDir(folder()).entryList(QDir::AllEntries | QDir::Hidden | QDir::NoDotAndDotDot), QStringList());
    }

    void whatIsNotInTheFileIsListed() {
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(m_fixture->copyOfJob("everything").string())));
        const ui::MessageModel& messages = window().find<ui::MessageModel>();
        const int before = messages.rowCount();
        open();
        chooseFormat(rowOf("DXF"));
        click(exportButton());
        QVERIFY(waitUntilWritten());
        QVERIFY2(status().endsWith(". Elements that are not in it: 1, listed in Messages"), qPrintable(status()));
        QCOMPARE(messages.rowCount(), before + 1);
        QCOMPARE(messages.index(before, ui::MessageModel::Text).data().toString(),
                 QString("Not in everything.dxf: it has no width"));
        QCOMPARE(messages.index(before, ui::MessageModel::Location).data().toString(),
                 QString("steps/board/layers/top/features:63"));
        const model::ElementId element = messages.message(before).element;
        QVERIFY(element.isValid());
        emit window().table("messages").rowChosen(before);
        QCOMPARE(window().selection().selected(), (std::vector{model::BoardElement{0, element}}));
        open();
        click(button("&Copper"));  // the next export takes the place of that one
        part<QLineEdit>("exportFile").setText(folder() + "/again.dxf");
        click(exportButton());
        QVERIFY(waitUntilWritten());
        QCOMPARE(messages.rowCount(), before + 1);
        QVERIFY(messages.index(before, ui::MessageModel::Text).data().toString().contains("again.dxf"));
        QVERIFY(m_fixture->openAndWait(m_fixture->copyOfSample()));
        QVERIFY(messages.rowCount() == 0 || !messages.message(messages.rowCount() - 1).text.starts_with("Not in"));
    }

    void aFileThatIsBrowsedForChoosesTheFormat() {
        open();
        chooseFormat(rowOf("STEP"));
        click(button("B&rowse…"));
        auto* files = dialog().findChild<QFileDialog*>();
        QVERIFY(files != nullptr && files->isVisible());
        QCOMPARE(files->nameFilters().size(), static_cast<qsizetype>(model::exportFormats().size()));
        QCOMPARE(files->selectedNameFilter(), QString("STEP (*.step *.stp)"));
        emit files->fileSelected(folder() + "/chosen.svg");
        files->close();
        QCOMPARE(&dialog().format(), &model::exportFormats()[rowOf("SVG")]);
        QCOMPARE(dialog().path(), folder() + "/chosen.svg");
    }

    void anotherBoardEndsTheDialog() {
        open();
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(m_fixture->copyOfJob("drills").string())));
        QTRY_VERIFY(window().findChild<ui::ExportDialog*>() == nullptr);
    }

private:
    TestWindow& window() { return m_fixture->window(); }
    [[nodiscard]] QString folder() const { return m_fixture->folder() + "/out"; }
    ui::ExportDialog& dialog() { return window().find<ui::ExportDialog>(); }
    template <class Part>
    Part& part(const char* name) {
        return *dialog().findChild<Part*>(name);
    }
    QCheckBox& box(const char* name) { return part<QCheckBox>(name); }
    QString path() { return part<QLineEdit>("exportFile").text(); }
    QString estimate() { return part<QLabel>("exportEstimate").text(); }
    QString problem() { return part<QLabel>("exportProblem").text(); }
    QString status() { return window().statusBar()->currentMessage(); }

    void open() {
        QTRY_VERIFY(window().findChild<ui::ExportDialog*>() == nullptr);  // the one before
        window().actions()[ActionId::ExportBoard].trigger();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog()));
    }
    QPushButton& button(const QString& text) {
        const auto buttons = dialog().findChildren<QPushButton*>();
        const auto found = std::ranges::find(buttons, text, &QPushButton::text);
        return found != buttons.end() ? **found : (qFatal("no such button"), *buttons.front());
    }
    QPushButton& exportButton() { return button("&Export"); }
    static void click(QAbstractButton& button) {
        QTest::mouseClick(&button, Qt::LeftButton, {}, {10, button.height() / 2});
    }

    static std::size_t rowOf(std::string_view format) {
        const auto formats = model::exportFormats();
        return static_cast<std::size_t>(std::ranges::find(formats, format, &model::ExportFormat::name) -
                                        formats.begin());
    }
    void chooseFormat(std::size_t row) {
        auto& formats = part<QComboBox>("exportFormat");
        formats.setFocus();
        QTest::keyClick(&formats, Qt::Key_Home);
        for (std::size_t i = 0; i < row; ++i) {
            QTest::keyClick(&formats, Qt::Key_Down);
        }
        QCOMPARE(formats.currentIndex(), static_cast<int>(row));
    }
    std::size_t netWithAName() {
        const auto& nets = window().document()->nets;
        return static_cast<std::size_t>(std::ranges::find(nets, std::string("GND"), &model::Net::name) - nets.begin());
    }
    bool waitUntilWritten() {
        return QTest::qWaitFor([this] { return !window().workspace().isWorking(); }, 60000);
    }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(ExportDialogTest)
#include "export_dialog_test.moc"
