#include "ui/workspace/actions.h"

#include <QMenu>
#include <QWidget>
#include <QtTest>
#include <set>

#include "tests/locations.h"
#include "ui/shell/help_dialogs.h"
#include "ui/shell/icons.h"
#include "ui/workspace/key_presets.h"

using ui::ActionId;
using ui::ActionSpec;

namespace {

constexpr ui::KeyPreset kPresets[] = {ui::KeyPreset::Copperscope, ui::KeyPreset::KiCad, ui::KeyPreset::Altium,
                                      ui::KeyPreset::Allegro, ui::KeyPreset::KLayout};

}  // namespace

class ActionsTest : public QObject {
    Q_OBJECT

private slots:
    void tableIsInTheOrderOfTheIds() {
        for (std::size_t row = 0; row < ui::kActionCount; ++row) {
            QCOMPARE(static_cast<std::size_t>(ui::ActionSet::kSpecs[row].id), row);
        }
    }

    void everyCommandHasTextTipAndAMnemonicOfItsOwnInItsMenu() {
        std::set<std::pair<ui::MenuId, QChar>> taken;
        for (const ActionSpec& spec : ui::ActionSet::kSpecs) {
            const QString text = QString::fromUtf8(spec.text);
            const auto at = text.indexOf('&');
            QVERIFY2(at >= 0 && at + 1 < text.size(), spec.text);
            QVERIFY2(taken.emplace(spec.menu, text[at + 1].toLower()).second, spec.text);
            QVERIFY2(QString::fromUtf8(spec.tip).size() > 10, spec.text);
        }
    }

    void everyCommandHasAKeyInEveryPreset() {
        for (const ui::KeyPreset preset : kPresets) {
            for (const ActionSpec& spec : ui::ActionSet::kSpecs) {
                QVERIFY2(!ui::keysOf(spec, preset).isEmpty(), spec.text);
            }
        }
    }

    void everyKeyIsInTheDocumentOfKeys() {
        QFile file(QFileInfo(locations::kTestData).dir().filePath("../docs/keys.md"));
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QString document = QString::fromUtf8(file.readAll());
        for (const ActionSpec& spec : ui::ActionSet::kSpecs) {
            for (const QString& key : QString::fromUtf8(spec.shortcuts).split(' ', Qt::SkipEmptyParts)) {
                QVERIFY2(document.contains('`' + key + '`'), spec.text);
            }
        }
    }

    void noTwoCommandsOfAPresetShareAKeyOrBeginAlike() {
        for (const ui::KeyPreset preset : kPresets) {
            QList<QKeySequence> taken;
            for (const ActionSpec& spec : ui::ActionSet::kSpecs) {
                for (const QKeySequence& key : ui::keysOf(spec, preset)) {
                    for (const QKeySequence& other : taken) {
                        const QString both = key.toString() + " and " + other.toString() + " of " + spec.text;
                        QVERIFY2(key.matches(other) == QKeySequence::NoMatch, qPrintable(both));
                        QVERIFY2(other.matches(key) == QKeySequence::NoMatch, qPrintable(both));
                    }
                    taken += key;
                }
            }
        }
    }

    void keysCanBeTyped() {
        for (const ui::KeyPreset preset : kPresets) {
            for (const ActionSpec& spec : ui::ActionSet::kSpecs) {
                const QList<QKeySequence> keys = ui::keysOf(spec, preset);
                for (const QKeySequence& key : keys) {
                    for (int i = 0; i < key.count(); ++i) {
                        QVERIFY2(key[static_cast<uint>(i)].key() != Qt::Key_unknown, spec.text);
                    }
                }
                QVERIFY2(keys.front() != QKeySequence("`"), "many keyboards cannot type it: menus name another");
            }
        }
        QCOMPARE(ui::keysFrom("Ctrl+K,F1 ,").size(), 2);
        QCOMPARE(ui::keysFrom("Ctrl+K,F1 ,")[0].count(), 2);
        QCOMPARE(ui::keysFrom("Ctrl+K,F1 ,")[1].toString(), QString(","));
    }

    void presetsGiveTheKeysOfTheirPrograms() {
        QWidget window;
        ui::ActionSet actions(window);
        actions.setKeys(ui::KeyPreset::KLayout);
        QCOMPARE(actions[ActionId::Fit].shortcut(), QKeySequence("F2"));
        QVERIFY(actions[ActionId::Fit].toolTip().contains("F2"));
        actions.setKeys(ui::KeyPreset::KiCad);
        QVERIFY(actions[ActionId::HighlightNet].shortcuts().contains(QKeySequence(Qt::Key_QuoteLeft)));
        QCOMPARE(actions[ActionId::HighlightNet].shortcut(), QKeySequence("N"));
        actions.setKeys(ui::KeyPreset::Altium);
        QVERIFY(actions[ActionId::Flip].shortcuts().contains(QKeySequence("Ctrl+F")));
        QVERIFY(!actions[ActionId::Find].shortcuts().contains(QKeySequence("Ctrl+F")));
        actions.setKeys(ui::KeyPreset::Copperscope);
        QCOMPARE(actions[ActionId::Find].shortcut(), QKeySequence("Ctrl+F"));
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
        for (const ui::KeyPreset preset : kPresets) {
            const QString plane = ui::keyListText(preset);
            for (const ActionSpec& spec : ui::ActionSet::kSpecs) {
                for (const QKeySequence& key : ui::keysOf(spec, preset)) {
                    QVERIFY2(plane.contains(key.toString(QKeySequence::NativeText).toHtmlEscaped()), spec.text);
                }
            }
        }
        QVERIFY(ui::keyListText(ui::KeyPreset::KLayout).contains("Zoom into the box"));
        QVERIFY(!ui::keyListText(ui::KeyPreset::Copperscope).contains("Zoom into the box"));
    }

    void iconsAreDrawnInTheirSize() {
        const QIcon icon = ui::iconOf(ActionId::ViewTop);
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
