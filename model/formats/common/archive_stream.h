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
    /// Of what was packed by gzip, which must outlive what is read: data of entries may lie in there. Read from front
    /// to back, as what libarchive unpacks by itself.
    ArchiveStream(const FileBytes& unpacked, Formats formats);
    ArchiveStream(const ArchiveStream&) = delete;
    ArchiveStream& operator=(const ArchiveStream&) = delete;

    /// Moves to the next entry. False at the end or on an error; `failed` says which. Throws std::bad_alloc, as all
    /// that reads here does, where memory ran out: that says nothing about the archive.
    [[nodiscard]] bool next();
    [[nodiscard]] bool failed() const { return m_failed; }
    /// Was any entry found so far?
    [[nodiscard]] bool hasEntries() const { return m_hasEntries; }
    [[nodiscard]] std::string errorText() const;

    /// UTF-8 where the archive says so, else its own bytes. Empty where it is said to be UTF-8 and is not.
    [[nodiscard]] std::string name() const;
    /// Is anything unpacked, or are these the file's own bytes?
    [[nodiscard]] bool isPacked() const;
    [[nodiscard]] bool isRegularFile() const;
    [[nodiscard]] bool isFolder() const;
    enum class Reading { Whole, Broken, TooLarge };
    /// The data of the entry; what came before where it is broken or larger than `limit` bytes.
    [[nodiscard]] Reading read(Bytes& out, std::uint64_t limit);
    /// Bytes of the archive file read so far.
    [[nodiscard]] std::uint64_t position() const;

private:
    struct Free {
        void operator()(archive* a) const { archive_read_free(a); }
    };
    void support(Formats formats);
    /// Hands libarchive all bytes at once.
    static la_ssize_t giveBytes(archive*, void* stream, const void** bytes);
    [[nodiscard]] bool keeps(std::string_view piece) const;
    void checkMemory() const;

    std::string_view m_toGive;    ///< unpacked bytes that libarchive does not have yet
    std::string_view m_unpacked;  ///< what data may point into
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
