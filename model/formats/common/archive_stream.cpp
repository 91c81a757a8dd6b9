#include "model/formats/common/archive_stream.h"

#include <archive_entry.h>

#include <algorithm>
#include <array>

namespace model::formats {

namespace {

constexpr std::size_t kBlock = 256 * 1024;

/// Only what libarchive unpacks by itself: for other packings (lrzip, grzip, lzop), and for those that it was built
/// without, it starts a program of the machine, which the bytes of a board must never do.
void supportPackings(archive* a) {
    archive_read_support_filter_compress(a);
    if (archive_zlib_version() != nullptr) {
        archive_read_support_filter_gzip(a);
    }
    if (archive_bzlib_version() != nullptr) {
        archive_read_support_filter_bzip2(a);
    }
    if (archive_liblzma_version() != nullptr) {
        archive_read_support_filter_xz(a);
        archive_read_support_filter_lzma(a);
    }
    if (archive_libzstd_version() != nullptr) {
        archive_read_support_filter_zstd(a);
    }
    if (archive_liblz4_version() != nullptr) {
        archive_read_support_filter_lz4(a);
    }
}

}  // namespace

ArchiveStream::ArchiveStream(const std::filesystem::path& path, Formats formats) {
    support(formats);
    m_isOpen = archive_read_open_filename(m_archive.get(), path.c_str(), kBlock) == ARCHIVE_OK;
    m_failed = !m_isOpen;
}

ArchiveStream::ArchiveStream(std::string_view bytes, Formats formats) {
    support(formats);
    m_isOpen = archive_read_open_memory(m_archive.get(), bytes.data(), bytes.size()) == ARCHIVE_OK;
    m_failed = !m_isOpen;
}

void ArchiveStream::support(Formats formats) {
    m_archive.reset(archive_read_new());
    archive* a = m_archive.get();
    supportPackings(a);
    archive_read_support_format_zip(a);
    if (formats == Formats::Containers) {
        archive_read_support_format_tar(a);
        archive_read_support_format_gnutar(a);
    } else {
        archive_read_support_format_raw(a);
    }
}

bool ArchiveStream::next() {
    if (!m_isOpen) {
        return false;
    }
    const int status = archive_read_next_header(m_archive.get(), &m_entry);
    // A warning is about names or times we do not use; the data that follows is sound.
    m_failed = status != ARCHIVE_OK && status != ARCHIVE_WARN && status != ARCHIVE_EOF;
    const bool isEntry = status == ARCHIVE_OK || status == ARCHIVE_WARN;
    m_hasEntries = m_hasEntries || isEntry;
    return isEntry;
}

std::string ArchiveStream::errorText() const {
    const char* text = archive_error_string(m_archive.get());
    return text != nullptr ? text : "unknown error";
}

std::string ArchiveStream::name() const {
    const char* name = archive_entry_pathname(m_entry);
    return name != nullptr ? name : "";
}

bool ArchiveStream::isPacked() const {
    return archive_filter_code(m_archive.get(), 0) != ARCHIVE_FILTER_NONE ||
           archive_format(m_archive.get()) == ARCHIVE_FORMAT_ZIP;
}

bool ArchiveStream::isRegularFile() const {
    return archive_entry_filetype(m_entry) == AE_IFREG && archive_entry_hardlink(m_entry) == nullptr;
}

bool ArchiveStream::isFolder() const {
    return archive_entry_filetype(m_entry) == AE_IFDIR;
}

ArchiveStream::Reading ArchiveStream::read(std::string& out, std::uint64_t limit) {
    const void* block = nullptr;
    std::size_t size = 0;
    la_int64_t offset = 0;
    int status = ARCHIVE_OK;
    while ((status = archive_read_data_block(m_archive.get(), &block, &size, &offset)) == ARCHIVE_OK) {
        if (out.size() + size > limit) {
            return Reading::TooLarge;
        }
        out.append(static_cast<const char*>(block), size);
    }
    return status == ARCHIVE_EOF ? Reading::Whole : Reading::Broken;
}

std::uint64_t ArchiveStream::position() const {
    const la_int64_t bytes = archive_filter_bytes(m_archive.get(), -1);
    return bytes > 0 ? static_cast<std::uint64_t>(bytes) : 0;
}

base::Result<Bytes> decodeMember(Bytes bytes, std::uint64_t limit) {
    constexpr std::array<std::string_view, 3> kMagics = {"\x1f\x9d", "\x1f\x8b", "PK\x03\x04"};
    if (std::ranges::none_of(kMagics, [&](std::string_view magic) { return bytes.view().starts_with(magic); })) {
        return bytes;
    }
    ArchiveStream stream(bytes.view(), ArchiveStream::Formats::Member);
    std::string text;
    // A header too broken for its format would come through as raw bytes.
    const bool isThere = stream.next() && stream.isPacked();
    const ArchiveStream::Reading reading = isThere ? stream.read(text, limit) : ArchiveStream::Reading::Broken;
    if (reading == ArchiveStream::Reading::TooLarge) {
        return base::Error{base::ErrorCode::BadInput,
                           "the packed file unpacks to more than " + bytesText(limit) + ", the limit for one file"};
    }
    if (reading == ArchiveStream::Reading::Broken) {
        return base::Error{base::ErrorCode::BadInput, "the packed file is broken"};
    }
    return Bytes(std::move(text));
}

}  // namespace model::formats
