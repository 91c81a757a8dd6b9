#pragma once

#include <QByteArray>
#include <QSettings>
#include <QString>
#include <QStringList>

#include "render/layer_style.h"
#include "render/view_settings.h"
#include "ui/actions.h"
#include "ui/models/lengths.h"

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

    [[nodiscard]] models::LengthUnit unit() const;
    void setUnit(models::LengthUnit unit);

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
