#include <QScreen>
#include <QtTest>

#include "ui/clearance/rule_dialog.h"
#include "ui/common/first_size.h"
#include "ui/shell/form_chooser.h"
#include "ui/shell/guide_window.h"

/// Windows that know how large they want to be, on a screen that has less.
class SmallScreenTest : public QObject {
    Q_OBJECT

private slots:
    void theScreenIsSmall() { QCOMPARE(QGuiApplication::primaryScreen()->size(), QSize(800, 600)); }

    void dialogsLeaveTheirButtonsOnTheScreen() {
        fits(ui::RuleDialog(model::defaultRules(), {}, ui::LengthUnit::Millimetre));
        fits(ui::GuideWindow(QStringLiteral("nowhere"), nullptr));
        fits(ui::FormChooser("folder", {model::BoardForm{&model::knownFormats().front(), "folder"}}));
    }

private:
    static void fits(QDialog&& dialog) {
        dialog.show();
        const QSize room = ui::roomForWindow(dialog.screen()->availableSize());
        QVERIFY2(dialog.width() <= room.width() && dialog.height() <= room.height(),
                 qPrintable(
                     QStringLiteral("%1: %2 x %3").arg(dialog.windowTitle()).arg(dialog.width()).arg(dialog.height())));
    }
};

QTEST_MAIN(SmallScreenTest)

#include "small_screen_test.moc"
