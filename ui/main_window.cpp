#include "ui/main_window.h"

#include <QCloseEvent>
#include <QMenu>
#include <QMenuBar>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>
#include <algorithm>
#include <map>
#include <utility>

#include "ui/docks.h"
#include "ui/element_panel.h"
#include "ui/element_picture.h"
#include "ui/histogram_view.h"
#include "ui/icons.h"
#include "ui/keyboard.h"
#include "ui/layers_panel.h"
#include "ui/load_summary.h"
#include "ui/looks.h"
#include "ui/measurements_panel.h"
#include "ui/message_bar.h"
#include "ui/messages_panel.h"
#include "ui/net_check_panel.h"
#include "ui/nets_panel.h"
#include "ui/paths.h"
#include "ui/recent_boards.h"
#include "ui/search_box.h"
#include "ui/stack_panel.h"
#include "ui/stack_view.h"
#include "ui/start_page.h"
#include "ui/statistics_panel.h"
#include "ui/status_line.h"
#include "ui/views_panel.h"

namespace ui {

namespace {

/// Toolbar in order; Count stands for a separator.
constexpr ActionId kToolBar[] = {ActionId::OpenFile,   ActionId::Count,   ActionId::Fit,        ActionId::LookTop,
                                 ActionId::LookBottom, ActionId::LookIso, ActionId::Count,      ActionId::Orthographic,
                                 ActionId::Explode,    ActionId::Count,   ActionId::SavePicture};
/// Commands that need a board.
// One name a line would fill the page.
// clang-format off
constexpr ActionId kBoardActions[] = {
    ActionId::Reload, ActionId::SavePicture, ActionId::CopyPicture, ActionId::Fit,
    ActionId::LookTop, ActionId::LookBottom, ActionId::LookIso, ActionId::Flip,
    ActionId::ZoomIn, ActionId::ZoomOut, ActionId::ShowAllLayers, ActionId::HideAllLayers,
    ActionId::ShowCopperOnly, ActionId::SoloLayer, ActionId::RestoreLayers, ActionId::Contrast,
    ActionId::NextLayer, ActionId::PreviousLayer, ActionId::ClearSelection, ActionId::ShowSelection,
    ActionId::ColourNet, ActionId::ChooseNetColour, ActionId::HideNet, ActionId::ShowAllNets,
    ActionId::ClearNetColours, ActionId::SelectComponent, ActionId::SelectPin, ActionId::CheckNets,
    ActionId::ExportStack, ActionId::InferNets, ActionId::HighlightNet, ActionId::SaveLargePicture,
    ActionId::ViewBack, ActionId::ViewForward, ActionId::KeepView, ActionId::KeepSelection,
    ActionId::SaveSession, ActionId::FindGaps, ActionId::NextGap, ActionId::PreviousGap,
    ActionId::EditRules, ActionId::ExportGaps, ActionId::Lens, ActionId::DistanceMap, ActionId::MeasurePoints,
    ActionId::MeasureObjects, ActionId::MeasureAngle, ActionId::MeasureLines, ActionId::MeasureRadius,
    ActionId::MeasureLength, ActionId::MeasureGap,
    ActionId::ExportMeasurements, ActionId::DrawSection, ActionId::OpenAlongSection,
    ActionId::SectionAlongNet, ActionId::KeepSection, ActionId::ExportSection};
// clang-format on

}  // namespace

MainWindow::MainWindow(GpuContext& context, Settings& settings, const Loader::Work& work)
    : m_context(context), m_settings(settings), m_actions(*this), m_loader(work) {
    setObjectName(QStringLiteral("workbench"));
    resize(1280, 800);  // before the docks take their shares of it
    setWindowTitle(QStringLiteral("Copperscope"));
    m_statusLine = new StatusLine(*statusBar());
    m_statusLine->showDevice(QString::fromStdString(context.device().caps().name));
    createCentre();
    createDocks();
    createToolBar();
    createMenus();
    connectCommands();
    connectLoader();
    restoreSettings();
    onIdle();
}

MainWindow::~MainWindow() {
    hide();          // an editor that is open commits while all it needs is still there
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
    m_probing = new Probing(*m_views, m_selection, m_netLooks, this);
    m_elementLooks = new ElementLooks(*m_views, m_selection, m_netLooks, this);
    m_planPainter = std::make_unique<PlanPainter>(m_views->flat());
    m_planPainter->setLooks(m_netLooks);
    m_outlines = new ElementOutlines(*m_views, m_selection, this);
    m_clearances =
        new Clearances(*m_views, *m_probing, m_selection, *m_planPainter, m_actions, m_thicknesses.history(), this);
    m_sections = new Sections(*m_views, m_selection, m_actions, m_thicknesses.history(), this);
    m_placeReadout = new PlaceReadout(*m_probing, *m_statusLine, this);
    m_measurements = new MeasurementKeeping(m_thicknesses.history(), this);
    m_measuring = new Measuring(*m_views, *m_probing, *m_measurements, this);
    connect(m_views, &BoardViews::timed, m_statusLine, &StatusLine::showFrame);
    connect(m_views, &BoardViews::troubled, m_messageBar, &MessageBar::showError);
    connect(&m_layerModel, &models::LayerModel::looksChanged, this, [this] {
        m_views->setLooks(m_layerModel.effectiveLooks());
        colourStack();
    });
}

void MainWindow::createDocks() {
    m_layersPanel = new LayersPanel(m_layerModel, m_actions);
    m_netModel.setLooks(m_netLooks);
    m_netsPanel = new NetsPanel(m_netModel, m_selection, m_netLooks, m_actions);
    m_netLookEditing = new NetLookEditing(m_netLooks, m_thicknesses.history(), this);
    m_elementPanel = new ElementPanel(m_selection, new ElementPicture(m_context, m_selection, m_layerModel));
    connect(m_views, &BoardViews::deviceGoes, &m_elementPanel->picture(), &ElementPicture::releaseDevice);
    m_netCheckPanel = new NetCheckPanel(m_netCheckModel, m_actions);
    m_stackPanel = new StackPanel(m_stackModel, m_actions);
    m_statisticsPanel = new StatisticsPanel(m_statisticsModel, m_drillModel);
    m_messagesPanel = new MessagesPanel(m_messageModel);
    m_viewKeeping = new ViewKeeping(*m_views, m_layerModel, m_selection, m_thicknesses.history(), this);
    m_viewsPanel = new ViewsPanel(m_viewKeeping->list(), m_actions);
    m_measurementsPanel = new MeasurementsPanel(m_measurements->list(), m_actions);
    connect(m_messagesPanel, &MessagesPanel::chosen, this, qOverload<const model::Diagnostic&>(&MainWindow::goTo));
    const std::map<ActionId, QWidget*> panels = {{ActionId::ShowLayersDock, m_layersPanel},
                                                 {ActionId::ShowNetsDock, m_netsPanel},
                                                 {ActionId::ShowElementDock, m_elementPanel},
                                                 {ActionId::ShowStackDock, m_stackPanel},
                                                 {ActionId::ShowNetCheckDock, m_netCheckPanel},
                                                 {ActionId::ShowStatisticsDock, m_statisticsPanel},
                                                 {ActionId::ShowMessagesDock, m_messagesPanel},
                                                 {ActionId::ShowViewsDock, m_viewsPanel},
                                                 {ActionId::ShowMeasurementsDock, m_measurementsPanel},
                                                 {ActionId::ShowClearanceDock, &m_clearances->panel()},
                                                 {ActionId::ShowSectionDock, &m_sections->panel()}};
    addDocks(*this, m_actions, [&panels](ActionId toggle) { return panels.at(toggle); });
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
    addMenu(*menuBar(), MenuId::Edit);
    QMenu* view = addMenu(*menuBar(), MenuId::View);
    view->addSeparator();
    addMenu(*view, MenuId::Solid);
    addMenu(*view, MenuId::Arrangement);
    addMenu(*view, MenuId::Panels);
    addMenu(*view, MenuId::Theme);
    addMenu(*view, MenuId::Backend);
    addMenu(*view, MenuId::Keys);
    addMenu(*menuBar(), MenuId::Layers);
    addMenu(*menuBar(), MenuId::Nets);
    addMenu(*menuBar(), MenuId::Board);
    addMenu(*menuBar(), MenuId::Measure);
    addMenu(*menuBar(), MenuId::Select);
    addMenu(*menuBar(), MenuId::Help);

    auto* recent = new QMenu(QStringLiteral("Open r&ecent"), this);
    file->insertMenu(&m_actions[ActionId::Reload], recent);
    m_recent = new RecentBoards(m_settings, *recent, this);
    connect(m_recent, &RecentBoards::chosen, this, [this](const QString& path) { open(toPath(path)); });
}

void MainWindow::connectLoader() {
    connect(&m_loader, &Loader::started, this, &MainWindow::onStarted);
    connect(&m_loader, &Loader::loaded, this, &MainWindow::onLoaded);
    connect(&m_loader, &Loader::failed, this, &MainWindow::onFailed);
    connect(&m_loader, &Loader::cancelled, this, &MainWindow::onCancelled);
    LoadBar& bar = m_statusLine->loadBar();
    connect(&m_loader, &Loader::progressed, &bar, &LoadBar::report);
    connect(&bar, &LoadBar::cancelRequested, this, &MainWindow::cancelWork);
    connect(m_statusLine, &StatusLine::stepChosen, this, [this](const QString& step) {
        LoadRequest request = m_thicknesses.request();
        request.step = step.toStdString();
        m_loader.open(std::move(request));
    });
}

void MainWindow::closeEvent(QCloseEvent* event) {
    m_loader.cancel();
    m_settings.setWindow(saveGeometry(), saveState());
    event->accept();
}

void MainWindow::open(const std::filesystem::path& path, const std::string& step) {
    m_loader.open({.path = path, .step = step});
}

void MainWindow::openDropped(const QStringList& paths) {
    open(toPath(paths.first()));
    if (paths.size() > 1) {
        statusBar()->showMessage(QStringLiteral("One board at a time: opening the first of %1").arg(paths.size()));
    }
}

void MainWindow::onStarted(const LoadRequest& request) {
    m_netChecker.cancel();
    m_clearances->cancel();
    onWorking(displayName(request.path));
}

void MainWindow::onWorking(const QString& what) {
    m_statusLine->loadBar().begin(what);
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
    m_actions[ActionId::InferNets].setChecked(m_board && m_board->request.inferNets);
}

void MainWindow::onLoaded(const LoadedBoard& board) {
    m_board = board;
    m_layerModel.setDocument(board.document, defaultLooks(*board.document, m_settings.palette()));
    m_statisticsModel.setDocument(board.document, board.copperNm2);
    m_drillModel.setDocument(board.document);
    m_statisticsPanel->plot().setDocument(board.document);
    m_stackModel.setDocument(board.document);
    m_thicknesses.setBoard(board);
    m_searchBox->search().setBoard(board.document);
    m_stackPanel->view().setStack(board.document);
    colourStack();
    m_netCheckModel.setChecks(nullptr, {});
    m_messageModel.setMessages(board.document, board.model->diagnostics);
    m_views->show(board, m_layerModel.effectiveLooks());
    m_viewKeeping->setBoard(board);
    for (ViewHistory* history : m_viewHistories) {
        history->clear();
    }
    m_probing->setBoard(board);
    m_parts->forgetBoard();
    m_cutting->setBoard(board);
    m_frameDisplay->setBoard(board);
    m_actions[ActionId::CutOpen].setChecked(false);
    m_netLookEditing->setBoard(board);
    m_netsPanel->setBoard(board.document, board.nets);
    m_clearances->setBoard(board);
    m_sections->setBoard(board);
    m_actions[ActionId::DrawSection].setChecked(false);
    m_outlines->setOrigin(board.model->origin);
    m_planPainter->setBoard(board.index, {board.model->origin});
    m_measurements->setBoard(board);
    m_measuring->setBoard(board);
    updateContrast();
    m_pages->setCurrentWidget(m_views);
    if (const auto unit = m_viewKeeping->restoreDesk(board)) {
        setUnit(*unit);
    }
    showNotes(board.sessionNotes);
    m_recent->add(fromPath(board.request.path));
    setWindowTitle(QStringLiteral("%1 – Copperscope").arg(displayName(board.request.path)));
    statusBar()->showMessage(loadSummary(board, m_messageModel));
    onIdle();
}

void MainWindow::showNotes(const std::vector<std::string>& notes) {
    QStringList lines;
    for (const std::string& note : notes) {
        lines += QString::fromStdString(note);
    }
    lines.isEmpty() ? m_messageBar->hide() : m_messageBar->showError(lines.join('\n'));
}

void MainWindow::colourStack() {
    std::vector<QColor> colours;
    for (const models::LayerLook& look : m_layerModel.effectiveLooks()) {
        colours.push_back(look.colour);
    }
    m_sections->setColours(colours);
    m_stackPanel->view().setLooks(std::move(colours), m_layerModel.soloLayer());
}

void MainWindow::onRestacked(const std::shared_ptr<const model::Document>& document) {
    m_board->document = document;
    m_layerModel.setHeights(document);
    m_stackModel.setDocument(document);
    m_stackPanel->view().setStack(document);
    m_messageModel.setMessages(document, m_board->model->diagnostics);
    m_views->setHeights(document);
    m_measuring->setHeights(document);
    m_sections->setHeights(document);
}

void MainWindow::onFailed(const LoadRequest& request, const QString& reason) {
    m_messageBar->showError(QStringLiteral("%1 was not opened. %2").arg(displayName(request.path), reason));
    onIdle();
}

void MainWindow::onCancelled(const LoadRequest& request) {
    statusBar()->showMessage(QStringLiteral("Stopped opening %1").arg(displayName(request.path)));
    onIdle();
}

}  // namespace ui
