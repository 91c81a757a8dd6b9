#pragma once

#include <algorithm>
#include <span>
#include <string>
#include <string_view>
#include <vector>

/// What hostile input is thrown at: one row per reader and per kind of file that a user can hand in, shared by the
/// libFuzzer programs (scripts/fuzz.sh) and by the test that feeds every truncated prefix. A new reader needs a row
/// and, if tests/data holds no file for it, a seed below tests/fuzz/corpus/<name>/. Rows stand in groups, so that a
/// program is linked with what it needs and no more: fuzz.cmake.
namespace fuzz {

struct Target {
    const char* name;
    void (*run)(std::string_view input);       ///< must come back from any input, within a second
    std::vector<std::string_view> fixtures{};  ///< names of files below tests/data/odb that this reader reads
    bool takesJobs = false;                    ///< its input is a whole job as `bundle` writes it
    std::string_view folder{};                 ///< below tests/data: all files in it are seeds
};

/// Archives, and the files of an ODB++ job.
[[nodiscard]] std::span<const Target> odbTargets();
/// IPC-2581, KiCad, Gerber with what lies beside images, the paper's text, and folders that hold several of them.
[[nodiscard]] std::span<const Target> formatTargets();
/// Rules, waivers, sessions, layer maps.
[[nodiscard]] std::span<const Target> settingTargets();
/// Triangulators, booleans, NURBS curves, the STEP writer.
[[nodiscard]] std::span<const Target> geometryTargets();
/// All of them.
[[nodiscard]] const std::vector<Target>& targets();

/// nullptr if there is none of this name.
[[nodiscard]] inline const Target* findTarget(std::span<const Target> all, std::string_view name) {
    const auto location = std::ranges::find(all, name, &Target::name);
    return location == all.end() ? nullptr : &*location;
}

/// A file of a job in a bundle.
struct File {
    std::string path;
    std::string text;
};

/// Several files as one text: each begins with a line "=== path". The fuzzer can cut and swap files in it.
[[nodiscard]] std::string bundle(std::span<const File> files);
[[nodiscard]] std::vector<File> unbundle(std::string_view text);

/// Inputs to start from: the files of tests/data that the target reads, its corpus, or the jobs as bundles; in the
/// order of their paths.
[[nodiscard]] std::vector<File> seedsOf(const Target& target);

}  // namespace fuzz
