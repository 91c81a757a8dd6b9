#pragma once

#include <QMainWindow>

#include "ui/layers/layer_model.h"
#include "ui/nets/net_styles.h"
#include "ui/parts/part_picking.h"
#include "ui/shell/drop_target.h"
#include "ui/shell/panel_arrangements.h"
#include "ui/views/board_views.h"
#include "ui/views/plan_painter.h"
#include "ui/views/position_readout.h"
#include "ui/views/probing.h"
#include "ui/workspace/feature.h"

class QStackedWidget;

namespace ui {

class BoardWatch;
class ChangeBar;
class Keyboard;
class MessageBar;
class StatusLine;

/// The workbench: a workspace, the views of its board, and around them the features (ui/shell/features.cpp), each with
/// its panel and commands. What belongs to no feature is here: menus, files, undo, settings, status.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    /// `work` is what loads boards; tests put their own in.
    MainWindow(GpuContext& context, Settings& settings, const Loader::Work& work = loadBoard);
    ~MainWindow() override;

    /// Shows the window as it was left; the first time with all of its frame on the screen.
    void appear();
    /// Starts to load a board. Where a folder or archive holds several forms, the user chooses one first.
    void open(model::OpenRequest request);
    /// Back to the state of a first start, except for the board.
    void resetSettings();

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    void createCentre();
    void createToolBar();
    void createMenus();
    void connectFiles();
    void connectHistory();
    void connectCommands();
    void connectHelp();
    void connectStatus();
    void addChoices();
    void restoreSettings();

    void escape();
    void openPath(const QString& path);
    void openDropped(const QStringList& paths);
    void chooseForm(const model::OpenRequest& request, const std::vector<model::BoardForm>& forms);
    void closeWhatIsAboutTheBoard();
    void onFilesChanged();
    void onOpened(const LoadedBoard& board);
    void enableActions();
    void askBeforeClosing(const QString& file);

    Settings& m_settings;
    Workspace m_workspace;
    ActionSet m_actions;
    LayerModel m_layers;
    NetStyles m_netStyles;
    PartPicking m_parts;
    BoardViews* m_views;
    Probing m_probing;
    PlanPainter m_plan;
    PositionReadout m_position;
    FeatureContext m_features;
    DropTarget m_dropTarget;
    QStackedWidget* m_pages;  // owned by the window, as the rest
    MessageBar* m_messageBar;
    ChangeBar* m_changeBar;
    BoardWatch* m_watch;
    StatusLine* m_statusLine;
    Keyboard* m_keyboard = nullptr;
    QPointer<QDialog> m_nextBoard;                    ///< in which another one is chosen
    bool m_mayStopWriting = false;                    ///< the user said so
    std::optional<PanelArrangements> m_arrangements;  ///< once the panels are there
};

}  // namespace ui
