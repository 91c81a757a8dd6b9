#include "ui/main_window.h"

#include <QClipboard>
#include <QCloseEvent>
#include <QDockWidget>
#include <QFileInfo>
#include <QGuiApplication>
#include <QMenu>
#include <QMenuBar>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>
#include <utility>

#include "ui/element_panel.h"
#include "ui/help_dialogs.h"
#include "ui/icons.h"
#include "ui/layers_panel.h"
#include "ui/load_summary.h"
#include "ui/looks.h"
#include "ui/message_bar.h"
#include "ui/message_place.h"
#include "ui/messages_panel.h"
#include "ui/nets_panel.h"
#include "ui/paths.h"
#include "ui/recent_boards.h"
#include "ui/start_page.h"
#include "ui/statistics_panel.h"
#include "ui/status_line.h"
#include "ui/theme.h"

namespace ui {

namespace {

constexpr std::pair<ActionId, Theme> kThemes[] = {
    {ActionId::ThemeSystem, Theme::System}, {ActionId::ThemeDark, Theme::Dark}, {ActionId::ThemeLight, Theme::Light}};
constexpr std::pair<ActionId, render::Backend> kBackends[] = {{ActionId::BackendAuto, render::Backend::Auto},
                                                              {ActionId::BackendMesh, render::Backend::Mesh},
                                                              {ActionId::BackendPull, render::Backend::Pull}};
constexpr std::pair<ActionId, Arrangement> kArrangements[] = {{ActionId::ShowFlat, Arrangement::Flat},
                                                              {ActionId::ShowSolid, Arrangement::Solid},
                                                              {ActionId::ShowSideBySide, Arrangement::SideBySide},
                                                              {ActionId::ShowStacked, Arrangement::Stacked}};
/// Toolbar in order; Count stands for a separator.
constexpr ActionId kToolBar[] = {ActionId::OpenFile,   ActionId::Count,   ActionId::Fit,        ActionId::LookTop,
                                 ActionId::LookBottom, ActionId::LookIso, ActionId::Count,      ActionId::Orthographic,
                                 ActionId::Explode,    ActionId::Count,   ActionId::SavePicture};
/// Commands that need a board.
constexpr ActionId kBoardActions[] = {
    ActionId::Reload,         ActionId::SavePicture,   ActionId::CopyPicture,    ActionId::Fit,
    ActionId::LookTop,        ActionId::LookBottom,    ActionId::LookIso,        ActionId::Flip,
    ActionId::ZoomIn,         ActionId::ZoomOut,       ActionId::ShowAllLayers,  ActionId::HideAllLayers,
    ActionId::ShowCopperOnly, ActionId::SoloLayer,     ActionId::RestoreLayers,  ActionId::Contrast,
    ActionId::NextLayer,      ActionId::PreviousLayer, ActionId::ClearSelection, ActionId::ShowSelection,
    ActionId::HighlightNet};

}  // namespace

MainWindow::MainWindow(GpuContext& context, Settings& settings, const Loader::Work& work)
    : m_context(context), m_settings(settings), m_actions(*this), m_loader(work) {
    setObjectName(QStringLiteral("workbench"));
    setWindowTitle(QStringLiteral("Copperscope"));
    m_statusLine = new StatusLine(*statusBar());
    m_statusLine->showDevice(QString::fromStdString(context.device().caps().name));
    createCentre();
    createDocks();
    createToolBar();
    createMenus();
    connectFileActions();
    connectViewActions();
    connectLayerActions();
    connectSelectActions();
    connectHelpActions();
    connectLoader();
    restoreSettings();
    onIdle();
}

MainWindow::~MainWindow() {
    delete m_views;  // its canvases must not draw with painters that are gone
}

void MainWindow::createCentre() {
    m_views = new BoardViews(m_context);
    m_messageBar = new MessageBar;
    m_pages = new QStackedWidget;
    m_pages->addWidget(new StartPage(m_actions));
    m_pages->addWidget(m_views);
    auto* centre = new QWidget;
    auto* layout = new QVBoxLayout(centre);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_messageBar);
    layout->addWidget(m_pages, 1);
    setCentralWidget(centre);

    setAcceptDrops(true);
    installEventFilter(&m_dropTarget);
    for (BoardView* view : m_views->both()) {
        view->canvas().installEventFilter(&m_dropTarget);
    }
    connect(&m_dropTarget, &DropTarget::dropped, this, &MainWindow::openDropped);
    m_probing = new Probing(*m_views, m_selection, this);
    m_planPainter = std::make_unique<PlanPainter>(m_views->flat());
    connect(m_views, &BoardViews::timed, m_statusLine, &StatusLine::showFrame);
    connect(m_views, &BoardViews::troubled, m_messageBar, &MessageBar::showError);
    connect(&m_layerModel, &models::LayerModel::looksChanged, this,
            [this] { m_views->setLooks(m_layerModel.effectiveLooks()); });
}

QDockWidget* MainWindow::addDock(Qt::DockWidgetArea area, const char* name, const QString& title, QWidget* content,
                                 ActionId toggle) {
    auto* dock = new QDockWidget(title);
    dock->setObjectName(QLatin1String(name));  // saveState finds it by this name
    dock->setWidget(content);
    addDockWidget(area, dock);
    m_actions.adopt(toggle, *dock->toggleViewAction());
    return dock;
}

void MainWindow::createDocks() {
    m_layersPanel = new LayersPanel(m_layerModel, m_actions);
    m_netsPanel = new NetsPanel(m_netModel, m_selection);
    m_elementPanel = new ElementPanel(m_selection);
    m_statisticsPanel = new StatisticsPanel(m_statisticsModel);
    m_messagesPanel = new MessagesPanel(m_messageModel);
    connect(m_messagesPanel, &MessagesPanel::chosen, this, &MainWindow::goTo);
    QDockWidget* layers =
        addDock(Qt::LeftDockWidgetArea, "layers", QStringLiteral("Layers"), m_layersPanel, ActionId::ShowLayersDock);
    QDockWidget* nets =
        addDock(Qt::RightDockWidgetArea, "nets", QStringLiteral("Nets"), m_netsPanel, ActionId::ShowNetsDock);
    QDockWidget* element = addDock(Qt::RightDockWidgetArea, "element", QStringLiteral("Element"), m_elementPanel,
                                   ActionId::ShowElementDock);
    QDockWidget* statistics = addDock(Qt::BottomDockWidgetArea, "statistics", QStringLiteral("Statistics"),
                                      m_statisticsPanel, ActionId::ShowStatisticsDock);
    QDockWidget* messages = addDock(Qt::BottomDockWidgetArea, "messages", QStringLiteral("Messages"), m_messagesPanel,
                                    ActionId::ShowMessagesDock);
    tabifyDockWidget(messages, statistics);
    messages->raise();
    setCorner(Qt::BottomLeftCorner, Qt::LeftDockWidgetArea);
    const int line = fontMetrics().height();
    resizeDocks({layers, nets, element}, {line * 24, line * 22, line * 22}, Qt::Horizontal);
    resizeDocks({messages}, {line * 13}, Qt::Vertical);
}

void MainWindow::createToolBar() {
    QToolBar* bar = addToolBar(QStringLiteral("Toolbar"));
    bar->setObjectName(QStringLiteral("toolbar"));
    bar->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    bar->setIconSize({fontMetrics().height() + 4, fontMetrics().height() + 4});
    for (const ActionId id : kToolBar) {
        if (id == ActionId::Count) {
            bar->addSeparator();
            continue;
        }
        m_actions[id].setIcon(iconOf(id));
        bar->addAction(&m_actions[id]);
    }
    m_actions.adopt(ActionId::ShowToolBar, *bar->toggleViewAction());
}

void MainWindow::createMenus() {
    const auto addMenu = [this](auto& parent, MenuId id) {
        QMenu* menu = parent.addMenu(QString::fromUtf8(menuTitle(id)));
        m_actions.fill(*menu, id);
        return menu;
    };
    QMenu* file = addMenu(*menuBar(), MenuId::File);
    QMenu* view = addMenu(*menuBar(), MenuId::View);
    view->addSeparator();
    addMenu(*view, MenuId::Arrangement);
    addMenu(*view, MenuId::Theme);
    addMenu(*view, MenuId::Backend);
    addMenu(*menuBar(), MenuId::Layers);
    addMenu(*menuBar(), MenuId::Select);
    addMenu(*menuBar(), MenuId::Help);

    auto* recent = new QMenu(QStringLiteral("Open r&ecent"), this);
    file->insertMenu(&m_actions[ActionId::Reload], recent);
    m_recent = new RecentBoards(m_settings, *recent, this);
    connect(m_recent, &RecentBoards::chosen, this, [this](const QString& path) { open(toPath(path)); });
}

template <class Slot>
void MainWindow::on(ActionId id, Slot slot) {
    connect(&m_actions[id], &QAction::triggered, this, slot);
}

void MainWindow::connectFileActions() {
    on(ActionId::OpenFile, [this] { askForBoardToOpen(BoardForm::File); });
    on(ActionId::OpenFolder, [this] { askForBoardToOpen(BoardForm::Folder); });
    on(ActionId::Reload, [this] { open(m_board->request.path, m_board->request.step); });
    on(ActionId::CancelLoading, [this] { m_loader.cancel(); });
    on(ActionId::SavePicture, [this] {
        askForPicturePath(*this, m_settings.lastFolder(), [this](const QString& path) { savePicture(path); });
    });
    on(ActionId::CopyPicture, &MainWindow::copyPicture);
    on(ActionId::Quit, &QWidget::close);
}

void MainWindow::connectViewActions() {
    on(ActionId::Fit, [this] { active().fit(); });
    on(ActionId::ZoomIn, [this] { active().zoomAtCentre(CameraController::kZoomPerNotch); });
    on(ActionId::ZoomOut, [this] { active().zoomAtCentre(1.0F / CameraController::kZoomPerNotch); });
    on(ActionId::Flip, [this] { active().flip(); });
    on(ActionId::LookTop, [this] { active().look(render::NamedView::Top); });
    on(ActionId::LookBottom, [this] { active().look(render::NamedView::Bottom); });
    on(ActionId::LookIso, [this] { m_views->solid().controller().look(render::NamedView::Iso); });
    on(ActionId::Orthographic, [this](bool isOn) { m_views->solid().controller().setOrthographic(isOn); });
    on(ActionId::Explode, [this](bool isOn) { m_views->explode(isOn); });
    for (const auto& [id, arrangement] : kArrangements) {
        on(id, [this, arrangement = arrangement] { setArrangement(arrangement); });
    }
    for (const auto& [id, theme] : kThemes) {
        on(id, [this, theme = theme] { setTheme(theme); });
    }
    for (const auto& [id, backend] : kBackends) {
        on(id, [this, backend = backend] { setBackend(backend); });
    }
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

void MainWindow::connectSelectActions() {
    on(ActionId::ClearSelection, [this] { m_loader.isLoading() ? m_loader.cancel() : void(m_selection.clearStep()); });
    on(ActionId::ShowSelection, [this] { m_probing->showInBoth(m_selection.selected()); });
    on(ActionId::HighlightNet, &MainWindow::highlightNet);
    on(ActionId::DimOthers, [this](bool isOn) { m_probing->setDimOthers(isOn); });
    on(ActionId::FollowInSolid, [this](bool isOn) { m_probing->setFollows(BoardView::Kind::Solid, isOn); });
    on(ActionId::FollowInFlat, [this](bool isOn) { m_probing->setFollows(BoardView::Kind::Flat, isOn); });
    on(ActionId::FollowInTables, [this](bool isOn) { m_netsPanel->setFollows(isOn); });
    on(ActionId::FollowFromTables, [this](bool isOn) { m_netsPanel->setShowsChosen(isOn); });
    m_actions[ActionId::FollowInTables].setChecked(true);
    connect(m_netsPanel, &NetsPanel::showRequested, m_probing, &Probing::showNet);
    on(ActionId::NextUnit, [this] { setUnit(models::nextUnit(m_unit)); });
    on(ActionId::ShowGrid, [this](bool isOn) { m_planPainter->showGrid(isOn); });
    on(ActionId::ShowNames, [this](bool isOn) { m_planPainter->showNames(isOn); });
    m_actions[ActionId::ShowGrid].setChecked(true);
    m_actions[ActionId::ShowNames].setChecked(true);
    connect(m_probing, &Probing::pointedAt, this,
            [this](double x, double y) { m_statusLine->showPlace(models::placeText(x, y, m_unit)); });
    connect(m_probing, &Probing::pointedAway, this, [this] { m_statusLine->showPlace({}); });
}

void MainWindow::highlightNet() {
    const auto at = m_selection.hovered() ? m_selection.hovered() : m_selection.current();
    if (at && at->copy == 0) {
        const model::NetId net = document()->elements.net[at->element.row()];
        if (net.isValid()) {
            m_selection.toggleNet(net);
            return;
        }
    }
    statusBar()->showMessage(QStringLiteral("Point at an element of a net, or select one, to highlight its net"));
}

void MainWindow::setUnit(models::LengthUnit unit) {
    m_unit = unit;
    m_settings.setUnit(unit);
    m_probing->setUnit(unit);
    m_planPainter->setUnit(unit);
    m_elementPanel->setUnit(unit);
    m_netModel.setUnit(unit);
    m_statusLine->showPlace({});
    statusBar()->showMessage(QStringLiteral("Lengths are in %1").arg(QLatin1String(models::unitName(unit))));
}

void MainWindow::connectHelpActions() {
    on(ActionId::KeysSheet, [this] { showKeysSheet(*this); });
    on(ActionId::About, [this] { showAbout(*this); });
    on(ActionId::ResetSettings, [this] { askToReset(*this, [this] { resetSettings(); }); });
}

void MainWindow::connectLoader() {
    connect(&m_loader, &Loader::started, this, &MainWindow::onStarted);
    connect(&m_loader, &Loader::loaded, this, &MainWindow::onLoaded);
    connect(&m_loader, &Loader::failed, this, &MainWindow::onFailed);
    connect(&m_loader, &Loader::cancelled, this, &MainWindow::onCancelled);
    LoadBar& bar = m_statusLine->loadBar();
    connect(&m_loader, &Loader::progressed, &bar, &LoadBar::report);
    connect(&bar, &LoadBar::cancelRequested, &m_loader, &Loader::cancel);
    connect(m_statusLine, &StatusLine::stepChosen, this,
            [this](const QString& step) { open(m_board->request.path, step.toStdString()); });
}

void MainWindow::restoreSettings() {
    resize(1280, 800);
    m_defaultState = saveState();
    restoreGeometry(m_settings.windowGeometry());
    restoreState(m_settings.windowState());
    setTheme(m_settings.theme());
    setBackend(m_settings.backend());
    setArrangement(m_settings.arrangement());
    setUnit(m_settings.unit());
    statusBar()->clearMessage();
    m_actions[ActionId::BackendMesh].setEnabled(m_context.device().caps().hasMeshShader);
}

void MainWindow::resetSettings() {
    m_settings.reset();
    restoreState(m_defaultState);
    setTheme(Theme::System);
    setBackend(render::Backend::Auto);
    setArrangement(Arrangement::SideBySide);
    setUnit(models::LengthUnit::Millimetre);
}

void MainWindow::closeEvent(QCloseEvent* event) {
    m_loader.cancel();
    m_settings.setWindow(saveGeometry(), saveState());
    event->accept();
}

void MainWindow::open(const std::filesystem::path& path, const std::string& step) {
    m_loader.open({path, step});
}

void MainWindow::openDropped(const QStringList& paths) {
    open(toPath(paths.first()));
    if (paths.size() > 1) {
        statusBar()->showMessage(QStringLiteral("One board at a time: opening the first of %1").arg(paths.size()));
    }
}

void MainWindow::askForBoardToOpen(BoardForm form) {
    askForBoard(*this, form, m_settings.lastFolder(), [this](const QString& path) {
        m_settings.setLastFolder(QFileInfo(path).absolutePath());
        open(toPath(path));
    });
}

void MainWindow::savePicture(const QString& path) {
    const base::Result<QImage> picture = m_views->active().grabPicture();
    if (!picture) {
        m_messageBar->showError(QString::fromStdString(picture.error().text));
    } else if (!picture->save(path, "PNG")) {
        m_messageBar->showError(QStringLiteral("%1 cannot be written").arg(path));
    } else {
        statusBar()->showMessage(QStringLiteral("Saved %1").arg(path));
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

void MainWindow::onStarted(const LoadRequest& request) {
    m_statusLine->loadBar().begin(displayName(request.path));
    m_actions[ActionId::CancelLoading].setEnabled(true);
    m_actions[ActionId::ClearSelection].setEnabled(true);
}

void MainWindow::onIdle() {
    m_statusLine->loadBar().hide();
    m_actions[ActionId::CancelLoading].setEnabled(false);
    if (m_board) {
        m_statusLine->showSteps(m_board->document->job);  // also undoes a choice that was not loaded
    }
    for (const ActionId id : kBoardActions) {
        m_actions[id].setEnabled(m_board.has_value());
    }
}

void MainWindow::onLoaded(const LoadedBoard& board) {
    m_board = board;
    m_layerModel.setDocument(board.document, defaultLooks(*board.document));
    m_statisticsModel.setDocument(board.document);
    m_messageModel.setMessages(board.document, board.model->diagnostics);
    m_views->show(board, m_layerModel.effectiveLooks());
    m_probing->setBoard(board);
    m_netModel.setNets(board.document, board.nets);
    m_planPainter->setBoard(board.index, {board.model->origin});
    updateContrast();
    m_pages->setCurrentWidget(m_views);
    m_messageBar->hide();
    m_recent->add(fromPath(board.request.path));
    setWindowTitle(QStringLiteral("%1 – Copperscope").arg(displayName(board.request.path)));
    statusBar()->showMessage(loadSummary(board, m_messageModel));
    onIdle();
}

void MainWindow::goTo(const model::Diagnostic& message) {
    const std::optional<render::Box3> place = placeOf(message, *m_board->document, *m_board->model);
    if (!place) {
        statusBar()->showMessage(QStringLiteral("This message is not about one place on the board"));
        return;
    }
    m_views->setHighlight({}, false);
    if (message.element.isValid()) {
        m_views->setHighlight({{message.element}}, false);
        const std::size_t layer = m_board->document->elements.layer[message.element.row()].row();
        const QModelIndex visible = m_layerModel.index(static_cast<int>(layer), models::LayerModel::Visible);
        m_layerModel.setData(visible, Qt::Checked, Qt::CheckStateRole);
    }
    for (BoardView* view : m_views->both()) {
        view->controller().show(place->min, place->max);
    }
}

void MainWindow::onFailed(const LoadRequest& request, const QString& reason) {
    m_messageBar->showError(QStringLiteral("%1 was not opened. %2").arg(displayName(request.path), reason));
    onIdle();
}

void MainWindow::onCancelled(const LoadRequest& request) {
    statusBar()->showMessage(QStringLiteral("Stopped opening %1").arg(displayName(request.path)));
    onIdle();
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

void MainWindow::updateContrast() {
    m_views->setContrastLayer(m_actions[ActionId::Contrast].isChecked() ? m_layersPanel->currentLayer()
                                                                        : model::LayerId{});
}

}  // namespace ui
