#pragma once

#include <cstdint>
#include <functional>
#include <limits>
#include <string>
#include <vector>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace app {

/// How the values of options are read, alike in all commands.
///
/// An option takes the one word behind it, and never the next one, which may be the board. A list is one word too, with
/// commas in it. No value is empty: an empty one is a variable of a script that was not set. Numbers are finite and
/// decimal. A file is not called "-", which others would take for stdin or stdout.

/// For a parser with all its commands and options, when all of them are there: holds every one to the above, but for
/// lists, whose entries are checked where they are made.
void checkValues(CLI::App& parser);

/// Before parsing: the error for an argument such as `--rules=`, which the parser would give the next word; else empty.
[[nodiscard]] std::string emptyAssignment(int argc, const char* const* argv);

/// What a list of names must be.
struct NameList {
    std::vector<std::string> choices{};  ///< each one of these; empty: any
    std::size_t count = 0;               ///< so many of them; 0: any number
};

/// An option whose value is names with commas between them, blanks around which do not count.
CLI::Option* addNames(CLI::App& command, const char* name, std::vector<std::string>& values, const char* help,
                      const NameList& form = {});

/// What a list of numbers must be.
struct NumberList {
    std::size_t count = 0;  ///< as NameList::count
    double least = std::numeric_limits<double>::lowest();
    double most = std::numeric_limits<double>::max();
};

/// An option whose value is numbers with commas between them. For double, float and int.
template <class Number>
CLI::Option* addNumbers(CLI::App& command, const char* name, std::vector<Number>& values, const char* help,
                        const NumberList& form = {});

/// An option that may be given several times, with one value each.
CLI::Option* addRepeated(CLI::App& command, const char* name, std::vector<std::string>& values, const char* help);

/// An option that is a number of bytes above 0, with K, M, G or T behind it for powers of 1024.
CLI::Option* addSize(CLI::App& command, const char* name, const char* help,
                     const std::function<void(std::uint64_t)>& take);

}  // namespace app
