#pragma once

#include <QTemporaryDir>
#include <memory>

#include "ui/canvas/gpu_context.h"
#include "ui/shell/main_window.h"
#include "ui/workspace/settings.h"

namespace ui {
class Clearances;
class ElementPanel;
class FrameDisplay;
class LayersPanel;
class Measuring;
class MeasurementsPanel;
class MessagesPanel;
class NetCheckModel;
class NetCheckPanel;
class NetModel;
class NetsPanel;
class SavedMeasurements;
class SavedViewsPanel;
class SearchBox;
class Sections;
class StackupModel;
class StackupPanel;
class StatisticsPanel;
class ViewCube;
class ViewListModel;
}  // namespace ui

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
    /// Triggers a command that saves a file, and names it in its dialog.
    void save(ui::ActionId id, const QString& path);
    /// As the commands that save pictures do.
    void savePicture(const QString& path, int width = 0);

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
    [[nodiscard]] ui::Clearances& clearances() const;
    [[nodiscard]] ui::ElementPanel& elementPanel() const;
    [[nodiscard]] ui::FrameDisplay& frameDisplay() const;
    [[nodiscard]] ui::LayersPanel& layersPanel() const;
    [[nodiscard]] ui::Measuring& measuring() const;
    [[nodiscard]] ui::SavedMeasurements& measurements() const;
    [[nodiscard]] ui::MeasurementsPanel& measurementsPanel() const;
    [[nodiscard]] ui::MessageBar& messageBar() const;
    [[nodiscard]] ui::MessagesPanel& messagesPanel() const;
    [[nodiscard]] ui::NetCheckModel& netCheck() const;
    [[nodiscard]] ui::NetCheckPanel& netCheckPanel() const;
    [[nodiscard]] ui::NetModel& nets() const;
    [[nodiscard]] ui::NetsPanel& netsPanel() const;
    [[nodiscard]] ui::ViewListModel& savedViews() const;
    [[nodiscard]] ui::SavedViewsPanel& savedViewsPanel() const;
    [[nodiscard]] ui::SearchBox& searchBox() const;
    [[nodiscard]] ui::Sections& sections() const;
    [[nodiscard]] ui::StackupModel& stack() const;
    [[nodiscard]] ui::StackupPanel& stackupPanel() const;
    [[nodiscard]] ui::StatisticsPanel& statisticsPanel() const;
    [[nodiscard]] ui::StatusLine& statusLine() const;
    [[nodiscard]] ui::ViewCube& viewCube() const;
};

/// A workbench window with a device and settings of its own, shown on the platform's display. Without Vulkan surfaces
/// (the offscreen platform) its canvas draws through memory.
class WindowFixture {
public:
    explicit WindowFixture(const ui::Loader::Work& work = ui::loadBoard);

    /// Loads and waits until the board is shown; false if that fails or takes too long.
    [[nodiscard]] bool openAndWait(const QString& path);
    /// A fresh window over the same settings, as in the next run of the program.
    void restart(const ui::Loader::Work& work = ui::loadBoard);

    [[nodiscard]] TestWindow& window() { return *m_window; }
    [[nodiscard]] ui::Settings& settings() { return m_settings; }
    [[nodiscard]] ui::GpuContext& context() { return *m_context; }
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
    std::unique_ptr<ui::GpuContext> m_context;
    std::unique_ptr<TestWindow> m_window;
};

/// Pixels that differ visibly; all of them if the sizes differ.
[[nodiscard]] int differingPixels(const QImage& a, const QImage& b);

/// How much of a picture is not background, 0 to 1.
[[nodiscard]] double inkOf(const QImage& picture);
