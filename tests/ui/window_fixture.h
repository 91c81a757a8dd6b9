#pragma once

#include <QTemporaryDir>
#include <memory>

#include "ui/canvas/gpu_context.h"
#include "ui/shell/main_window.h"
#include "ui/workspace/settings.h"

/// A workbench window with a device and settings of its own, shown on the platform's display. Without Vulkan surfaces
/// (the offscreen platform) its canvas draws through memory.
class WindowFixture {
public:
    explicit WindowFixture(const ui::Loader::Work& work = ui::loadBoard);

    /// Loads and waits until the board is shown; false if that fails or takes too long.
    [[nodiscard]] bool openAndWait(const QString& path);
    /// A fresh window over the same settings, as in the next run of the program.
    void restart(const ui::Loader::Work& work = ui::loadBoard);

    [[nodiscard]] ui::MainWindow& window() { return *m_window; }
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
    std::unique_ptr<ui::MainWindow> m_window;
};

/// Pixels that differ visibly; all of them if the sizes differ.
[[nodiscard]] int differingPixels(const QImage& a, const QImage& b);

/// How much of a picture is not background, 0 to 1.
[[nodiscard]] double inkOf(const QImage& picture);
