#include "ui/clearance/clearance_panel.h"

#include <QComboBox>
#include <QContextMenuEvent>
#include <QHelpEvent>
#include <QLineEdit>
#include <QMenu>
#include <QScrollBar>
#include <QSplitter>
#include <QTimer>
#include <QToolTip>
#include <QWheelEvent>
#include <QtTest>
#include <algorithm>
#include <utility>

#include "tests/ui/clearance/clearance_fixture.h"
#include "tests/ui/window_fixture.h"
#include "ui/clearance/notes_area.h"
#include "ui/clearance/rule_dialog.h"
#include "ui/common/elided_label.h"

using ui::ActionId;
using ui::ClearanceModel;
using ui::ClearancePanel;

/// What the panel says in its table and around it, in little room; the command that checks rules, and what these begin
/// with.
class ClearancePanelTest : public QObject, protected ClearanceFixture {
    Q_OBJECT

private slots:
    void initTestCase() { open(); }
    void cleanupTestCase() { QCOMPARE(validationErrorsOnClosing(m_fixture), 0U); }

    void rulesAreCheckedByTheirCommandWhereverTheUserIs() {
        box("what").setCurrentIndex(static_cast<int>(ClearancePanel::What::Smallest));
        dock().hide();
        m_fixture->key(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(panel().isVisible());
        QCOMPARE(panel().what(), ClearancePanel::What::Rules);
        QTRY_VERIFY(!window().workspace().isWorking());
        QVERIFY(window().find<ClearanceModel>().isOfRules());
        QVERIFY2(label("summary") != "No search yet", qPrintable(label("summary")));
    }

    void theVerdictIsWholeInANarrowPanel() {
        ui::RuleModel& rules = window().find<ui::RuleModel>();
        const model::RuleTable before = rules.rules();
        QVERIFY(rules.setData(rules.index(0, ui::RuleModel::Least), "5 mm", Qt::EditRole));
        m_fixture->key(Qt::Key_R, Qt::ControlModifier | Qt::ShiftModifier);
        QTRY_VERIFY(!window().workspace().isWorking());
        const auto& summary = *panel().findChild<ui::ElidedLabel*>("summary");
        const QString verdict = summary.text().section(';', 0, 0);
        QVERIFY2(verdict.startsWith("FAIL: ") && verdict.contains("break"), qPrintable(verdict));
        for (const int width : {280, 640}) {
            floatAt(width);
            QTRY_VERIFY2(summary.shown().startsWith(verdict), qPrintable(summary.shown()));
            QTRY_VERIFY(summary.height() >= summary.heightForWidth(summary.width()));
        }
        auto& table = *panel().findChild<ui::TableView*>("rules");
        const QRect row = table.visualRect(rules.index(0, ui::RuleModel::Title));
        QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, row.center());
        QVERIFY2(summary.text().contains("; shown: "), qPrintable(summary.text()));
        floatAt(280);
        QTRY_VERIFY2(summary.shown().startsWith(verdict), qPrintable(summary.shown()));
        table.clearSelection();
        rules.replaceRules(before);
        dock().setFloating(false);
    }

    /// As one reads it: what is broken, between what, by how much, where.
    void rulesNetsAndValuesAreInSightInANarrowPanel() {
        ui::RuleModel& rules = window().find<ui::RuleModel>();
        const model::RuleTable before = rules.rules();
        QVERIFY(rules.setData(rules.index(0, ui::RuleModel::Least), "0.2 mm", Qt::EditRole));
        checkRules();
        const ui::TableView& table = panel().table();
        constexpr ClearanceModel::Column kOrder[] = {ClearanceModel::Rule,     ClearanceModel::First,
                                                     ClearanceModel::Second,   ClearanceModel::Spacing,
                                                     ClearanceModel::Required, ClearanceModel::Layer};
        const auto left = [&](int column) { return table.columnViewportPosition(column); };
        for (std::size_t at = 1; at < std::size(kOrder); ++at) {
            QVERIFY(!table.isColumnHidden(kOrder[at - 1]) && left(kOrder[at - 1]) < left(kOrder[at]));
        }
        const auto& locations = window().find<ClearanceModel>();
        QCOMPARE(locations.index(0, ClearanceModel::Required).data().toString(), "0.2000 mm");
        floatAt(420);
        QTRY_VERIFY(left(ClearanceModel::Required) <= table.viewport()->width());
        const QModelIndex first = table.model()->index(0, ClearanceModel::First);
        panel().table().setColumnWidth(ClearanceModel::First, 40);
        QCOMPARE(tipAt(table, first), first.data().toString());  // whole, where it is cut
        QToolTip::hideText();
        rules.replaceRules(before);
        dock().setFloating(false);
        box("what").setCurrentIndex(static_cast<int>(ClearancePanel::What::Smallest));
        QVERIFY(table.isColumnHidden(ClearanceModel::Rule) && table.isColumnHidden(ClearanceModel::Required));
    }

    void theMenuOfARowShowsItAgain() {
        ui::RuleModel& rules = window().find<ui::RuleModel>();
        const model::RuleTable before = rules.rules();
        QVERIFY(rules.setData(rules.index(0, ui::RuleModel::Least), "0.2 mm", Qt::EditRole));
        checkRules();
        window().showPanel("clearances");
        panel().setCurrentRow(0);
        ui::BoardView& flat = window().views().flat();
        window().views().setActive(flat);
        window().actions()[ActionId::Fit].trigger();
        const float fitted = flat.controller().mmPerPixel();
        const QStringList entries = chooseInMenu("Show");
        QVERIFY2(entries.contains(QString::fromUtf8("Waive…")), qPrintable(entries.join(", ")));
        QTRY_VERIFY(flat.controller().mmPerPixel() < fitted / 2);
        rules.replaceRules(before);
    }

    void whatRulesBeginWithIsNamedAndCanBeTakenBack() {
        model::RuleTable own = model::defaultRules();
        own.rules.front().least += 1'000;
        ui::RuleDialog dialog(own, {}, ui::LengthUnit::Millimetre);
        auto& choice = *dialog.findChild<QComboBox*>("presets");
        QVERIFY(choice.isEnabled());
        QCOMPARE(choice.currentText(), "Rules as they are");
        QTest::keyClick(&choice, Qt::Key_Down);
        QCOMPARE(choice.currentText(), "Common boards");
        QVERIFY(dialog.rules().rules() == model::defaultRules());
        QTest::keyClick(&choice, Qt::Key_Up);
        QVERIFY(dialog.rules().rules() == own);
        const ui::RuleDialog ofPreset(model::defaultRules(), {}, ui::LengthUnit::Millimetre);
        QCOMPARE(ofPreset.findChild<QComboBox*>("presets")->currentText(), "Common boards");
    }

    /// Side by side in little room neither would show more than below each other.
    void tablesLieSideBySideWhereBothHaveRoom() {
        box("what").setCurrentIndex(static_cast<int>(ClearancePanel::What::Rules));
        const auto& tables = *qobject_cast<QSplitter*>(rules().parentWidget());
        for (const auto& [width, orientation] : {std::pair(320, Qt::Vertical), std::pair(640, Qt::Vertical),
                                                 std::pair(panel().fontMetrics().height() * 60, Qt::Horizontal)}) {
            floatAt(width);
            QTRY_COMPARE(tables.orientation(), orientation);
        }
        dock().setFloating(false);
    }

    void aRuleThatIsCutIsWholeInItsTip() {
        box("what").setCurrentIndex(static_cast<int>(ClearancePanel::What::Rules));
        floatAt(320);
        const QModelIndex title = rules().model()->index(0, ui::RuleModel::Title);
        const int before = rules().columnWidth(ui::RuleModel::Title);
        rules().setColumnWidth(ui::RuleModel::Title, 40);
        QCOMPARE(tipAt(rules(), title), title.data().toString());
        rules().setColumnWidth(ui::RuleModel::Title, 2'000);
        QTRY_VERIFY(tipAt(rules(), title) != title.data().toString());
        rules().setColumnWidth(ui::RuleModel::Title, before);
        QToolTip::hideText();
        dock().setFloating(false);
    }

    void theLabelOfTheToleranceIsWholeAtFirst() {
        ui::RuleDialog dialog(model::defaultRules(), {}, ui::LengthUnit::Millimetre);
        dialog.show();
        QVERIFY(QTest::qWaitForWindowExposed(&dialog));
        const auto* field = dialog.findChild<QLineEdit*>("tolerance");
        const auto labels = dialog.findChildren<QLabel*>();
        const auto label = std::ranges::find(labels, field, [](const QLabel* each) { return each->buddy(); });
        QVERIFY(label != labels.end());
        const QFontMetrics letters = (*label)->fontMetrics();
        const int text = letters.horizontalAdvance((*label)->text().remove('&'));
        QVERIFY2((*label)->width() >= text + letters.averageCharWidth() / 2, "a letter more than fits tightly");
    }

    void manyNotesTakeThreeLinesAndScroll() {
        floatAt(500);
        auto& notes = window().find<ui::NotesArea>();
        const int line = notes.fontMetrics().lineSpacing();
        QStringList ties;
        for (int pin = 1; pin <= 12; ++pin) {
            ties += QStringLiteral("net tie: U30 ties unconnected-(U30-NC-Pad%1)").arg(pin);
        }
        panel().setNotes(ties.join('\n'));
        QTRY_VERIFY(notes.isVisible() && notes.height() >= 2 * line);
        QVERIFY2(notes.height() <= 3 * line, qPrintable(QString::number(notes.height())));
        QTRY_VERIFY(notes.verticalScrollBar()->isVisible());
        const QPointF at = notes.viewport()->rect().center();
        QWheelEvent wheel(at, notes.viewport()->mapToGlobal(at), {}, {0, -120}, Qt::NoButton, {}, Qt::NoScrollPhase,
                          false);
        QCoreApplication::sendEvent(notes.viewport(), &wheel);
        QVERIFY(notes.verticalScrollBar()->value() > 0);
        panel().setNotes(ties.front());
        QTRY_VERIFY(notes.height() < 2 * line);
        QTRY_VERIFY(!notes.verticalScrollBar()->isVisible());
        panel().setNotes({});
        QVERIFY(!notes.isVisible());
        dock().setFloating(false);
    }

private:
    /// What a pointer that rests on a cell is shown.
    static QString tipAt(const ui::TableView& table, const QModelIndex& cell) {
        const QPoint at = table.visualRect(cell).topLeft() + QPoint(5, 5);
        QHelpEvent event(QEvent::ToolTip, at, table.viewport()->mapToGlobal(at));
        QCoreApplication::sendEvent(table.viewport(), &event);
        return QToolTip::text();
    }

    ui::TableView& rules() { return *panel().findChild<ui::TableView*>("rules"); }
    QDockWidget& dock() { return *window().findChild<QDockWidget*>("clearances"); }
    void checkRules() {
        window().actions()[ActionId::CheckRules].trigger();
        QTRY_VERIFY(!window().workspace().isWorking());
        QVERIFY(window().find<ClearanceModel>().rowCount() > 0);
    }
    /// An entry of the menu of the current row; all that the menu has.
    QStringList chooseInMenu(const QString& text) {
        QStringList entries;
        QTimer::singleShot(0, this, [&] {
            auto* open = qobject_cast<QMenu*>(QApplication::activePopupWidget());
            for (QAction* action : open != nullptr ? open->actions() : QList<QAction*>()) {
                entries += action->text();
                if (action->text() == text) {
                    action->trigger();
                }
            }
            if (open != nullptr) {
                open->close();
            }
        });
        ui::TableView& table = panel().table();
        const QPoint cell = table.visualRect(table.currentIndex()).center();
        QContextMenuEvent event(QContextMenuEvent::Mouse, cell, table.viewport()->mapToGlobal(cell));
        QApplication::sendEvent(table.viewport(), &event);
        return entries;
    }
    void floatAt(int width) {
        dock().show();
        dock().setFloating(true);
        dock().resize(width, 500);
        QTRY_VERIFY(std::abs(panel().width() - width) < 20);
    }
};

QTEST_MAIN(ClearancePanelTest)
#include "clearance_panel_test.moc"
