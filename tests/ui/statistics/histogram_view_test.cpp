// Bars of a histogram and rows of the drill table select their elements, with the mouse and with keys; the line above
// them sums the board up.

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

    /// A part of a number is another.
    void numbersOverNarrowBarsAreWholeOrNotThere() {
        ui::HistogramView narrow;
        narrow.setMinimumSize(1, 1);
        narrow.setDocument(window().workspace().board()->document);
        narrow.setMeasure(model::Measure::HoleDiameter);
        const auto& bars = narrow.histogram().bars;
        const int line = narrow.fontMetrics().height();
        for (const int column : {line / 2, line + 1, 100}) {
            narrow.resize(column * static_cast<int>(bars.size()) + 12, 200);
            for (std::size_t bar = 0; bar < bars.size(); ++bar) {
                const int needed =
                    narrow.fontMetrics().horizontalAdvance(QLocale().toString(qulonglong{bars[bar].count}));
                const QRectF at = narrow.countRect(bar);
                QCOMPARE(at.isEmpty(), column < line);
                QVERIFY2(!at.isEmpty() || !hasText(narrow, bar), "a number that has no room");
                QVERIFY(at.isEmpty() || (column < 100 ? at.height() : at.width()) >= needed);
                const QRectF room = narrow.columnRect(bar).adjusted(-0.1, -0.1, 0.1, 0.1);  // of rounding
                QVERIFY(at.isEmpty() || room.contains(at));
            }
        }
    }

    void aLineSumsTheBoardUp() {
        const auto summary = [this] { return window().label("boardSummary"); };
        QVERIFY2(summary().startsWith("Board 50.8 mm × 50.8 mm · 1.57"), qPrintable(summary()));
        const model::Document& board = *window().document();
        QVERIFY2(summary().contains(
                     QString(" · %1 nets · %2 components · ").arg(board.nets.size()).arg(board.components.size())),
                 qPrintable(summary()));
        m_fixture->key(Qt::Key_Q);
        QVERIFY2(summary().startsWith("Board 2000 mil × 2000 mil · "), qPrintable(summary()));
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
    /// Is something written over the bar, where the unit is not?
    static bool hasText(ui::HistogramView& plot, std::size_t bar) {
        const QRectF column = plot.columnRect(bar);
        if (column.right() > plot.width() - plot.fontMetrics().horizontalAdvance(" mm ")) {
            return false;
        }
        const QImage picture = plot.grab().toImage();
        const QColor text = plot.palette().color(QPalette::Text);
        const double scale = picture.devicePixelRatio();
        for (int y = 0; y < int(column.bottom() * scale); ++y) {
            for (int x = int(column.left() * scale); x < int(column.right() * scale); ++x) {
                const QColor pixel = picture.pixelColor(x, y);
                if (std::abs(pixel.lightness() - text.lightness()) < 30) {
                    return true;
                }
            }
        }
        return false;
    }

    TestWindow& window() { return m_fixture->window(); }
    ui::HistogramView& plot() { return window().find<ui::HistogramView>(); }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(HistogramViewTest)
#include "histogram_view_test.moc"
