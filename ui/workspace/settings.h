#pragma once

#include <QByteArray>
#include <QDir>
#include <QString>
#include <QStringList>
#include <QVariant>
#include <algorithm>

#include "render/scene/layer_style.h"
#include "render/scene/view_settings.h"
#include "ui/common/display_units.h"
#include "ui/workspace/actions.h"
#include "ui/workspace/settings_file.h"

namespace ui {

enum class Theme { System, Dark, Light };
/// Which of the two views are shown: 2D, 3D, or both.
enum class Arrangement { SideBySide, Stacked, Flat, Solid };
/// What the window is used for: each has panels of its own.
enum class Use { General, Stackup, Nets, Clearance };

/// What is kept between runs: window place, panels, theme, back end, what the views show, recent boards. Stored where
/// the system keeps settings, or in one file for tests.
class Settings {
public:
    Settings() = default;
    explicit Settings(const QString& iniFile) : m_store(iniFile) {}

    [[nodiscard]] QByteArray windowGeometry() const { return m_store.value("window/geometry").toByteArray(); }
    void setWindowGeometry(const QByteArray& geometry) { m_store.setValue("window/geometry", geometry); }
    /// Where the panels of a use are.
    [[nodiscard]] QByteArray windowState(Use use) const { return m_store.value(stateKey(use)).toByteArray(); }
    void setWindowState(Use use, const QByteArray& state) { m_store.setValue(stateKey(use), state); }

    /// What the user chose of Theme, Arrangement, Use, LengthUnit, KeyPreset, render::Backend or render::Palette; the
    /// first value where nothing was chosen, or by another version.
    template <class Value>
    [[nodiscard]] Value choice() const {
        return static_cast<Value>(indexIn(choicesOf(Value{})));
    }
    template <class Value>
    void choose(Value value) {
        const Choices choices = choicesOf(value);
        m_store.setValue(choices.key, choices.words[static_cast<qsizetype>(value)]);
    }

    /// A command that is on or off: which one it is, is kept under a word.
    struct Switch {
        ActionId id;
        const char* word;
    };
    static constexpr Switch kSwitches[] = {{ActionId::ShowGrid, "grid"},
                                           {ActionId::ShowNames, "net names"},
                                           {ActionId::ShowPinNames, "pin names"},
                                           {ActionId::ShowOutlines, "outlines"},
                                           {ActionId::ShowViewCube, "view cube"},
                                           {ActionId::DimOthers, "dim others"},
                                           {ActionId::FollowInSolid, "follow in 3d"},
                                           {ActionId::FollowInFlat, "follow in 2d"},
                                           {ActionId::FollowInTables, "follow in tables"},
                                           {ActionId::FollowFromTables, "follow tables"}};
    /// `other` where nothing was chosen.
    [[nodiscard]] bool isOn(const Switch& kept, bool other) const { return m_store.value(keyOf(kept), other).toBool(); }
    void setOn(const Switch& kept, bool isOn) { m_store.setValue(keyOf(kept), isOn); }

    /// How far what does not stand out is darkened, in percent; `other` where nothing was chosen.
    [[nodiscard]] int dimPercent(int other) const { return m_store.value("view/dim", other).toInt(); }
    void setDimPercent(int percent) { m_store.setValue("view/dim", percent); }
    /// How much of the room of both views the 2D view has: between 0 and 1, at first one half.
    [[nodiscard]] double flatShare() const {
        constexpr double kHalf = 0.5;
        const double share = m_store.value("view/2d share", kHalf).toDouble();
        return share > 0.0 && share < 1.0 ? share : kHalf;
    }
    void setFlatShare(double share) { m_store.setValue("view/2d share", share); }

    /// Paths, newest first.
    [[nodiscard]] QStringList recentBoards() const { return m_store.value("files/recent").toStringList(); }
    void setRecentBoards(const QStringList& paths) { m_store.setValue("files/recent", paths); }
    /// From where the last board was opened with a dialog; `other` before the first one. Apart from where files are
    /// written: what is exported of a board does not go beside one that was looked at before.
    [[nodiscard]] QString boardsFolder(const QString& other = QDir::homePath()) const {
        return m_store.value("files/boards", other).toString();
    }
    void setBoardsFolder(const QString& folder) { m_store.setValue("files/boards", folder); }
    /// Where the last file was written; `other` before the first one.
    [[nodiscard]] QString lastFolder(const QString& other = QDir::homePath()) const {
        return m_store.value("files/folder", other).toString();
    }
    void setLastFolder(const QString& folder) { m_store.setValue("files/folder", folder); }

    /// Whom waivers of design rules name.
    [[nodiscard]] QString author() const { return m_store.value("waivers/author").toString(); }
    void setAuthor(const QString& name) { m_store.setValue("waivers/author", name); }

    /// What was chosen in the export dialog, by the name it has there; `other` where nothing was.
    [[nodiscard]] QVariant exportChoice(const QString& name, const QVariant& other) const {
        return m_store.value("export/" + name, other);
    }
    void setExportChoice(const QString& name, const QVariant& value) { m_store.setValue("export/" + name, value); }

    /// Whether the user was told that no graphics card draws.
    [[nodiscard]] bool knowsOfSoftwareDevice() const { return m_store.value("window/knows software device").toBool(); }
    void setKnowsOfSoftwareDevice() { m_store.setValue("window/knows software device", true); }

    /// False: the system does not let them be written, so they end with the program.
    [[nodiscard]] bool areKept() const { return m_store.isWritable(); }
    /// Of their file, or what the system has instead of one.
    [[nodiscard]] QString path() const { return m_store.path(); }

    /// Forgets everything.
    void reset() { m_store.clear(); }

private:
    struct Choices {
        const char* key;
        QStringList words;  ///< of the values of the type, in order
    };
    static Choices choicesOf(Theme) { return {"view/theme", {"system", "dark", "light"}}; }
    static Choices choicesOf(Arrangement) { return {"view/arrangement", {"side by side", "stacked", "2d", "3d"}}; }
    static Choices choicesOf(Use) { return {"window/use", {"general", "stackup", "nets", "clearance"}}; }
    static Choices choicesOf(LengthUnit) { return {"view/unit", {"mm", "mil", "inch"}}; }
    static Choices choicesOf(render::Backend) {
        return {"view/backend", {"auto", "mesh", "pull", "impostor", "raster"}};
    }
    static Choices choicesOf(render::Palette) { return {"view/palette", {"standard", "colour-blind safe"}}; }
    static Choices choicesOf(KeyPreset) {
        return {"view/keys", {"copperscope", "kicad", "altium", "allegro", "klayout"}};
    }
    static QString keyOf(const Switch& kept) { return QStringLiteral("view/switches/") + QLatin1String(kept.word); }
    static QString stateKey(Use use) {
        return QStringLiteral("window/panels ") + choicesOf(use).words[static_cast<qsizetype>(use)];
    }
    [[nodiscard]] qsizetype indexIn(const Choices& choices) const {
        return std::max<qsizetype>(choices.words.indexOf(m_store.value(choices.key).toString()), 0);
    }

    SettingsFile m_store;
};

}  // namespace ui
