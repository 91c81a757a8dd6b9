#include "ui/shell/workbench.h"

#include <unistd.h>

#include <QApplication>
#include <QIcon>
#include <QMessageBox>
#include <clocale>
#include <cstdio>
#include <cstdlib>

#include "ui/canvas/gpu_context.h"
#include "ui/common/display_units.h"
#include "ui/shell/card_calibration.h"
#include "ui/shell/main_window.h"

namespace ui {

namespace {

constexpr int kFailed = 3;
constexpr const char* kNoDisplay =
    "there is no display to show the window on; `copperscope render` and `copperscope info` need none";

QtMessageHandler s_handlerBefore = nullptr;

int fail(const std::string& reason) {
    std::fprintf(stderr, "copperscope: %s\n", reason.c_str());
    return kFailed;
}

/// Qt aborts where it cannot reach the display; what it said before is why.
void endWithoutDisplay(QtMsgType type, const QMessageLogContext& context, const QString& text) {
    if (type == QtFatalMsg) {
        std::_Exit(fail(kNoDisplay));
    }
    s_handlerBefore(type, context, text);
}

/// Did somebody start the program from the menu of a desktop? Who did sees no terminal.
bool isStartedFromMenu() {
    return !qEnvironmentVariableIsEmpty("XDG_CURRENT_DESKTOP") && ::isatty(STDERR_FILENO) == 0;
}

/// In a dialog too where nobody reads what is on stderr; scripts would wait for ever until it is closed.
int failVisibly(const std::string& reason) {
    const int code = fail(reason);
    if (isStartedFromMenu()) {
        QMessageBox::critical(nullptr, QGuiApplication::applicationName(), QString::fromStdString(reason));
    }
    return code;
}

/// Where none is named, one sentence is enough.
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
        return fail(kNoDisplay);
    }
    if (!options.device.empty()) {
        qputenv("COPPERSCOPE_DEVICE", QByteArray::fromStdString(options.device));
    }
    s_handlerBefore = qInstallMessageHandler(endWithoutDisplay);
    QApplication application(argc, argv);
    qInstallMessageHandler(s_handlerBefore);
    std::setlocale(LC_NUMERIC, "C");  // Qt has set the user's: numbers in files would have commas
    setNumberFormat();
    QApplication::setApplicationName(QStringLiteral("Copperscope"));
    QApplication::setApplicationVersion(QStringLiteral(COPPERSCOPE_VERSION));
    // The desktop file and icon of resources/desktop, where they are installed.
    QApplication::setDesktopFileName(QStringLiteral("org.copperscope.Copperscope"));
    QApplication::setWindowIcon(QIcon::fromTheme(QStringLiteral("copperscope")));
    base::Result<std::unique_ptr<GpuContext>> context = GpuContext::create();
    if (!context) {
        return failVisibly(context.error().text);
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
