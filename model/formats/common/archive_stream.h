#pragma once

#include <archive.h>

#include <cstdint>
#include <filesystem>
#include <memory>
#include <string>
#include <string_view>

#include "model/base/result.h"
#include "model/formats/common/archive.h"

namespace model::formats {

/// libarchive's reader with its resource rules: opened, walked entry by entry, freed.
class ArchiveStream {
public:
    enum class Formats {
        Containers,  ///< tar in all dialects and zip, packed or not
        Member       ///< one packed file: compress, gzip or the first file of a zip
    };

    ArchiveStream(const std::filesystem::path& path, Formats formats);
    ArchiveStream(std::string_view bytes, Formats formats);

    /// Moves to the next entry. False at the end or on an error; `failed` says which.
    [[nodiscard]] bool next();
    [[nodiscard]] bool failed() const { return m_failed; }
    /// Was any entry found so far?
    [[nodiscard]] bool hasEntries() const { return m_hasEntries; }
    [[nodiscard]] std::string errorText() const;

    [[nodiscard]] std::string name() const;
    /// Is anything unpacked, or are these the file's own bytes?
    [[nodiscard]] bool isPacked() const;
    [[nodiscard]] bool isRegularFile() const;
    [[nodiscard]] bool isFolder() const;
    enum class Reading { Whole, Broken, TooLarge };
    /// Appends the data of the entry to `out`, as long as that does not grow past `limit` bytes.
    [[nodiscard]] Reading read(std::string& out, std::uint64_t limit);
    /// Bytes of the archive file read so far.
    [[nodiscard]] std::uint64_t position() const;

private:
    struct Free {
        void operator()(archive* a) const { archive_read_free(a); }
    };
    void support(Formats formats);

    std::unique_ptr<archive, Free> m_archive;
    archive_entry* m_entry = nullptr;
    bool m_isOpen = false;
    bool m_failed = false;
    bool m_hasEntries = false;
};

/// The plain text of a member that may be packed, which its first bytes say: `1F 9D` is Unix compress, `1F 8B` gzip,
/// `PK` a zip with one file (DipTrace names those `.Z` too); anything else is returned as it is. Errors: BadInput when
/// it is broken or unpacks to more than `limit` bytes.
[[nodiscard]] base::Result<Bytes> decodeMember(Bytes bytes, std::uint64_t limit = base::kMostMemberBytes);

}  // namespace model::formats
