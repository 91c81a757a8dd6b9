#include "ui/shell/main_window.h"

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

#include "ui/common/paths.h"
#include "ui/element/element_panel.h"
#include "ui/element/element_picture.h"
#include "ui/layers/layers_panel.h"
#include "ui/measure/measurements_panel.h"
#include "ui/messages/messages_panel.h"
#include "ui/nets/net_check_panel.h"
#include "ui/nets/nets_panel.h"
#include "ui/saved_views/saved_views_panel.h"
#include "ui/search/search_box.h"
#include "ui/shell/docks.h"
#include "ui/shell/icons.h"
#include "ui/shell/keyboard.h"
#include "ui/shell/load_summary.h"
#include "ui/shell/message_bar.h"
#include "ui/shell/recent_boards.h"
#include "ui/shell/start_page.h"
#include "ui/shell/status_line.h"
#include "ui/stackup/stackup_panel.h"
#include "ui/stackup/stackup_view.h"
#include "ui/statistics/histogram_view.h"
#include "ui/statistics/statistics_panel.h"
#include "ui/views/layer_styles.h"

namespace ui {

namespace {

/// Toolbar in order; Count stands for a separator.
constexpr ActionId kToolBar[] = {ActionId::OpenFile,   ActionId::Count,   ActionId::Fit,        ActionId::ViewTop,
                                 ActionId::ViewBottom, ActionId::ViewIso, ActionId::Count,      ActionId::Orthographic,
                                 ActionId::Explode,    ActionId::Count,   ActionId::SavePicture};
/// Commands that need a board.
// One name a line would fill the page.
// clang-format off
constexpr ActionId kBoardActions[] = {
    ActionId::Reload, ActionId::SavePicture, ActionId::CopyPicture, ActionId::Fit,
    ActionId::ViewTop, ActionId::ViewBottom, ActionId::ViewIso, ActionId::Flip,
    ActionId::ZoomIn, ActionId::ZoomOut, ActionId::ShowAllLayers, ActionId::HideAllLayers,
    ActionId::ShowCopperOnly, ActionId::SoloLayer, ActionId::RestoreLayers, ActionId::Contrast,
    ActionId::NextLayer, ActionId::PreviousLayer, ActionId::ClearSelection, ActionId::ShowSelection,
    ActionId::ColourNet, ActionId::ChooseNetColour, ActionId::HideNet, ActionId::ShowAllNets,
    ActionId::ClearNetColours, ActionId::SelectComponent, ActionId::SelectPin, ActionId::CheckNets,
    ActionId::ExportStackup, ActionId::InferNets, ActionId::HighlightNet, ActionId::SaveLargePicture,
    ActionId::ViewBack, ActionId::ViewForward, ActionId::SaveView, ActionId::SaveSelection,
    ActionId::SaveSession, ActionId::SearchClearances, ActionId::NextClearance, ActionId::PreviousClearance,
    ActionId::EditRules, ActionId::ExportClearances, ActionId::Lens, ActionId::ClearanceMap, ActionId::MeasurePoints,
    ActionId::MeasureObjects, ActionId::MeasureAngle, ActionId::MeasureLines, ActionId::MeasureRadius,
    ActionId::MeasureLength, ActionId::MeasureSpacing,
    ActionId::ExportMeasurements, ActionId::DrawSection, ActionId::OpenAlongSection,
    ActionId::SectionAlongNet, ActionId::SaveSection, ActionId::ExportSection};
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
    m_probing = new Probing(*m_views, m_selection, m_netStyles, this);
    m_elementStyles = new ElementStyles(*m_views, m_selection, m_netStyles, this);
    m_planPainter = std::make_unique<PlanPainter>(m_views->flat());
    m_planPainter->setStyles(m_netStyles);
    m_outlines = new ElementOutlines(*m_views, m_selection, this);
    m_clearances =
        new Clearances(*m_views, *m_probing, m_selection, *m_planPainter, m_actions, m_thicknesses.history(), this);
    m_sections = new Sections(*m_views, m_selection, m_actions, m_thicknesses.history(), this);
    m_positionReadout = new PositionReadout(*m_probing, *m_statusLine, this);
    m_measurements = new SavedMeasurements(m_thicknesses.history(), this);
    m_measuring = new Measuring(*m_views, *m_probing, *m_measurements, this);
    connect(m_views, &BoardViews::timed, m_statusLine, &StatusLine::showFrame);
    connect(m_views, &BoardViews::troubled, m_messageBar, &MessageBar::showError);
    connect(&m_layerModel, &LayerModel::stylesChanged, this, [this] {
        m_views->setStyles(m_layerModel.effectiveStyles());
        colourStackup();
    });
}

void MainWindow::createDocks() {
    m_layersPanel = new LayersPanel(m_layerModel, m_actions);
    m_netModel.setStyles(m_netStyles);
    m_netsPanel = new NetsPanel(m_netModel, m_selection, m_netStyles, m_actions);
    m_netStyleEditing = new NetStyleEditing(m_netStyles, m_thicknesses.history(), this);
    m_elementPanel = new ElementPanel(m_selection, new ElementPicture(m_context, m_selection, m_layerModel));
    connect(m_views, &BoardViews::deviceGoes, &m_elementPanel->picture(), &ElementPicture::releaseDevice);
    m_netCheckPanel = new NetCheckPanel(m_netCheckModel, m_actions);
    m_stackupPanel = new StackupPanel(m_stackupModel, m_actions);
    m_statisticsPanel = new StatisticsPanel(m_statisticsModel, m_drillModel);
    m_messagesPanel = new MessagesPanel(m_messageModel);
    m_savedViews = new SavedViews(*m_views, m_layerModel, m_selection, m_thicknesses.history(), this);
    m_savedViewsPanel = new SavedViewsPanel(m_savedViews->list(), m_actions);
    m_measurementsPanel = new MeasurementsPanel(m_measurements->list(), m_actions);
    connect(m_messagesPanel, &MessagesPanel::chosen, this, qOverload<const model::Diagnostic&>(&MainWindow::goTo));
    const std::map<ActionId, QWidget*> panels = {{ActionId::ShowLayersDock, m_layersPanel},
                                                 {ActionId::ShowNetsDock, m_netsPanel},
                                                 {ActionId::ShowElementDock, m_elementPanel},
                                                 {ActionId::ShowStackupDock, m_stackupPanel},
                                                 {ActionId::ShowNetCheckDock, m_netCheckPanel},
                                                 {ActionId::ShowStatisticsDock, m_statisticsPanel},
                                                 {ActionId::ShowMessagesDock, m_messagesPanel},
                                                 {ActionId::ShowSavedViewsDock, m_savedViewsPanel},
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
    m_layerModel.setDocument(board.document, defaultAppearances(*board.document, m_settings.palette()));
    m_statisticsModel.setDocument(board.document, board.copperNm2);
    m_drillModel.setDocument(board.document);
    m_statisticsPanel->plot().setDocument(board.document);
    m_stackupModel.setDocument(board.document);
    m_thicknesses.setBoard(board);
    m_searchBox->search().setBoard(board.document);
    m_stackupPanel->view().setStackup(board.document);
    colourStackup();
    m_netCheckModel.setChecks(nullptr, {});
    m_messageModel.setMessages(board.document, board.model->diagnostics);
    m_views->show(board, m_layerModel.effectiveStyles());
    m_savedViews->setBoard(board);
    for (ViewHistory* history : m_viewHistories) {
        history->clear();
    }
    m_probing->setBoard(board);
    m_parts->clearBoard();
    m_sectionPlane->setBoard(board);
    m_frameDisplay->setBoard(board);
    m_actions[ActionId::SectionPlane].setChecked(false);
    m_netStyleEditing->setBoard(board);
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
    if (const auto unit = m_savedViews->restoreDesk(board)) {
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

void MainWindow::colourStackup() {
    std::vector<QColor> colours;
    for (const LayerAppearance& look : m_layerModel.effectiveStyles()) {
        colours.push_back(look.colour);
    }
    m_sections->setColours(colours);
    m_stackupPanel->view().setStyles(std::move(colours), m_layerModel.soloLayer());
}

void MainWindow::onRestacked(const std::shared_ptr<const model::Document>& document) {
    m_board->document = document;
    m_layerModel.setHeights(document);
    m_stackupModel.setDocument(document);
    m_stackupPanel->view().setStackup(document);
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
