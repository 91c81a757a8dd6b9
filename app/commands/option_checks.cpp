#include "app/commands/option_checks.h"

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <vector>

namespace app {

namespace {

namespace fs = std::filesystem;

bool isWritten(const CLI::Option* option) {
    return option->check_lname("output") || option->check_lname("write-waivers");
}

bool isRead(const CLI::Option* option) {
    return !isWritten(option) && (option->get_positional() || option->get_type_name() == "FILE");
}

/// Waivers are added to a file of waivers, which is read before.
bool isAddedTo(const CLI::Option& out, const CLI::Option& in) {
    return out.check_lname("write-waivers") && in.check_lname("waivers");
}

bool isSameFile(const std::string& a, const std::string& b) {
    std::error_code error;
    return fs::equivalent(fs::path(a), fs::path(b), error) && !error;
}

std::optional<std::string> overwrittenInput(const CLI::App& command) {
    for (const CLI::Option* out : command.get_options(isWritten)) {
        for (const CLI::Option* in : command.get_options(isRead)) {
            for (const std::string& written : out->results()) {
                for (const std::string& read : in->results()) {
                    if (!isAddedTo(*out, *in) && isSameFile(written, read)) {
                        return written + " is read, so it is not written over; name another file for " +
                               out->get_name();
                    }
                }
            }
        }
    }
    return {};
}

std::optional<std::string> endlessNumber(const CLI::App& command) {
    for (const CLI::Option* option : command.get_options()) {
        if (option->get_type_name().find("FLOAT") == std::string::npos) {
            continue;
        }
        for (const std::string& text : option->results()) {
            double number = 0.0;
            const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
            if (read.ec == std::errc() && !std::isfinite(number)) {
                return option->get_name() + ": " + text + " is no number that can be used";
            }
        }
    }
    return {};
}

}  // namespace

std::optional<std::string> unusableOption(const CLI::App& parser) {
    for (const CLI::App* command : parser.get_subcommands()) {
        if (auto why = overwrittenInput(*command)) {
            return why;
        }
        if (auto why = endlessNumber(*command)) {
            return why;
        }
    }
    return {};
}

}  // namespace app
