// Views are kept, renamed, forgotten and looked at again; Back and Forward walk through where one has been.

#include <QComboBox>
#include <QLineEdit>
#include <QtTest>
#include <algorithm>

#include "model/session/session.h"
#include "tests/locations.h"
#include "tests/patience.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/table_view.h"
#include "ui/shell/message_bar.h"

using ui::ActionId;
namespace fs = std::filesystem;

class SavedViewsTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_fixture = std::make_unique<WindowFixture>();
        m_job = m_fixture->copyOfJob("everything");
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(m_job.string())));
        window().showPanel("views");
    }
    void cleanup() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void aKeptViewIsLookedAtAgain() {
        window().views().setActive(window().views().solid());
        m_fixture->key(Qt::Key_I);
        solid().zoomAt({300, 200}, 2.5F);
        window().layers().showOnly({"TOP"});
        m_fixture->key(Qt::Key_B, Qt::ControlModifier);
        const render::CameraPose kept = solid().camera().pose();
        const QImage before = m_fixture->picture();
        window().layers().showAll();
        m_fixture->key(Qt::Key_B);  // from below
        QVERIFY(solid().camera().pose() != kept);
        choose(0);
        QVERIFY(isNear(solid().camera().pose(), kept));
        QCOMPARE(window().layers().visibleNames(), std::vector<std::string>{"TOP"});
        QVERIFY(differingPixels(m_fixture->picture(), before) < 50);
    }

    void viewsStayInPlaceWhenTheOutlineChanges() {
        solid().zoomAt({300, 200}, 2.5F);
        m_fixture->key(Qt::Key_B, Qt::ControlModifier);
        render::CameraPose expected = solid().camera().pose();
        window().awaitFiles();
        std::vector<model::session::SavedView> views = window().savedViews().views();
        QVERIFY(views[0].solid.origin == std::optional(window().workspace().board()->model->origin));
        // As if the board had been 10 mm longer on its right.
        views[0].flat.origin->x += 5'000'000;
        views[0].solid.origin->x += 5'000'000;
        expected.target.x += 5.0F;
        QVERIFY(model::session::saveViews(m_job, *window().document(), views).ok());
        reopen();
        choose(0);
        QVERIFY(isNear(solid().camera().pose(), expected));
    }

    void keptViewsAreInTheSessionOfTheBoard() {
        const auto jobFiles = QDir(QString::fromStdString(m_job.string())).entryList();
        m_fixture->key(Qt::Key_B, Qt::ControlModifier);
        m_fixture->key(Qt::Key_B, Qt::ControlModifier);
        rename(1, "U1 from the corner");
        QTRY_COMPARE(names(), (QStringList{"View 1", "U1 from the corner"}));  // the editor answers a little later
        m_fixture->restart();
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(m_job.string())));
        QCOMPARE(names(), (QStringList{"View 1", "U1 from the corner"}));
        QCOMPARE(QDir(QString::fromStdString(m_job.string())).entryList(), jobFiles);
    }

    /// Both call their first view alike.
    void viewsOfTwoWindowsAreAllKept() {
        const QString job = QString::fromStdString(m_job.string());
        auto other = std::make_unique<WindowFixture>();
        QVERIFY(other->openAndWait(job));
        other->key(Qt::Key_Plus);
        other->key(Qt::Key_B, Qt::ControlModifier);
        other->window().awaitFiles();
        QVERIFY(activate(window()));
        m_fixture->key(Qt::Key_B, Qt::ControlModifier);
        QTRY_VERIFY(window().messageBar().isVisible());
        QVERIFY2(window().error().contains("The views"), qPrintable(window().error()));
        m_fixture->key(Qt::Key_Z, Qt::ControlModifier);
        m_fixture->key(Qt::Key_B, Qt::ControlModifier);
        QCOMPARE(names(), QStringList{"View 1"});
        // Cameras and layers are those of the window that saved them last, which says so.
        m_fixture->key(Qt::Key_S, Qt::ControlModifier);
        window().awaitFiles();
        QVERIFY(activate(other->window()));
        other->key(Qt::Key_S, Qt::ControlModifier);
        QTRY_VERIFY(other->window().messageBar().isVisible());
        QVERIFY2(other->window().error().contains("was replaced"), qPrintable(other->window().error()));
        QCOMPARE(validationErrorsOnClosing(other), 0U);
        QVERIFY(activate(window()));
        m_fixture->key(Qt::Key_F5);
        QTRY_COMPARE(names(), (QStringList{"View 1", "View 1"}));
    }

    void whatAnotherWindowSavedOfOtherPartsIsTold() {
        const std::vector measurements{model::Measurement{"M", "pcb", model::MeasurementKind::Clearance}};
        QVERIFY(model::session::saveMeasurements(m_job, *window().document(), measurements).ok());
        m_fixture->key(Qt::Key_B, Qt::ControlModifier);
        QTRY_VERIFY(window().messageBar().isVisible());
        QVERIFY2(window().error().contains("measurements"), qPrintable(window().error()));
        window().messageBar().hide();
        m_fixture->key(Qt::Key_B, Qt::ControlModifier);
        m_fixture->key(Qt::Key_S, Qt::ControlModifier);
        window().awaitFiles();
        QVERIFY2(!window().messageBar().isVisible(), "what was said once is not said again");
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(m_job.string())));
        QCOMPARE(window().measurements().rowCount(), 1);
    }

    void aDoubleClickGoesThereAndDoesNotRename() {
        m_fixture->key(Qt::Key_B, Qt::ControlModifier);
        const render::CameraPose kept = solid().camera().pose();
        solid().zoomAt({300, 200}, 2.5F);
        const QPoint at = table().visualRect(table().model()->index(0, 0)).center();
        QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, at);
        QTest::mouseDClick(table().viewport(), Qt::LeftButton, {}, at);
        QVERIFY(isNear(solid().camera().pose(), kept));
        QVERIFY(table().findChild<QLineEdit*>() == nullptr);
        rename(0, "By F2");
        QTRY_COMPARE(names(), QStringList{"By F2"});
    }

    void theMenuOfARowUpdatesAndShowsAView() {
        window().layers().showOnly({"TOP"});
        m_fixture->key(Qt::Key_B, Qt::ControlModifier);
        window().layers().showAll();
        const std::vector<std::string> all = window().layers().visibleNames();
        table().setCurrentIndex(table().model()->index(0, 0));
        command("update").trigger();
        QCOMPARE(names(), QStringList{"View 1"});
        QCOMPARE(window().savedViews().views()[0].layers, all);
        window().actions()[ui::ActionId::Undo].trigger();
        QCOMPARE(window().savedViews().views()[0].layers, std::vector<std::string>{"TOP"});
        command("show").trigger();
        QCOMPARE(window().layers().visibleNames(), std::vector<std::string>{"TOP"});
    }

    void aSelectionIsUpdatedByWhatIsSelectedAndNotByNothing() {
        window().selection().select({{0, model::ElementId{std::size_t{0}}}});
        m_fixture->key(Qt::Key_B, Qt::ControlModifier | Qt::ShiftModifier);
        const auto saved = [&] { return window().savedViews().views()[0].selection; };
        const auto before = saved();
        QVERIFY(before && before->elements.size() == 1);
        window().selection().select({});
        table().setCurrentIndex(table().model()->index(0, 0));
        command("update").trigger();
        QCOMPARE(saved(), before);
        window().selection().select({{0, model::ElementId{std::size_t{1}}}});
        command("update").trigger();
        QVERIFY(saved() && saved() != before);
        QCOMPARE(names(), QStringList{"Selection 1"});
    }

    void whereThe2DViewIsNarrowerThanThenAllThatWasSeenIsSeen() {
        ui::CameraController& flat = window().views().flat().controller();
        const auto arrange = [&](ui::Arrangement arrangement) {
            window().views().setArrangement(arrangement);
            QTest::qWait(100);
            QTRY_COMPARE(flat.viewport().toSize(), window().views().flat().size());
        };
        const auto widthSeen = [&] { return flat.nmPerPixel() * flat.viewport().width(); };
        arrange(ui::Arrangement::Stacked);
        flat.fit();
        flat.zoomAtCentre(1.25F);
        const double then = widthSeen();
        const float wide = flat.aspect();
        m_fixture->key(Qt::Key_B, Qt::ControlModifier);
        arrange(ui::Arrangement::SideBySide);
        QVERIFY(flat.aspect() < 0.8F * wide);
        flat.zoomAtCentre(3.0F);
        const QPoint at = table().visualRect(table().model()->index(0, 0)).center();
        QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, at);
        QTest::mouseDClick(table().viewport(), Qt::LeftButton, {}, at);
        QVERIFY(std::abs(widthSeen() / then - 1.0) < 1e-3);
        arrange(ui::Arrangement::Stacked);  // nobody has moved the camera
        QVERIFY(std::abs(widthSeen() / then - 1.0) < 1e-3);
        flat.zoomAtCentre(2.0F);
        arrange(ui::Arrangement::SideBySide);
        QVERIFY(widthSeen() < 0.5 * then);
    }

    void whatIsForgottenComesBackByUndo() {
        m_fixture->key(Qt::Key_B, Qt::ControlModifier);
        m_fixture->key(Qt::Key_B, Qt::ControlModifier);
        table().setFocus();
        table().setCurrentIndex(table().model()->index(0, 0));
        QTest::keyClick(&table(), Qt::Key_Delete);
        QCOMPARE(names(), QStringList{"View 2"});
        window().actions()[ActionId::Undo].trigger();
        QCOMPARE(names(), (QStringList{"View 1", "View 2"}));
        window().actions()[ActionId::Undo].trigger();
        window().actions()[ActionId::Undo].trigger();
        QVERIFY(names().isEmpty());
        window().awaitFiles();
        QVERIFY(!fs::exists(model::session::sessionPath(m_job)));
        window().actions()[ActionId::Redo].trigger();
        QCOMPARE(names(), QStringList{"View 1"});
    }

    void aSessionThatCannotBeWrittenIsTold() {
        const QSignalSpy reported(&window().workspace(), &ui::Workspace::reported);
        fs::create_directories(model::session::sessionPath(m_job) / "in the way");
        m_fixture->key(Qt::Key_B, Qt::ControlModifier);
        window().awaitFiles();
        QVERIFY(window().messageBar().isVisible());
        QCOMPARE(names(), QStringList{"View 1"});
        QCOMPARE(reported.last()[0].toString(),
                 QString("View 1 is not saved: it counts until another board is opened"));
    }

    void viewsOfABoardWithoutItsSessionAreNotSaved() {
        window().workspace().reload([](model::OpenRequest& request) { request.noSession = true; });
        QTRY_VERIFY(window().workspace().board()->request.noSession);
        const QSignalSpy reported(&window().workspace(), &ui::Workspace::reported);
        m_fixture->key(Qt::Key_B, Qt::ControlModifier);
        QCOMPARE(names(), QStringList{"View 1"});
        QCOMPARE(reported.last()[0].toString(),
                 QString("View 1 is not saved: it counts until another board is opened"));
        QVERIFY(!fs::exists(model::session::sessionPath(m_job)));
    }

    void viewsThatStandInNoFileOutliveAReload() {
        fs::create_directories(model::session::sessionPath(m_job) / "in the way");
        m_fixture->key(Qt::Key_B, Qt::ControlModifier);
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(m_job.string())));
        QCOMPARE(names(), QStringList{"View 1"});
        fs::remove_all(model::session::sessionPath(m_job));
        const QSignalSpy reported(&window().workspace(), &ui::Workspace::reported);
        m_fixture->key(Qt::Key_B, Qt::ControlModifier);  // now all are saved
        window().awaitFiles();
        QCOMPARE(reported.last()[0].toString(), QString("Saved as View 2"));
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(m_job.string())));
        QCOMPARE(names(), (QStringList{"View 1", "View 2"}));
    }

    void backAndForwardWalkThroughPlaces() {
        rest();
        const render::CameraPose first = solid().camera().pose();
        solid().zoomAt({100, 100}, 3.0F);
        rest();
        const render::CameraPose second = solid().camera().pose();
        solid().zoomAt({200, 100}, 2.0F);  // has not rested: Back counts it all the same
        const render::CameraPose third = solid().camera().pose();
        m_fixture->key(Qt::Key_Left, Qt::AltModifier);
        QVERIFY(isNear(solid().camera().pose(), second));
        m_fixture->key(Qt::Key_Left, Qt::AltModifier);
        QVERIFY(isNear(solid().camera().pose(), first));
        m_fixture->key(Qt::Key_Left, Qt::AltModifier);  // nothing before
        QVERIFY(isNear(solid().camera().pose(), first));
        m_fixture->key(Qt::Key_Right, Qt::AltModifier);
        m_fixture->key(Qt::Key_Right, Qt::AltModifier);
        QVERIFY(isNear(solid().camera().pose(), third));
        m_fixture->key(Qt::Key_Left, Qt::AltModifier);
        solid().zoomAt({50, 50}, 1.5F);  // elsewhere: the third place is forgotten
        rest();
        m_fixture->key(Qt::Key_Right, Qt::AltModifier);
        QVERIFY(!isNear(solid().camera().pose(), third));
    }

    void whatTheWindowShowsIsSavedOnlyWhenAsked() {
        solid().zoomAt({300, 200}, 2.5F);
        window().layers().showOnly({"TOP"});
        const QModelIndex colour = window().layers().index(0, ui::LayerModel::Colour);
        window().layers().setData(colour, QColor(10, 20, 30), Qt::EditRole);
        m_fixture->restart();
        QVERIFY(!fs::exists(model::session::sessionPath(m_job)));
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(m_job.string())));
        QVERIFY(window().layers().visibleNames().size() > 1);

        window().layers().setData(window().layers().index(0, ui::LayerModel::Colour), QColor(10, 20, 30), Qt::EditRole);
        window().layers().showOnly({"TOP"});
        solid().zoomAt({300, 200}, 2.5F);
        const render::CameraPose saved = solid().camera().pose();
        m_fixture->key(Qt::Key_S, Qt::ControlModifier);
        window().awaitFiles();
        QVERIFY(fs::exists(model::session::sessionPath(m_job)));
        m_fixture->restart();
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(m_job.string())));
        QVERIFY(isNear(solid().camera().pose(), saved));
        QCOMPARE(window().layers().visibleNames(), std::vector<std::string>{"TOP"});
        QCOMPARE(window().layers().effectiveStyles()[0].colour, QColor(10, 20, 30));
        window().layers().restoreDefaults();
        QVERIFY(window().layers().effectiveStyles()[0].colour != QColor(10, 20, 30));
    }

    void anotherStepOfTheJobShowsTheSameLayers() {
        m_fixture->restart();
        QVERIFY(m_fixture->openAndWait(locations::kTestData + QStringLiteral("/odb/panel")));
        const std::vector<std::string> before = window().layers().visibleNames();
        window().layers().showOnly({"BOTTOM"});
        const model::Document* panel = window().document();
        QComboBox& box = *window().findChild<QComboBox*>("steps");
        emit box.textActivated("CARD");
        QTRY_VERIFY(window().document() != panel && window().document()->job.step == "CARD");
        QCOMPARE(window().layers().visibleNames(), std::vector<std::string>{"BOTTOM"});
        QVERIFY(before.size() > 1);
    }

    void aLayerShownAloneIsSavedToo() {
        const model::LayerId top = window().document()->findLayer("TOP");
        window().layers().toggleSolo(top);
        m_fixture->key(Qt::Key_S, Qt::ControlModifier);
        m_fixture->restart();
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(m_job.string())));
        QCOMPARE(window().layers().soloLayer(), top);
        QCOMPARE(window().workspace().currentLayer(), top);
    }

    void aSelectionIsKeptAndSelectedAgain() {
        m_fixture->key(Qt::Key_B, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(names().isEmpty());  // nothing is selected
        const std::vector<model::BoardElement> chosen{{0, model::ElementId{std::size_t{1}}},
                                                      {0, model::ElementId{std::size_t{4}}}};
        const std::vector<model::BoardNet> nets{{0, model::NetId{std::size_t{1}}}};
        window().selection().setNets(nets);
        window().selection().select(chosen);
        m_fixture->key(Qt::Key_B, Qt::ControlModifier | Qt::ShiftModifier);
        QCOMPARE(names(), QStringList{"Selection 1"});
        reopen();
        QVERIFY(window().selection().selected().empty());
        const render::CameraPose before = solid().camera().pose();
        choose(0);
        QCOMPARE(window().selection().selected(), chosen);
        QCOMPARE(window().selection().nets(), nets);
        QVERIFY(isNear(solid().camera().pose(), before));
        QVERIFY(!window().messageBar().isVisible());
    }

    void aViewHasTheCurrentLayerThatItWasSavedWith() {
        const auto layer = [&](const char* name) { return window().document()->findLayer(name); };
        m_fixture->key(Qt::Key_B, Qt::ControlModifier);
        window().workspace().setCurrentLayer(layer("TOP"));
        m_fixture->key(Qt::Key_B, Qt::ControlModifier);
        reopen();
        window().workspace().setCurrentLayer(layer("BOTTOM"));
        choose(1);
        QCOMPARE(window().workspace().currentLayer(), layer("TOP"));
        choose(0);
        QVERIFY(!window().workspace().currentLayer().isValid());
        window().awaitFiles();
        std::vector<model::session::SavedView> views = window().savedViews().views();
        views[0].current.reset();  // as older versions have saved it
        QVERIFY(model::session::saveViews(m_job, *window().document(), views).ok());
        reopen();
        window().workspace().setCurrentLayer(layer("BOTTOM"));
        choose(0);
        QCOMPARE(window().workspace().currentLayer(), layer("BOTTOM"));
    }

    void aViewHighlightsTheNetsThatItWasSavedWith() {
        m_fixture->key(Qt::Key_B, Qt::ControlModifier);
        const std::vector<model::BoardNet> nets{{0, model::NetId{std::size_t{1}}}};
        window().selection().setNets(nets);
        m_fixture->key(Qt::Key_B, Qt::ControlModifier);
        reopen();
        QVERIFY(window().selection().nets().empty());
        choose(1);
        QCOMPARE(window().selection().nets(), nets);
        const QString name = QString::fromStdString(window().document()->nets[1].name);
        QVERIFY(table().model()->index(1, ui::ViewListModel::Layers).data().toString().startsWith("net " + name + ";"));
        choose(0);  // says nothing of nets
        QCOMPARE(window().selection().nets(), nets);
        QVERIFY(!window().messageBar().isVisible());
    }

    void aViewSelectsTheElementsThatItWasSavedWith() {
        m_fixture->key(Qt::Key_B, Qt::ControlModifier);
        const std::vector<model::BoardElement> chosen{{0, model::ElementId{std::size_t{1}}},
                                                      {0, model::ElementId{std::size_t{4}}}};
        window().selection().select(chosen);
        m_fixture->key(Qt::Key_B, Qt::ControlModifier);
        reopen();
        QVERIFY(window().selection().selected().empty());
        const QString contents = table().model()->index(1, ui::ViewListModel::Layers).data().toString();
        QVERIFY2(contents.startsWith("2 elements; "), qPrintable(contents));
        choose(1);
        QCOMPARE(window().selection().selected(), chosen);
        choose(0);  // says nothing of elements
        QCOMPARE(window().selection().selected(), chosen);
        QVERIFY(!window().messageBar().isVisible());
    }

    void whatASelectionNoLongerFindsIsTold() {
        window().selection().select({{0, model::ElementId{std::size_t{1}}}, {0, model::ElementId{std::size_t{4}}}});
        m_fixture->key(Qt::Key_B, Qt::ControlModifier | Qt::ShiftModifier);
        window().awaitFiles();
        std::vector<model::session::SavedView> views = window().savedViews().views();
        views[0].selection->elements[0].box.max.x += 12345;  // as in another version of the board
        views[0].selection->nets.push_back({"pcb", "GONE"});
        QVERIFY(model::session::saveViews(m_job, *window().document(), views).ok());
        reopen();
        choose(0);
        QCOMPARE(window().selection().selected().size(), std::size_t{1});
        QTRY_VERIFY(window().messageBar().isVisible());
        QVERIFY(window().error().contains("net GONE, 1 of 2 elements"));
    }

private:
    /// Keys reach the window in use only.
    static bool activate(TestWindow& window) {
        window.activateWindow();
        return QTest::qWaitForWindowActive(&window);
    }

    /// In another window.
    void reopen() {
        m_fixture->restart();
        QVERIFY(m_fixture->openAndWait(QString::fromStdString(m_job.string())));
        window().showPanel("views");
    }

    TestWindow& window() { return m_fixture->window(); }
    ui::CameraController& solid() { return window().views().solid().controller(); }
    ui::TableView& table() { return window().table("views"); }
    /// An entry of the menu of rows.
    QAction& command(const QString& name) {
        const QList<QAction*> actions = table().actions();
        return **std::ranges::find(actions, name, &QAction::objectName);
    }
    static void rest() { QTest::qWait(ui::ViewHistory::kRestMs + 100); }
    static bool isNear(const render::CameraPose& a, const render::CameraPose& b) {
        return glm::length(a.target - b.target) < 1e-3F && std::abs(a.distance - b.distance) < 1e-3F &&
               std::abs(a.yaw - b.yaw) < 1e-4F && std::abs(a.pitch - b.pitch) < 1e-4F &&
               a.isOrthographic == b.isOrthographic;
    }
    QStringList names() {
        QStringList names;
        for (const auto& view : window().savedViews().views()) {
            names += QString::fromStdString(view.name);
        }
        return names;
    }
    void choose(int row) {
        const QRect cell = table().visualRect(table().model()->index(row, 0));
        QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, cell.center());
    }
    void rename(int row, const QString& name) {
        table().setFocus();
        table().setCurrentIndex(table().model()->index(row, 0));
        QTest::keyClick(&table(), Qt::Key_F2);
        auto* editor = table().findChild<QLineEdit*>();
        QVERIFY(editor != nullptr);
        editor->selectAll();
        QTest::keyClicks(editor, name);
        QTest::keyClick(editor, Qt::Key_Return);
    }

    std::unique_ptr<WindowFixture> m_fixture;
    fs::path m_job;
};

QTEST_MAIN(SavedViewsTest)
#include "saved_views_feature_test.moc"
