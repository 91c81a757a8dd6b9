#include "ui/clearance/rule_waivers.h"

#include <QContextMenuEvent>
#include <QDialogButtonBox>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QPushButton>
#include <QTimer>
#include <QToolButton>
#include <QtTest>
#include <algorithm>

#include "tests/locations.h"
#include "tests/patience.h"
#include "tests/ui/clearance/clearance_fixture.h"
#include "tests/ui/window_fixture.h"
#include "ui/clearance/system_user.h"
#include "ui/clearance/waive_dialog.h"
#include "ui/common/table_view.h"

using ui::ActionId;
using ui::ClearanceModel;
using ui::ClearancePanel;

/// Findings are waived with the mouse and the keys, and stay so in the next run.
class RuleWaiversTest : public QObject, protected ClearanceFixture {
    Q_OBJECT

private slots:
    void initTestCase() {
        open();
        checkRules();
    }
    void cleanupTestCase() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void aWaivedRowStaysWaivedInTheNextRun() {
        ui::RuleModel& rules = window().find<ui::RuleModel>();
        QVERIFY(rules.setData(rules.index(0, ui::RuleModel::Least), "0.2 mm", Qt::EditRole));
        check();
        const int before = failing();
        QVERIFY(before > 1);
        const ClearanceModel::Location worst = locations().location(0);
        const ClearanceModel::Location second = locations().location(1);
        chooseInMenu(0, "waive");
        auto* dialog = window().findChild<ui::WaiveDialog*>();
        QVERIFY(dialog != nullptr && dialog->isVisible());
        auto* ok = dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok);
        QVERIFY(!ok->isEnabled());  // no reason yet
        const QString spacing = at(0, ClearanceModel::Spacing);
        QVERIFY2(dialog->findChild<QLabel*>("location")->text().contains(spacing), "it says what the list says");
        QTest::keyClicks(dialog->findChild<QLineEdit*>("reason"), "looked at");
        auto* author = dialog->findChild<QLineEdit*>("author");
        QCOMPARE(author->text(), ui::systemUserName());  // before anyone has waived anything
        author->selectAll();
        QTest::keyClicks(author, "Me");
        QTest::mouseClick(ok, Qt::LeftButton);
        QTRY_VERIFY(!window().workspace().isWorking());
        QCOMPARE(waivedRows(), 1);
        const int row = locations().rowOf(worst);
        QVERIFY(row >= failing() && locations().location(row).waiver);
        QCOMPARE(panel().currentRow(), locations().rowOf(second));  // the list stays where it was
        QVERIFY(at(row, ClearanceModel::Waived).startsWith("looked at (Me, 20"));
        QVERIFY2(summary().contains("1 waived"), qPrintable(summary()));
        QVERIFY(rules.index(0, ui::RuleModel::Result).data().toString().endsWith("1 waived"));

        m_fixture->restart();
        QVERIFY(m_fixture->openAndWait(m_board));
        checkRules();
        QCOMPARE(window().find<ui::RuleModel>().rules().rules[0].least, model::Nm{200'000});
        QCOMPARE(waivedRows(), 1);
        QCOMPARE(m_fixture->settings().author(), "Me");
    }

    void waivedRowsAreHiddenByASwitch() {
        QAction* show = menu().actions().front();
        const int all = panel().table().model()->rowCount();
        show->trigger();
        QCOMPARE(panel().table().model()->rowCount(), all - 1);
        show->trigger();
        QCOMPARE(panel().table().model()->rowCount(), all);
    }

    void withdrawnWaiversCountAgainAndUndoTakesThatBack() {
        const int row = locations().rowCount() - 1;
        QVERIFY(locations().location(row).waiver);
        chooseInMenu(row, "withdraw");
        QTRY_VERIFY(!window().workspace().isWorking());
        QCOMPARE(waivedRows(), 0);
        window().actions()[ActionId::Undo].trigger();
        QTRY_VERIFY(!window().workspace().isWorking());
        QCOMPARE(waivedRows(), 1);
    }

    /// The rows on the screen are those of the last check until the next one ends.
    void oneIsWithdrawnWhileTheCheckAfterAnotherRuns() {
        auto& waivers = window().find<ui::RuleWaivers>();
        model::Waiver other = locations().waiverFor(0);
        other.reason = "looked at as well";
        other.author = "Me";
        other.date = "2026-11-23";
        waivers.add({other});
        QTRY_VERIFY(!window().workspace().isWorking());
        QCOMPARE(waivers.list().size(), std::size_t{2});
        const int first = rowOfWaiver(0);
        const int second = rowOfWaiver(1);
        QVERIFY(first >= 0 && second >= 0);
        emit panel().withdrawalAsked({first});
        QCOMPARE(waivers.list(), std::vector{other});
        emit panel().withdrawalAsked({first});  // again, which is no step of the history
        emit panel().withdrawalAsked({second});
        QVERIFY(waivers.list().empty());
        QTRY_VERIFY(!window().workspace().isWorking());
        QCOMPARE(waivedRows(), 0);
        for (int step = 0; step < 3; ++step) {
            window().actions()[ActionId::Undo].trigger();
            QTRY_VERIFY(!window().workspace().isWorking());
        }
        QCOMPARE(waivers.list().size(), std::size_t{1});
        QCOMPARE(waivedRows(), 1);
    }

    void severalLocationsAreWaivedAtOnceAndTheNextOneIsCurrent() {
        ui::RuleModel& rules = window().find<ui::RuleModel>();
        QVERIFY(rules.setData(rules.index(0, ui::RuleModel::Least), "0.5 mm", Qt::EditRole));
        check();
        QVERIFY(failing() > 3);
        const std::vector<ClearanceModel::Location> chosen{locations().location(0), locations().location(1),
                                                           locations().location(2)};
        selectFirst(3);
        QCOMPARE(panel().currentRow(), 2);  // which the views show
        QCOMPARE(command("waive").text(), QString::fromUtf8("Waive 3 locations…"));
        QVERIFY(!command("withdraw").isEnabled());
        command("waive").trigger();
        auto* dialog = window().findChild<ui::WaiveDialog*>();
        QVERIFY(dialog != nullptr && dialog->isVisible());
        QVERIFY(dialog->findChild<QLabel*>("location")->text().startsWith("3 locations, the first: "));
        QTest::keyClicks(dialog->findChild<QLineEdit*>("reason"), "looked at together");
        QTest::mouseClick(dialog->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Ok), Qt::LeftButton);
        QTRY_VERIFY(!window().workspace().isWorking());
        for (const ClearanceModel::Location& each : chosen) {
            const int row = locations().rowOf(each);
            QVERIFY(locations().location(row).waiver);
            QVERIFY(at(row, ClearanceModel::Waived).startsWith("looked at together (Me, 20"));
        }
        QCOMPARE(panel().currentRow(), 0);
    }

    /// Of those that are selected only waived ones can be withdrawn, and only others waived.
    void allWaiversAreWithdrawnAtOnceAndEachStepIsUndone() {
        const int waived = waivedRows();
        panel().table().setFocus();
        QTest::keyClick(&panel().table(), Qt::Key_A, Qt::ControlModifier);
        QCOMPARE(command("withdraw").text(), QStringLiteral("Withdraw %L1 waivers").arg(waived));
        QCOMPARE(command("waive").text(), QString::fromUtf8("Waive %L1 locations…").arg(failing()));
        command("withdraw").trigger();
        QTRY_VERIFY(!window().workspace().isWorking());
        QCOMPARE(waivedRows(), 0);
        undo();
        QCOMPARE(waivedRows(), waived);
        undo();
        QCOMPARE(window().find<ui::RuleWaivers>().list().size(), std::size_t{1});
        undo();  // the rule
        check();
        QCOMPARE(waivedRows(), 1);
        panel().setCurrentRow(0);
        QCOMPARE(command("waive").text(), QString::fromUtf8("Waive…"));
    }

    void theFirstAuthorIsTheUserOfTheSystem() {
        QCOMPARE(ui::userNameOf("Jane Doe,Room 12,,", "jane"), "Jane Doe");
        QCOMPARE(ui::userNameOf("& Doe", "jane"), "Jane Doe");
        QCOMPARE(ui::userNameOf(",,,", "jane"), "jane");
    }

    void waiversAreFilesToo() {
        auto& waivers = window().find<ui::RuleWaivers>();
        const QString path = m_fixture->folder() + "/waivers.json";
        emit panel().waiversSaved();
        window().nameFile(path);
        QCOMPARE(model::readWaivers(path.toStdString())->size(), std::size_t{1});
        waivers.withdraw({waivers.list().front()});
        QTRY_VERIFY(!window().workspace().isWorking());
        QVERIFY(waivers.read(path));
        QTRY_VERIFY(!window().workspace().isWorking());
        QCOMPARE(waivedRows(), 1);
        QVERIFY(!waivers.read(m_board));
        QCOMPARE(waivers.list().size(), std::size_t{1});
    }

    void aNarrowPanelHasThemInTheMenuOfWhatHasNoRoom() {
        m_fixture->key(Qt::Key_F12, Qt::ControlModifier);  // the panel is a column beside the views
        box("what").setCurrentIndex(static_cast<int>(ClearancePanel::What::Rules));
        QTRY_VERIFY(panel().isVisible());
        auto* more = panel().findChild<QToolButton*>("qt_toolbar_ext_button");
        auto* waivers = panel().findChild<QToolButton*>("waivers");
        if (waivers->isVisible()) {
            QSKIP("on this screen the button has room");
        }
        QTRY_VERIFY(more->isVisible());
        QMenu* open = nullptr;
        QStringList entries;
        QTimer::singleShot(0, this, [&] {
            open = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            for (const QAction* action : open != nullptr ? open->actions() : QList<QAction*>()) {
                entries += action->text();
                if (action->text() == "Waivers" && action->menu() != nullptr) {
                    entries += action->menu()->actions().back()->text();
                }
            }
            if (open != nullptr) {
                open->close();
            }
        });
        QTest::mouseClick(more, Qt::LeftButton);
        QTRY_VERIFY(open != nullptr);
        QVERIFY2(entries.contains("Withdraw waivers without a &finding"), qPrintable(entries.join(", ")));
    }

    void waiversWithoutAFindingAreSaidAndWithdrawn() {
        ui::RuleModel& rules = window().find<ui::RuleModel>();
        const QString least = rules.index(0, ui::RuleModel::Least).data().toString();
        QVERIFY(rules.setData(rules.index(0, ui::RuleModel::Least), "1 um", Qt::EditRole));
        check();
        const QString notes = label("notes");
        QVERIFY2(notes.contains("no finding there any more"), qPrintable(notes));
        menu().actions().back()->trigger();
        QTRY_VERIFY(!window().workspace().isWorking());
        QVERIFY(window().find<ui::RuleWaivers>().list().empty());
        QVERIFY(!label("notes").contains("any more"));
    }

private:
    [[nodiscard]] ClearanceModel& locations() { return window().find<ClearanceModel>(); }
    [[nodiscard]] QMenu& menu() { return *panel().findChild<QToolButton*>("waivers")->defaultAction()->menu<QMenu*>(); }
    [[nodiscard]] QString summary() { return label("summary"); }
    [[nodiscard]] QString at(int row, int column) { return locations().index(row, column).data().toString(); }

    [[nodiscard]] int waivedRows() {
        int count = 0;
        for (int row = 0; row < locations().rowCount(); ++row) {
            count += locations().location(row).waiver ? 1 : 0;
        }
        return count;
    }
    [[nodiscard]] int rowOfWaiver(std::size_t waiver) {
        int row = locations().rowCount() - 1;
        while (row >= 0 && locations().location(row).waiver != waiver) {
            --row;
        }
        return row;
    }
    [[nodiscard]] int failing() { return locations().rowCount() - waivedRows(); }

    void checkRules() {
        box("what").setCurrentIndex(static_cast<int>(ClearancePanel::What::Rules));
        check();
    }
    void check() {
        window().actions()[ActionId::SearchClearances].trigger();
        QTRY_VERIFY(!window().workspace().isWorking());
    }
    void undo() {
        window().actions()[ActionId::Undo].trigger();
        QTRY_VERIFY(!window().workspace().isWorking());
    }
    /// With the keys.
    void selectFirst(int count) {
        window().showPanel("clearances");
        panel().setCurrentRow(0);
        panel().table().setFocus();
        for (int row = 1; row < count; ++row) {
            QTest::keyClick(&panel().table(), Qt::Key_Down, Qt::ShiftModifier);
        }
    }
    /// An entry of the menu of rows.
    [[nodiscard]] QAction& command(const QString& name) {
        const QList<QAction*> actions = panel().table().actions();
        return **std::ranges::find(actions, name, &QAction::objectName);
    }
    /// A right click on a row, and the entry of the menu.
    void chooseInMenu(int row, const char* name) {
        window().showPanel("clearances");
        panel().setCurrentRow(row);
        ui::TableView& table = panel().table();
        const QPoint cell = table.visualRect(table.currentIndex()).center();
        QTimer::singleShot(0, this, [name] {
            auto* open = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            QVERIFY(open != nullptr);
            for (QAction* action : open->actions()) {
                if (action->objectName() == QLatin1String(name) && action->isEnabled()) {
                    open->setActiveAction(action);
                    QTest::keyClick(open, Qt::Key_Return);
                    return;
                }
            }
            open->close();
            QFAIL(name);
        });
        QContextMenuEvent event(QContextMenuEvent::Mouse, cell, table.viewport()->mapToGlobal(cell));
        QApplication::sendEvent(table.viewport(), &event);
    }
};

QTEST_MAIN(RuleWaiversTest)
#include "rule_waivers_test.moc"
