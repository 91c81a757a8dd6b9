#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include <csignal>
#include <new>

#include "app/commands/command_line.h"
#include "app/common/exit_code.h"
#include "app/common/interrupt.h"
#include "app/common/memory_limit.h"

int main(int argc, char** argv) {
    app::endWhereMemoryRunsOut();
    app::limitMemory(app::machineMemory());
    std::signal(SIGXFSZ, SIG_IGN);  // a limit of file size is an error of the write, as a full disk is
    try {
        spdlog::set_default_logger(spdlog::stderr_color_mt("copperscope"));  // data goes to stdout, talk to stderr
        return app::endAsInterrupted(app::endOutput(app::parseCommandLine(argc, argv)()));
    } catch (const std::bad_alloc&) {
        return app::failOutOfMemory();
    }
}
