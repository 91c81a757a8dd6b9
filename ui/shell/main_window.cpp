#include "ui/shell/main_window.h"

#include <QAbstractButton>
#include <QApplication>
#include <QCloseEvent>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QPushButton>
#include <QScreen>
#include <QStackedWidget>
#include <QStatusBar>
#include <QToolBar>
#include <QVBoxLayout>
#include <algorithm>

#include "model/formats/board_forms.h"
#include "ui/common/first_size.h"
#include "ui/common/paths.h"
#include "ui/shell/change_bar.h"
#include "ui/shell/device_notice.h"
#include "ui/shell/features.h"
#include "ui/shell/form_chooser.h"
#include "ui/shell/guide_window.h"
#include "ui/shell/help_dialogs.h"
#include "ui/shell/icons.h"
#include "ui/shell/keyboard.h"
#include "ui/shell/message_bar.h"
#include "ui/shell/recent_boards.h"
#include "ui/shell/status_bar.h"
#include "ui/shell/status_line.h"
#include "ui/shell/wheel_guard.h"
#include "ui/theme/theme.h"
#include "ui/views/height_controls.h"
#include "ui/workspace/board_watch.h"

namespace ui {

namespace {

/// Toolbar in order; Count stands for a separator.
constexpr ActionId kToolBar[] = {ActionId::OpenFile,       ActionId::Count,        ActionId::Fit,
                                 ActionId::ViewTop,        ActionId::ViewBottom,   ActionId::ViewIso,
                                 ActionId::Count,          ActionId::Orthographic, ActionId::Explode,
                                 ActionId::ShowComponents, ActionId::Count,        ActionId::SavePicture};

/// Submenus of View, in order.
constexpr MenuId kViewMenus[] = {MenuId::Solid, MenuId::Arrangement, MenuId::Uses, MenuId::Panels,
                                 MenuId::Theme, MenuId::Backend,     MenuId::Keys};
constexpr MenuId kMenus[] = {MenuId::File,  MenuId::Edit,    MenuId::View,   MenuId::Layers, MenuId::Nets,
                             MenuId::Board, MenuId::Measure, MenuId::Select, MenuId::Help};

QPushButton* buttonFor(QAction& action) {
    auto* button = new QPushButton(action.text());
    button->setToolTip(action.toolTip());
    QObject::connect(button, &QPushButton::clicked, &action, &QAction::trigger);
    return button;
}

QLabel* centredLabel(const QString& text) {
    auto* label = new QLabel(text);
    label->setAlignment(Qt::AlignCenter);
    return label;
}

/// What is in the middle of the window before a board is open: how to open one.
QWidget* startPage(const ActionSet& actions) {
    QLabel* title = centredLabel(QStringLiteral("Copperscope"));
    QFont large = title->font();
    large.setPointSizeF(large.pointSizeF() * 2.0);
    title->setFont(large);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch();
    buttons->addWidget(buttonFor(actions[ActionId::OpenFile]));
    buttons->addWidget(buttonFor(actions[ActionId::OpenFolder]));
    buttons->addWidget(buttonFor(actions[ActionId::ShowGuide]));
    buttons->addStretch();
    auto* page = new QWidget;
    auto* layout = new QVBoxLayout(page);
    layout->setSpacing(12);
    layout->addStretch();
    layout->addWidget(title);
    layout->addWidget(
        centredLabel(MainWindow::tr("Drop a board here, or open one: ODB++, IPC-2581, KiCad or Gerber,\n"
                                    "as a file, a folder or an archive.")));
    layout->addLayout(buttons);
    layout->addStretch();
    return page;
}

QStatusBar& createStatusBar(QMainWindow& window) {
    window.setStatusBar(new StatusBar);
    return *window.statusBar();
}

}  // namespace

MainWindow::MainWindow(GpuContext& context, Settings& settings, const Loader::Work& work)
    : m_settings(settings),
      m_workspace(work, this),
      m_actions(*this),
      m_layers(this),
      m_netStyles(this),
      m_parts(m_actions, m_workspace, this),
      m_views(new BoardViews(context)),
      m_probing(*m_views, m_workspace, m_netStyles, m_layers, this),
      m_plan(m_views->flat(), m_workspace, m_netStyles, this),
      m_position(m_probing, m_workspace, this),
      m_features{*this,       context, m_workspace, m_actions, m_settings, m_layers,
                 m_netStyles, m_parts, *m_views,    m_probing, m_plan,     m_position},
      m_pages(new QStackedWidget),
      m_messageBar(new MessageBar),
      m_changeBar(new ChangeBar),
      m_watch(new BoardWatch(this)),
      m_statusLine(new StatusLine(createStatusBar(*this))) {
    setObjectName(QStringLiteral("workbench"));
    resize(1280, 800);  // before the panels take their shares of it
    setWindowTitle(QStringLiteral("Copperscope"));
    m_statusLine->showDevice(context.device().caps());
    createCentre();
    addFeatures(m_features);
    m_keyboard = new Keyboard(*this, m_actions, *m_views);
    createToolBar();
    m_arrangements.emplace(*this, m_settings);
    createMenus();
    connectFiles();
    connectCommands();
    connectHelp();
    connectStatus();
    addChoices();
    restoreSettings();
    enableActions();
}

MainWindow::~MainWindow() {
    hide();          // an editor that is open commits while all it needs is still there
    delete m_views;  // its canvases must not draw with painters that are gone
}

void MainWindow::appear() {
    if (m_settings.windowGeometry().isEmpty()) {
        const FirstSize first = firstSize(size(), screen()->availableSize());
        resize(first.size);
        setWindowState(first.isMaximised ? Qt::WindowMaximized : Qt::WindowNoState);
    }
    show();
}

void MainWindow::createCentre() {
    m_pages->addWidget(startPage(m_actions));
    m_pages->addWidget(m_views);
    auto* centre = new QWidget;
    auto* layout = new QVBoxLayout(centre);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(new DeviceNotice(m_features.device.device().caps(), m_settings));
    layout->addWidget(m_messageBar);
    layout->addWidget(m_changeBar);
    layout->addWidget(m_pages, 1);
    setCentralWidget(centre);
    setAcceptDrops(true);
    installEventFilter(&m_dropTarget);
    new WheelGuard(this);
    for (BoardView* view : m_views->both()) {
        view->canvas().installEventFilter(&m_dropTarget);
    }
}

void MainWindow::createToolBar() {
    QToolBar* bar = addToolBar(tr("Toolbar"));
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
        if (id == ActionId::Explode) {
            bar->addWidget(new HeightControls(*m_views, m_workspace, m_actions));
        }
    }
    m_actions.adopt(ActionId::ShowToolBar, *bar->toggleViewAction());
}

void MainWindow::createMenus() {
    const auto addMenu = [this](auto& parent, MenuId id) {
        QMenu* menu = parent.addMenu(menuTitle(id));
        m_actions.fill(*menu, id);
        return menu;
    };
    QMenu* file = nullptr;
    for (const MenuId id : kMenus) {
        QMenu* menu = addMenu(*menuBar(), id);
        file = id == MenuId::File ? menu : file;
        if (id == MenuId::View) {
            menu->addSeparator();
            std::ranges::for_each(kViewMenus, [&](MenuId sub) { addMenu(*menu, sub); });
        }
    }
    auto* recent = new QMenu(tr("Open r&ecent"), this);
    file->insertMenu(&m_actions[ActionId::Reload], recent);
    auto* boards = new RecentBoards(m_settings, *recent, this);
    connect(boards, &RecentBoards::chosen, this, &MainWindow::openPath);
    connect(&m_workspace, &Workspace::boardOpened, boards,
            [boards](const LoadedBoard& board) { boards->add(fromPath(board.request.path)); });
}

void MainWindow::connectFiles() {
    const auto choose = [this](const QString& title, FeatureContext::BoardPath kind) {
        m_nextBoard = &m_features.openBoardPath(title, kind, [this](const QString& path) { openPath(path); });
    };
    m_features.on(ActionId::OpenFile, [choose] { choose(tr("Open a board"), FeatureContext::BoardPath::File); });
    m_features.on(ActionId::OpenFolder,
                  [choose] { choose(tr("Open a board folder"), FeatureContext::BoardPath::Folder); });
    m_features.on(ActionId::Reload, [this] { m_workspace.reload(); });
    m_features.on(ActionId::CancelLoading, [this] { m_workspace.cancelWork(); });
    m_features.on(ActionId::Quit, [this] { close(); });
    connect(&m_dropTarget, &DropTarget::dropped, this, [this](const QStringList& paths) { openDropped(paths); });
    connect(m_statusLine, &StatusLine::stepChosen, this, [this](const QString& step) {
        if (m_workspace.isOpen(step.toStdString())) {
            m_workspace.cancelLoading();  // of another one
            return;                       // reading it again would empty the list of what can be undone
        }
        m_workspace.reload([&step](model::OpenRequest& request) { request.step = step.toStdString(); });
    });
    connect(&m_workspace, &Workspace::formsFound, this, &MainWindow::chooseForm);
    connect(&m_workspace, &Workspace::openingBegan, m_watch, &BoardWatch::begin);
    connect(&m_workspace, &Workspace::boardOpened, m_watch,
            [this](const LoadedBoard& board) { m_watch->watch(board.request); });
    connect(m_watch, &BoardWatch::changed, this, &MainWindow::onFilesChanged);
    connect(m_changeBar, &ChangeBar::reloadRequested, this, [this] { m_workspace.reload(); });
    connect(&m_workspace, &Workspace::boardLeaves, this, &MainWindow::closeWhatIsAboutTheBoard);
    connect(&m_workspace, &Workspace::boardRead, m_changeBar, &QWidget::hide);
    connect(&m_workspace, &Workspace::boardRead, m_messageBar, &QWidget::hide);
    connect(&m_workspace, &Workspace::boardOpened, this, &MainWindow::onOpened);
}

void MainWindow::open(model::OpenRequest request) {
    request.onlyAsks = true;
    m_workspace.open(std::move(request));
}

void MainWindow::openPath(const QString& path) {
    open({.path = toPath(path)});
}

void MainWindow::openDropped(const QStringList& paths) {
    std::vector<std::filesystem::path> files;
    std::ranges::transform(paths, std::back_inserter(files), toPath);
    const std::filesystem::path job = model::jobOfFiles(files);
    open({.path = job.empty() ? files.front() : job});
    if (!job.empty()) {
        m_workspace.report(tr("These are files of one job: opening their folder %1").arg(displayName(job)));
    } else if (paths.size() > 1) {
        m_workspace.report(tr("One board at a time: opening the first of %1").arg(paths.size()));
    }
}

void MainWindow::chooseForm(const model::OpenRequest& request, const std::vector<model::BoardForm>& forms) {
    auto* chooser = new FormChooser(request.path, forms, this);
    chooser->setAttribute(Qt::WA_DeleteOnClose);
    connect(chooser, &FormChooser::chosen, this,
            [this, request](const model::BoardForm& form) { m_workspace.open(model::requestOf(request, form)); });
    connect(&m_workspace, &Workspace::openingBegan, chooser, &QDialog::close);
    chooser->open();
}

/// Menus and dialogs hold what was chosen on it, ids above all.
void MainWindow::closeWhatIsAboutTheBoard() {
    while (auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget())) {
        menu->close();
    }
    for (QDialog* dialog : findChildren<QDialog*>()) {
        if (dialog->isVisible() && dialog->isModal() && dialog != m_nextBoard) {
            dialog->reject();
        }
    }
}

void MainWindow::onFilesChanged() {
    const bool isAtWork = m_workspace.isWorking() || QApplication::activeModalWidget() != nullptr ||
                          QApplication::activePopupWidget() != nullptr;
    if (m_workspace.board()->format == "kicad" && !isAtWork) {
        m_workspace.reload();  // its board is looked at here while it is edited there
    } else {
        m_changeBar->show();
    }
}

void MainWindow::connectHistory() {
    QUndoStack& history = m_workspace.history();
    const auto connectWay = [&](ActionId id, auto go, auto text, auto textChanged, auto isPossible,
                                const QString& done) {
        QAction& action = m_actions[id];
        action.setEnabled(false);
        m_features.on(id, &history, [this, &history, go, text, done] {
            const QString what = (history.*text)();
            (history.*go)();
            m_workspace.report(done.arg(what));  // it may be out of sight
        });
        connect(&history, isPossible, &action, &QAction::setEnabled);
        connect(&history, textChanged, &action, [&action, name = action.text()](QString what) {
            action.setText(what.isEmpty() ? name : name + QLatin1Char(' ') + what.replace('&', QLatin1String("&&")));
        });
    };
    connectWay(ActionId::Undo, &QUndoStack::undo, &QUndoStack::undoText, &QUndoStack::undoTextChanged,
               &QUndoStack::canUndoChanged, tr("Undone: %1"));
    connectWay(ActionId::Redo, &QUndoStack::redo, &QUndoStack::redoText, &QUndoStack::redoTextChanged,
               &QUndoStack::canRedoChanged, tr("Redone: %1"));
}

void MainWindow::connectCommands() {
    connectHistory();
    m_features.on(ActionId::ClearSelection, [this] { escape(); });
    m_features.on(ActionId::NextUnit, [this] {
        const LengthUnit unit = nextUnit(m_workspace.unit());
        m_settings.choose(unit);
        m_workspace.setUnit(unit);
    });
}

void MainWindow::escape() {
    if (!m_workspace.cancelWork() && !m_keyboard->returnToView() &&
        std::ranges::none_of(m_features.escapes, [](const auto& ranked) { return ranked.second(); }) &&
        !m_messageBar->end()) {
        m_workspace.selection().clearStep();
    }
}

void MainWindow::connectHelp() {
    m_features.on(ActionId::ShowGuide, [this] { showGuide(*this); });
    m_features.on(ActionId::ShowKeys, [this] { showKeyList(*this, m_actions.keys()); });
    m_features.on(ActionId::About, [this] { showAbout(*this); });
    m_features.on(ActionId::ResetSettings, [this] {
        auto* question =
            new QMessageBox(QMessageBox::Question, tr("Reset settings"),
                            tr("Reset panels, theme, back end, what the views show and the list of recent boards?"),
                            QMessageBox::Reset | QMessageBox::Cancel, this);
        question->setAttribute(Qt::WA_DeleteOnClose);
        connect(question, &QMessageBox::buttonClicked, this, [this, question](QAbstractButton* button) {
            if (question->standardButton(button) == QMessageBox::Reset) {
                resetSettings();
            }
        });
        question->open();
    });
}

void MainWindow::connectStatus() {
    connect(&m_workspace, &Workspace::reported, m_statusLine, &StatusLine::say);
    connect(&m_workspace, &Workspace::errorReported, m_messageBar, &MessageBar::showError);
    connect(&m_workspace, &Workspace::errorReported, this,
            [this] { m_actions[ActionId::ClearSelection].setEnabled(true); });
    connect(&m_workspace.history(), &QUndoStack::indexChanged, this, [this](int index) {
        if (index > 0) {  // 0: emptied, with another board
            m_messageBar->endEarlierError();
        }
    });
    connect(&m_workspace, &Workspace::workBegan, m_statusLine, &StatusLine::beginWork);
    connect(&m_workspace, &Workspace::workBegan, this, [this] {
        m_actions[ActionId::CancelLoading].setEnabled(true);
        m_actions[ActionId::ClearSelection].setEnabled(true);
    });
    connect(&m_workspace, &Workspace::workProgressed, m_statusLine, &StatusLine::showProgress);
    connect(&m_workspace, &Workspace::idle, m_statusLine, &StatusLine::endWork);
    connect(&m_workspace, &Workspace::idle, this, &MainWindow::enableActions);
    connect(m_statusLine, &StatusLine::cancelRequested, &m_workspace, &Workspace::cancelWork);
    connect(m_views, &BoardViews::timed, m_statusLine, &StatusLine::showFrame);
    connect(&m_position, &PositionReadout::changed, m_statusLine, &StatusLine::showPosition);
}

void MainWindow::onOpened(const LoadedBoard& board) {
    m_pages->setCurrentWidget(m_views);
    enableActions();  // where a file is still being written, nothing is idle
    const QString member = QString::fromStdString(board.request.member);
    const QString name = displayName(board.request.path);
    setWindowTitle(QStringLiteral("%1 – Copperscope").arg(member.isEmpty() ? name : tr("%1: %2").arg(name, member)));
}

void MainWindow::enableActions() {
    m_actions.enable(m_workspace.board() != nullptr);
    m_actions[ActionId::CancelLoading].setEnabled(m_workspace.isWorking());
    if (m_workspace.isWorking() || !m_messageBar->isHidden()) {
        m_actions[ActionId::ClearSelection].setEnabled(true);  // there is something to end, also without a board
    }
    if (m_workspace.board() != nullptr) {
        m_statusLine->showSteps(m_workspace.board()->document->job);  // also undoes a choice that was not loaded
    }
}

void MainWindow::addChoices() {
    m_features.addChoice<Theme>({{ActionId::ThemeSystem, Theme::System},
                                 {ActionId::ThemeDark, Theme::Dark},
                                 {ActionId::ThemeLight, Theme::Light}},
                                applyTheme);
    m_features.addChoice<KeyPreset>({{ActionId::KeysCopperscope, KeyPreset::Copperscope},
                                     {ActionId::KeysKiCad, KeyPreset::KiCad},
                                     {ActionId::KeysAltium, KeyPreset::Altium},
                                     {ActionId::KeysAllegro, KeyPreset::Allegro},
                                     {ActionId::KeysKLayout, KeyPreset::KLayout}},
                                    [this](KeyPreset preset) { m_keyboard->setPreset(preset); });
    m_features.addChoice<Use>({{ActionId::UseGeneral, Use::General},
                               {ActionId::UseStackup, Use::Stackup},
                               {ActionId::UseNets, Use::Nets},
                               {ActionId::UseClearance, Use::Clearance}},
                              [this](Use use) { m_arrangements->show(use); });
    m_features.on(ActionId::RestorePanels, [this] { m_arrangements->restoreDefault(); });
    m_features.keepSwitches();
    m_features.restorers.emplace_back([this] { m_workspace.setUnit(m_settings.choice<LengthUnit>()); });
}

void MainWindow::restoreSettings() {
    restoreGeometry(m_settings.windowGeometry());
    std::ranges::for_each(m_features.restorers, [](const auto& restore) { restore(); });
    statusBar()->clearMessage();
    if (!m_settings.areKept()) {
        m_workspace.report(tr("Settings cannot be saved: %1 cannot be written").arg(m_settings.path()));
    }
}

void MainWindow::resetSettings() {
    m_settings.reset();
    m_arrangements->discard();
    std::ranges::for_each(m_features.restorers, [](const auto& restore) { restore(); });
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (const QString file = m_workspace.fileAtWork(); !file.isEmpty() && !m_mayStopWriting) {
        event->ignore();
        askBeforeClosing(file);
        return;
    }
    if (!m_workspace.files().finish()) {
        event->ignore();  // the message bar says what would be lost; closed again, it is
        return;
    }
    m_workspace.cancelLoading();
    m_settings.setWindowGeometry(saveGeometry());
    m_arrangements->save();
    event->accept();
}

void MainWindow::askBeforeClosing(const QString& file) {
    auto* question = new QMessageBox(QMessageBox::Question, tr("Close"),
                                     tr("%1 is still being written. Stop it and close the window?").arg(file),
                                     QMessageBox::Close | QMessageBox::Cancel, this);
    question->setAttribute(Qt::WA_DeleteOnClose);
    question->setTextFormat(Qt::PlainText);
    question->setDefaultButton(QMessageBox::Cancel);
    connect(&m_workspace, &Workspace::idle, question, &QDialog::reject);  // written, or not: the status bar says it
    connect(question, &QMessageBox::buttonClicked, this, [this, question](QAbstractButton* button) {
        if (question->standardButton(button) == QMessageBox::Close) {
            m_mayStopWriting = true;
            close();
        }
    });
    question->open();
}

}  // namespace ui
