#include <QClipboard>
#include <QColorDialog>
#include <QComboBox>
#include <QGuiApplication>
#include <QHeaderView>
#include <QLineEdit>
#include <QScrollBar>
#include <QSpinBox>
#include <QtTest>

#include "tests/patience.h"
#include "tests/unit/ui/sample_document.h"
#include "ui/common/table_view.h"
#include "ui/layers/layers_panel.h"
#include "ui/messages/message_model.h"
#include "ui/messages/messages_feature.h"
#include "ui/statistics/statistics_model.h"
#include "ui/theme/theme.h"
#include "ui/workspace/actions.h"

using ui::LayerModel;

namespace {

QPoint middleOf(const QTableView& table, int row, int column) {
    return table.visualRect(table.model()->index(row, column)).center();
}

/// Where the panel shows a layer, or the heading of a group.
QPoint middleOf(ui::LayersPanel& panel, int layer, int column) {
    return middleOf(panel.table(), panel.rows().reveal(model::LayerId{std::size_t(layer)}), column);
}
int headingOf(ui::LayersPanel& panel, model::LayerGroup group) {
    for (int row = 0; row < panel.rows().rowCount(); ++row) {
        if (panel.rows().isHeading(row) && panel.rows().groupAt(row) == group) {
            return row;
        }
    }
    return -1;
}

}  // namespace

class PanelsTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_actions.reset();  // before its owner, which would delete it too
        m_owner = std::make_unique<QWidget>();
        m_actions = std::make_unique<ui::ActionSet>(*m_owner);
        m_layers.setDocument(sampleDocument(), std::vector<ui::LayerAppearance>(4));
        m_statistics.setDocument(sampleDocument());
        m_messages.setMessages(sampleDocument(), {});
    }

    void clickOnACheckMarkHidesTheLayer() {
        ui::LayersPanel panel(m_layers, *m_actions);
        show(panel);
        const QPoint box = middleOf(panel, 1, LayerModel::Visible);
        QTest::mouseClick(panel.table().viewport(), Qt::LeftButton, {}, box);
        QVERIFY(!m_layers.effectiveStyles()[1].isVisible);
        QTest::mouseClick(panel.table().viewport(), Qt::LeftButton, {}, box);
        QVERIFY(m_layers.effectiveStyles()[1].isVisible);
        QTest::mouseClick(panel.table().viewport(), Qt::LeftButton, {}, middleOf(panel, 2, LayerModel::Solo));
        QCOMPARE(m_layers.soloLayer().row(), std::size_t{2});
    }

    void spaceTurnsAllSelectedLayersTheSameWay() {
        ui::LayersPanel panel(m_layers, *m_actions);
        show(panel);
        m_layers.setData(m_layers.index(1, LayerModel::Visible), Qt::Unchecked, Qt::CheckStateRole);
        panel.table().selectAll();
        QTest::keyClick(&panel.table(), Qt::Key_Space);
        for (const auto& look : m_layers.effectiveStyles()) {
            QVERIFY(!look.isVisible);
        }
        QTest::keyClick(&panel.table(), Qt::Key_Space);
        for (const auto& look : m_layers.effectiveStyles()) {
            QVERIFY(look.isVisible);
        }
    }

    void opacityIsDraggedInItsCell() {
        ui::LayersPanel panel(m_layers, *m_actions);
        show(panel);
        QTableView& table = panel.table();
        const QRect cell = table.visualRect(panel.rows().mapFromSource(m_layers.index(0, LayerModel::Opacity)));
        QTest::mousePress(table.viewport(), Qt::LeftButton, {}, cell.center());
        const int middle = m_layers.effectiveStyles()[0].opacityPercent;
        QVERIFY2(middle > 40 && middle < 60, qPrintable(QString::number(middle)));
        QMouseEvent move(QEvent::MouseMove, QPointF(cell.right() - 2, cell.center().y()),
                         table.viewport()->mapToGlobal(QPointF(cell.right() - 2, cell.center().y())), Qt::NoButton,
                         Qt::LeftButton, Qt::NoModifier);
        QCoreApplication::sendEvent(table.viewport(), &move);
        QCOMPARE(m_layers.effectiveStyles()[0].opacityPercent, 100);
        QTest::mouseRelease(table.viewport(), Qt::LeftButton, {}, cell.center());
    }

    void dragThatSelectsRowsChangesNoOpacity() {
        ui::LayersPanel panel(m_layers, *m_actions);
        show(panel);
        QTableView& table = panel.table();
        QTest::mousePress(table.viewport(), Qt::LeftButton, {}, middleOf(panel, 0, LayerModel::Name));
        const QPointF there = middleOf(panel, 1, LayerModel::Opacity);
        QMouseEvent move(QEvent::MouseMove, there, table.viewport()->mapToGlobal(there), Qt::NoButton, Qt::LeftButton,
                         Qt::NoModifier);
        QCoreApplication::sendEvent(table.viewport(), &move);
        QTest::mouseRelease(table.viewport(), Qt::LeftButton, {}, there.toPoint());
        QCOMPARE(m_layers.effectiveStyles()[1].opacityPercent, 100);
        QCOMPARE(table.selectionModel()->selectedRows().size(), 2);
    }

    void opacityIsTypedAfterEnter() {
        ui::LayersPanel panel(m_layers, *m_actions);
        show(panel);
        panel.table().setCurrentIndex(panel.rows().mapFromSource(m_layers.index(1, LayerModel::Opacity)));
        QTest::keyClick(&panel.table(), Qt::Key_Return);
        auto* box = panel.findChild<QSpinBox*>();
        QVERIFY(box != nullptr);
        box->selectAll();
        QTest::keyClicks(box, "35");
        QTest::keyClick(box, Qt::Key_Return);
        QTRY_COMPARE(m_layers.effectiveStyles()[1].opacityPercent, 35);
    }

    void colourDialogShowsItsChoiceAtOnceAndTakesItBackOnCancel() {
        ui::LayersPanel panel(m_layers, *m_actions);
        show(panel);
        const QColor before = m_layers.effectiveStyles()[0].colour;
        QTest::mouseClick(panel.table().viewport(), Qt::LeftButton, {}, middleOf(panel, 0, LayerModel::Colour));
        QPointer<QColorDialog> dialog = panel.findChild<QColorDialog*>();
        QVERIFY(dialog != nullptr);
        dialog->setCurrentColor(Qt::cyan);
        QCOMPARE(m_layers.effectiveStyles()[0].colour, QColor(Qt::cyan));
        dialog->reject();
        QCOMPARE(m_layers.effectiveStyles()[0].colour, before);
        QTRY_VERIFY(dialog.isNull());
    }

    void colourDialogOutlivesItsBoard() {
        ui::LayersPanel panel(m_layers, *m_actions);
        show(panel);
        QTest::mouseClick(panel.table().viewport(), Qt::LeftButton, {}, middleOf(panel, 3, LayerModel::Colour));
        auto* dialog = panel.findChild<QColorDialog*>();
        QVERIFY(dialog != nullptr);
        m_layers.setDocument(nullptr, {});
        dialog->setCurrentColor(Qt::cyan);
        dialog->reject();
    }

    void groupsFoldAndTheirMarkIsOfAllTheirLayers() {
        ui::LayersPanel panel(m_layers, *m_actions);
        show(panel);
        ui::GroupedLayers& rows = panel.rows();
        QCOMPARE(rows.rowCount(), 5);  // copper with two layers, and what is folded: the outline, notes
        QVERIFY(!rows.isFolded(model::LayerGroup::Copper) && rows.isFolded(model::LayerGroup::Other));
        const int other = headingOf(panel, model::LayerGroup::Other);
        const auto click = [&](int row, int column) {
            QTest::mouseClick(panel.table().viewport(), Qt::LeftButton, {}, ::middleOf(panel.table(), row, column));
        };
        click(other, LayerModel::Name);
        QCOMPARE(rows.rowCount(), 6);
        QTest::keyClick(&panel.table(), Qt::Key_Return);
        QCOMPARE(rows.rowCount(), 5);
        const QModelIndex mark = rows.index(headingOf(panel, model::LayerGroup::Copper), LayerModel::Visible);
        m_layers.setData(m_layers.index(0, LayerModel::Visible), Qt::Unchecked, Qt::CheckStateRole);
        QCOMPARE(mark.data(Qt::CheckStateRole).toInt(), int(Qt::PartiallyChecked));
        click(mark.row(), LayerModel::Visible);
        QVERIFY(m_layers.visibility()[0] && m_layers.visibility()[1]);
        click(mark.row(), LayerModel::Visible);
        QVERIFY(!m_layers.visibility()[0] && !m_layers.visibility()[1]);
    }

    void clickIntoABoxLeavesTheCurrentLayer() {
        ui::LayersPanel panel(m_layers, *m_actions);
        show(panel);
        panel.select(model::LayerId{std::size_t{0}});
        QTest::mouseClick(panel.table().viewport(), Qt::LeftButton, {}, middleOf(panel, 1, LayerModel::Visible));
        QCOMPARE(panel.currentLayer(), model::LayerId{std::size_t{0}});
    }

    /// As + is typed on many keyboards.
    void steppingWithShiftHeldSelectsOneLayer() {
        ui::LayersPanel panel(m_layers, *m_actions);
        show(panel);
        panel.select(model::LayerId{std::size_t{0}});
        QTest::keyPress(&panel, Qt::Key_Shift, Qt::ShiftModifier);
        panel.step(1);
        QTest::keyRelease(&panel, Qt::Key_Shift);
        QCOMPARE(panel.table().selectionModel()->selectedRows().size(), 1);
        QCOMPARE(panel.currentLayer(), model::LayerId{std::size_t{1}});
    }

    void namesComeBeforeTypesAndNoHeadingIsCut() {
        ui::LayersPanel panel(m_layers, *m_actions);
        for (const int width : {230, 270, 600}) {
            show(panel);
            panel.resize(width, 300);
            const QTableView& table = panel.table();
            QTRY_COMPARE(table.isColumnHidden(LayerModel::Type), width < 600);
            for (int column = 0; column < m_layers.columnCount(); ++column) {
                const QString heading = m_layers.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
                const int needed = table.fontMetrics().horizontalAdvance(heading);
                const bool isCut = !table.isColumnHidden(column) && table.columnWidth(column) < needed;
                QVERIFY2(!isCut, qPrintable(QString("%1 at %2").arg(heading).arg(width)));
            }
            QCOMPARE(table.horizontalScrollBar()->maximum(), 0);
        }
    }

    void headingClickSortsStatisticsAndKeepsTheSumLast() {
        ui::TableView table(m_statistics);
        table.makeSortable();
        show(table);
        QAbstractItemModel& shown = *table.model();
        QCOMPARE(shown.index(0, 0).data().toString(), "top");  // the board's own order at first
        QHeaderView& header = *table.horizontalHeader();
        const int x = header.sectionViewportPosition(ui::StatisticsModel::Circle) + 5;
        QTest::mouseClick(header.viewport(), Qt::LeftButton, {}, QPoint(x, header.height() / 2));
        QTest::mouseClick(header.viewport(), Qt::LeftButton, {}, QPoint(x, header.height() / 2));
        QCOMPARE(shown.index(0, 0).data().toString(), "bottom");
        QCOMPARE(shown.index(shown.rowCount() - 1, 0).data().toString(), "All layers");
    }

    void rowsAreCopiedAsShown() {
        ui::TableView table(m_statistics);
        table.makeSortable();
        show(table);
        table.selectRow(1);
        QTest::keyClick(&table, Qt::Key_C, Qt::ControlModifier);
        QCOMPARE(QGuiApplication::clipboard()->text(), "bottom\t0\t0\t2\t0\t0\t2\t2\t\n");
        table.copyAll();
        QVERIFY(QGuiApplication::clipboard()->text().startsWith("Layer\tLine\t"));
    }

    void messagesAreFilteredByWordsAndSeverity() {
        const std::unique_ptr<QWidget> panel(ui::makeMessagesPanel(m_messages, [](const model::Diagnostic&) {}));
        show(*panel);
        const QAbstractItemModel& shown = *panel->findChild<ui::TableView*>()->model();
        QCOMPARE(shown.rowCount(), 3);
        QTest::keyClicks(panel->findChild<QLineEdit*>(), "features");
        QCOMPARE(shown.rowCount(), 2);
        panel->findChild<QComboBox*>()->setCurrentIndex(2);
        QCOMPARE(shown.rowCount(), 1);
        QCOMPARE(shown.index(0, ui::MessageModel::Text).data().toString(), "Symbol is defined nowhere");
        panel->findChild<QLineEdit*>()->clear();
        panel->findChild<QComboBox*>()->setCurrentIndex(0);
        QCOMPARE(shown.rowCount(), 3);
    }

    void everyCellIsReadableInBothThemes() {
        for (const ui::Theme theme : {ui::Theme::Dark, ui::Theme::Light}) {
            ui::applyTheme(theme);
            const QPalette palette = QGuiApplication::palette();
            for (const auto& [text, ground] :
                 {std::pair(QPalette::Text, QPalette::Base), std::pair(QPalette::Text, QPalette::AlternateBase),
                  std::pair(QPalette::WindowText, QPalette::Window), std::pair(QPalette::ButtonText, QPalette::Button),
                  std::pair(QPalette::HighlightedText, QPalette::Highlight), std::pair(QPalette::Link, QPalette::Base),
                  std::pair(QPalette::Link, QPalette::AlternateBase)}) {
                const double contrast = contrastOf(palette.color(text), palette.color(ground));
                QVERIFY2(contrast >= 4.5, qPrintable(QString::number(contrast)));  // WCAG 2 AA for text
            }
        }
        ui::applyTheme(ui::Theme::System);
    }

private:
    static void show(QWidget& panel) {
        panel.resize(600, 300);
        panel.show();
        QVERIFY(QTest::qWaitForWindowExposed(&panel));
        panel.activateWindow();
    }

    /// WCAG 2 contrast ratio, 1 to 21.
    static double contrastOf(const QColor& a, const QColor& b) {
        const auto luminance = [](const QColor& colour) {
            const auto linear = [](double c) { return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4); };
            return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) + 0.0722 * linear(colour.blueF());
        };
        const auto [low, high] = std::minmax({luminance(a), luminance(b)});
        return (high + 0.05) / (low + 0.05);
    }

    std::unique_ptr<QWidget> m_owner;
    std::unique_ptr<ui::ActionSet> m_actions;
    LayerModel m_layers;
    ui::StatisticsModel m_statistics;
    ui::MessageModel m_messages;
};

QTEST_MAIN(PanelsTest)
#include "panels_test.moc"
