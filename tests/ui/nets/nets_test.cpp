// The Nets panel in the window: groups, what is known of nets, nets of steps that a panel places, colours and hiding.

#include <QApplication>
#include <QColorDialog>
#include <QComboBox>
#include <QContextMenuEvent>
#include <QFile>
#include <QHeaderView>
#include <QLineEdit>
#include <QMenu>
#include <QMouseEvent>
#include <QScrollBar>
#include <QSlider>
#include <QStatusBar>
#include <QTimer>
#include <QToolButton>
#include <QtTest>

#include "tests/locations.h"
#include "tests/patience.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/table_view.h"
#include "ui/nets/nets_panel.h"

using model::BoardNet;
using ui::NetModel;

class NetsTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_fixture = std::make_unique<WindowFixture>(); }
    void cleanup() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void aHeadingStandsForItsNets() {
        open(m_fixture->copyOfSample());
        panel().findChild<QComboBox*>("netGroups")->setCurrentText("By supply");
        QTRY_VERIFY(nets().isArranged() && nets().isHeading(0));
        const int end = static_cast<int>(nets().netsAt(0).size()) + 1;
        QVERIFY(end > 1);
        click(0);
        QCOMPARE(window().selection().nets().size(), static_cast<std::size_t>(end - 1));
        QCOMPARE(table().selectionModel()->selectedRows().size(), end);
        click(0, Qt::ControlModifier);
        QVERIFY2(window().selection().nets().empty(), "taken back alone, a heading takes its nets with it");
        click(0);
        click(1);
        QCOMPARE(window().selection().nets(), (std::vector<BoardNet>{{0, nets().netAt(1)}}));
        window().views().solid().takeKeyboard();
        m_fixture->key(Qt::Key_Escape);
        QTRY_VERIFY(table().selectionModel()->selectedRows().isEmpty());
    }

    /// Of pairs on one sheet, in a panel that has no room for their whole names.
    void headingsThatAreCutCanBeToldApart() {
        open(boardWithPairs());
        window().showPanel("nets");
        panel().findChild<QComboBox*>("netGroups")->setCurrentText("By pair");
        QTRY_VERIFY(nets().isArranged() && nets().isHeading(0) && nets().isHeading(3));
        QCOMPARE(nets().index(0, NetModel::Length).data().toString(), "2 nets");
        table().setColumnWidth(NetModel::Name, 120);
        QTRY_VERIFY(headingPicture(0) != headingPicture(3));
    }

    void aTriangleAndArrowKeysFold() {
        open(m_fixture->copyOfSample());
        panel().findChild<QComboBox*>("netGroups")->setCurrentText("By supply");
        QTRY_VERIFY(nets().isArranged() && nets().isHeading(0));
        const int all = nets().rowCount();
        const int members = static_cast<int>(nets().netsAt(0).size());
        const QModelIndex heading = nets().index(0, NetModel::Name);
        const QPoint triangle = table().visualRect(heading).topLeft() + QPoint(8, 8);
        QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, triangle);
        QCOMPARE(nets().rowCount(), all - members);
        QVERIFY2(window().selection().nets().empty(), "folding chooses nothing");
        QTest::keyClick(&table(), Qt::Key_Right);
        QCOMPARE(nets().rowCount(), all);
        QTest::keyClick(&table(), Qt::Key_Left);
        QCOMPARE(nets().rowCount(), all - members);
        const model::NetId hidden = nets().netsAt(0).front().net;
        QVERIFY(!nets().rowOf(hidden));
        window().selection().setNets({{0, hidden}});
        QVERIFY2(nets().rowOf(hidden).has_value(), "what is selected elsewhere is unfolded");
    }

    void whatIsKnownOfTheHighlightedNetsStandsBelow() {
        open(m_fixture->copyOfSample());
        QTRY_VERIFY(window().label("netDetails").isEmpty());
        const model::NetId gnd = window().document()->findNet("GND");
        window().selection().setNets({{0, gnd}});
        QTRY_VERIFY(window().label("netDetails").startsWith("GND\n"));
        QTRY_VERIFY(window().label("netDetails").contains("via"));
        double routed = 0.0;
        const auto lengths = model::routedLengths(*window().document(), gnd);
        for (const auto& [layer, length] : lengths) {
            QVERIFY(window()
                        .label("netDetails")
                        .contains(QString::fromStdString(window().document()->layer(layer).name) + ": "));
            routed += length;
        }
        QVERIFY(routed > 0.0);
        window().selection().setNets({});
        QTRY_VERIFY(window().label("netDetails").isEmpty());
    }

    void netsOfPlacedStepsAreListedAndFollowed() {
        open(QString(locations::kTestData) + "/odb/panel");
        const model::StepTree& tree = window().selection().tree();
        QVERIFY(tree.steps.size() > 1 && !stepBox().isHidden());
        QStringList steps;
        for (int i = 0; i < stepBox().count(); ++i) {
            steps += stepBox().itemText(i);
        }
        QVERIFY(steps.contains("CARD") && steps.contains("COUPON"));
        // The net of an element in a late copy of each step: the table goes there and N lights it up.
        for (std::uint32_t copy = static_cast<std::uint32_t>(tree.copies.size()); copy-- > 1;) {
            const std::uint32_t step = tree.copies[copy].step;
            if (tree.steps[step]->nets.empty() || tree.steps[step]->netElements.empty()) {
                continue;
            }
            const model::BoardElement at{copy, tree.steps[step]->netElements.front()};
            window().selection().select({at});
            QTRY_VERIFY(nets().isArranged());
            QCOMPARE(stepBox().currentData().toUInt(), step);
            const BoardNet net = *window().selection().netOf(at);
            QTRY_COMPARE(table().currentIndex().row(), *nets().rowOf(net.net));
            m_fixture->key(Qt::Key_N);
            QCOMPARE(window().selection().nets(), std::vector{net});
            QVERIFY(!window().selection().highlight()[step].empty());
            QTRY_VERIFY(!window().label("netDetails").isEmpty());
            m_fixture->key(Qt::Key_N);
        }
    }

    void rowsOfTheSelectionAreMarkedAndAClickOnOneHighlightsIt() {
        open(m_fixture->copyOfSample());
        const BoardNet other{0, model::NetId{gnd().net.row() == 0 ? std::size_t{1} : std::size_t{0}}};
        window().selection().setNets({other});
        QCOMPARE(markedRows(), QList{*nets().rowOf(other.net)});
        window().selection().select({{0, aPadOf(gnd())}});
        QCOMPARE(markedRows(), QList{*nets().rowOf(gnd().net)});
        QCOMPARE(table().currentIndex().row(), *nets().rowOf(gnd().net));
        QTRY_VERIFY(window().label("netDetails").startsWith("GND\n"));
        QCOMPARE(window().selection().nets(), std::vector{other});
        click(*nets().rowOf(gnd().net));
        QCOMPARE(window().selection().nets(), std::vector{gnd()});
        QVERIFY(window().selection().selected().empty());
    }

    void undoTakesBackTheLastThingDone() {
        openCopy();
        const BoardNet other{0, model::NetId{gnd().net.row() == 0 ? std::size_t{1} : std::size_t{0}}};
        QAction& undo = window().actions()[ActionId::Undo];
        window().selection().setNets({gnd()});
        m_fixture->key(Qt::Key_U);
        window().selection().toggleNets({other});
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(window().selection().nets().empty());
        QCOMPARE(undo.text(), QString("&Undo end of highlights"));
        undo.trigger();
        QCOMPARE(window().statusBar()->currentMessage(), QString("Undone: end of highlights"));
        QCOMPARE(window().actions()[ActionId::Redo].text(), QString("&Redo end of highlights"));
        QCOMPARE(window().selection().nets().size(), std::size_t{2});
        undo.trigger();
        QCOMPARE(window().selection().nets(), std::vector{gnd()});
        QVERIFY(window().netStyles().hasColours());
        undo.trigger();
        QVERIFY(!window().netStyles().hasColours());
        QCOMPARE(window().selection().nets(), std::vector{gnd()});
        undo.trigger();
        QCOMPARE(undo.text(), QString("&Undo"));
        QVERIFY(window().selection().nets().empty());
        QVERIFY(!undo.isEnabled());
        window().actions()[ActionId::Redo].trigger();
        QCOMPARE(window().selection().nets(), std::vector{gnd()});
        window().selection().setNets({other});  // one after the other, as the arrows in the table do
        window().selection().setNets({{0, model::NetId{std::size_t{2}}}});
        undo.trigger();
        QCOMPARE(window().selection().nets(), std::vector{gnd()});
    }

    void escEmptiesTheFilterThenLeavesIt() {
        openCopy();
        window().selection().setNets({gnd()});
        QLineEdit& filter = window().netsPanel().filterEdit();
        window().showPanel("nets");
        window().activateWindow();
        QVERIFY(QTest::qWaitForWindowActive(&window()));
        filter.setFocus();
        QTRY_VERIFY(filter.hasFocus());
        QTest::keyClicks(&filter, "vc");
        QTest::keyClick(&filter, Qt::Key_Escape);
        QCOMPARE(filter.text(), QString());
        QVERIFY(filter.hasFocus());
        QTest::keyClick(&filter, Qt::Key_Escape);
        QVERIFY(!filter.hasFocus());
        QCOMPARE(window().selection().nets(), std::vector{gnd()});
    }

    void whatNLackedIsNoLongerSaidOnceItHasIt() {
        open(m_fixture->copyOfSample());
        m_fixture->key(Qt::Key_N);
        QVERIFY(window().statusBar()->currentMessage().startsWith("Point at an element"));
        window().selection().select({{0, aPadOf(gnd())}});
        m_fixture->key(Qt::Key_N);
        QCOMPARE(window().selection().nets(), std::vector{gnd()});
        QVERIFY(window().statusBar()->currentMessage().isEmpty());
    }

    void aNarrowPanelShowsNamesAndLengthsBesideEachOther() {
        openCopy();
        window().showPanel("nets");
        window().resizeDocks({window().findChild<QDockWidget*>("nets")}, {320}, Qt::Horizontal);
        QTRY_VERIFY(std::abs(table().width() - 320) < 30);
        const auto end = [&](NetModel::Column column) {
            return table().horizontalHeader()->sectionViewportPosition(column) + table().columnWidth(column);
        };
        QTRY_VERIFY(end(NetModel::Length) <= table().viewport()->width());
        QVERIFY(table().columnWidth(NetModel::Name) >= table().fontMetrics().horizontalAdvance("1PPS_OUT"));
        table().horizontalHeader()->resizeSection(NetModel::Name, 250);
        window().resizeDocks({window().findChild<QDockWidget*>("nets")}, {350}, Qt::Horizontal);
        QTest::qWait(50);
        QVERIFY2(table().columnWidth(NetModel::Name) == 250, "the user has set it");
    }

    void namesTakeTheRoomThatNumbersLeave() {
        open(boardWithPairs());
        window().showPanel("nets");
        panel().findChild<QComboBox*>("netGroups")->setCurrentText("No groups");
        QTRY_VERIFY(nets().isArranged() && !nets().isHeading(0));
        const auto needed = [&](NetModel::Column column) {
            return std::max(table().sizeHintForIndex(nets().index(0, column)).width(),
                            table().horizontalHeader()->sectionSizeHint(column));
        };
        window().resizeDocks({window().findChild<QDockWidget*>("nets")}, {320}, Qt::Horizontal);
        QTRY_VERIFY(std::abs(table().width() - 320) < 30);
        QVERIFY(table().columnWidth(NetModel::Length) <= needed(NetModel::Length) + 4);
        QVERIFY(table().columnWidth(NetModel::Name) < needed(NetModel::Name));
        const QHeaderView& header = *table().horizontalHeader();
        const int end = header.sectionViewportPosition(NetModel::Length) + table().columnWidth(NetModel::Length);
        QCOMPARE(end, table().viewport()->width());
        window().resizeDocks({window().findChild<QDockWidget*>("nets")}, {540}, Qt::Horizontal);
        QTRY_VERIFY(table().columnWidth(NetModel::Name) >= needed(NetModel::Name));
    }

    /// Rows on the same ground.
    void namesThatAreCutDifferAtBothEnds() {
        open(boardWithNets({"/CAM0_FLAT_FLEX_CABLE_N", "/CAM0_FLAT_FLEX_CABLE_P", "/CAM1_FLAT_FLEX_CABLE_N",
                            "/CAM1_FLAT_FLEX_CABLE_P", "/CAM2_FLAT_FLEX_CABLE_P"}));
        window().showPanel("nets");
        panel().findChild<QComboBox*>("netGroups")->setCurrentText("No groups");
        QTRY_VERIFY(nets().isArranged() && nets().rowCount() == 5);
        table().setColumnWidth(NetModel::Name, 120);
        QTRY_VERIFY(headingPicture(0) != headingPicture(2));  // CAM0_…_N, CAM1_…_N
        QVERIFY(headingPicture(2) != headingPicture(4));      // CAM1_…_N, CAM2_…_P
        QVERIFY(headingPicture(1) != headingPicture(3));      // CAM0_…_P, CAM1_…_P
    }

    void lengthsAreShownWhole() {
        openCopy();
        const int column = NetModel::Length;
        ui::NetModel& model = nets();
        const auto needed = [&] {
            int widest = 0;
            for (int row = 0; row < model.rowCount(); ++row) {
                const QString text = model.index(row, column).data().toString();
                widest = std::max(widest, table().fontMetrics().horizontalAdvance(text) + 6);
            }
            return widest;
        };
        table().setColumnWidth(column, 20);
        m_fixture->key(Qt::Key_Q);
        QVERIFY2(table().columnWidth(column) >= needed(), "in another unit");
        m_fixture->key(Qt::Key_Q);
        m_fixture->key(Qt::Key_Q);
        QVERIFY(table().columnWidth(column) >= needed());
    }

    /// A column beside the name is clicked, and the table follows what is chosen elsewhere.
    void theTableDoesNotScrollSideways() {
        openCopy();
        window().showPanel("nets");
        table().setMaximumWidth(150);  // the name begins in sight and ends out of it
        QTRY_VERIFY(table().width() <= 150);
        table().horizontalScrollBar()->setValue(0);
        window().selection().setNets({gnd()});
        QCOMPARE(table().horizontalScrollBar()->value(), 0);
        const QRect cell = table().visualRect(table().model()->index(1, NetModel::Name));
        QTest::mouseClick(table().viewport(), Qt::LeftButton, {}, cell.topLeft() + QPoint(4, 4));
        QTest::qWait(QApplication::doubleClickInterval() + 200);  // Qt scrolls then, lest a double click be missed
        QCOMPARE(table().horizontalScrollBar()->value(), 0);
    }

    void nReplacesAndCtrlNAdds() {
        open(m_fixture->copyOfSample());
        const BoardNet other{0, model::NetId{gnd().net.row() == 0 ? std::size_t{1} : std::size_t{0}}};
        window().selection().setNets({other});
        window().selection().select({{0, aPadOf(gnd())}});
        m_fixture->key(Qt::Key_N, Qt::ControlModifier);
        QCOMPARE(window().selection().nets().size(), std::size_t{2});
        window().selection().select({{0, aPadOf(gnd())}});
        m_fixture->key(Qt::Key_N);
        QCOMPARE(window().selection().nets(), std::vector{gnd()});
        m_fixture->key(Qt::Key_U);
        QVERIFY(!window().netStyles().of(other).colour);
        QVERIFY(window().netStyles().of(gnd()).colour);
        m_fixture->key(Qt::Key_N);
        QVERIFY(window().selection().nets().empty());
        window().actions()[ActionId::ClearNetColours].trigger();
    }

    void isolatingHidesAllOtherNetsAndAgainShowsThem() {
        openCopy();
        window().selection().setNets({gnd()});
        m_fixture->key(Qt::Key_I, Qt::ShiftModifier);
        for (int row = 0; row < nets().rowCount(); ++row) {
            QCOMPARE(window().netStyles().isHidden({0, nets().netAt(row)}), nets().netAt(row) != gnd().net);
        }
        m_fixture->key(Qt::Key_I, Qt::ShiftModifier);
        QVERIFY(window().netStyles().state().empty());
        window().actions()[ActionId::Undo].trigger();
        QCOMPARE(window().netStyles().state().size(), window().document()->nets.size() - 1);
        window().actions()[ActionId::Undo].trigger();
        QVERIFY(window().netStyles().state().empty());
    }

    void thatNetsAreHiddenIsSeenAlsoWhenTheBoardIsOpenedAgain() {
        openCopy();
        const auto badge = [&] { return window().findChild<QToolButton*>("hiddenNets"); };
        QVERIFY(!badge()->isVisible());
        window().selection().setNets({gnd()});
        m_fixture->key(Qt::Key_I, Qt::ShiftModifier);
        const QString text = QString("%L1 nets hidden").arg(window().document()->nets.size() - 1);
        QVERIFY(badge()->isVisible());
        QCOMPARE(badge()->text(), text);
        m_fixture->restart();
        open(QString::fromStdString(m_job.string()));
        QVERIFY(badge()->isVisible());
        QCOMPARE(badge()->text(), text);
        QTest::mouseClick(badge(), Qt::LeftButton);
        QVERIFY(window().netStyles().state().empty());
        QVERIFY(!badge()->isVisible());
    }

    void theContextMenuHasTheCommandsForTheRows() {
        open(m_fixture->copyOfSample());
        const QList<QAction*> actions = table().actions();
        for (const ActionId id : {ActionId::HighlightNet, ActionId::ShowSelection, ActionId::ColourNet,
                                  ActionId::HideNet, ActionId::IsolateNet, ActionId::ShowAllNets}) {
            QVERIFY(actions.contains(&window().actions()[id]));
        }
        QStringList texts;
        QTimer::singleShot(0, this, [&] {
            QWidget* popup = QApplication::activePopupWidget();
            const auto* menu = qobject_cast<QMenu*>(popup);
            for (const QAction* action : menu != nullptr ? menu->actions() : QList<QAction*>()) {
                texts += action->text().remove('&');
            }
            if (popup != nullptr) {
                popup->close();  // or else a test that fails waits for it
            }
        });
        QContextMenuEvent event(QContextMenuEvent::Mouse, {5, 5}, table().viewport()->mapToGlobal(QPoint(5, 5)));
        QCoreApplication::sendEvent(table().viewport(), &event);
        QVERIFY(texts.contains("Isolate net"));
    }

    void aColourStaysUntilItIsTakenBack() {
        openCopy();
        const QImage before = m_fixture->picture();
        window().selection().setNets({gnd()});
        m_fixture->key(Qt::Key_U);
        m_fixture->key(Qt::Key_Escape);
        QVERIFY(window().selection().nets().empty());
        QVERIFY(window().netStyles().of(gnd()).colour.has_value());
        const QImage coloured = m_fixture->picture();
        QVERIFY(differingPixels(before, coloured) > 50);
        for (int step = 0; step < 3; ++step) {  // Esc, U, the highlight
            window().actions()[ActionId::Undo].trigger();
        }
        QCOMPARE(differingPixels(before, m_fixture->picture()), 0);
        for (int step = 0; step < 3; ++step) {
            window().actions()[ActionId::Redo].trigger();
        }
        QCOMPARE(differingPixels(coloured, m_fixture->picture()), 0);
        m_fixture->restart();
        openCopy();
        QVERIFY2(window().netStyles().of(gnd()).colour.has_value(), "it is in the session file");
        QVERIFY(differingPixels(before, m_fixture->picture()) > 50);
        window().actions()[ActionId::ClearNetColours].trigger();
        QCOMPARE(differingPixels(before, m_fixture->picture()), 0);
        window().awaitFiles();
        QVERIFY(!std::filesystem::exists(model::session::sessionPath(m_job)));
    }

    void hiddenNetsAreNeitherDrawnNorClicked() {
        open(m_fixture->copyOfSample());
        window().layers().showCopperOnly();
        const model::ElementId pad = aPadOf(gnd());
        BoardView& view = window().views().flat();
        view.controller().show(place(pad) - glm::vec3(1.0F), place(pad) + glm::vec3(1.0F));
        const QPointF at = *view.controller().screenOf(place(pad));
        click(view, at);
        QCOMPARE(window().selection().netOf(*window().selection().current()), std::optional(gnd()));
        const QImage before = picture(view);
        m_fixture->key(Qt::Key_N, Qt::ShiftModifier);  // of what is selected
        QVERIFY(window().netStyles().isHidden(gnd()));
        window().selection().select({});
        QVERIFY(differingPixels(before, picture(view)) > 200);
        click(view, at);
        const auto found = window().selection().current();
        QVERIFY(!found || window().selection().netOf(*found) != gnd());
        for (const auto& hit : window().probing().hitsAt(view, at)) {
            QVERIFY(window().selection().netOf(hit.at) != gnd());
        }
        window().actions()[ActionId::ShowAllNets].trigger();
        QVERIFY(!window().netStyles().isHidden(gnd()));
        QVERIFY(!window().probing().hitsAt(view, at).empty());
        window().actions()[ActionId::Undo].trigger();
        window().actions()[ActionId::Undo].trigger();
        QVERIFY(window().netStyles().state().empty());
    }

    void cellsOfThePanelHideAndColour() {
        openCopy();
        const int row = *nets().rowOf(gnd().net);
        click(row, Qt::NoModifier, NetModel::Shown);
        QVERIFY(window().netStyles().isHidden(gnd()));
        QVERIFY2(window().selection().nets().empty(), "a box is no row to be chosen");
        click(row, Qt::NoModifier, NetModel::Shown);
        QVERIFY(!window().netStyles().isHidden(gnd()));
        click(row, Qt::NoModifier, NetModel::Colour);
        QVERIFY(nets().index(row, NetModel::Colour).data(Qt::EditRole).value<QColor>().isValid());
        panel().chooseColour({gnd()});
        auto* dialog = panel().findChild<QColorDialog*>();
        QVERIFY(dialog != nullptr);
        dialog->setCurrentColor(QColor(1, 2, 3));
        dialog->accept();
        QCOMPARE(window().netStyles().of(gnd()).colour, std::optional(qRgb(1, 2, 3)));
        click(row);
        QTest::keyClick(&table(), Qt::Key_Space);
        QVERIFY(window().netStyles().isHidden(gnd()));
    }

    void theRestIsDimmedAsFarAsTheSliderSays() {
        openCopy();
        const QImage before = m_fixture->picture();
        m_fixture->key(Qt::Key_D);
        QCOMPARE(differingPixels(before, m_fixture->picture()), 0);
        window().selection().setNets({gnd()});
        std::vector<double> lights;
        for (const int percent : {0, 50, 100}) {
            panel().dimSlider().setValue(percent);
            lights.push_back(lightOf(m_fixture->picture()));
        }
        QVERIFY(lights[0] > lights[1] + 0.1 && lights[1] > lights[2] + 0.1);
        m_fixture->key(Qt::Key_D);
        QVERIFY(std::abs(lightOf(m_fixture->picture()) - lights[0]) < 1e-6);
    }

private:
    using ActionId = ui::ActionId;
    using BoardView = ui::BoardView;

    /// Cut as the table cuts it, on the same ground.
    QImage headingPicture(int row) {
        QRect cell = table().visualRect(nets().index(row, NetModel::Name));
        return table().viewport()->grab(cell.adjusted(20, 2, -2, -2)).toImage();
    }
    QString boardWithPairs() {
        const QString sheet = "/A sheet with a rather long name/";
        return boardWithNets({sheet + "DATA1_P", sheet + "DATA1_N", sheet + "DATA2_P", sheet + "DATA2_N"});
    }
    QString boardWithNets(const QStringList& names) {
        const QString path = m_fixture->folder() + "/pairs.kicad_pcb";
        QString nets;
        QString tracks;
        int count = 0;
        for (const QString& name : names) {
            ++count;
            nets += QStringLiteral("(net %1 \"%2\") ").arg(count).arg(name);
            tracks +=
                QStringLiteral("(segment (start 2 %1) (end 18 %1) (width 0.2) (layer \"F.Cu\") (net %1)) ").arg(count);
        }
        QFile file(path);
        if (file.open(QFile::WriteOnly)) {
            file.write(
                QStringLiteral("(kicad_pcb (version 20241229) (generator \"pcbnew\") (layers (0 \"F.Cu\" signal) "
                               "(2 \"B.Cu\" signal) (25 \"Edge.Cuts\" user)) (net 0 \"\") %1 %2 (gr_rect (start 0 0) "
                               "(end 20 20) (stroke (width 0.1) (type default)) (fill no) (layer \"Edge.Cuts\")))")
                    .arg(nets, tracks)
                    .toUtf8());
        }
        return path;
    }

    TestWindow& window() { return m_fixture->window(); }
    ui::NetsPanel& panel() { return window().netsPanel(); }
    NetModel& nets() { return window().nets(); }
    ui::TableView& table() { return panel().table(); }
    QComboBox& stepBox() { return *panel().findChild<QComboBox*>("netSteps"); }
    void open(const QString& path) {
        QVERIFY(m_fixture->openAndWait(path));
        QTRY_VERIFY(nets().isArranged());
    }
    /// A copy that a session may lie beside.
    void openCopy() {
        m_job = m_fixture->copyOfJob("everything");
        open(QString::fromStdString(m_job.string()));
    }
    QList<int> markedRows() {
        QList<int> rows;
        for (const QModelIndex& index : table().selectionModel()->selectedRows()) {
            rows += index.row();
        }
        return rows;
    }
    BoardNet gnd() { return {0, window().document()->findNet("GND")}; }
    void click(int row, Qt::KeyboardModifiers modifiers = Qt::NoModifier, int column = NetModel::Name) {
        table().scrollTo(nets().index(row, column));
        QTest::mouseClick(table().viewport(), Qt::LeftButton, modifiers,
                          table().visualRect(nets().index(row, column)).center());
    }
    /// On the uppermost copper layer.
    model::ElementId aPadOf(const BoardNet& net) {
        const model::Document& board = *window().document();
        for (const model::ElementId element : board.elementsOf(net.net)) {
            const model::Layer& layer = board.layer(board.elements.layer[element.row()]);
            if (layer.isCopper() && layer.side == model::LayerSide::Top &&
                (board.elements.flags[element.row()] & model::kPad) != 0) {
                return element;
            }
        }
        return {};
    }
    glm::vec3 place(model::ElementId element) {
        const model::Box box = window().document()->boxOf(element);
        return window().probing().position().toModel(
            {(double(box.min.x) + box.max.x) / 2.0, (double(box.min.y) + box.max.y) / 2.0});
    }
    static QImage picture(BoardView& view) {
        base::Result<QImage> image = view.grabPicture();
        return image ? image->convertToFormat(QImage::Format_RGB32) : QImage();
    }
    static void click(BoardView& view, QPointF at) {
        for (const auto type : {QEvent::MouseButtonPress, QEvent::MouseButtonRelease}) {
            QMouseEvent event(type, at, view.mapToGlobal(at), Qt::LeftButton,
                              type == QEvent::MouseButtonPress ? Qt::LeftButton : Qt::NoButton, Qt::NoModifier);
            QCoreApplication::sendEvent(&view.canvas(), &event);
        }
    }
    static double lightOf(const QImage& picture) {
        double sum = 0.0;
        for (int y = 0; y < picture.height(); ++y) {
            for (int x = 0; x < picture.width(); ++x) {
                sum += qGray(picture.pixel(x, y));
            }
        }
        return sum / (picture.width() * picture.height());
    }

    std::unique_ptr<WindowFixture> m_fixture;
    std::filesystem::path m_job;
};

QTEST_MAIN(NetsTest)
#include "nets_test.moc"
