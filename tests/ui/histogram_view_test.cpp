// Bars of a histogram select their elements, with the mouse and with keys.

#include <QComboBox>
#include <QDockWidget>
#include <QtTest>

#include "tests/places.h"
#include "tests/ui/window_fixture.h"
#include "ui/histogram_view.h"
#include "ui/statistics_panel.h"

class HistogramViewTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_fixture = std::make_unique<WindowFixture>();
        window().findChild<QDockWidget*>("statistics")->raise();
        QVERIFY(m_fixture->openAndWait(places::kSample));
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

    void anotherMeasureIsChosen() {
        const std::size_t tracks = plot().histogram().elements.size();
        window().statisticsPanel().measureBox().setCurrentIndex(1);
        QVERIFY(plot().histogram().elements.size() != tracks);
        QTest::keyClick(&plot(), Qt::Key_Right);
        QVERIFY(!window().selection().selected().empty());
        for (const model::BoardElement& at : window().selection().selected()) {
            QVERIFY((window().document()->elements.flags[at.element.row()] & model::kHole) != 0);
        }
    }

private:
    ui::MainWindow& window() { return m_fixture->window(); }
    ui::HistogramView& plot() { return window().statisticsPanel().plot(); }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(HistogramViewTest)
#include "histogram_view_test.moc"
