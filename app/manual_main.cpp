// copperscope_manual FOLDER: writes the man pages and completions that are installed with the program. Run by the
// build.
#include <cstdio>
#include <filesystem>
#include <fstream>

#include "app/commands/command_line.h"
#include "app/manual/completion.h"
#include "app/manual/man_page.h"
#include "app/manual/manual.h"

namespace {

namespace fs = std::filesystem;

bool write(const fs::path& path, const std::string& text) {
    std::ofstream file(path, std::ios::binary | std::ios::trunc);
    file << text;
    file.close();
    if (!file) {
        std::fprintf(stderr, "%s cannot be written\n", path.c_str());
    }
    return static_cast<bool>(file);
}

bool writeManual(const fs::path& folder, const app::ManualCommand& program) {
    bool isWritten = write(folder / "copperscope.1", app::manPage(program, COPPERSCOPE_VERSION)) &&
                     write(folder / "copperscope.bash", app::bashCompletion(program)) &&
                     write(folder / "_copperscope", app::zshCompletion(program));
    for (const app::ManualCommand& command : program.commands) {
        isWritten = isWritten && write(folder / (program.name + "-" + command.name + ".1"),
                                       app::manPage(program, command, COPPERSCOPE_VERSION));
    }
    return isWritten;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc != 2) {
        std::fprintf(stderr, "usage: copperscope_manual FOLDER\n");
        return 1;
    }
    std::error_code error;
    fs::create_directories(argv[1], error);
    app::Command chosen;
    const auto parser = app::makeCommandLine(argc, argv, chosen);
    return writeManual(argv[1], app::readManual(*parser)) ? 0 : 3;
}
