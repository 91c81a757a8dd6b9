#pragma once

#include <QMainWindow>
#include <memory>
#include <optional>

#include "ui/clearance/clearances.h"
#include "ui/layers/layer_model.h"
#include "ui/measure/measuring.h"
#include "ui/measure/saved_measurements.h"
#include "ui/messages/message_model.h"
#include "ui/nets/net_check_model.h"
#include "ui/nets/net_checker.h"
#include "ui/nets/net_model.h"
#include "ui/nets/net_style_editing.h"
#include "ui/nets/net_styles.h"
#include "ui/parts/part_picking.h"
#include "ui/saved_views/saved_views.h"
#include "ui/search/board_search.h"
#include "ui/section/sections.h"
#include "ui/shell/dialogs.h"
#include "ui/shell/drop_target.h"
#include "ui/shell/position_readout.h"
#include "ui/stackup/stackup_model.h"
#include "ui/stackup/thickness_editing.h"
#include "ui/statistics/drill_model.h"
#include "ui/statistics/statistics_model.h"
#include "ui/views/board_views.h"
#include "ui/views/element_outlines.h"
#include "ui/views/element_styles.h"
#include "ui/views/frame_display.h"
#include "ui/views/plan_painter.h"
#include "ui/views/probing.h"
#include "ui/views/section_plane_tool.h"
#include "ui/views/view_history.h"
#include "ui/workspace/actions.h"
#include "ui/workspace/loader.h"
#include "ui/workspace/selection_model.h"
#include "ui/workspace/settings.h"

class QStackedWidget;

namespace ui {

class Keyboard;
class LayersPanel;
class ElementPanel;
class MeasurementsPanel;
class MessageBar;
class MessagesPanel;
class NetCheckPanel;
class NetCommands;
class NetsPanel;
class RecentBoards;
class SearchBox;
class StackupPanel;
class StatisticsPanel;
class StatusLine;
class ViewCube;
class SavedViewsPanel;

/// The workbench: one board, its 3D view, and panels beside it. Boards are read in the background; the one on the
/// screen stays usable until the new one is ready, and stays for good if that fails.
class MainWindow : public QMainWindow {
    Q_OBJECT

public:
    /// `work` is what loads boards; tests put their own in.
    MainWindow(GpuContext& context, Settings& settings, const Loader::Work& work = loadBoard);

    ~MainWindow() override;

    /// Starts to load a file or folder; an empty step means the job's first one.
    void open(const std::filesystem::path& path, const std::string& step = {});
    void open(LoadRequest request) { m_loader.open(std::move(request)); }
    /// Writes what the canvas shows as PNG, `width` pixels wide (0: as on the screen); what goes wrong is shown in the
    /// message bar.
    void savePicture(const QString& path, int width = 0);
    /// Writes the stack as its name's ending says (.svg, .csv).
    void exportStackup(const QString& path);
    /// Writes all measurements as a table.
    void exportMeasurements(const QString& path);
    /// Back to the state of a first start, except for the board.
    void resetSettings();

    [[nodiscard]] const model::Document* document() const { return m_board ? m_board->document.get() : nullptr; }
    [[nodiscard]] BoardViews& views() { return *m_views; }
    [[nodiscard]] Loader& loader() { return m_loader; }
    [[nodiscard]] LayerModel& layers() { return m_layerModel; }
    [[nodiscard]] LayersPanel& layersPanel() { return *m_layersPanel; }
    [[nodiscard]] SelectionModel& selection() { return m_selection; }
    [[nodiscard]] NetsPanel& netsPanel() { return *m_netsPanel; }
    [[nodiscard]] NetModel& nets() { return m_netModel; }
    [[nodiscard]] NetStyles& netStyles() { return m_netStyles; }
    [[nodiscard]] Probing& probing() { return *m_probing; }
    [[nodiscard]] Clearances& clearances() { return *m_clearances; }
    [[nodiscard]] Sections& sections() { return *m_sections; }
    [[nodiscard]] ElementPanel& elementPanel() { return *m_elementPanel; }
    [[nodiscard]] MessagesPanel& messagesPanel() { return *m_messagesPanel; }
    [[nodiscard]] NetCheckPanel& netCheckPanel() { return *m_netCheckPanel; }
    [[nodiscard]] NetChecker& netChecker() { return m_netChecker; }
    [[nodiscard]] NetCheckModel& netCheck() { return m_netCheckModel; }
    [[nodiscard]] SearchBox& searchBox() { return *m_searchBox; }
    [[nodiscard]] StackupPanel& stackupPanel() { return *m_stackupPanel; }
    [[nodiscard]] StackupModel& stack() { return m_stackupModel; }
    [[nodiscard]] StatisticsPanel& statisticsPanel() { return *m_statisticsPanel; }
    [[nodiscard]] SavedViewsPanel& savedViewsPanel() { return *m_savedViewsPanel; }
    [[nodiscard]] ViewCube& viewCube() { return *m_viewCube; }
    [[nodiscard]] FrameDisplay& frameDisplay() { return *m_frameDisplay; }
    [[nodiscard]] SavedViews& savedViews() { return *m_savedViews; }
    [[nodiscard]] Measuring& measuring() { return *m_measuring; }
    [[nodiscard]] SavedMeasurements& measurements() { return *m_measurements; }
    [[nodiscard]] MeasurementsPanel& measurementsPanel() { return *m_measurementsPanel; }
    [[nodiscard]] MessageBar& messageBar() { return *m_messageBar; }
    [[nodiscard]] StatusLine& statusLine() { return *m_statusLine; }
    [[nodiscard]] ActionSet& actions() { return m_actions; }

protected:
    void closeEvent(QCloseEvent* event) override;

private:
    void createCentre();
    void createDocks();
    void createMenus();
    void createToolBar();
    /// The rest of this group is in main_window_commands.cpp.
    void connectCommands();
    template <class Slot>
    void on(ActionId id, Slot slot);
    void connectFileActions();
    void connectEditActions();
    void connectViewActions();
    void connectChoices();
    void connectSavedViews();
    void connectSolidActions();
    void connectLayerActions();
    void connectBoardActions();
    void connectClearances();  ///< this one and rules: main_window_clearances.cpp
    void connectRules();
    void connectSections();
    void connectStackupActions();
    void connectSelectActions();
    void connectFollowActions();
    void connectPlanActions();
    void connectMeasuring();  ///< in main_window_measuring.cpp
    void connectHelpActions();
    void connectLoader();
    void restoreSettings();  ///< this one and choices: main_window_choices.cpp

    [[nodiscard]] CameraController& active() { return m_views->active().controller(); }
    void requestBoardToOpen(BoardForm form);
    void openDropped(const QStringList& paths);

    void onStarted(const LoadRequest& request);
    void onLoaded(const LoadedBoard& board);
    void onFailed(const LoadRequest& request, const QString& reason);
    void onCancelled(const LoadRequest& request);
    void onWorking(const QString& what);
    void onIdle();
    void onRestacked(const std::shared_ptr<const model::Document>& document);
    void colourStackup();
    /// What of the session is not used.
    void showNotes(const std::vector<std::string>& notes);
    /// Shows what a message is about: its element lights up, its layer becomes visible.
    void goTo(const model::Diagnostic& message);
    void goTo(const NetCheckModel::Finding& finding);
    void goTo(const Found& found);
    void goToPart(const Found& found);
    void showLayer(model::LayerId layer);
    void checkNets();
    /// Brings the panel to the front.
    static void raise(QWidget& panel);
    void inferNets(bool isOn);
    /// Stops loading or checking; false when nothing is under way.
    bool cancelWork();
    void setTheme(Theme theme);
    void setBackend(render::Backend backend);
    void setArrangement(Arrangement arrangement);
    void updateContrast();
    void setUnit(LengthUnit unit);
    void setPalette(render::Palette palette);
    void copyPicture();

    GpuContext& m_context;
    Settings& m_settings;
    ActionSet m_actions;
    Loader m_loader;
    LayerModel m_layerModel;
    NetModel m_netModel;
    SelectionModel m_selection;
    NetStyles m_netStyles;
    NetCheckModel m_netCheckModel;
    NetChecker m_netChecker;
    StackupModel m_stackupModel;
    StatisticsModel m_statisticsModel;
    DrillModel m_drillModel;
    MessageModel m_messageModel;
    ThicknessEditing m_thicknesses;
    DropTarget m_dropTarget;

    std::optional<LoadedBoard> m_board;
    LengthUnit m_unit = LengthUnit::Millimetre;
    QByteArray m_defaultState;

    // Owned by the window as Qt children.
    BoardViews* m_views = nullptr;
    QStackedWidget* m_pages = nullptr;
    MessageBar* m_messageBar = nullptr;
    Probing* m_probing = nullptr;
    ElementStyles* m_elementStyles = nullptr;
    Clearances* m_clearances = nullptr;
    Sections* m_sections = nullptr;
    ElementOutlines* m_outlines = nullptr;
    std::unique_ptr<PlanPainter> m_planPainter;
    PositionReadout* m_positionReadout = nullptr;
    std::unique_ptr<SectionPlaneTool> m_sectionPlane;
    ViewCube* m_viewCube = nullptr;
    FrameDisplay* m_frameDisplay = nullptr;
    LayersPanel* m_layersPanel = nullptr;
    NetsPanel* m_netsPanel = nullptr;
    NetStyleEditing* m_netStyleEditing = nullptr;
    NetCommands* m_netCommands = nullptr;
    PartPicking* m_parts = nullptr;
    ElementPanel* m_elementPanel = nullptr;
    NetCheckPanel* m_netCheckPanel = nullptr;
    SearchBox* m_searchBox = nullptr;
    StackupPanel* m_stackupPanel = nullptr;
    StatisticsPanel* m_statisticsPanel = nullptr;
    MessagesPanel* m_messagesPanel = nullptr;
    SavedViewsPanel* m_savedViewsPanel = nullptr;
    SavedViews* m_savedViews = nullptr;
    MeasurementsPanel* m_measurementsPanel = nullptr;
    SavedMeasurements* m_measurements = nullptr;
    Measuring* m_measuring = nullptr;
    std::array<ViewHistory*, 2> m_viewHistories{};  ///< as BoardViews::both
    Keyboard* m_keyboard = nullptr;
    StatusLine* m_statusLine = nullptr;
    RecentBoards* m_recent = nullptr;
};

}  // namespace ui
