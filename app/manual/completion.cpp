#include "app/manual/completion.h"

#include <functional>

namespace app {

namespace {

std::string joined(const std::vector<std::string>& words, const char* between) {
    std::string text;
    for (const std::string& word : words) {
        text += (text.empty() ? "" : between) + word;
    }
    return text;
}

std::vector<std::string> commandNames(const ManualCommand& program) {
    std::vector<std::string> names;
    for (const ManualCommand& command : program.commands) {
        names.push_back(command.name);
    }
    return names;
}

std::vector<std::string> optionNames(const ManualCommand& command) {
    std::vector<std::string> names;
    for (const ManualOption& option : command.options) {
        names.insert(names.end(), option.names.begin(), option.names.end());
    }
    return names;
}

// ---- bash ----

/// A row of `case $command:$previous in` for what follows the options of a command.
std::string bashValues(const std::string& command, const ManualOption& option) {
    std::vector<std::string> patterns;
    for (const std::string& name : option.names) {
        patterns.push_back(command + ":" + name);
    }
    const std::string row = "        " + joined(patterns, " | ") + ") ";
    switch (option.value) {
        case ValueKind::None: return {};
        case ValueKind::Free: return row + "return ;;\n";
        case ValueKind::File: return row + "_copperscope_files; return ;;\n";
        case ValueKind::Choice: return row + "_copperscope_words '" + joined(option.choices, " ") + "'; return ;;\n";
    }
    return {};
}

std::string bashRows(const ManualCommand& program,
                     const std::function<std::string(const std::string&, const ManualCommand&)>& row) {
    std::string text = row("", program);
    for (const ManualCommand& command : program.commands) {
        text += row(command.name, command);
    }
    return text;
}

std::string allBashValues(const ManualCommand& program) {
    return bashRows(program, [](const std::string& name, const ManualCommand& command) {
        std::string text;
        for (const ManualOption& option : command.options) {
            text += bashValues(name, option);
        }
        return text;
    });
}

std::string allBashOptions(const ManualCommand& program) {
    return bashRows(program, [](const std::string& name, const ManualCommand& command) {
        return "        -*:" + name + ") _copperscope_words '" + joined(optionNames(command), " ") + "' ;;\n";
    });
}

constexpr const char* kBashHelpers = R"(# Completion of copperscope for bash, made from its own --help.

_copperscope_words() {
    mapfile -t COMPREPLY < <(compgen -W "$1" -- "$current")
}

_copperscope_files() {
    mapfile -t -O "${#COMPREPLY[@]}" COMPREPLY < <(compgen -f -- "$current")
    compopt -o filenames 2>/dev/null
}

)";

// ---- zsh ----

/// Text in '[...]' of a specification, between single quotes.
std::string zshText(const std::string& text) {
    std::string out;
    for (const char c : text) {
        const bool isSpecial = c == '[' || c == ']' || c == ':' || c == '\\';
        out += c == '\'' ? "'\\''" : (isSpecial ? "\\" : "") + std::string(1, c);
    }
    return out;
}

std::string zshAction(const ManualOption& option) {
    switch (option.value) {
        case ValueKind::None: return {};
        case ValueKind::Free: return ":" + zshText(option.form) + ": ";
        case ValueKind::File: return ":" + zshText(option.form) + ":_files";
        case ValueKind::Choice: return ":" + zshText(option.form) + ":(" + joined(option.choices, " ") + ")";
    }
    return {};
}

/// '(-o --output)'{-o+,--output=}'[what it does]:FILE:_files'
std::string zshOption(const ManualOption& option) {
    std::vector<std::string> names;
    for (const std::string& name : option.names) {
        const bool isLong = name.starts_with("--");
        names.push_back(name + (option.value == ValueKind::None ? "" : isLong ? "=" : "+"));
    }
    const std::string spread = names.size() == 1 ? names.front() : "'{" + joined(names, ",") + "}'";
    const std::string before = option.isRepeatable ? "*" : "(" + joined(option.names, " ") + ")";
    return "            '" + before + spread + "[" + zshText(option.text) + "]" + zshAction(option) + "'";
}

std::string zshOptions(const ManualCommand& command) {
    std::string text;
    for (const ManualOption& option : command.options) {
        text += zshOption(option) + " \\\n";
    }
    return text;
}

std::string zshCommands(const ManualCommand& program) {
    std::string text = "    local -a commands=(\n";
    for (const ManualCommand& command : program.commands) {
        text += "        '" + command.name + ":" + zshText(command.summary) + "'\n";
    }
    return text + "    )\n";
}

}  // namespace

std::string bashCompletion(const ManualCommand& program) {
    return std::string(kBashHelpers) +
           "_copperscope() {\n"
           "    local current=${COMP_WORDS[COMP_CWORD]} previous=${COMP_WORDS[COMP_CWORD - 1]} command= i\n"
           "    COMPREPLY=()\n"
           "    # --option=value comes as three words\n"
           "    if [ \"$previous\" = = ]; then\n"
           "        previous=${COMP_WORDS[COMP_CWORD - 2]}\n"
           "    elif [ \"$current\" = = ]; then\n"
           "        current=\n"
           "    fi\n"
           "    for ((i = 1; i < COMP_CWORD; ++i)); do\n"
           "        case ${COMP_WORDS[i]} in\n"
           "            " +
           joined(commandNames(program), " | ") +
           ") command=${COMP_WORDS[i]}; break ;;\n"
           "        esac\n"
           "    done\n"
           "    case $command:$previous in\n" +
           allBashValues(program) +
           "    esac\n"
           "    case $current:$command in\n" +
           allBashOptions(program) + "        *:) _copperscope_words '" + joined(commandNames(program), " ") +
           "'; _copperscope_files ;;\n"
           "        *) _copperscope_files ;;\n"
           "    esac\n"
           "}\n"
           "complete -F _copperscope copperscope\n";
}

std::string zshCompletion(const ManualCommand& program) {
    std::string text =
        "#compdef copperscope\n# Completion of copperscope for zsh, made from its own --help.\n\n_copperscope() {\n"
        "    local curcontext=$curcontext state line\n    typeset -A opt_args\n" +
        zshCommands(program) + "    _arguments -C -A '-*' \\\n" + zshOptions(program) +
        "            '1: :->first' '*:: :->rest' && return\n"
        "    if [[ $state = first ]]; then\n"
        "        _describe -t commands command commands\n"
        "        _files\n"
        "        return\n"
        "    fi\n"
        "    case ${line[1]} in\n";
    for (const ManualCommand& command : program.commands) {
        text += "        " + command.name + ")\n            _arguments \\\n" + zshOptions(command) +
                "            '*:board:_files' ;;\n";
    }
    return text + "    esac\n}\n\n_copperscope \"$@\"\n";
}

}  // namespace app
