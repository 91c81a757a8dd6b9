#include "app/manual/manual.h"

#include <CLI/CLI.hpp>
#include <sstream>

namespace app {

namespace {

/// "TEXT:{a,b}" has choices, "UINT:UINT in [1 - 9]" a range.
void readType(const std::string& type, ManualOption& option) {
    const std::size_t colon = type.find(':');
    option.form = type.substr(0, colon);
    option.value = option.form == "FILE" ? ValueKind::File : ValueKind::Free;
    const std::size_t brace = type.find('{');
    const std::size_t bracket = type.find('[');
    if (brace != std::string::npos) {
        option.value = ValueKind::Choice;
        std::istringstream list(type.substr(brace + 1, type.rfind('}') - brace - 1));
        for (std::string choice; std::getline(list, choice, ',');) {
            option.choices.push_back(choice);
        }
    } else if (bracket != std::string::npos) {
        option.range = type.substr(bracket + 1, type.rfind(']') - bracket - 1);
    }
}

ManualOption readOption(const CLI::Option& parsed) {
    ManualOption option;
    if (parsed.get_positional()) {
        option.names.push_back(parsed.get_name(true, false));
        option.value = ValueKind::File;  // all arguments are boards
    } else {
        for (const std::string& name : parsed.get_snames()) {
            option.names.push_back("-" + name);
        }
        for (const std::string& name : parsed.get_lnames()) {
            option.names.push_back("--" + name);
        }
        if (parsed.get_type_size() != 0) {
            readType(parsed.get_type_name(), option);
        }
    }
    option.standard = parsed.get_default_str();
    option.text = parsed.get_description();
    option.isRequired = parsed.get_required();
    option.isRepeatable =
        parsed.get_items_expected_max() > 1 || parsed.get_multi_option_policy() == CLI::MultiOptionPolicy::TakeAll;
    return option;
}

}  // namespace

ManualCommand readManual(const CLI::App& parser) {
    ManualCommand command{parser.get_name(), parser.get_description(), parser.get_footer(), {}, {}, {}};
    for (const CLI::Option* option : parser.get_options()) {
        (option->get_positional() ? command.arguments : command.options).push_back(readOption(*option));
    }
    for (const CLI::App* each : parser.get_subcommands({})) {
        command.commands.push_back(readManual(*each));
    }
    return command;
}

}  // namespace app
