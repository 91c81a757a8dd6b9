#include "ui/workspace/settings.h"

#include <QFile>
#include <QMenu>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

#include "ui/shell/recent_boards.h"

using ui::RecentBoards;
using ui::Settings;

class SettingsTest : public QObject {
    Q_OBJECT

private slots:
    void init() {
        m_folder = std::make_unique<QTemporaryDir>();
        QVERIFY(m_folder->isValid());
    }

    void valuesSurviveTheProgram() {
        {
            Settings settings(iniFile());
            settings.choose(ui::Theme::Dark);
            settings.choose(render::Backend::Pull);
            settings.choose(ui::Arrangement::Stacked);
            settings.choose(ui::KeyPreset::Allegro);
            settings.setWindowGeometry("geometry");
            settings.setWindowState(ui::Use::Nets, "state");
            settings.choose(ui::Use::Clearance);
            settings.setLastFolder("/boards");
            settings.setOn(Settings::kSwitches[0], false);
            settings.setDimPercent(30);
            settings.setFlatShare(0.25);
        }
        const Settings settings(iniFile());
        QCOMPARE(settings.choice<ui::Theme>(), ui::Theme::Dark);
        QCOMPARE(settings.choice<render::Backend>(), render::Backend::Pull);
        QCOMPARE(settings.choice<ui::Arrangement>(), ui::Arrangement::Stacked);
        QCOMPARE(settings.choice<ui::KeyPreset>(), ui::KeyPreset::Allegro);
        QCOMPARE(settings.windowGeometry(), QByteArray("geometry"));
        QCOMPARE(settings.windowState(ui::Use::Nets), QByteArray("state"));
        QVERIFY(settings.windowState(ui::Use::General).isEmpty());
        QCOMPARE(settings.choice<ui::Use>(), ui::Use::Clearance);
        QCOMPARE(settings.lastFolder(), "/boards");
        QVERIFY(!settings.isOn(Settings::kSwitches[0], true));
        QVERIFY(settings.isOn(Settings::kSwitches[1], true) && !settings.isOn(Settings::kSwitches[1], false));
        QCOMPARE(settings.dimPercent(70), 30);
        QCOMPARE(settings.flatShare(), 0.25);
    }

    void whatCannotBeWrittenIsKeptForThisRunAlone() {
        QVERIFY(Settings(iniFile()).areKept());
        Settings settings(QStringLiteral("/dev/null/folder/settings.ini"));
        QVERIFY(!settings.areKept());
        QCOMPARE(settings.path(), "/dev/null/folder/settings.ini");
        settings.choose(ui::Theme::Dark);
        QCOMPARE(settings.choice<ui::Theme>(), ui::Theme::Dark);
    }

    void unknownWordsFallBackToTheDefault() {
        {
            QSettings store(iniFile(), QSettings::IniFormat);
            store.setValue("view/theme", "sepia");
            store.setValue("view/backend", 7);
            store.setValue("view/2d share", "nan");
        }
        const Settings settings(iniFile());
        QCOMPARE(settings.choice<ui::Theme>(), ui::Theme::System);
        QCOMPARE(settings.choice<render::Backend>(), render::Backend::Auto);
        QCOMPARE(settings.flatShare(), 0.5);
    }

    void resetForgetsEverything() {
        Settings settings(iniFile());
        settings.choose(ui::Theme::Light);
        settings.setRecentBoards({"/a"});
        settings.reset();
        QCOMPARE(settings.choice<ui::Theme>(), ui::Theme::System);
        QVERIFY(settings.recentBoards().isEmpty());
    }

    void recentBoardsAreNewestFirstWithoutDoubles() {
        Settings settings(iniFile());
        QMenu menu;
        RecentBoards recent(settings, menu);
        recent.add("/boards/a.tgz");
        recent.add("/boards/b.tgz");
        recent.add("/boards/a.tgz");
        QCOMPARE(settings.recentBoards(), QStringList({"/boards/a.tgz", "/boards/b.tgz"}));
        for (int i = 0; i < 20; ++i) {
            recent.add(QStringLiteral("/boards/%1.tgz").arg(i));
        }
        QCOMPARE(settings.recentBoards().size(), RecentBoards::kMost);
        QCOMPARE(settings.recentBoards().first(), "/boards/19.tgz");
    }

    void menuGreysWhatIsMissingAndOpensWhatIsThere() {
        Settings settings(iniFile());
        QMenu menu;
        RecentBoards recent(settings, menu);
        const QString there = m_folder->filePath("R&D board.tgz");
        QVERIFY(QFile(there).open(QIODevice::WriteOnly));
        recent.add(there);
        recent.add(m_folder->filePath("gone.tgz"));
        emit menu.aboutToShow();
        QCOMPARE(menu.actions().size(), 4);  // two boards, a separator, Clear
        QVERIFY(!menu.actions()[0]->isEnabled());
        QVERIFY(menu.actions()[1]->isEnabled());
        QVERIFY2(menu.actions()[1]->text().contains("R&&D"), qPrintable(menu.actions()[1]->text()));
        QSignalSpy chosen(&recent, &RecentBoards::chosen);
        menu.actions()[1]->trigger();
        QCOMPARE(chosen.value(0).value(0).toString(), there);
    }

    void clearEmptiesTheMenu() {
        Settings settings(iniFile());
        QMenu menu;
        RecentBoards recent(settings, menu);
        recent.add("/boards/a.tgz");
        emit menu.aboutToShow();
        menu.actions().last()->trigger();
        emit menu.aboutToShow();
        QCOMPARE(menu.actions().size(), 2);
        QVERIFY(!menu.actions().last()->isEnabled());
    }

private:
    [[nodiscard]] QString iniFile() const { return m_folder->filePath("settings.ini"); }

    std::unique_ptr<QTemporaryDir> m_folder;
};

QTEST_MAIN(SettingsTest)
#include "settings_test.moc"
