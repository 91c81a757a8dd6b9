#include <spdlog/sinks/stdout_color_sinks.h>
#include <spdlog/spdlog.h>

#include "app/commands/command_line.h"

int main(int argc, char** argv) {
    spdlog::set_default_logger(spdlog::stderr_color_mt("copperscope"));  // data goes to stdout, talk to stderr
    return app::parseCommandLine(argc, argv)();
}
