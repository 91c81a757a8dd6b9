#include "app/commands/option_checks.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <vector>

#include "model/export/files/export_file.h"
#include "model/formats/board_forms.h"

namespace app {

namespace {

namespace fs = std::filesystem;

bool isWritten(const CLI::Option* option) {
    return option->check_lname("output") || option->check_lname("write-waivers") || option->check_lname("map");
}

bool isRead(const CLI::Option* option) {
    return !isWritten(option) && (option->get_positional() || option->get_type_name() == "FILE");
}

/// Waivers are added to a file of waivers, which is read before.
bool isAddedTo(const CLI::Option& out, const CLI::Option& in) {
    return out.check_lname("write-waivers") && in.check_lname("waivers");
}

/// What writing the file that an option names writes.
std::vector<fs::path> filesBy(const CLI::App& command, const std::string& written) {
    std::vector<fs::path> files{written};
    const fs::path other = command.get_name() == "export" ? model::otherFileOf(written) : fs::path();
    if (!other.empty()) {
        files.push_back(other);
    }
    return files;
}

std::string refusal(const CLI::Option& out, const fs::path& file, const std::string& written) {
    const std::string whose = file == written ? "" : ", which belongs to " + written + ",";
    return file.string() + whose + " is read, so it is not written over; name another file for " + out.get_name();
}

std::optional<std::string> overwrittenInput(const CLI::App& command) {
    for (const CLI::Option* out : command.get_options(isWritten)) {
        for (const CLI::Option* in : command.get_options(isRead)) {
            for (const std::string& written : out->results()) {
                for (const fs::path& file : filesBy(command, written)) {
                    const bool isRead = std::ranges::any_of(
                        in->results(), [&](const std::string& read) { return model::isReadFor(read, file); });
                    if (isRead && !isAddedTo(*out, *in)) {
                        return refusal(*out, file, written);
                    }
                }
            }
        }
    }
    return {};
}

/// What stands before the command is for the workbench.
std::optional<std::string> misplacedOption(const CLI::App& parser, const CLI::App& command) {
    for (const CLI::Option* option : parser.get_options()) {
        if (option->count() > 0) {
            const std::string what = option->get_positional() ? option->results().front() : option->get_name();
            return what + " stands before " + command.get_name() + ", which takes what stands behind it";
        }
    }
    return {};
}

struct Combination {
    const char* command;
    const char* option;
    std::vector<const char*> others;
};

/// The option does what the others would have no part in.
const std::vector<Combination>& exclusions() {
    static const std::vector<Combination> kRows = {
        {"info",
         "--print-layer-map",
         {"--step", "--set-thickness", "--no-session", "--save-session", "--chord", "--infer-nets", "--paper-segments",
          "--triangulator", "--json", "--check-nets"}},
        {"info", "--paper-segments", {"--chord"}},
        {"render", "--paper-segments", {"--chord"}},
        {"render", "--layers", {"--components"}},
        {"render",
         "--mono",
         {"--transparent", "--net", "--components", "--mask-colour", "--silkscreen-colour", "--finish"}},
        {"export", "--paper-segments", {"--chord"}},
        {"clearance",
         "--print",
         {"--step", "--infer-nets", "--worst", "--through", "--allow-incomplete", "--below", "--layer", "--nets",
          "--format", "--waivers", "--write-waivers", "BOARD", "--input-format", "--layer-map", "--max-unpacked"}},
        {"clearance", "--through", {"--layer", "--rules", "--map"}},
        {"clearance", "--map", {"--rules", "--below", "--nets", "--worst", "--format", "--output"}},
        {"clearance", "--write-waivers", {"--below", "--worst", "--format", "--output", "--allow-incomplete"}},
        {"bench", "--paper-segments", {"--chord"}},
        {"bench",
         "--triangulation",
         {"--pipeline", "--frames", "--lod", "--only-culled", "--components", "--step", "--infer-nets", "--chord",
          "--paper-segments", "--input-format", "--layer-map"}},
        {"bench",
         "--interactive",
         {"--pipeline", "--lod", "--only-culled", "--components", "--stages", "--triangulation", "--chord",
          "--paper-segments"}},
        {"bench",
         "--calibrate",
         {"BOARD", "--pipeline", "--lod", "--only-culled", "--components", "--stages", "--frames", "--triangulation",
          "--interactive", "--chord", "--paper-segments", "--step", "--infer-nets", "--input-format", "--layer-map",
          "--max-unpacked"}},
    };
    return kRows;
}

/// The option says how the others do what they do, and is nothing without them.
const std::vector<Combination>& needs() {
    static const std::vector<Combination> kRows = {
        {"clearance", "--tolerance", {"--rules"}},
        {"info", "--allow-incomplete", {"--check-nets"}},
        {"measure", "--allow-incomplete", {"--below"}},
    };
    return kRows;
}

}  // namespace

void limitCombinations(CLI::App& parser) {
    for (const Combination& row : exclusions()) {
        CLI::App& command = *parser.get_subcommand(row.command);
        for (const char* other : row.others) {
            command.get_option(row.option)->excludes(command.get_option(other));
        }
    }
    for (const Combination& row : needs()) {
        CLI::App& command = *parser.get_subcommand(row.command);
        for (const char* other : row.others) {
            command.get_option(row.option)->needs(command.get_option(other));
        }
    }
}

std::optional<std::string> unusableOption(const CLI::App& parser) {
    for (const CLI::App* command : parser.get_subcommands()) {
        if (auto why = misplacedOption(parser, *command)) {
            return why;
        }
        if (auto why = overwrittenInput(*command)) {
            return why;
        }
    }
    return {};
}

}  // namespace app
