#include "ui/actions.h"

#include <QMenu>
#include <QWidget>
#include <QtTest>
#include <set>

#include "ui/help_dialogs.h"
#include "ui/icons.h"

using ui::ActionId;
using ui::ActionSpec;

class ActionsTest : public QObject {
    Q_OBJECT

private slots:
    void tableIsInTheOrderOfTheIds() {
        for (std::size_t row = 0; row < ui::kActionCount; ++row) {
            QCOMPARE(static_cast<std::size_t>(ui::actionSpecs()[row].id), row);
        }
    }

    void everyCommandHasTextTipAndAMnemonicOfItsOwnInItsMenu() {
        std::set<std::pair<ui::MenuId, QChar>> taken;
        for (const ActionSpec& spec : ui::actionSpecs()) {
            const QString text = QString::fromUtf8(spec.text);
            const auto at = text.indexOf('&');
            QVERIFY2(at >= 0 && at + 1 < text.size(), spec.text);
            QVERIFY2(taken.emplace(spec.menu, text[at + 1].toLower()).second, spec.text);
            QVERIFY2(QString::fromUtf8(spec.tip).size() > 10, spec.text);
        }
    }

    void shortcutsAreValidAndNoTwoCommandsShareOne() {
        std::set<QString> taken;
        for (const ActionSpec& spec : ui::actionSpecs()) {
            for (const QKeySequence& key : ui::shortcutsOf(spec)) {
                QVERIFY2(!key.isEmpty() && key[0].key() != Qt::Key_unknown, spec.text);
                QVERIFY2(taken.insert(key.toString()).second, spec.text);
            }
        }
    }

    void menusHoldTheTable() {
        QWidget window;
        const ui::ActionSet actions(window);
        std::size_t filled = 0;
        for (std::size_t menu = 0; menu < ui::kMenuCount; ++menu) {
            QMenu shown;
            actions.fill(shown, static_cast<ui::MenuId>(menu));
            for (const QAction* action : shown.actions()) {
                filled += action->isSeparator() ? 0 : 1;
            }
        }
        QCOMPARE(filled, ui::kActionCount);
    }

    void themesExcludeEachOther() {
        QWidget window;
        const ui::ActionSet actions(window);
        actions[ActionId::ThemeDark].trigger();
        actions[ActionId::ThemeLight].trigger();
        QVERIFY(!actions[ActionId::ThemeDark].isChecked());
        QVERIFY(actions[ActionId::ThemeLight].isChecked());
    }

    void adoptedActionTakesTextAndKeys() {
        QWidget window;
        ui::ActionSet actions(window);
        QAction own(&window);
        actions.adopt(ActionId::ShowLayersDock, own);
        QCOMPARE(&actions[ActionId::ShowLayersDock], &own);
        QCOMPARE(own.shortcut(), QKeySequence("Ctrl+1"));
    }

    void keysSheetListsEveryShortcut() {
        const QString sheet = ui::keysSheetText();
        for (const ActionSpec& spec : ui::actionSpecs()) {
            for (const QKeySequence& key : ui::shortcutsOf(spec)) {
                QVERIFY2(sheet.contains(key.toString(QKeySequence::NativeText).toHtmlEscaped()), spec.text);
            }
        }
    }

    void iconsAreDrawnInTheirSize() {
        const QIcon icon = ui::iconOf(ActionId::LookTop);
        const QImage image = icon.pixmap(32, 32).toImage();
        bool hasInk = false;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                hasInk = hasInk || image.pixelColor(x, y).alpha() > 200;
            }
        }
        QVERIFY(hasInk);
        QVERIFY(ui::iconOf(ActionId::About).isNull());
    }
};

QTEST_MAIN(ActionsTest)
#include "actions_test.moc"
