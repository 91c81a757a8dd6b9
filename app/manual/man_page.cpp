#include "app/manual/man_page.h"

#include "model/base/ascii.h"

namespace app {

namespace {

/// As text that roff takes for nothing else.
std::string escaped(const std::string& text) {
    std::string out;
    for (const char c : text) {
        out += c == '\\' ? "\\e" : c == '-' ? "\\-" : std::string(1, c);
    }
    return out.starts_with('.') || out.starts_with('\'') ? "\\&" + out : out;
}

std::string bold(const std::string& text) {
    return "\\fB" + escaped(text) + "\\fR";
}

std::string italic(const std::string& text) {
    return "\\fI" + escaped(text) + "\\fR";
}

std::string section(const std::string& title) {
    return ".SH " + title + "\n";
}

std::string header(const std::string& page, const std::string& summary, const std::string& version) {
    return ".\\\" Made from the program's own --help.\n.TH " + base::upperCase(page) + " 1 \"\" \"Copperscope " +
           version + "\" \"Copperscope\"\n" + section("NAME") + escaped(page) + " \\- " + escaped(summary) + "\n";
}

std::string usageOf(const ManualOption& argument) {
    const std::string name = italic(argument.names.front()) + (argument.isRepeatable ? " ..." : "");
    return argument.isRequired ? name : "[" + name + "]";
}

/// "copperscope info [OPTION ...] [BOARD]"
std::string synopsis(const std::string& call, const ManualCommand& command) {
    std::string line = bold(call) + " [" + italic("OPTION") + " ...]";
    for (const ManualOption& option : command.options) {
        line += option.isRequired ? " " + bold(option.names.back()) + " " + italic(option.form) : "";
    }
    for (const ManualOption& argument : command.arguments) {
        line += " " + usageOf(argument);
    }
    return line + "\n";
}

std::string describe(const ManualOption& option) {
    std::string text = ".TP\n";
    for (const std::string& name : option.names) {
        const bool isArgument = !name.starts_with('-');
        text += (&name == &option.names.front() ? "" : ", ") + (isArgument ? italic(name) : bold(name));
    }
    text += option.form.empty() ? "\n" : " " + italic(option.form) + "\n";
    text += escaped(option.text) + "\n";
    if (!option.range.empty()) {
        text += "(" + escaped(option.range) + ")\n";
    }
    if (!option.standard.empty()) {
        text += "[" + escaped(option.standard) + "]\n";
    }
    return text;
}

std::string list(const char* title, const std::vector<ManualOption>& options) {
    std::string text = options.empty() ? std::string() : section(title);
    for (const ManualOption& option : options) {
        text += describe(option);
    }
    return text;
}

std::string commandList(const ManualCommand& program) {
    std::string text = section("COMMANDS");
    for (const ManualCommand& command : program.commands) {
        text += ".TP\n" + bold(command.name) + "\n" + escaped(command.summary) + "; see " +
                bold(program.name + "-" + command.name) + "(1)\n";
    }
    return text;
}

/// Beside the man pages, wherever that is (resources/desktop/install.cmake).
std::string files() {
    return section("FILES") + ".TP\n" + italic("share/copperscope/guide") +
           "\nthe guide with pictures that F1 opens in the window, as Markdown\n.TP\n" +
           italic("share/copperscope/sample") + "\nthe board that is opened where none is named\n";
}

std::string footer(const ManualCommand& program) {
    return section("NOTES") + escaped(program.footer) + "\n";
}

}  // namespace

std::string manPage(const ManualCommand& program, const std::string& version) {
    std::string text = header(program.name, program.summary, version) + section("SYNOPSIS") +
                       synopsis(program.name, program) + ".br\n" + bold(program.name) + " " + italic("COMMAND") + " [" +
                       italic("OPTION") + " ...] [" + italic("BOARD") + "]\n" + section("DESCRIPTION") +
                       "Without a command the board is opened in a window.\n" + commandList(program) +
                       list("ARGUMENTS", program.arguments) + list("OPTIONS", program.options) + files() +
                       footer(program) + section("SEE ALSO");
    for (const ManualCommand& command : program.commands) {
        text += bold(program.name + "-" + command.name) + "(1)" + (&command == &program.commands.back() ? "\n" : ",\n");
    }
    return text;
}

std::string manPage(const ManualCommand& program, const ManualCommand& command, const std::string& version) {
    return header(program.name + "-" + command.name, command.summary, version) + section("SYNOPSIS") +
           synopsis(program.name + " " + command.name, command) + list("ARGUMENTS", command.arguments) +
           list("OPTIONS", command.options) + footer(program) + section("SEE ALSO") + bold(program.name) + "(1)\n";
}

}  // namespace app
