#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What hostile input is thrown at: one row per parser, shared by the libFuzzer programs (scripts/fuzz.sh) and by the
/// test that feeds every truncated prefix. A new parser needs a row here and, if tests/data holds no file for it, a
/// seed below tests/fuzz/corpus/<name>/.
namespace fuzz {

struct Target {
    const char* name;
    void (*run)(std::string_view input);       ///< must come back from any input, within a second
    std::vector<std::string_view> fixtures{};  ///< names of files below tests/data/odb that this parser reads
    bool takesJobs = false;                    ///< its input is a whole job as `bundle` writes it
};

[[nodiscard]] std::span<const Target> targets();
/// nullptr if there is none of this name.
[[nodiscard]] const Target* findTarget(std::string_view name);

/// A file of a job in a bundle.
struct File {
    std::string path;
    std::string text;
};

/// Several files as one text: each begins with a line "=== path". The fuzzer can cut and swap files in it.
[[nodiscard]] std::string bundle(std::span<const File> files);
[[nodiscard]] std::vector<File> unbundle(std::string_view text);

/// Inputs to start from: the files of tests/data/odb that the target reads, its corpus, or the jobs as bundles; in the
/// order of their paths.
[[nodiscard]] std::vector<File> seedsOf(const Target& target);

}  // namespace fuzz
