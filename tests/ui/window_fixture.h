#pragma once

#include <QDockWidget>
#include <QTemporaryDir>
#include <memory>

#include "ui/canvas/gpu_context.h"
#include "ui/clearance/clearance_feature.h"
#include "ui/common/table_view.h"
#include "ui/element/element_panel.h"
#include "ui/element/element_picture.h"
#include "ui/layers/layers_panel.h"
#include "ui/measure/measure_feature.h"
#include "ui/messages/message_model.h"
#include "ui/netlist_check/netlist_check_model.h"
#include "ui/nets/nets_panel.h"
#include "ui/saved_views/view_list_model.h"
#include "ui/search/search_box.h"
#include "ui/section/section_feature.h"
#include "ui/shell/main_window.h"
#include "ui/shell/message_bar.h"
#include "ui/stackup/stackup_model.h"
#include "ui/stackup/stackup_panel.h"
#include "ui/stackup/stackup_view.h"
#include "ui/statistics/histogram_view.h"
#include "ui/views/frame_display.h"
#include "ui/views/picture_saver.h"
#include "ui/views/view_cube.h"
#include "ui/views/view_history.h"
#include "ui/views/views_feature.h"
#include "ui/workspace/settings.h"

/// The window with its parts, found among its children by their type.
class TestWindow : public ui::MainWindow {
public:
    using ui::MainWindow::MainWindow;
    using ui::MainWindow::open;
    void open(const std::filesystem::path& path) { MainWindow::open({path}); }

    template <class Part>
    [[nodiscard]] Part& find() const {
        auto* part = findChild<Part*>();
        if (part == nullptr) {
            qFatal("the window has no %s", Part::staticMetaObject.className());
        }
        return *part;
    }
    /// Opens the panel of this dock in front of the others.
    void showPanel(const char* dock) const;
    /// A panel by the name of its dock, and the first table in it.
    [[nodiscard]] QWidget& panel(const char* dock) const { return *findChild<QDockWidget*>(dock)->widget(); }
    [[nodiscard]] ui::TableView& table(const char* dock) const { return *panel(dock).findChild<ui::TableView*>(); }
    [[nodiscard]] QString label(const char* name) const { return findChild<QLabel*>(name)->text(); }
    /// What the element panel says of the selected element; empty when there is no such line.
    [[nodiscard]] QString fact(const QString& name) const;
    [[nodiscard]] QString error() const { return messageBar().findChild<QLabel*>()->text(); }
    /// Triggers a command that saves a file, and names it in its dialog.
    void save(ui::ActionId id, const QString& path);
    /// In the dialog that asks for the name of a file to write. It is written when this returns.
    void nameFile(const QString& path);
    /// Waits until what was edited or exported is in its file, or it is said why not.
    void awaitFiles() const;
    /// As the commands that save pictures do: begins it. True from `awaitWork` once that and all other work is done.
    void savePicture(const QString& path, int width = 0) const;
    [[nodiscard]] bool awaitWork() const;

    [[nodiscard]] ui::Workspace& workspace() const { return find<ui::Workspace>(); }
    /// Null before the first board.
    [[nodiscard]] const model::Document* document() const {
        return workspace().board() != nullptr ? workspace().board()->document.get() : nullptr;
    }
    [[nodiscard]] ui::SelectionModel& selection() const { return workspace().selection(); }
    [[nodiscard]] ui::ActionSet& actions() const { return find<ui::ActionSet>(); }
    [[nodiscard]] ui::BoardViews& views() const { return find<ui::BoardViews>(); }
    [[nodiscard]] ui::Loader& loader() const { return find<ui::Loader>(); }
    [[nodiscard]] ui::LayerModel& layers() const { return find<ui::LayerModel>(); }
    [[nodiscard]] ui::NetStyles& netStyles() const { return find<ui::NetStyles>(); }
    [[nodiscard]] ui::Probing& probing() const { return find<ui::Probing>(); }
    [[nodiscard]] ui::ClearanceFeature& clearances() const { return find<ui::ClearanceFeature>(); }
    [[nodiscard]] ui::ElementPanel& elementPanel() const { return find<ui::ElementPanel>(); }
    [[nodiscard]] ui::FrameDisplay& frameDisplay() const { return find<ui::FrameDisplay>(); }
    [[nodiscard]] ui::LayersPanel& layersPanel() const { return find<ui::LayersPanel>(); }
    [[nodiscard]] ui::MeasureFeature& measuring() const { return find<ui::MeasureFeature>(); }
    [[nodiscard]] ui::MeasurementModel& measurements() const { return find<ui::MeasurementModel>(); }
    [[nodiscard]] ui::MessageBar& messageBar() const { return find<ui::MessageBar>(); }
    [[nodiscard]] ui::NetlistCheckModel& netCheck() const { return find<ui::NetlistCheckModel>(); }
    [[nodiscard]] ui::NetModel& nets() const { return find<ui::NetModel>(); }
    [[nodiscard]] ui::NetsPanel& netsPanel() const { return find<ui::NetsPanel>(); }
    [[nodiscard]] ui::ViewListModel& savedViews() const { return find<ui::ViewListModel>(); }
    [[nodiscard]] ui::SearchBox& searchBox() const { return find<ui::SearchBox>(); }
    [[nodiscard]] ui::SectionFeature& sections() const { return find<ui::SectionFeature>(); }
    [[nodiscard]] ui::StackupModel& stack() const { return find<ui::StackupModel>(); }
    [[nodiscard]] ui::StackupPanel& stackupPanel() const { return find<ui::StackupPanel>(); }
    [[nodiscard]] ui::ViewCube& viewCube() const { return find<ui::ViewCube>(); }
};

/// A workbench window with settings of its own, shown on the platform's display. Without Vulkan surfaces (the offscreen
/// platform) its canvas draws through memory. Windows of one process share a device, as they do in the program; one
/// that was lost is not handed on.
class WindowFixture {
public:
    explicit WindowFixture(const ui::Loader::Work& work = ui::loadBoard);

    /// Loads and waits until the board is shown; false if that fails or takes too long.
    [[nodiscard]] bool openAndWait(const QString& path);
    /// Waits until both views are at rest: no frame for half a second, and the device has nothing to do. False if they
    /// go on drawing.
    [[nodiscard]] bool awaitRest();
    /// A copy of tests/data/odb/<name> that the test may write to, in a folder of the fixture's own. Made once.
    [[nodiscard]] std::filesystem::path copyOfJob(const char* name) const;
    /// The same of the bundled sample: what a window saves lies beside the board, which others open at the same time.
    [[nodiscard]] QString copyOfSample() const;
    /// A fresh window over the same settings, as in the next run of the program.
    void restart(const ui::Loader::Work& work = ui::loadBoard);

    [[nodiscard]] TestWindow& window() { return *m_window; }
    [[nodiscard]] ui::Settings& settings() { return m_settings; }
    [[nodiscard]] ui::GpuContext& context() { return *m_context; }
    /// Errors the validation layer has reported since the window is there.
    [[nodiscard]] std::uint32_t validationErrors() const { return m_context->validationErrors() - m_errorsBefore; }
    [[nodiscard]] QString folder() const { return m_folder.path(); }
    /// The canvas drawn to memory.
    [[nodiscard]] QImage picture();
    /// What is on the screen where the canvas is.
    [[nodiscard]] QImage shown();
    /// Types one key on the canvas.
    void key(Qt::Key key, Qt::KeyboardModifiers modifiers = Qt::NoModifier);

private:
    QTemporaryDir m_folder;
    ui::Settings m_settings;
    std::shared_ptr<ui::GpuContext> m_context;
    std::uint32_t m_errorsBefore;  ///< of the validation layer, in the windows before
    std::unique_ptr<TestWindow> m_window;
};

/// Closes the window; how often the validation layer complained while it was there.
[[nodiscard]] std::uint32_t validationErrorsOnClosing(std::unique_ptr<WindowFixture>& fixture);

/// Pixels that differ visibly; all of them if the sizes differ.
[[nodiscard]] int differingPixels(const QImage& a, const QImage& b);

/// How much of a picture is not background, 0 to 1.
[[nodiscard]] double inkOf(const QImage& picture);
