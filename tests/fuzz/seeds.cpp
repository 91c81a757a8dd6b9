#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "targets.h"
#include "tests/locations.h"

namespace fuzz {

namespace {

namespace fs = std::filesystem;

constexpr std::string_view kMark = "=== ";

const fs::path kJobs = fs::path(locations::kTestData) / "odb";
const fs::path kCorpus = locations::kFuzzCorpus;

std::string readFile(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

/// All files below a folder, with paths relative to it and in their order.
std::vector<File> filesBelow(const fs::path& folder) {
    std::vector<File> files;
    if (fs::exists(folder)) {
        for (const auto& entry : fs::recursive_directory_iterator(folder)) {
            if (entry.is_regular_file()) {
                files.push_back({entry.path().lexically_relative(folder).generic_string(), readFile(entry.path())});
            }
        }
    }
    std::ranges::sort(files, {}, &File::path);
    return files;
}

std::vector<File> jobsAsBundles() {
    std::vector<File> bundles;
    for (const auto& entry : fs::directory_iterator(kJobs)) {
        bundles.push_back({entry.path().filename().string(), bundle(filesBelow(entry.path()))});
    }
    std::ranges::sort(bundles, {}, &File::path);
    return bundles;
}

}  // namespace

std::string bundle(std::span<const File> files) {
    std::string text;
    for (const File& file : files) {
        text += std::string(kMark) + file.path + '\n' + file.text;
        text += text.ends_with('\n') ? "" : "\n";
    }
    return text;
}

std::vector<File> unbundle(std::string_view text) {
    std::vector<File> files;
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size() - 1) + 1;
        const std::string_view line = text.substr(0, end);
        if (line.starts_with(kMark)) {
            const std::string_view path = line.substr(kMark.size());
            files.push_back({std::string(path.substr(0, path.find('\n'))), {}});
        } else if (!files.empty()) {
            files.back().text += line;
        }
        text.remove_prefix(end);
    }
    return files;
}

std::vector<File> seedsOf(const Target& target) {
    std::vector<File> seeds = filesBelow(kCorpus / target.name);
    if (target.takesJobs) {
        std::ranges::move(jobsAsBundles(), std::back_inserter(seeds));
    }
    if (!target.folder.empty()) {
        std::ranges::move(filesBelow(fs::path(locations::kTestData) / target.folder), std::back_inserter(seeds));
    }
    for (File& file : filesBelow(kJobs)) {
        const std::string name = fs::path(file.path).filename().string();
        if (!file.text.empty() && std::ranges::find(target.fixtures, name) != target.fixtures.end()) {
            seeds.push_back(std::move(file));
        }
    }
    return seeds;
}

}  // namespace fuzz
