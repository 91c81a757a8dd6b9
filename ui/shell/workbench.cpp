#include "ui/shell/workbench.h"

#include <QApplication>
#include <QIcon>
#include <clocale>
#include <cstdio>

#include "ui/canvas/gpu_context.h"
#include "ui/shell/card_calibration.h"
#include "ui/shell/main_window.h"

namespace ui {

namespace {

constexpr int kFailed = 3;

int fail(const std::string& reason) {
    std::fprintf(stderr, "copperscope: %s\n", reason.c_str());
    return kFailed;
}

/// Qt ends the program when it finds no display; ask first.
bool hasDisplay() {
#if defined(Q_OS_UNIX) && !defined(Q_OS_DARWIN)
    return !qEnvironmentVariableIsEmpty("DISPLAY") || !qEnvironmentVariableIsEmpty("WAYLAND_DISPLAY") ||
           !qEnvironmentVariableIsEmpty("QT_QPA_PLATFORM");
#else
    return true;
#endif
}

}  // namespace

int runWorkbench(int argc, char** argv, const StartOptions& options) {
    if (!hasDisplay()) {
        return fail("there is no display to show the window on; `copperscope render` and `copperscope info` need none");
    }
    if (!options.device.empty()) {
        qputenv("COPPERSCOPE_DEVICE", QByteArray::fromStdString(options.device));
    }
    QApplication application(argc, argv);
    std::setlocale(LC_NUMERIC, "C");  // Qt has set the user's: numbers in files would have commas
    QApplication::setApplicationName(QStringLiteral("Copperscope"));
    QApplication::setApplicationVersion(QStringLiteral(COPPERSCOPE_VERSION));
    // The desktop file and icon of resources/desktop, where they are installed.
    QApplication::setDesktopFileName(QStringLiteral("org.copperscope.Copperscope"));
    QApplication::setWindowIcon(QIcon::fromTheme(QStringLiteral("copperscope")));
    base::Result<std::unique_ptr<GpuContext>> context = GpuContext::create();
    if (!context) {
        return fail(context.error().text);
    }
    const CardCalibration calibration((*context)->device().caps());
    Settings settings;
    MainWindow window(**context, settings);
    window.appear();
    if (options.board) {
        window.open(*options.board);
    }
    return QApplication::exec();
}

}  // namespace ui
