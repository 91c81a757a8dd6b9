// What the commands of the window do.

#include <QClipboard>
#include <QDockWidget>
#include <QFileInfo>
#include <QGuiApplication>
#include <QStatusBar>
#include <algorithm>
#include <utility>

#include "model/export/stackup_export.h"
#include "ui/common/paths.h"
#include "ui/element/element_panel.h"
#include "ui/layers/layers_panel.h"
#include "ui/nets/net_check_panel.h"
#include "ui/nets/net_commands.h"
#include "ui/nets/nets_panel.h"
#include "ui/saved_views/saved_views_panel.h"
#include "ui/search/search_box.h"
#include "ui/shell/dialogs.h"
#include "ui/shell/help_dialogs.h"
#include "ui/shell/keyboard.h"
#include "ui/shell/main_window.h"
#include "ui/shell/message_bar.h"
#include "ui/shell/status_line.h"
#include "ui/stackup/stackup_panel.h"
#include "ui/stackup/stackup_view.h"
#include "ui/statistics/histogram_view.h"
#include "ui/statistics/statistics_panel.h"
#include "ui/views/view_cube.h"

namespace ui {

namespace {

/// How far a key moves the cut, as a part of the board's larger side.
constexpr double kCutStep = 0.02;
/// How many times as thick layers are drawn when they are to be seen.
constexpr float kThickCopper = 10.0F;
constexpr float kThickDielectric = 5.0F;

constexpr int kLargeWidth = 3840;  ///< proposed for pictures of any size

}  // namespace

template <class Slot>
void MainWindow::on(ActionId id, Slot slot) {
    connect(&m_actions[id], &QAction::triggered, this, slot);
}

void MainWindow::connectCommands() {
    connectFileActions();
    connectEditActions();
    connectViewActions();
    connectChoices();
    connectSavedViews();
    connectSolidActions();
    connectLayerActions();
    connectBoardActions();
    connectClearances();
    connectSections();
    connectStackupActions();
    connectSelectActions();
    connectFollowActions();
    connectPlanActions();
    connectMeasuring();
    connectHelpActions();
}

void MainWindow::connectFileActions() {
    on(ActionId::OpenFile, [this] { requestBoardToOpen(BoardForm::File); });
    on(ActionId::OpenFolder, [this] { requestBoardToOpen(BoardForm::Folder); });
    on(ActionId::Reload, [this] { m_loader.open(m_thicknesses.request()); });
    on(ActionId::CancelLoading, &MainWindow::cancelWork);
    on(ActionId::SavePicture, [this] {
        requestPicturePath(*this, m_settings.lastFolder(), [this](const QString& path) { savePicture(path); });
    });
    on(ActionId::SaveLargePicture, [this] {
        const int most = static_cast<int>(m_context.device().caps().maxImageSize);
        requestWidth(*this, std::min(kLargeWidth, most), most, [this](int width) {
            requestPicturePath(*this, m_settings.lastFolder(),
                               [this, width](const QString& path) { savePicture(path, width); });
        });
    });
    on(ActionId::CopyPicture, &MainWindow::copyPicture);
    on(ActionId::Quit, &QWidget::close);
}

void MainWindow::connectEditActions() {
    m_searchBox = new SearchBox(m_actions, *this);
    on(ActionId::Find, [this] { m_searchBox->open({}); });
    on(ActionId::Commands, [this] { m_searchBox->open(QStringLiteral(">")); });
    connect(m_searchBox, &SearchBox::chosen, this, qOverload<const Found&>(&MainWindow::goTo));
    QUndoStack& history = m_thicknesses.history();
    on(ActionId::Undo, [&history] { history.undo(); });
    on(ActionId::Redo, [&history] { history.redo(); });
    connect(&history, &QUndoStack::canUndoChanged, &m_actions[ActionId::Undo], &QAction::setEnabled);
    connect(&history, &QUndoStack::canRedoChanged, &m_actions[ActionId::Redo], &QAction::setEnabled);
    m_actions[ActionId::Undo].setEnabled(false);
    m_actions[ActionId::Redo].setEnabled(false);
    connect(&m_stackupModel, &StackupModel::edited, &m_thicknesses, &ThicknessEditing::set);
    connect(&m_stackupModel, &StackupModel::refused, m_messageBar, &MessageBar::showError);
    connect(&m_thicknesses, &ThicknessEditing::restacked, this, &MainWindow::onRestacked);
    connect(&m_thicknesses, &ThicknessEditing::notSaved, m_messageBar, &MessageBar::showError);
}

void MainWindow::connectViewActions() {
    on(ActionId::Fit, [this] { active().fit(); });
    on(ActionId::ZoomIn, [this] { active().zoomAtCentre(CameraController::kZoomPerNotch); });
    on(ActionId::ZoomOut, [this] { active().zoomAtCentre(1.0F / CameraController::kZoomPerNotch); });
    on(ActionId::Flip, [this] { active().flip(); });
    on(ActionId::ViewTop, [this] { active().look(render::NamedView::Top); });
    on(ActionId::ViewBottom, [this] { active().look(render::NamedView::Bottom); });
    on(ActionId::ViewIso, [this] { m_views->solid().controller().look(render::NamedView::Iso); });
    on(ActionId::Orthographic, [this](bool isOn) { m_views->solid().controller().setOrthographic(isOn); });
    on(ActionId::Explode, [this](bool isOn) { m_views->explode(isOn); });
}

void MainWindow::connectSavedViews() {
    for (std::size_t i = 0; i < m_viewHistories.size(); ++i) {
        m_viewHistories[i] = new ViewHistory(m_views->both()[i]->controller(), this);
    }
    const auto history = [this]() -> ViewHistory& {
        return *m_viewHistories[&m_views->active() == &m_views->flat() ? 0 : 1];
    };
    on(ActionId::ViewBack, [history] { history().back(); });
    on(ActionId::ViewForward, [history] { history().forward(); });
    on(ActionId::SaveView, [this] {
        m_savedViews->keep();
        const auto& views = m_savedViews->list().views();
        statusBar()->showMessage(QStringLiteral("Kept as %1").arg(QString::fromStdString(views.back().name)));
    });
    on(ActionId::SaveSelection, [this] { m_savedViews->saveSelection(); });
    on(ActionId::SaveSession, [this] { m_savedViews->saveDesk(m_unit); });
    connect(m_savedViews, &SavedViews::deskSaved, this,
            [this](const QString& path) { statusBar()->showMessage(QStringLiteral("Saved %1").arg(path)); });
    connect(m_savedViews, &SavedViews::notKept, this,
            [this](const QString& reason) { statusBar()->showMessage(reason); });
    connect(m_savedViews, &SavedViews::missed, m_messageBar, &MessageBar::showError);
    connect(m_savedViewsPanel, &SavedViewsPanel::chosen, m_savedViews, &SavedViews::goTo);
    connect(m_savedViewsPanel, &SavedViewsPanel::forgotten, m_savedViews, &SavedViews::remove);
    connect(m_savedViews, &SavedViews::notSaved, m_messageBar, &MessageBar::showError);
    connect(m_savedViews, &SavedViews::shown, this, [this](const QString& name) {
        m_actions[ActionId::Orthographic].setChecked(m_views->solid().controller().camera().isOrthographic());
        statusBar()->showMessage(name);
    });
    connect(m_savedViews, &SavedViews::otherStep, this, [this](const QString& name, const QString& step) {
        statusBar()->showMessage(QStringLiteral("%1 shows step %2, which is not open").arg(name, step));
    });
}

void MainWindow::connectSolidActions() {
    m_viewCube = new ViewCube(m_views->solid(), this);
    on(ActionId::ShowViewCube, [this](bool isOn) { m_viewCube->setOn(isOn); });
    m_actions[ActionId::ShowViewCube].setChecked(true);
    m_frameDisplay = new FrameDisplay(*m_views, this);
    on(ActionId::ShowFrameDisplay, [this](bool isOn) { m_frameDisplay->setOn(isOn); });
    m_sectionPlane = std::make_unique<SectionPlaneTool>(*m_views);
    connect(m_probing, &Probing::pointedAt, this, [this](double x, double y) {
        m_sectionPlane->pointAt(base::PointD{x, y});
    });
    connect(m_probing, &Probing::pointedAway, this, [this] { m_sectionPlane->pointAt(std::nullopt); });
    on(ActionId::SectionPlane, [this](bool isOn) {
        m_sectionPlane->setOn(isOn);
        m_actions[ActionId::SectionPlane].setChecked(m_sectionPlane->isOn());
    });
    on(ActionId::RotateSectionPlane, [this] { m_sectionPlane->turn(); });
    on(ActionId::MoveSectionPlaneOn, [this] { m_sectionPlane->move(kCutStep); });
    on(ActionId::MoveSectionPlaneBack, [this] { m_sectionPlane->move(-kCutStep); });
    const auto setThick = [this] {
        m_views->setZScale({m_actions[ActionId::ExaggerateCopperHeight].isChecked() ? kThickCopper : 1.0F,
                            m_actions[ActionId::ExaggerateDielectricHeight].isChecked() ? kThickDielectric : 1.0F});
    };
    on(ActionId::ExaggerateCopperHeight, setThick);
    on(ActionId::ExaggerateDielectricHeight, setThick);
}

void MainWindow::connectLayerActions() {
    on(ActionId::ShowAllLayers, [this] { m_layerModel.showAll(); });
    on(ActionId::HideAllLayers, [this] { m_layerModel.hideAll(); });
    on(ActionId::ShowCopperOnly, [this] { m_layerModel.showCopperOnly(); });
    on(ActionId::RestoreLayers, [this] { m_layerModel.restoreDefaults(); });
    on(ActionId::Contrast, &MainWindow::updateContrast);
    on(ActionId::NextLayer, [this] { m_layersPanel->step(1); });
    on(ActionId::PreviousLayer, [this] { m_layersPanel->step(-1); });
    connect(m_layersPanel, &LayersPanel::currentChanged, this, &MainWindow::updateContrast);
    on(ActionId::SoloLayer, [this] { m_layerModel.toggleSolo(m_layersPanel->currentLayer()); });
}

void MainWindow::connectBoardActions() {
    on(ActionId::CheckNets, &MainWindow::checkNets);
    on(ActionId::InferNets, &MainWindow::inferNets);
    LoadBar& bar = m_statusLine->loadBar();
    connect(&m_netChecker, &NetChecker::progressed, &bar, &LoadBar::report);
    connect(&m_netChecker, &NetChecker::failed, m_messageBar, &MessageBar::showError);
    connect(&m_netChecker, &NetChecker::failed, this, &MainWindow::onIdle);
    connect(&m_netChecker, &NetChecker::checked, this, [this](const auto& board, const auto& checks) {
        m_netCheckModel.setChecks(board, checks);
        statusBar()->showMessage(QStringLiteral("Nets against copper: %1").arg(m_netCheckModel.summary()));
        onIdle();
    });
    connect(m_netCheckPanel, &NetCheckPanel::chosen, this, qOverload<const NetCheckModel::Finding&>(&MainWindow::goTo));
}

void MainWindow::connectStackupActions() {
    StackupView& view = m_stackupPanel->view();
    m_actions[ActionId::ExaggerateCopper].setChecked(view.isExaggerated());
    on(ActionId::ExaggerateCopper, [&view](bool isOn) { view.setExaggerated(isOn); });
    on(ActionId::ExportStackup, [this] {
        requestStackupPath(*this, m_settings.lastFolder(), [this](const QString& path) { exportStackup(path); });
    });
    connect(&view, &StackupView::isolateRequested, this, [this](model::LayerId layer) {
        m_layersPanel->selectRow(static_cast<int>(layer.row()));
        m_layerModel.toggleSolo(layer);
    });
}

void MainWindow::exportStackup(const QString& path) {
    const bool isExaggerated = m_stackupPanel->view().isExaggerated();
    if (const base::Status written = model::writeStackup(*m_board->document, toPath(path), isExaggerated); !written) {
        m_messageBar->showError(QString::fromStdString(written.error().text));
    } else {
        statusBar()->showMessage(QStringLiteral("Saved %1").arg(path));
    }
}

void MainWindow::raise(QWidget& panel) {
    auto* dock = qobject_cast<QDockWidget*>(panel.parentWidget());
    dock->show();
    dock->raise();
}

void MainWindow::checkNets() {
    m_loader.cancel();
    raise(*m_netCheckPanel);
    m_netChecker.start(m_board->document);
    onWorking(QStringLiteral("Nets"));
}

void MainWindow::inferNets(bool isOn) {
    LoadRequest request = m_thicknesses.request();
    request.inferNets = isOn;
    open(std::move(request));
}

bool MainWindow::cancelWork() {
    if (m_loader.isLoading()) {
        m_loader.cancel();
        return true;
    }
    if (!m_netChecker.isChecking() && !m_clearances->isMeasuring()) {
        return m_measuring->isFollowing() && m_measuring->stepBack();
    }
    m_netChecker.cancel();
    m_clearances->cancel();
    statusBar()->showMessage(QStringLiteral("Stopped"));
    onIdle();
    return true;
}

void MainWindow::connectSelectActions() {
    on(ActionId::ClearSelection, [this] {
        cancelWork() || m_keyboard->returnToView() || m_measuring->stepBack() || m_sections->giveUp() ||
            m_selection.clearStep();
    });
    on(ActionId::ShowSelection, [this] { m_probing->showInBoth(m_selection.selected()); });
    m_netCommands = new NetCommands(m_actions, m_selection, m_netStyles, *m_netsPanel, this);
    connect(m_netCommands, &NetCommands::missed, this, [this](const QString& what) { statusBar()->showMessage(what); });
    connect(m_netStyleEditing, &NetStyleEditing::notSaved, m_messageBar, &MessageBar::showError);
    m_elementStyles->obey(m_actions[ActionId::DimOthers], m_netsPanel->dimSlider());
    m_parts = new PartPicking(m_actions, m_selection, this);
    connect(m_parts, &PartPicking::missed, this, [this](const QString& what) { statusBar()->showMessage(what); });
    connect(m_probing, &Probing::componentAsked, m_parts, &PartPicking::selectComponentOf);
    connect(m_elementPanel, &ElementPanel::followed, m_parts, &PartPicking::follow);
    connect(m_parts, &PartPicking::layerChosen, this,
            [this](model::LayerId layer) { m_layersPanel->selectRow(static_cast<int>(layer.row())); });
    connect(m_netsPanel, &NetsPanel::showRequested, m_probing, [this](const auto& nets) { m_probing->showNets(nets); });
    const auto selectAll = [this](const std::vector<model::ElementId>& elements) {
        std::vector<model::BoardElement> selected;
        for (const model::ElementId element : elements) {
            selected.push_back({0, element});
        }
        m_selection.select(selected);
    };
    connect(&m_statisticsPanel->plot(), &HistogramView::chosen, this, selectAll);
    connect(m_statisticsPanel, &StatisticsPanel::holesChosen, this, selectAll);
}

void MainWindow::connectFollowActions() {
    on(ActionId::FollowInSolid, [this](bool isOn) { m_probing->setFollows(BoardView::Kind::Solid, isOn); });
    on(ActionId::FollowInFlat, [this](bool isOn) { m_probing->setFollows(BoardView::Kind::Flat, isOn); });
    on(ActionId::FollowInTables, [this](bool isOn) { m_netsPanel->setFollows(isOn); });
    on(ActionId::FollowFromTables, [this](bool isOn) { m_netsPanel->setShowsChosen(isOn); });
    m_actions[ActionId::FollowInTables].setChecked(true);
}

void MainWindow::connectPlanActions() {
    on(ActionId::NextUnit, [this] { setUnit(nextUnit(m_unit)); });
    on(ActionId::ShowGrid, [this](bool isOn) { m_planPainter->showGrid(isOn); });
    on(ActionId::ShowOutlines, [this](bool isOn) { m_views->flat().setOutlined(isOn); });
    on(ActionId::ShowNames, [this](bool isOn) { m_planPainter->showNames(isOn); });
    on(ActionId::ShowPinNames, [this](bool isOn) { m_planPainter->showPinNames(isOn); });
    m_actions[ActionId::ShowGrid].setChecked(true);
    m_actions[ActionId::ShowNames].setChecked(true);
    m_actions[ActionId::ShowPinNames].setChecked(true);
}

void MainWindow::connectHelpActions() {
    m_keyboard = new Keyboard(*this, m_actions, *m_views, m_settings);
    on(ActionId::ShowKeys, [this] { showKeyList(*this, m_actions.keys()); });
    on(ActionId::About, [this] { showAbout(*this); });
    on(ActionId::ResetSettings, [this] { confirmReset(*this, [this] { resetSettings(); }); });
}

void MainWindow::requestBoardToOpen(BoardForm form) {
    requestBoard(*this, form, m_settings.lastFolder(), [this](const QString& path) {
        m_settings.setLastFolder(QFileInfo(path).absolutePath());
        open(toPath(path));
    });
}

void MainWindow::savePicture(const QString& path, int width) {
    BoardView& view = m_views->active();
    const double shown = view.width() * view.devicePixelRatioF();
    const base::Result<QImage> picture = view.grabPicture(width > 0 ? width / shown : 1.0);
    if (!picture) {
        m_messageBar->showError(QString::fromStdString(picture.error().text));
    } else if (!picture->save(path, "PNG")) {
        m_messageBar->showError(QStringLiteral("%1 cannot be written").arg(path));
    } else {
        statusBar()->showMessage(
            QStringLiteral("Saved %1, %2 × %3 pixels").arg(path).arg(picture->width()).arg(picture->height()));
    }
}

void MainWindow::copyPicture() {
    const base::Result<QImage> picture = m_views->active().grabPicture();
    if (picture) {
        QGuiApplication::clipboard()->setImage(picture->copy());
        statusBar()->showMessage(QStringLiteral("The picture is on the clipboard"));
    } else {
        m_messageBar->showError(QString::fromStdString(picture.error().text));
    }
}

void MainWindow::updateContrast() {
    m_views->setContrastLayer(m_actions[ActionId::Contrast].isChecked() ? m_layersPanel->currentLayer()
                                                                        : model::LayerId{});
}

}  // namespace ui
