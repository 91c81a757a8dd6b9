#include "model/formats/odb/text/job_tree.h"

#include <algorithm>
#include <array>

#include "model/base/ascii.h"

namespace model::odb {

namespace {

/// Folders that are jobs, as Archive::rows writes them: the shallowest first.
std::vector<std::string> jobRoots(const formats::Archive& archive) {
    constexpr std::string_view kMatrix = "matrix/matrix";
    std::vector<std::string> roots;
    for (const auto& [path, row] : archive.rows()) {
        const std::string_view plain = path.ends_with(".z") ? std::string_view(path).substr(0, path.size() - 2) : path;
        if (plain != kMatrix && !plain.ends_with("/matrix/matrix")) {
            continue;
        }
        const std::string root(plain.substr(0, plain.size() - kMatrix.size()));
        const bool isNew = std::ranges::find(roots, root) == roots.end();  // a file may have a packed twin
        if (isNew && formats::FileTree(archive, root).hasFolder("steps")) {
            roots.push_back(root);
        }
    }
    std::ranges::stable_sort(
        roots, {}, [](const std::string& root) { return std::pair(std::ranges::count(root, '/'), root.size()); });
    return roots;
}

}  // namespace

base::Result<formats::FileTree> findJob(const formats::Archive& archive) {
    const std::vector<std::string> roots = jobRoots(archive);
    if (roots.empty()) {
        return base::Error{base::ErrorCode::BadInput,
                           "this is no ODB++ job: no folder in it holds both matrix/matrix and steps/"};
    }
    return formats::FileTree(archive, roots.front());
}

bool isOfJob(const formats::Archive& archive, std::string_view path) {
    constexpr std::array<std::string_view, 6> kFolders = {"fonts/", "matrix/",  "misc/",
                                                          "steps/", "symbols/", "wheels/"};
    const std::string file = base::lowerCase(path);
    return std::ranges::any_of(jobRoots(archive), [&](const std::string& root) {
        const std::string_view below = file.starts_with(root) ? std::string_view(file).substr(root.size()) : "";
        return std::ranges::any_of(kFolders, [&](std::string_view folder) { return below.starts_with(folder); });
    });
}

std::vector<std::string> otherJobs(const formats::Archive& archive) {
    const std::vector<std::string> roots = jobRoots(archive);
    std::vector<std::string> others;
    for (const std::string& root : roots) {
        if (!root.starts_with(roots.front())) {
            others.push_back(root.substr(0, root.size() - 1));
        }
    }
    return others;
}

}  // namespace model::odb
