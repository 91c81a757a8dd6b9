#include "model/formats/common/archive_stream.h"

#include <archive_entry.h>
#include <locale.h>  // newlocale and uselocale, which <clocale> lacks

#include <algorithm>
#include <array>
#include <cerrno>
#include <functional>
#include <new>
#include <utility>

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

/// libarchive converts names that are said to be UTF-8 to the locale of its thread, and has none for those which that
/// lacks: in the locale "C", that of a program which sets none, all beyond ASCII. While this lives, names stay UTF-8.
class Utf8Names {
public:
    Utf8Names() : m_before(::uselocale(utf8())) {}
    ~Utf8Names() { ::uselocale(m_before); }
    Utf8Names(const Utf8Names&) = delete;
    Utf8Names& operator=(const Utf8Names&) = delete;

private:
    /// Null where the system lacks it: the locale stays as it is.
    static locale_t utf8() {
        static const locale_t kLocale = ::newlocale(LC_CTYPE_MASK, "C.UTF-8", nullptr);
        return kLocale;
    }

    locale_t m_before;
};

}  // namespace

ArchiveStream::ArchiveStream(const std::filesystem::path& path, Formats formats) {
    support(formats);
    m_isOpen = archive_read_open_filename(m_archive.get(), path.c_str(), kBlock) == ARCHIVE_OK;
    m_failed = !m_isOpen;
    checkMemory();
}

ArchiveStream::ArchiveStream(std::string_view bytes, Formats formats) {
    support(formats);
    m_isOpen = archive_read_open_memory(m_archive.get(), bytes.data(), bytes.size()) == ARCHIVE_OK;
    m_failed = !m_isOpen;
    checkMemory();
}

ArchiveStream::ArchiveStream(const FileBytes& unpacked, Formats formats)
    : m_toGive(unpacked.view()), m_unpacked(unpacked.view()) {
    support(formats);
    m_isOpen = archive_read_open(m_archive.get(), this, nullptr, giveBytes, nullptr) == ARCHIVE_OK;
    m_failed = !m_isOpen;
    checkMemory();
}

la_ssize_t ArchiveStream::giveBytes(archive*, void* stream, const void** bytes) {
    const std::string_view given = std::exchange(static_cast<ArchiveStream*>(stream)->m_toGive, {});
    *bytes = given.data();
    return static_cast<la_ssize_t>(given.size());
}

bool ArchiveStream::keeps(std::string_view piece) const {
    const std::less_equal<> isBefore;
    return isBefore(m_unpacked.data(), piece.data()) &&
           isBefore(piece.data() + piece.size(), m_unpacked.data() + m_unpacked.size());
}

void ArchiveStream::support(Formats formats) {
    m_archive.reset(archive_read_new());
    archive* a = m_archive.get();
    if (a == nullptr) {
        throw std::bad_alloc();
    }
    supportPackings(a);
    archive_read_support_format_zip(a);
    if (formats == Formats::Containers) {
        archive_read_support_format_tar(a);
        archive_read_support_format_gnutar(a);
    } else {
        archive_read_support_format_raw(a);
    }
}

void ArchiveStream::checkMemory() const {
    if (archive_errno(m_archive.get()) == ENOMEM) {
        throw std::bad_alloc();
    }
}

bool ArchiveStream::next() {
    if (!m_isOpen) {
        return false;
    }
    const Utf8Names names;
    const int status = archive_read_next_header(m_archive.get(), &m_entry);
    // A warning is about names or times we do not use; the data that follows is sound.
    m_failed = status != ARCHIVE_OK && status != ARCHIVE_WARN && status != ARCHIVE_EOF;
    checkMemory();
    const bool isEntry = status == ARCHIVE_OK || status == ARCHIVE_WARN;
    m_hasEntries = m_hasEntries || isEntry;
    return isEntry;
}

std::string ArchiveStream::errorText() const {
    const char* text = archive_error_string(m_archive.get());
    return text != nullptr ? text : "unknown error";
}

std::string ArchiveStream::name() const {
    const Utf8Names names;
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

ArchiveStream::Reading ArchiveStream::read(Bytes& out, std::uint64_t limit) {
    const void* block = nullptr;
    std::size_t size = 0;
    la_int64_t offset = 0;
    int status = ARCHIVE_OK;
    std::string_view lone;  // the only piece so far, if that stays where it is
    std::string copied;
    bool isTooLarge = false;
    while (!isTooLarge && (status = archive_read_data_block(m_archive.get(), &block, &size, &offset)) == ARCHIVE_OK) {
        const std::string_view piece(static_cast<const char*>(block), size);
        isTooLarge = lone.size() + copied.size() + size > limit;
        if (isTooLarge || piece.empty()) {
            continue;
        }
        if (lone.empty() && copied.empty() && keeps(piece)) {
            lone = piece;
            continue;
        }
        copied.append(std::exchange(lone, {}));
        copied.append(piece);
    }
    checkMemory();
    out = lone.empty() ? Bytes(std::move(copied)) : Bytes::borrow(lone);
    return isTooLarge ? Reading::TooLarge : status == ARCHIVE_EOF ? Reading::Whole : Reading::Broken;
}

std::uint64_t ArchiveStream::position() const {
    const la_int64_t bytes = archive_filter_bytes(m_archive.get(), -1);
    return bytes > 0 ? static_cast<std::uint64_t>(bytes) : 0;
}

base::Result<Bytes> decodeMember(Bytes bytes, std::uint64_t limit) {
    constexpr std::array<std::string_view, 3> kMagics = {"\x1f\x9d", kGzipMagic, "PK\x03\x04"};
    if (std::ranges::none_of(kMagics, [&](std::string_view magic) { return bytes.view().starts_with(magic); })) {
        return bytes;
    }
    if (std::optional<FileBytes> whole = unpackGzip(bytes.view(), limit)) {
        return Bytes(*std::move(whole));
    }
    ArchiveStream stream(bytes.view(), ArchiveStream::Formats::Member);
    Bytes text;
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
    return text;
}

}  // namespace model::formats
