#include "ui/clearance/clearance_panel.h"

#include <QScrollBar>
#include <QWheelEvent>
#include <QtTest>

#include "tests/ui/clearance/clearance_fixture.h"
#include "tests/ui/window_fixture.h"
#include "ui/clearance/notes_area.h"
#include "ui/common/elided_label.h"

using ui::ClearanceModel;
using ui::ClearancePanel;

/// What the panel says around its tables, in little room; and the command that checks rules.
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
    QDockWidget& dock() { return *window().findChild<QDockWidget*>("clearances"); }
    void floatAt(int width) {
        dock().show();
        dock().setFloating(true);
        dock().resize(width, 500);
        QTRY_VERIFY(std::abs(panel().width() - width) < 20);
    }
};

QTEST_MAIN(ClearancePanelTest)
#include "clearance_panel_test.moc"
