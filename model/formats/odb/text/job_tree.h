#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/formats/common/archive.h"

namespace model::odb {

/// A file of the job, decoded.
struct JobFile {
    std::string path;  ///< inside the job, for "file and line"
    Bytes bytes;
    [[nodiscard]] std::string_view text() const { return bytes.view(); }
};

/// The job inside an archive: the folder that holds both `matrix/` and `steps/`, at whatever depth (odb-notes,
/// Container). Paths are relative to it.
class JobTree {
public:
    /// Errors: BadInput when no folder of the archive is a job.
    [[nodiscard]] static base::Result<JobTree> findIn(const Archive& archive);

    /// The folder's own name; empty when the archive has no top folder.
    [[nodiscard]] std::string name() const;
    [[nodiscard]] bool has(std::string_view path) const { return row(path) >= 0; }
    /// Stored size of the file or its `.Z` twin; 0 if there is none.
    [[nodiscard]] std::uint64_t storedSize(std::string_view path) const;
    /// Is there any file below this folder?
    [[nodiscard]] bool hasFolder(std::string_view path) const;
    /// The file, or its packed twin with `.Z` when the plain one is absent. Nothing when there is none, or when it
    /// cannot be unpacked, which is reported.
    [[nodiscard]] std::optional<JobFile> read(std::string_view path, Diagnostics& diagnostics) const;
    /// Names of the folders right below `path`, in the order of their lower-case names.
    [[nodiscard]] std::vector<std::string> foldersIn(std::string_view path) const;

private:
    [[nodiscard]] int row(std::string_view path) const;

    const Archive* m_archive = nullptr;
    std::string m_root;  ///< lower case, empty or ending in '/'
};

}  // namespace model::odb
