#include "ui/element/element_panel.h"

#include <QTableWidget>
#include <QtTest>

#include "tests/locations.h"
#include "tests/ui/window_fixture.h"
#include "ui/theme/theme.h"

class ElementPanelTest : public QObject {
    Q_OBJECT

private slots:
    void initTestCase() {
        m_fixture = std::make_unique<WindowFixture>();
        QVERIFY(m_fixture->openAndWait(locations::kSample));
    }
    void cleanupTestCase() {
        ui::applyTheme(ui::Theme::System);
        QCOMPARE(validationErrorsOnClosing(m_fixture), 0U);
    }

    /// What was listed before the theme is chosen, too.
    void linksHaveTheColourOfTheTheme() {
        window().elementPanel().show();
        window().selection().select({{0, model::ElementId{0}}});
        for (const ui::Theme theme : {ui::Theme::Dark, ui::Theme::Light, ui::Theme::Dark}) {
            ui::applyTheme(theme);
            QTRY_COMPARE(linkColour(), QGuiApplication::palette().color(QPalette::Link));
        }
    }

private:
    TestWindow& window() { return m_fixture->window(); }

    QColor linkColour() {
        const QTableWidget& table = *window().elementPanel().findChild<QTableWidget*>();
        for (int row = 0; row < table.rowCount(); ++row) {
            if (table.item(row, 0)->text() == QLatin1String("Layer")) {
                return table.item(row, 1)->foreground().color();
            }
        }
        return {};
    }

    std::unique_ptr<WindowFixture> m_fixture;
};

QTEST_MAIN(ElementPanelTest)
#include "element_panel_test.moc"
