// What users choose once: settings keep it from run to run.

#include <QStatusBar>
#include <utility>

#include "ui/element/element_panel.h"
#include "ui/nets/nets_panel.h"
#include "ui/search/search_box.h"
#include "ui/shell/keyboard.h"
#include "ui/shell/main_window.h"
#include "ui/shell/theme.h"
#include "ui/statistics/histogram_view.h"
#include "ui/statistics/statistics_panel.h"
#include "ui/views/layer_styles.h"

namespace ui {

namespace {

constexpr std::pair<ActionId, Theme> kThemes[] = {
    {ActionId::ThemeSystem, Theme::System}, {ActionId::ThemeDark, Theme::Dark}, {ActionId::ThemeLight, Theme::Light}};
constexpr std::pair<ActionId, render::Backend> kBackends[] = {{ActionId::BackendAuto, render::Backend::Auto},
                                                              {ActionId::BackendMesh, render::Backend::Mesh},
                                                              {ActionId::BackendPull, render::Backend::Pull},
                                                              {ActionId::BackendImpostor, render::Backend::Impostor},
                                                              {ActionId::BackendRaster, render::Backend::Raster}};
constexpr std::pair<ActionId, Arrangement> kArrangements[] = {{ActionId::ShowFlat, Arrangement::Flat},
                                                              {ActionId::ShowSolid, Arrangement::Solid},
                                                              {ActionId::ShowSideBySide, Arrangement::SideBySide},
                                                              {ActionId::ShowStacked, Arrangement::Stacked}};

}  // namespace

void MainWindow::connectChoices() {
    for (const auto& [id, arrangement] : kArrangements) {
        connect(&m_actions[id], &QAction::triggered, this,
                [this, arrangement = arrangement] { setArrangement(arrangement); });
    }
    for (const auto& [id, theme] : kThemes) {
        connect(&m_actions[id], &QAction::triggered, this, [this, theme = theme] { setTheme(theme); });
    }
    for (const auto& [id, backend] : kBackends) {
        connect(&m_actions[id], &QAction::triggered, this, [this, backend = backend] { setBackend(backend); });
    }
    connect(&m_actions[ActionId::SafeColours], &QAction::triggered, this,
            [this](bool isOn) { setPalette(isOn ? render::Palette::ColourBlindSafe : render::Palette::Standard); });
}

void MainWindow::restoreSettings() {
    m_defaultState = saveState();
    restoreGeometry(m_settings.windowGeometry());
    restoreState(m_settings.windowState());
    setTheme(m_settings.theme());
    setBackend(m_settings.backend());
    setArrangement(m_settings.arrangement());
    setUnit(m_settings.unit());
    m_keyboard->setPreset(m_settings.keys());
    setPalette(m_settings.palette());
    statusBar()->clearMessage();
    m_actions[ActionId::BackendMesh].setEnabled(m_context.device().caps().hasMeshShader);
    m_actions[ActionId::BackendRaster].setEnabled(m_context.device().caps().hasAtomic64);
}

void MainWindow::resetSettings() {
    m_settings.reset();
    restoreState(m_defaultState);
    setTheme(Theme::System);
    setBackend(render::Backend::Auto);
    setArrangement(Arrangement::SideBySide);
    setUnit(LengthUnit::Millimetre);
    m_keyboard->setPreset(KeyPreset::Copperscope);
    setPalette(render::Palette::Standard);
}

void MainWindow::setTheme(Theme theme) {
    for (const auto& [id, value] : kThemes) {
        m_actions[id].setChecked(value == theme);
    }
    m_settings.setTheme(theme);
    applyTheme(theme);
}

void MainWindow::setBackend(render::Backend backend) {
    for (const auto& [id, value] : kBackends) {
        m_actions[id].setChecked(value == backend);
    }
    m_settings.setBackend(backend);
    m_views->setBackend(backend);
}

void MainWindow::setArrangement(Arrangement arrangement) {
    for (const auto& [id, value] : kArrangements) {
        m_actions[id].setChecked(value == arrangement);
    }
    m_settings.setArrangement(arrangement);
    m_views->setArrangement(arrangement);
}

void MainWindow::setPalette(render::Palette palette) {
    m_actions[ActionId::SafeColours].setChecked(palette == render::Palette::ColourBlindSafe);
    m_settings.setPalette(palette);
    m_views->setPalette(palette);
    if (m_board) {
        m_layerModel.setDefaults(defaultAppearances(*m_board->document, palette));
    }
}

void MainWindow::setUnit(LengthUnit unit) {
    m_unit = unit;
    m_settings.setUnit(unit);
    m_probing->setUnit(unit);
    m_planPainter->setUnit(unit);
    m_elementPanel->setUnit(unit);
    m_netsPanel->setUnit(unit);
    m_netCheckModel.setUnit(unit);
    m_clearances->setUnit(unit);
    m_sections->setUnit(unit);
    m_statisticsPanel->plot().setUnit(unit);
    m_statisticsModel.setUnit(unit);
    m_drillModel.setUnit(unit);
    m_searchBox->setUnit(unit);
    m_positionReadout->setUnit(unit);
    m_measuring->setUnit(unit);
    statusBar()->showMessage(QStringLiteral("Lengths are in %1").arg(QLatin1String(unitName(unit))));
}

}  // namespace ui
