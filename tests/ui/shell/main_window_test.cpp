#include "ui/shell/main_window.h"

#include <QComboBox>
#include <QDialog>
#include <QDialogButtonBox>
#include <QDockWidget>
#include <QDropEvent>
#include <QFileDialog>
#include <QLineEdit>
#include <QMimeData>
#include <QPushButton>
#include <QSignalSpy>
#include <QSplitter>
#include <QStatusBar>
#include <QToolButton>
#include <QUrl>
#include <QtTest>
#include <algorithm>
#include <thread>

#include "model/board/document_builder.h"
#include "tests/locations.h"
#include "tests/patience.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/first_size.h"
#include "ui/export/export_dialog.h"
#include "ui/layers/layers_panel.h"
#include "ui/shell/message_bar.h"
#include "ui/shell/status_line.h"

using base::ErrorCode;
using model::OpenRequest;
using ui::ActionId;
using ui::LoadedBoard;

namespace {

const QString kSample = locations::kSample;

/// Real work, except that boards called "slow" never end until cancelled.
base::Result<LoadedBoard> workWithSlowBoards(const OpenRequest& request, base::Progress& progress) {
    if (request.path != "slow") {
        return ui::loadBoard(request, progress);
    }
    progress.beginPhase("Reading layers");
    while (!progress.isCancelled()) {
        std::this_thread::sleep_for(std::chrono::milliseconds(1));
    }
    return base::Error{ErrorCode::Cancelled, "Cancelled"};
}

/// A job of two steps; "broken" is a third that the matrix does not know of.
base::Result<LoadedBoard> workWithSteps(const OpenRequest& request, base::Progress&) {
    if (request.step == "broken") {
        return base::Error{ErrorCode::BadInput, "There is no such step"};
    }
    model::DocumentBuilder builder;
    builder.job().steps = {"pcb", "panel", "broken"};
    builder.job().step = request.step.empty() ? "pcb" : request.step;
    return LoadedBoard{{request, builder.finish()}, std::make_shared<const render::BoardModel>(), {}};
}

void drop(QWidget& target, const QList<QUrl>& urls) {
    QMimeData data;
    data.setUrls(urls);
    QDragEnterEvent enter({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(&target, &enter);
    if (enter.isAccepted()) {
        QDropEvent event({10, 10}, Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(&target, &event);
    }
}

}  // namespace

class MainWindowTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_fixture = std::make_unique<WindowFixture>(workWithSlowBoards);
        window().actions()[ActionId::ShowViewCube].trigger();  // it is on the screen and not in pictures
    }
    void cleanup() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void boardIsOpenedListedAndSeen() {
        QVERIFY(!window().actions()[ActionId::Fit].isEnabled());
        QVERIFY(m_fixture->openAndWait(kSample));
        QCOMPARE(window().windowTitle(), "ocp_tap_sa45_odb.tgz – Copperscope");
        QCOMPARE(window().layers().rowCount(), static_cast<int>(window().document()->layers.size()));
        QVERIFY(window().actions()[ActionId::Fit].isEnabled());
        QVERIFY(!window().messageBar().isVisible());
        QVERIFY2(inkOf(m_fixture->picture()) > 0.1, "the board covers a good part of the canvas");
        QTRY_VERIFY2(differingPixels(m_fixture->shown(), m_fixture->picture()) < m_fixture->picture().width() * 4,
                     "the screen shows what the picture has");
        QTRY_VERIFY(window().label("frame").endsWith(" ms"));
    }

    /// In whatever folder the dialog is, and whether Enter or its button ends it.
    void aPathThatIsTypedOpensItsFile() {
        const QString board = m_fixture->copyOfSample();
        for (const bool isInItsFolder : {false, true, true}) {
            QFileDialog& dialog = openDialog();
            QCOMPARE(dialog.directory().absolutePath(), isInItsFolder ? m_fixture->folder() : QDir::homePath());
            QCOMPARE(dialog.findChild<QComboBox*>("fileTypeCombo")->currentText(),
                     "Boards of all formats");  // else cut
            auto* field = dialog.findChild<QLineEdit*>("fileNameEdit");
            QTRY_VERIFY(field->hasFocus());
            QTest::keyClicks(field, board, Qt::NoModifier, 1);  // as Qt lists the folders on the way
            QSignalSpy opened(&window().workspace(), &ui::Workspace::boardOpened);
            QCOMPARE(field->text(), board);
            QTest::keyClick(field, Qt::Key_Return);
            QTRY_COMPARE(opened.count(), 1);
            QTRY_VERIFY(window().findChild<QFileDialog*>() == nullptr);
        }
        QFileDialog& dialog = openDialog();
        dialog.findChild<QLineEdit*>("fileNameEdit")->setText(board);
        QSignalSpy opened(&window().workspace(), &ui::Workspace::boardOpened);
        QTest::mouseClick(dialog.findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Open), Qt::LeftButton);
        QTRY_COMPARE(opened.count(), 1);
    }

    /// As long as no dialog was anywhere else.
    void theDialogBeginsBesideTheBoard() {
        QVERIFY(m_fixture->openAndWait(m_fixture->copyOfSample()));
        QFileDialog& dialog = openDialog();
        QCOMPARE(dialog.directory().absolutePath(), m_fixture->folder());
        dialog.reject();
    }

    /// Not beside the one that a dialog opened before.
    void anExportIsProposedBesideTheBoardThatIsShown() {
        QTemporaryDir other;
        const QString first = other.filePath("first.tgz");
        QVERIFY(QFile::copy(m_fixture->copyOfSample(), first));
        auto* field = openDialog().findChild<QLineEdit*>("fileNameEdit");
        QTRY_VERIFY(field->hasFocus());
        QSignalSpy opened(&window().workspace(), &ui::Workspace::boardOpened);
        QTest::keyClicks(field, first, Qt::NoModifier, 1);
        QTest::keyClick(field, Qt::Key_Return);
        QTRY_COMPARE(opened.count(), 1);
        QTRY_VERIFY(window().findChild<QFileDialog*>() == nullptr);
        QVERIFY(m_fixture->openAndWait(m_fixture->copyOfSample()));
        window().actions()[ActionId::ExportBoard].trigger();
        QTRY_VERIFY(window().findChild<QLineEdit*>("exportFile") != nullptr);
        const QString file = window().findChild<QLineEdit*>("exportFile")->text();
        QCOMPARE(QFileInfo(file).absolutePath(), m_fixture->folder());
        window().findChild<ui::ExportDialog*>()->reject();
        QFileDialog& dialog = openDialog();
        QCOMPARE(dialog.directory().absolutePath(), other.path());
        dialog.reject();
    }

    void theFirstWindowFitsOnTheScreenWithItsFrame() {
        const QSize wanted(1280, 800);
        QCOMPARE(ui::firstSize(wanted, {1920, 1080}), (ui::FirstSize{wanted, false}));
        for (const QSize screen : {QSize(1280, 800), QSize(1366, 768), QSize(1920, 820), QSize(800, 600)}) {
            const ui::FirstSize first = ui::firstSize(wanted, screen);
            QVERIFY(first.isMaximised);
            QVERIFY(first.size.width() < screen.width() && first.size.height() < screen.height());
        }
        QTemporaryDir folder;
        ui::Settings none(folder.filePath("settings.ini"));
        TestWindow first(m_fixture->context(), none);
        first.appear();
        const ui::FirstSize expected = ui::firstSize(wanted, first.screen()->availableSize());
        QCOMPARE(first.isMaximized(), expected.isMaximised);
        QVERIFY(expected.isMaximised || first.size() == wanted);
        TestWindow later(m_fixture->context(), m_fixture->settings());
        m_fixture->settings().setWindowGeometry(window().saveGeometry());
        later.appear();  // the settings know a place
        QVERIFY(!later.isMaximized());
    }

    void hidingALayerChangesThePictureAndShowingItRestoresIt() {
        QVERIFY(m_fixture->openAndWait(kSample));
        const QImage before = m_fixture->picture();
        const QModelIndex cell = topCopper(ui::LayerModel::Visible);
        QVERIFY(window().layers().setData(cell, Qt::Unchecked, Qt::CheckStateRole));
        const QImage hidden = m_fixture->picture();
        QVERIFY(differingPixels(before, hidden) > 1000);
        QTRY_VERIFY(differingPixels(m_fixture->shown(), hidden) < hidden.width() * 4);
        QVERIFY(window().layers().setData(cell, Qt::Checked, Qt::CheckStateRole));
        QCOMPARE(differingPixels(before, m_fixture->picture()), 0);
    }

    void colourOfALayerIsSeenOnTheCanvas() {
        QVERIFY(m_fixture->openAndWait(kSample));
        m_fixture->key(Qt::Key_T);
        const QImage before = m_fixture->picture();
        window().layers().setData(topCopper(ui::LayerModel::Colour), QColor(Qt::green), Qt::EditRole);
        QVERIFY(differingPixels(before, m_fixture->picture()) > 1000);
    }

    void soloKeyShowsTheCurrentLayerAlone() {
        QVERIFY(m_fixture->openAndWait(kSample));
        const QImage all = m_fixture->picture();
        const QModelIndex cell = topCopper(ui::LayerModel::Name);
        window().layersPanel().select(model::LayerId{std::size_t(cell.row())});
        m_fixture->key(Qt::Key_H);
        QCOMPARE(window().layers().soloLayer().row(), static_cast<std::size_t>(cell.row()));
        QVERIFY(differingPixels(all, m_fixture->picture()) > 1000);
        m_fixture->key(Qt::Key_H);
        QCOMPARE(differingPixels(all, m_fixture->picture()), 0);
    }

    void hideAllLeavesAnEmptyCanvas() {
        QVERIFY(m_fixture->openAndWait(kSample));
        window().actions()[ActionId::HideAllLayers].trigger();
        QCOMPARE(inkOf(m_fixture->picture()), 0.0);
        window().actions()[ActionId::ShowCopperOnly].trigger();
        QVERIFY(inkOf(m_fixture->picture()) > 0.05);
    }

    void viewKeysMoveTheCamera() {
        QVERIFY(m_fixture->openAndWait(kSample));
        const render::Camera& camera = window().views().solid().controller().camera();
        m_fixture->key(Qt::Key_T);
        QVERIFY(camera.direction().z < -0.999F);
        const float fitted = camera.mmPerPixel(100.0F);
        m_fixture->key(Qt::Key_B);
        QVERIFY(camera.direction().z > 0.999F);
        m_fixture->key(Qt::Key_I);
        QVERIFY(camera.direction().z > -0.9F && camera.direction().z < -0.1F);
        m_fixture->key(Qt::Key_T);
        m_fixture->key(Qt::Key_Plus);
        QVERIFY(camera.mmPerPixel(100.0F) < fitted * 0.9F);
        m_fixture->key(Qt::Key_F);
        QVERIFY(std::abs(camera.mmPerPixel(100.0F) / fitted - 1.0F) < 1e-3F);
        m_fixture->key(Qt::Key_O);
        QVERIFY(camera.isOrthographic());
        m_fixture->key(Qt::Key_O);
        QVERIFY(!camera.isOrthographic());
    }

    void explodeSpreadsTheLayersAndFoldsThemBack() {
        QVERIFY(m_fixture->openAndWait(kSample));
        const QImage before = m_fixture->picture();
        m_fixture->key(Qt::Key_E);
        QVERIFY(window().actions()[ActionId::Explode].isChecked());
        QTRY_VERIFY(differingPixels(before, m_fixture->picture()) > 5000);
        m_fixture->key(Qt::Key_E);
        // The camera is fitted again from another place, which may round differently: 1 pixel in 10,000.
        QTRY_VERIFY(differingPixels(before, m_fixture->picture()) < before.width() * before.height() / 10000);
    }

    void boardsAreCutOpenAndWholeAgain() {
        QVERIFY(m_fixture->openAndWait(kSample));
        const QImage whole = m_fixture->picture();
        m_fixture->key(Qt::Key_X);
        QVERIFY(window().actions()[ActionId::SectionPlane].isChecked());
        const render::SectionCut* cut = window().views().solid().cut();
        QVERIFY(cut != nullptr && !cut->faces.empty());
        const QImage open = m_fixture->picture();
        QVERIFY(differingPixels(whole, open) > 5000);
        const glm::dvec2 direction = cut->plane.direction;
        m_fixture->key(Qt::Key_X, Qt::ShiftModifier);
        QVERIFY(std::abs(glm::dot(window().views().solid().cut()->plane.direction, direction) - std::sqrt(0.5)) < 1e-9);
        m_fixture->key(Qt::Key_Period);
        m_fixture->key(Qt::Key_Comma);
        m_fixture->key(Qt::Key_X);
        QVERIFY(window().views().solid().cut() == nullptr);
        QTRY_COMPARE(differingPixels(whole, m_fixture->picture()), 0);
    }

    void layersAreThickAndThinAgain() {
        QVERIFY(m_fixture->openAndWait(kSample));
        const auto thickness = [&] {
            const std::vector<render::ZRange> heights = window().views().solid().drawnHeights();
            const auto& layers = window().document()->layers;
            const auto copper = std::ranges::find_if(layers, &model::Layer::isCopper) - layers.begin();
            return heights[std::size_t(copper)].z1 - heights[std::size_t(copper)].z0;
        };
        const float before = thickness();
        m_fixture->key(Qt::Key_C);
        QVERIFY(std::abs(thickness() / before - 10.0F) < 0.01F);
        m_fixture->key(Qt::Key_C);
        QVERIFY(std::abs(thickness() / before - 1.0F) < 0.001F);
    }

    void whatWasDoneIsSaidUntilSomethingElseIs() {
        constexpr int kReadingMs = 200;
        auto& line = window().find<ui::StatusLine>();
        line.setReadingMs(60'000);
        window().workspace().report(QString("Undone: hiding one net"));
        m_fixture->key(Qt::Key_Shift);
        QCOMPARE(window().statusBar()->currentMessage(), "Undone: hiding one net");
        line.setReadingMs(kReadingMs);
        QTest::qWait(2 * kReadingMs);
        QCOMPARE(window().statusBar()->currentMessage(), "Undone: hiding one net");
        m_fixture->key(Qt::Key_Shift);
        QVERIFY(window().statusBar()->currentMessage().isEmpty());
        window().workspace().prompt("Click the first corner");
        QTest::qWait(2 * kReadingMs);
        m_fixture->key(Qt::Key_Shift);
        QCOMPARE(window().statusBar()->currentMessage(), "Click the first corner");
    }

    void nothingIsDrawnWhileNothingChanges() {
        QVERIFY(m_fixture->openAndWait(kSample));
        QVERIFY(m_fixture->awaitRest());
        QSignalSpy drawn(&window().views().solid(), &ui::BoardView::drawn);
        QTest::qWait(400);
        QCOMPARE(drawn.count(), 0);
        for (int i = 0; i < 10; ++i) {
            window().views().solid().controller().zoomAtCentre(1.01F);
        }
        QTRY_VERIFY(drawn.count() > 0);
        QVERIFY(m_fixture->awaitRest());
        // Ten changes, one frame; and where frames are slow a smoothed one when the view has come to rest.
        QVERIFY2(drawn.count() <= 2, qPrintable(QString::number(drawn.count())));
    }

    void failedOpenKeepsTheBoardAndTellsWhy() {
        QVERIFY(m_fixture->openAndWait(kSample));
        const model::Document* before = window().document();
        QVERIFY(!m_fixture->openAndWait("/no/such/board.tgz"));
        QCOMPARE(window().document(), before);
        QVERIFY(window().messageBar().isVisible());
        QVERIFY2(window().error().contains("board.tgz"), qPrintable(window().error()));
        QVERIFY(window().windowTitle().startsWith("ocp_tap_sa45"));
        QCOMPARE(m_fixture->settings().recentBoards().size(), 1);
        window().messageBar().findChild<QToolButton*>()->click();
        QVERIFY(!window().messageBar().isVisible());
    }

    void cancelledLoadKeepsTheBoardWhichStaysUsableMeanwhile() {
        QVERIFY(m_fixture->openAndWait(kSample));
        const model::Document* before = window().document();
        window().open("slow");
        QWidget& bar = *window().findChild<QWidget*>("work");
        QTRY_COMPARE(bar.findChild<QLabel*>()->text(), "slow: Reading layers");
        QVERIFY(bar.isVisible());
        m_fixture->key(Qt::Key_T);
        QVERIFY(window().views().solid().controller().camera().direction().z < -0.999F);
        QVERIFY(inkOf(m_fixture->picture()) > 0.1);
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(!window().loader().isLoading());
        QVERIFY(!bar.isVisible());
        QCOMPARE(window().document(), before);
    }

    void cancelButtonStopsALoad() {
        window().open("slow");
        QVERIFY(window().loader().isLoading());
        window().findChild<QWidget*>("work")->findChild<QToolButton*>()->click();
        QVERIFY(!window().loader().isLoading());
        QVERIFY(!window().actions()[ActionId::CancelLoading].isEnabled());
    }

    void droppedFileIsOpened() {
        drop(window(), {QUrl::fromLocalFile(kSample)});
        QVERIFY(window().loader().isLoading());
        QTRY_VERIFY(window().document() != nullptr);
        QCOMPARE(window().document()->job.steps.empty(), false);
    }

    void whatIsNoLocalFileIsNotTaken() {
        drop(window(), {QUrl("https://example.org/board.tgz")});
        QVERIFY(!window().loader().isLoading());
    }

    void otherStepIsChosenInTheStatusBar() {
        m_fixture->restart(workWithSteps);
        QVERIFY(m_fixture->openAndWait("job"));
        QComboBox& box = *window().findChild<QComboBox*>("steps");
        QVERIFY(box.isVisible());
        QCOMPARE(box.currentText(), "pcb");
        const model::Document* pcb = window().document();
        emit box.textActivated("pcb");
        QVERIFY(!window().loader().isLoading());  // it is the one that is shown
        emit box.textActivated("panel");
        QVERIFY(window().loader().isLoading());
        emit box.textActivated("pcb");
        QTRY_VERIFY(!window().loader().isLoading());
        QCOMPARE(window().document(), pcb);
        emit box.textActivated("panel");
        QTRY_COMPARE(window().document()->job.step, std::string("panel"));
        QCOMPARE(box.currentText(), "panel");
        box.setCurrentText("broken");
        emit box.textActivated("broken");
        QTRY_VERIFY(window().messageBar().isVisible());
        QCOMPARE(box.currentText(), "panel");
    }

    void reloadKeepsTheBoardOnTheScreen() {
        QVERIFY(m_fixture->openAndWait(kSample));
        const model::Document* before = window().document();
        const model::Document* meanwhile = nullptr;
        connect(&window().loader(), &ui::Loader::started, [&] { meanwhile = window().document(); });
        m_fixture->key(Qt::Key_F5);
        QCOMPARE(meanwhile, before);
        QTRY_VERIFY(!window().loader().isLoading());
        QCOMPARE(m_fixture->settings().recentBoards().size(), 1);
    }

    void settingsPersistBetweenTwoWindows() {
        QVERIFY(m_fixture->openAndWait(kSample));
        window().resize(780, 640);  // fits on the screen of the offscreen platform, 800 pixels wide
        window().actions()[ActionId::ShowStatisticsDock].trigger();
        window().actions()[ActionId::ShowLayersDock].trigger();
        window().actions()[ActionId::ThemeDark].trigger();
        window().actions()[ActionId::BackendImpostor].trigger();
        const QSize size = window().size();
        window().close();

        TestWindow second(m_fixture->context(), m_fixture->settings());
        QCOMPARE(second.size(), size);
        QVERIFY(!second.findChild<QDockWidget*>("statistics")->isHidden());
        QVERIFY(second.findChild<QDockWidget*>("layers")->isHidden());
        QVERIFY(second.actions()[ActionId::ThemeDark].isChecked());
        QVERIFY(second.actions()[ActionId::BackendImpostor].isChecked());
        QVERIFY(!second.actions()[ActionId::BackendPull].isChecked());
        QCOMPARE(m_fixture->settings().recentBoards(), QStringList(QFileInfo(kSample).absoluteFilePath()));

        second.resetSettings();
        QVERIFY(second.findChild<QDockWidget*>("statistics")->isHidden());
        QVERIFY(!second.findChild<QDockWidget*>("layers")->isHidden());
        QVERIFY(second.actions()[ActionId::ThemeSystem].isChecked());
        QVERIFY(m_fixture->settings().recentBoards().isEmpty());
    }

    void whatTheViewsShowIsKept() {
        constexpr ActionId kOff[] = {ActionId::ShowGrid, ActionId::ShowPinNames, ActionId::FollowInTables};
        constexpr ActionId kOn[] = {ActionId::ShowOutlines, ActionId::DimOthers, ActionId::FollowInSolid};
        const auto areSet = [&](bool isOn) {
            const auto isSo = [&](ActionId id) { return window().actions()[id].isChecked() == isOn; };
            return std::ranges::all_of(kOn, isSo) && std::ranges::none_of(kOff, isSo);
        };
        const auto share = [this] {
            const ui::BoardViews& views = window().views();
            return double(views.both()[0]->width()) / (views.both()[0]->width() + views.both()[1]->width());
        };
        QVERIFY(m_fixture->openAndWait(kSample));
        QVERIFY(areSet(false));
        for (const ActionId id : {kOff[0], kOff[1], kOff[2], kOn[0], kOn[1], kOn[2]}) {
            window().actions()[id].trigger();
        }
        const int dim = window().netsPanel().dimSlider().value();
        window().netsPanel().dimSlider().setValue(dim / 2);
        auto* splitter = window().views().findChild<QSplitter*>();
        splitter->setSizes({1000, 3000});
        emit splitter->splitterMoved(1000, 1);  // as the user does
        m_fixture->restart();
        QVERIFY(m_fixture->openAndWait(kSample));
        QVERIFY(areSet(true));
        QVERIFY2(window().views().flat().controller().margins().isNull(), "no rulers either");
        QVERIFY(!window().actions()[ActionId::ShowViewCube].isChecked());
        QCOMPARE(window().netsPanel().dimSlider().value(), dim / 2);
        QVERIFY2(share() < 0.4, qPrintable(QString::number(share())));
        window().resetSettings();
        QVERIFY(areSet(false) && window().actions()[ActionId::ShowViewCube].isChecked());
        QCOMPARE(window().netsPanel().dimSlider().value(), dim);
        QTRY_VERIFY(std::abs(share() - 0.5) < 0.05);
    }

    void panelsAreToggledByKeys() {
        QVERIFY(m_fixture->openAndWait(kSample));
        auto* layers = window().findChild<QDockWidget*>("layers");
        m_fixture->key(Qt::Key_1, Qt::ControlModifier);
        QVERIFY(layers->isHidden());
        m_fixture->key(Qt::Key_1, Qt::ControlModifier);
        QVERIFY(!layers->isHidden());
        m_fixture->key(Qt::Key_6, Qt::ControlModifier);  // from behind
        auto* stack = window().findChild<QDockWidget*>("stackup");
        QTRY_VERIFY(!stack->visibleRegion().isEmpty());
        QTRY_VERIFY(!window().actions()[ActionId::ShowLayersDock].isChecked());
        m_fixture->key(Qt::Key_6, Qt::ControlModifier);
        QVERIFY(stack->isHidden());
    }

    void keysSheetOpensBesideTheWindow() {
        m_fixture->window().actions()[ActionId::ShowKeys].trigger();
        auto* plane = window().findChild<QDialog*>("keysSheet");
        QVERIFY(plane != nullptr && plane->isVisible() && !plane->isModal());
        plane->close();
    }

    void safeColoursAreKeptAndLeaveChosenOnesAlone() {
        QVERIFY(m_fixture->openAndWait(locations::kSample));
        const std::vector<ui::LayerAppearance> standard = window().layers().effectiveStyles();
        const QModelIndex chosen = window().layers().index(0, ui::LayerModel::Colour);
        window().layers().setData(chosen, QColor(1, 2, 3), Qt::EditRole);
        const QImage before = m_fixture->picture();
        window().actions()[ActionId::SafeColours].trigger();
        const std::vector<ui::LayerAppearance> safe = window().layers().effectiveStyles();
        QCOMPARE(safe[0].colour, QColor(1, 2, 3));
        int changed = 0;
        for (std::size_t row = 1; row < safe.size(); ++row) {
            changed += safe[row].colour != standard[row].colour ? 1 : 0;
            QCOMPARE(safe[row].isVisible, standard[row].isVisible);
        }
        QVERIFY(changed > 3);
        QVERIFY(differingPixels(before, m_fixture->picture()) > 1000);  // lacquer and metal too
        m_fixture->restart();
        QVERIFY(window().actions()[ActionId::SafeColours].isChecked());
        QVERIFY(m_fixture->openAndWait(locations::kSample));
        QCOMPARE(window().layers().effectiveStyles()[1].colour, safe[1].colour);
        window().actions()[ActionId::SafeColours].trigger();
        QCOMPARE(window().layers().effectiveStyles()[1].colour, standard[1].colour);
    }

private:
    /// The dialog that chooses the next board, once it can be typed in.
    QFileDialog& openDialog() {
        window().actions()[ActionId::OpenFile].trigger();
        auto* dialog = window().findChild<QFileDialog*>();
        if (dialog == nullptr || !QTest::qWaitForWindowExposed(dialog)) {
            qFatal("no dialog");
        }
        return *dialog;
    }
    TestWindow& window() { return m_fixture->window(); }

    QModelIndex topCopper(int column) {
        const model::Document& document = *window().document();
        for (std::size_t row = 0; row < document.layers.size(); ++row) {
            if (document.layers[row].isCopper()) {
                return window().layers().index(static_cast<int>(row), column);
            }
        }
        return {};
    }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(MainWindowTest)
#include "main_window_test.moc"
