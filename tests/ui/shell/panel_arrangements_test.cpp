// Which panels are shown for what, and that they leave the views the larger part of the window.

#include "ui/shell/panel_arrangements.h"

#include <QDockWidget>
#include <QHeaderView>
#include <QToolBar>
#include <QtTest>

#include "tests/locations.h"
#include "tests/patience.h"
#include "tests/ui/window_fixture.h"

using ui::ActionId;

namespace {

constexpr double kViewShare = 0.65;
constexpr ActionId kUses[] = {ActionId::UseGeneral, ActionId::UseStackup, ActionId::UseNets, ActionId::UseClearance};

}  // namespace

class PanelArrangementsTest : public QObject {
    Q_OBJECT

private slots:
    void init() { m_fixture = std::make_unique<WindowFixture>(); }
    void cleanup() { m_fixture.reset(); }

    void viewsTakeMostOfTheWindow_data() {
        QTest::addColumn<QSize>("size");
        QTest::newRow("1280x800") << QSize(1280, 800);
        QTest::newRow("1920x1080") << QSize(1920, 1080);
    }

    void viewsTakeMostOfTheWindow() {
        QFETCH(const QSize, size);
        QVERIFY(m_fixture->openAndWait(locations::kSample));
        window().resize(size);
        for (const ActionId use : kUses) {
            window().actions()[use].trigger();
            const QByteArray what = window().actions()[use].text().toUtf8();
            QTRY_COMPARE(window().size(), size);
            QTRY_VERIFY2(viewShare() >= kViewShare, what + ": " + QByteArray::number(viewShare()) + narrowest());
        }
    }

    void everyUseHasItsPanelsInFront() {
        QVERIFY(isInFront("layers") && isInFront("element"));
        window().actions()[ActionId::UseStackup].trigger();
        QTRY_VERIFY(isInFront("stackup") && !isInFront("element"));
        window().actions()[ActionId::UseNets].trigger();
        QTRY_VERIFY(isInFront("nets") && isInFront("element"));
        window().actions()[ActionId::UseClearance].trigger();
        QTRY_VERIFY(isInFront("clearances") && !isInFront("nets"));
        QVERIFY(window().actions()[ActionId::UseClearance].isChecked());
        QVERIFY(!window().actions()[ActionId::UseNets].isChecked());
    }

    /// Whatever the use, each opens by its command, and closes by it.
    void everyPanelIsFoundInEveryUse() {
        for (const ActionId use : kUses) {
            window().actions()[use].trigger();
            for (int id = int(ActionId::ShowLayersDock); id < int(ActionId::ShowToolBar); ++id) {
                QAction& panel = window().actions()[ActionId(id)];
                if (!panel.isChecked()) {
                    panel.trigger();
                }
                QTRY_VERIFY2(panel.isChecked(), panel.text().toUtf8());
            }
        }
    }

    void panelsAtTheBottomShowMoreThanAFewRows() {
        window().resize(1280, 800);
        QVERIFY(m_fixture->openAndWait(locations::kSample));
        window().actions()[ActionId::ShowMessagesDock].trigger();
        QTRY_VERIFY(isInFront("messages"));
        const ui::TableView& table = window().table("messages");
        QTRY_VERIFY(table.viewport()->height() >= 6 * table.verticalHeader()->defaultSectionSize());
    }

    void aUseIsShownAgainAsItWasLeft() {
        window().actions()[ActionId::UseNets].trigger();
        window().actions()[ActionId::ShowMessagesDock].trigger();
        window().actions()[ActionId::UseStackup].trigger();
        QTRY_VERIFY(!isInFront("messages"));
        window().actions()[ActionId::UseNets].trigger();
        QTRY_VERIFY(isInFront("messages"));

        m_fixture->restart();  // and in the next run
        QVERIFY(window().actions()[ActionId::UseNets].isChecked());
        QTRY_VERIFY(isInFront("messages") && isInFront("nets"));
        window().actions()[ActionId::RestorePanels].trigger();
        QTRY_VERIFY(!isInFront("messages") && isInFront("nets"));
        window().resetSettings();
        QTRY_VERIFY(isInFront("layers"));
        QVERIFY(window().actions()[ActionId::UseGeneral].isChecked());
    }

    void theToolBarIsNoMatterOfTheUse() {
        window().actions()[ActionId::ShowToolBar].trigger();
        window().actions()[ActionId::UseNets].trigger();
        QVERIFY(window().findChild<QToolBar*>("toolbar")->isHidden());
        window().actions()[ActionId::ShowToolBar].trigger();
        window().actions()[ActionId::UseGeneral].trigger();
        QVERIFY(!window().findChild<QToolBar*>("toolbar")->isHidden());
    }

private:
    TestWindow& window() { return m_fixture->window(); }

    bool isInFront(const char* dock) {
        const QDockWidget& panel = *window().findChild<QDockWidget*>(dock);
        return panel.isVisible() && !panel.visibleRegion().isEmpty();
    }

    double viewShare() {
        const QSize views = window().views().size();
        return double(views.width()) * views.height() / (double(window().width()) * window().height());
    }

    /// What keeps the panels wide.
    QByteArray narrowest() {
        QByteArray all;
        for (const QDockWidget* dock : window().findChildren<QDockWidget*>()) {
            all += '\n' + dock->objectName().toUtf8() + (dock->isVisible() ? " shown " : " ") +
                   QByteArray::number(dock->width()) + ", at least " +
                   QByteArray::number(dock->minimumSizeHint().width());
        }
        return all;
    }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(PanelArrangementsTest)
#include "panel_arrangements_test.moc"
