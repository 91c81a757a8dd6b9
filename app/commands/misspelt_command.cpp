#include "app/commands/misspelt_command.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <filesystem>
#include <numeric>
#include <string_view>
#include <vector>

namespace app {

namespace {

namespace fs = std::filesystem;

/// How many letters are to be put in, taken out or replaced.
std::size_t editsBetween(std::string_view a, std::string_view b) {
    std::vector<std::size_t> edits(b.size() + 1);  // from the start of a to each start of b
    std::iota(edits.begin(), edits.end(), 0U);
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = edits[0]++;
        for (std::size_t k = 0; k < b.size(); ++k) {
            const std::size_t replaced = diagonal + (a[i] == b[k] ? 0 : 1);
            diagonal = edits[k + 1];
            edits[k + 1] = std::min({replaced, diagonal + 1, edits[k] + 1});
        }
    }
    return edits.back();
}

/// Empty if none is spelt like it.
std::string closestCommand(const CLI::App& parser, const std::string& word) {
    std::string closest;
    std::size_t least = word.size() / 3 + 2;  // so many edits make another word
    for (const CLI::App* command : parser.get_subcommands([](const CLI::App*) { return true; })) {
        if (const std::size_t edits = editsBetween(word, command->get_name()); edits < least) {
            least = edits;
            closest = command->get_name();
        }
    }
    return closest;
}

}  // namespace

std::optional<std::string> misspeltCommand(const CLI::App& parser) {
    const std::vector<std::string> words = parser.get_option("BOARD")->results();
    if (words.empty()) {
        return {};
    }
    const fs::path path = words.front();
    std::error_code error;
    if (path.has_extension() || path.has_parent_path() || fs::exists(path, error)) {
        return {};
    }
    const std::string closest = closestCommand(parser, words.front());
    return words.front() + " is neither a command nor a file that is there" +
           (closest.empty() ? "; copperscope --help lists the commands" : "; did you mean " + closest + '?');
}

}  // namespace app
