#pragma once

#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "model/base/ascii.h"
#include "model/base/progress.h"
#include "model/base/result.h"
#include "model/board/diagnostics.h"
#include "model/formats/common/archive_limits.h"
#include "model/formats/common/gzip_member.h"

namespace model::formats {

class ArchiveStream;

/// Bytes that are either held here or borrowed from somebody who lives longer.
class Bytes {
public:
    Bytes() = default;
    explicit Bytes(std::string own) : m_own(std::move(own)) {}
    explicit Bytes(FileBytes own) : m_file(std::move(own)), m_borrowed(m_file.view()) {}
    [[nodiscard]] static Bytes borrow(std::string_view bytes) {
        Bytes borrowed;
        borrowed.m_borrowed = bytes;
        return borrowed;
    }
    [[nodiscard]] std::string_view view() const { return m_own.empty() ? m_borrowed : std::string_view(m_own); }

private:
    std::string m_own;
    FileBytes m_file;
    std::string_view m_borrowed;  ///< of somebody else, or of m_file
};

/// For messages: "4 GiB", "512 MiB"; what is no whole number of these in bytes.
[[nodiscard]] std::string bytesText(std::uint64_t bytes);

/// Why nothing exists at a path, as its status and the error of asking for it tell.
[[nodiscard]] std::string noneThere(std::filesystem::file_status status, std::error_code error);

/// The files of a board as one tree, whatever they came in: a folder, a .tgz, .tar.gz, .tar (V7 included) or .zip, or
/// a file that is packed by itself (board.xml.gz), which is then the only one and named without its last ending.
/// Names are found whatever their case. Archives are held in memory and nothing is ever written to disk; permissions in
/// the archive are not looked at. Entries with `..` or an absolute path, and those whose names cannot be read, are left
/// out with an error in the diagnostics.
/// Of folders see filesBelow. Reading is safe from several threads.
class Archive {
public:
    /// Errors: BadInput (missing, unreadable, no archive, ends early, over the limits), Cancelled.
    [[nodiscard]] static base::Result<Archive> open(const std::filesystem::path& path, const ArchiveLimits& limits,
                                                    base::Progress& progress, Diagnostics& diagnostics);
    /// The same for the bytes of a file that is already in memory; `name` is what messages call it.
    [[nodiscard]] static base::Result<Archive> unpack(std::string_view bytes, const std::filesystem::path& name,
                                                      const ArchiveLimits& limits, base::Progress& progress,
                                                      Diagnostics& diagnostics);

    /// A tree of files that are in memory, path and bytes each.
    [[nodiscard]] static Archive of(std::vector<std::pair<std::string, std::string>> files);

    /// Row of the file with this path (blanks and slashes as in the job, any case); -1 if there is none.
    [[nodiscard]] int find(std::string_view path) const;
    [[nodiscard]] std::size_t size() const { return m_entries.size(); }
    /// The path as the archive writes it.
    [[nodiscard]] const std::string& path(int row) const { return m_entries[static_cast<std::size_t>(row)].path; }
    /// Size of the stored bytes.
    [[nodiscard]] std::uint64_t storedSize(int row) const { return m_entries[static_cast<std::size_t>(row)].size; }
    /// The stored bytes, not yet decoded; they may point into the archive. Errors: BadInput when a file of a folder
    /// cannot be read.
    [[nodiscard]] base::Result<Bytes> bytes(int row) const;
    /// As if the file were not there.
    void leaveOut(int row) { m_rows.erase(base::lowerCase(path(row))); }
    /// Rows of all files in the order of their lower-case paths.
    [[nodiscard]] const std::map<std::string, int, std::less<>>& rows() const { return m_rows; }

private:
    struct Entry {
        std::string path;
        Bytes data;                    ///< of archives
        std::filesystem::path source;  ///< of folders
        std::uint64_t size = 0;
    };

    [[nodiscard]] static base::Result<Archive> openFolder(const std::filesystem::path& path,
                                                          const ArchiveLimits& limits, base::Progress& progress,
                                                          Diagnostics& diagnostics);
    [[nodiscard]] static base::Result<Archive> openFile(const std::filesystem::path& path, const ArchiveLimits& limits,
                                                        base::Progress& progress, Diagnostics& diagnostics);
    /// Of an archive of so many bytes whose packing, gzip, is off already.
    [[nodiscard]] static base::Result<Archive> readUnpacked(FileBytes unpacked, std::uint64_t packedBytes,
                                                            const std::filesystem::path& path,
                                                            const ArchiveLimits& limits, base::Progress& progress,
                                                            Diagnostics& diagnostics);
    /// `streamBytes` is how many bytes the stream has; `packedBytes` how many it comes from.
    [[nodiscard]] static base::Result<Archive> readAll(ArchiveStream& stream, std::uint64_t streamBytes,
                                                       std::uint64_t packedBytes, const std::filesystem::path& path,
                                                       const ArchiveLimits& limits, base::Progress& progress,
                                                       Diagnostics& diagnostics);
    [[nodiscard]] static Archive loneFile(const std::filesystem::path& path, Bytes data);
    /// A packed file that is no container; nothing if it is none, or broken. Errors: BadInput if it is too large.
    [[nodiscard]] static std::optional<base::Result<Archive>> readLone(ArchiveStream& stream, std::uint64_t packedBytes,
                                                                       const std::filesystem::path& path,
                                                                       const ArchiveLimits& limits);
    void add(Entry entry, Diagnostics& diagnostics);

    FileBytes m_unpacked;  ///< what data of entries may point into
    std::vector<Entry> m_entries;
    std::map<std::string, int, std::less<>> m_rows;
};

}  // namespace model::formats
