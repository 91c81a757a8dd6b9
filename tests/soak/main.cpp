// Uses the window at random, stops its work at random moments, or opens and closes it: scripts/soak.sh,
// scripts/cycles.sh.

#include <QApplication>
#include <QCommandLineParser>
#include <clocale>
#include <cstdio>
#include <cstdlib>

#include "tests/locations.h"
#include "tests/soak/action_log.h"
#include "tests/soak/modes.h"

namespace {

struct Mode {
    const char* name;
    bool (*run)(const soak::Options& options);
};
constexpr Mode kModes[] = {
    {"use", soak::useAtRandom}, {"cancels", soak::cancelAtRandom}, {"cycles", soak::openAndClose}};

/// Complaints of Qt are bugs of ours, except those about what a platform cannot do.
void onMessage(QtMsgType type, const QMessageLogContext&, const QString& text) {
    const bool isOfPlatform = text.contains("This plugin does not support") || text.contains("propagateSizeHints");
    if (type == QtInfoMsg || type == QtDebugMsg || isOfPlatform) {
        return;
    }
    std::fprintf(stderr, "soak: Qt complains: %s\n", qPrintable(text));
    std::abort();
}

soak::Options optionsOf(const QCommandLineParser& parser) {
    soak::Options options;
    options.seed = parser.value("seed").toULongLong();
    options.seconds = parser.value("seconds").toDouble();
    options.count = parser.value("count").toULongLong();
    options.withFaults = parser.isSet("faults");
    options.mostStallMs = parser.value("stall-ms").toDouble();
    for (const QString& board : parser.positionalArguments().mid(1)) {
        options.boards.emplace_back(board.toStdString());
    }
    if (options.boards.empty()) {
        options.boards = {locations::kSample, std::filesystem::path(locations::kTestData) / "odb" / "everything"};
    }
    return options;
}

}  // namespace

int main(int argc, char** argv) {
    const QApplication application(argc, argv);
    std::setlocale(LC_NUMERIC, "C");
    qInstallMessageHandler(onMessage);
    QCommandLineParser parser;
    parser.addHelpOption();
    parser.addPositionalArgument("mode", "use, cancels or cycles");
    parser.addPositionalArgument("boards", "Boards; none: two that are bundled", "[boards...]");
    parser.addOptions({{"seed", "What is drawn follows from it.", "number", "1"},
                       {"seconds", "Random use lasts so long.", "number", "0"},
                       {"count", "So many steps, cancels or cycles.", "number", "0"},
                       {"faults", "Devices are lost and run out of memory."},
                       {"stall-ms", "A longer time without an answer is a failure.", "number", "0"}});
    parser.process(application);
    const QString name = parser.positionalArguments().value(0);
    for (const Mode& mode : kModes) {
        if (name == mode.name) {
            soak::ActionLog::instance().watchFailures(QCoreApplication::arguments().join(' ').toStdString());
            return mode.run(optionsOf(parser)) ? EXIT_SUCCESS : EXIT_FAILURE;
        }
    }
    parser.showHelp(EXIT_FAILURE);
}
