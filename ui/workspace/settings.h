#pragma once

#include <QByteArray>
#include <QSettings>
#include <QString>
#include <QStringList>

#include "render/scene/layer_style.h"
#include "render/scene/view_settings.h"
#include "ui/common/lengths.h"
#include "ui/workspace/actions.h"

namespace ui {

enum class Theme { System, Dark, Light };
/// Which of the two views are shown: 2D, 3D, or both.
enum class Arrangement { SideBySide, Stacked, Flat, Solid };

/// What is kept between runs: window place, panels, theme, back end, recent boards. Stored where the system keeps
/// settings, or in one file for tests.
class Settings {
public:
    Settings();
    explicit Settings(const QString& iniFile);

    [[nodiscard]] QByteArray windowGeometry() const;
    [[nodiscard]] QByteArray windowState() const;
    void setWindow(const QByteArray& geometry, const QByteArray& state);

    [[nodiscard]] Theme theme() const;
    void setTheme(Theme theme);
    [[nodiscard]] render::Backend backend() const;
    void setBackend(render::Backend backend);

    [[nodiscard]] Arrangement arrangement() const;
    void setArrangement(Arrangement arrangement);

    [[nodiscard]] LengthUnit unit() const;
    void setUnit(LengthUnit unit);

    [[nodiscard]] render::Palette palette() const;
    void setPalette(render::Palette palette);
    [[nodiscard]] KeyPreset keys() const;
    void setKeys(KeyPreset keys);

    /// Paths, newest first.
    [[nodiscard]] QStringList recentBoards() const;
    void setRecentBoards(const QStringList& paths);
    /// Where the last dialog was, or the home folder.
    [[nodiscard]] QString lastFolder() const;
    void setLastFolder(const QString& folder);

    /// Forgets everything.
    void reset();

private:
    QSettings m_store;
};

}  // namespace ui
