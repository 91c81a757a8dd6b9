// Bars of a histogram and rows of the drill table select their elements, with the mouse and with keys.

#include "ui/statistics/histogram_view.h"

#include <QComboBox>
#include <QTabWidget>
#include <QtTest>

#include "tests/locations.h"
#include "tests/ui/window_fixture.h"
#include "ui/common/table_view.h"
#include "ui/statistics/drill_model.h"

class HistogramViewTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_fixture = std::make_unique<WindowFixture>();
        window().showPanel("statistics");
        QVERIFY(m_fixture->openAndWait(locations::kSample));
    }
    void cleanup() { m_fixture.reset(); }

    void aClickOnABarSelectsItsElements() {
        QVERIFY(plot().histogram().bars.size() > 1);
        for (std::size_t bar = 0; bar < plot().histogram().bars.size(); ++bar) {
            QTest::mouseClick(&plot(), Qt::LeftButton, {}, plot().columnRect(bar).center().toPoint());
            const model::HistogramBar& values = plot().histogram().bars[bar];
            QCOMPARE(window().selection().selected().size(), std::size_t{values.elements.count});
            for (const model::BoardElement& at : window().selection().selected()) {
                QVERIFY(window().document()->layer(window().document()->elements.layer[at.element.row()]).isCopper());
            }
        }
    }

    void arrowsWalkAlongTheBars() {
        QTest::keyClick(&plot(), Qt::Key_Right);
        QTest::keyClick(&plot(), Qt::Key_Right);
        QCOMPARE(window().selection().selected().size(), std::size_t{plot().histogram().bars[1].elements.count});
        QTest::keyClick(&plot(), Qt::Key_Left);
        QTest::keyClick(&plot(), Qt::Key_Left);
        QCOMPARE(window().selection().selected().size(), std::size_t{plot().histogram().bars[0].elements.count});
    }

    /// "0.…" under every bar says nothing.
    void numbersUnderNarrowBarsAreWholeOrNotThere() {
        ui::HistogramView narrow;
        narrow.setDocument(window().workspace().board()->document);
        for (const int width : {150, 250, 400, 4000}) {
            narrow.resize(width, 120);
            double end = 0.0;
            for (std::size_t bar = 0; bar < narrow.histogram().bars.size(); ++bar) {
                const QString label = narrow.labelUnder(bar);
                QVERIFY2(!label.contains(QChar(0x2026)), qPrintable(label));
                if (!label.isEmpty()) {
                    QVERIFY(narrow.columnRect(bar).left() >= end);
                    end = narrow.columnRect(bar).left() + narrow.fontMetrics().horizontalAdvance(label);
                    QVERIFY(end <= narrow.width());
                }
            }
            QVERIFY2(!narrow.labelUnder(0).isEmpty(), "the axis begins with a number");
            QVERIFY(width < 4000 || !narrow.labelUnder(1).isEmpty());
        }
    }

    void anotherMeasureIsChosen() {
        const std::size_t tracks = plot().histogram().elements.size();
        window().panel("statistics").findChild<QComboBox*>()->setCurrentIndex(1);
        QVERIFY(plot().histogram().elements.size() != tracks);
        QTest::keyClick(&plot(), Qt::Key_Right);
        QVERIFY(!window().selection().selected().empty());
        for (const model::BoardElement& at : window().selection().selected()) {
            QVERIFY((window().document()->elements.flags[at.element.row()] & model::kHole) != 0);
        }
    }

    void aClickInTheDrillTableSelectsTheHolesOfTheRow() {
        auto& tabs = *window().panel("statistics").findChild<QTabWidget*>();
        tabs.setCurrentIndex(1);
        auto& table = static_cast<ui::TableView&>(*tabs.currentWidget());
        table.sortByColumn(ui::DrillModel::Diameter, Qt::DescendingOrder);  // rows are not the board's
        QVERIFY(table.model()->rowCount() > 1);
        std::size_t all = 0;
        for (int row = 0; row < table.model()->rowCount(); ++row) {
            const auto cell = [&](int column) { return table.model()->index(row, column); };
            table.scrollTo(cell(ui::DrillModel::Layer));
            QTest::mouseClick(table.viewport(), Qt::LeftButton, {}, table.visualRect(cell(0)).center());
            const auto& selected = window().selection().selected();
            QCOMPARE(selected.size(), std::size_t{cell(ui::DrillModel::Holes).data(Qt::EditRole).toUInt()});
            for (const model::BoardElement& at : selected) {
                const model::Box box = window().document()->boxOf(at.element);
                QVERIFY((window().document()->elements.flags[at.element.row()] & model::kHole) != 0);
                const double diameter = cell(ui::DrillModel::Diameter).data(Qt::EditRole).toDouble();
                QVERIFY(base::toMm(static_cast<double>(box.width())) > diameter - 2e-6);  // boxes are of whole nm
            }
            all += selected.size();
        }
        table.selectAll();
        QTest::keyClick(&table, Qt::Key_Return);
        QCOMPARE(window().selection().selected().size(), all);
    }

private:
    TestWindow& window() { return m_fixture->window(); }
    ui::HistogramView& plot() { return window().find<ui::HistogramView>(); }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(HistogramViewTest)
#include "histogram_view_test.moc"
