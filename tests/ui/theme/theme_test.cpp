#include "ui/theme/theme.h"

#include <QAction>
#include <QGuiApplication>
#include <QMainWindow>
#include <QPalette>
#include <QToolBar>
#include <QToolButton>
#include <QtTest>

class ThemeTest : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { ui::applyTheme(ui::Theme::System); }

    void theButtonForWhatAToolbarHasNoRoomForIsSeen_data() {
        QTest::addColumn<ui::Theme>("theme");
        QTest::newRow("dark") << ui::Theme::Dark;
        QTest::newRow("light") << ui::Theme::Light;
    }
    void theButtonForWhatAToolbarHasNoRoomForIsSeen() {
        QFETCH(ui::Theme, theme);
        ui::applyTheme(theme);
        QMainWindow window;
        QToolBar* bar = window.addToolBar("toolbar");
        for (int i = 0; i < 12; ++i) {
            bar->addAction("A command with a name");
        }
        window.resize(300, 200);
        window.show();
        QVERIFY(QTest::qWaitForWindowExposed(&window));
        auto* more = bar->findChild<QToolButton*>("qt_toolbar_ext_button");
        QVERIFY(more != nullptr && more->isVisible());
        const QImage drawn = more->grab().toImage();
        const int ground = qGray(QGuiApplication::palette().color(QPalette::Window).rgb());
        int most = 0;
        for (int y = drawn.height() / 4; y < 3 * drawn.height() / 4; ++y) {
            for (int x = 2; x < drawn.width() - 2; ++x) {
                most = std::max(most, std::abs(qGray(drawn.pixel(x, y)) - ground));
            }
        }
        QVERIFY2(most > 80, qPrintable(QString::number(most)));
    }
};

QTEST_MAIN(ThemeTest)
#include "theme_test.moc"
