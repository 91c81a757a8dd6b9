#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/formats/common/archive.h"

namespace model::formats {

/// A file of a tree, unpacked.
struct TreeFile {
    std::string path;  ///< inside the tree, for "file and line"
    Bytes bytes;
    [[nodiscard]] std::string_view text() const { return bytes.view(); }
};

/// A folder of an archive with all that is below it. Paths are relative to it and found whatever their case. The
/// archive must outlive it.
class FileTree {
public:
    /// `root` as Archive::rows writes it: lower case, empty or ending in '/'.
    explicit FileTree(const Archive& archive, std::string root = {}) : m_archive(&archive), m_root(std::move(root)) {}

    /// The folder's own name; empty when it is the whole archive.
    [[nodiscard]] std::string name() const;
    [[nodiscard]] bool has(std::string_view path) const { return row(path) >= 0; }
    /// Stored size of the file or its packed `.Z` twin; 0 if there is none.
    [[nodiscard]] std::uint64_t storedSize(std::string_view path) const;
    /// Is there any file below this folder?
    [[nodiscard]] bool hasFolder(std::string_view path) const;
    /// The file, or its packed twin with `.Z` when the plain one is absent. Nothing when there is none, or when it
    /// cannot be unpacked, which is reported.
    [[nodiscard]] std::optional<TreeFile> read(std::string_view path, Diagnostics& diagnostics) const;
    /// Names of the folders right below `path`, in the order of their lower-case names.
    [[nodiscard]] std::vector<std::string> foldersIn(std::string_view path) const;

private:
    [[nodiscard]] int row(std::string_view path) const;

    const Archive* m_archive;
    std::string m_root;
};

}  // namespace model::formats
