#include "app/commands/option_values.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <string_view>

#include "model/base/ascii.h"

namespace app {

namespace {

constexpr const char* kEmpty = "the value is empty";

std::string trimmed(std::string_view text) {
    const std::size_t first = text.find_first_not_of(" \t");
    return first == std::string_view::npos ? std::string()
                                           : std::string(text.substr(first, text.find_last_not_of(" \t") - first + 1));
}

bool isDecimal(std::string_view digits) {
    return !digits.empty() && std::ranges::all_of(digits, base::isDigit);
}

/// Zeros that lead a number, which the parser would take for the sign of another base.
void dropLeadingZeros(std::string& text, std::size_t begin = 0) {
    while (begin + 1 < text.size() && text[begin] == '0' && isDecimal(text.substr(begin + 1, 1))) {
        text.erase(begin, 1);
    }
}

/// Why the text is no number that can be used; empty if it is one.
std::string errorOfNumber(std::string_view text, double& number) {
    const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
    const char* end = text.data() + text.size();
    const auto read = std::from_chars(begin, end, number);
    return read.ec == std::errc() && read.ptr == end && std::isfinite(number)
               ? std::string()
               : std::string(text) + " is no number that can be used";
}

std::string errorOfWholeNumber(std::string& text, bool maySink) {
    const std::size_t begin = maySink && text.starts_with('-') ? 1 : 0;
    if (!isDecimal(std::string_view(text).substr(begin))) {
        return text + " is no whole number" + (maySink ? "" : " from 0 up") + " in decimal digits";
    }
    dropLeadingZeros(text, begin);
    return {};
}

/// What stands behind the digits the parser checks.
std::string errorOfSize(std::string& text) {
    dropLeadingZeros(text);
    std::uint64_t number = 0;
    std::from_chars(text.data(), text.data() + text.size(), number);
    return number > 0 ? std::string() : text + " is no size above 0";
}

std::string errorOfFile(const std::string& text) {
    return text == "-" ? "takes a file, and - is not stdin or stdout; ./- is the file of that name" : "";
}

/// Of a value as it stands on the command line, by the kind that --help shows.
CLI::Validator validatorFor(const std::string& kind) {
    return {[kind](std::string& text) -> std::string {
                double number = 0.0;
                return text.empty()                ? kEmpty
                       : kind.starts_with("UINT")  ? errorOfWholeNumber(text, false)
                       : kind.starts_with("INT")   ? errorOfWholeNumber(text, true)
                       : kind.starts_with("FLOAT") ? errorOfNumber(text, number)
                       : kind.starts_with("SIZE")  ? errorOfSize(text)
                       : kind.starts_with("FILE")  ? errorOfFile(text)
                                                   : std::string();
            },
            ""};
}

/// What stands between the commas; so many, if that is not 0.
std::vector<std::string> entriesOf(const char* name, const std::string& text, std::size_t count) {
    std::vector<std::string> entries;
    for (std::size_t begin = 0; begin <= text.size();) {
        const std::size_t end = std::min(text.find(',', begin), text.size());
        entries.push_back(trimmed(std::string_view(text).substr(begin, end - begin)));
        if (entries.back().empty()) {
            throw CLI::ValidationError(name, "nothing stands before, behind or between commas in \"" + text + '"');
        }
        begin = end + 1;
    }
    if (count > 0 && entries.size() != count) {
        throw CLI::ValidationError(
            name, "takes " + std::to_string(count) + " values with commas between them, not \"" + text + '"');
    }
    return entries;
}

template <class Number>
Number numberFrom(const char* name, const std::string& text, const NumberList& form) {
    double number = 0.0;
    if (const std::string error = errorOfNumber(text, number); !error.empty()) {
        throw CLI::ValidationError(name, error);
    }
    if (number < form.least || number > form.most || (std::is_integral_v<Number> && number != std::floor(number))) {
        throw CLI::ValidationError(name, text + " is not one of the numbers that it takes");
    }
    return static_cast<Number>(number);
}

}  // namespace

void checkValues(CLI::App& parser) {
    for (CLI::Option* option : parser.get_options()) {
        if (option->get_items_expected_max() == 0) {
            continue;  // a flag
        }
        option->transform(validatorFor(option->get_type_name()));
        if (!option->get_positional()) {
            option->allow_extra_args(false);
        }
    }
    for (CLI::App* command : parser.get_subcommands([](const CLI::App*) { return true; })) {
        checkValues(*command);
    }
}

std::string emptyAssignment(int argc, const char* const* argv) {
    for (int i = 1; i < argc; ++i) {
        const std::string_view word = argv[i];
        if (word == "--") {
            break;
        }
        if (word.starts_with("--") && word.find('=') == word.size() - 1) {
            return std::string(word.substr(0, word.size() - 1)) + ": " + kEmpty;
        }
    }
    return {};
}

CLI::Option* addNames(CLI::App& command, const char* name, std::vector<std::string>& values, const char* help,
                      const NameList& form) {
    const std::vector<std::string>& choices = form.choices;
    const auto take = [name, &values, form](const std::string& text) {
        values = entriesOf(name, text, form.count);
        for (const std::string& value : values) {
            if (!form.choices.empty() && std::ranges::find(form.choices, value) == form.choices.end()) {
                throw CLI::ValidationError(name, value + " is none of " + CLI::detail::join(form.choices, ", "));
            }
        }
    };
    return command.add_option_function<std::string>(name, take, help)
        ->type_name(choices.empty() ? "LIST" : "LIST:{" + CLI::detail::join(choices, ",") + "}");
}

template <class Number>
CLI::Option* addNumbers(CLI::App& command, const char* name, std::vector<Number>& values, const char* help,
                        const NumberList& form) {
    const auto take = [name, &values, form](const std::string& text) {
        values.clear();
        for (const std::string& entry : entriesOf(name, text, form.count)) {
            values.push_back(numberFrom<Number>(name, entry, form));
        }
    };
    return command.add_option_function<std::string>(name, take, help)->type_name("LIST");
}

template CLI::Option* addNumbers(CLI::App&, const char*, std::vector<double>&, const char*, const NumberList&);
template CLI::Option* addNumbers(CLI::App&, const char*, std::vector<float>&, const char*, const NumberList&);
template CLI::Option* addNumbers(CLI::App&, const char*, std::vector<int>&, const char*, const NumberList&);

CLI::Option* addRepeated(CLI::App& command, const char* name, std::vector<std::string>& values, const char* help) {
    return command.add_option(name, values, std::string(help) + "; may be given several times")
        ->take_all()
        ->expected(1);
}

CLI::Option* addSize(CLI::App& command, const char* name, const char* help,
                     const std::function<void(std::uint64_t)>& take) {
    return command
        .add_option_function<std::uint64_t>(
            name, [take](const std::uint64_t& bytes) { take(bytes); }, help)
        ->transform(CLI::AsSizeValue(false))
        ->type_name("SIZE");
}

}  // namespace app
