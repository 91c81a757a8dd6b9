#include "model/formats/common/gzip_member.h"

#include <libdeflate.h>
#include <sys/mman.h>

#include <algorithm>
#include <cstdlib>
#include <new>

namespace model::formats {
namespace {

constexpr std::size_t kLargePage = 2U << 20;
/// Header and trailer without anything between them.
constexpr std::size_t kSmallestMember = 18;
/// Deflate cannot pack more into a byte.
constexpr std::uint64_t kMostPerByte = 1032;

/// The size a member says it has, modulo 2^32: its last four bytes, little endian.
std::uint64_t sizeSaid(std::string_view packed) {
    std::uint64_t size = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        size |= std::uint64_t{static_cast<unsigned char>(packed[packed.size() - 4 + i])} << (8 * i);
    }
    return size;
}

}  // namespace

FileBytes::FileBytes(std::size_t size) {
    const bool isLarge = size >= 2 * kLargePage;
    const std::size_t room =
        isLarge ? (size + kLargePage - 1) / kLargePage * kLargePage : std::max<std::size_t>(size, 1);
    m_bytes.reset(static_cast<char*>(isLarge ? std::aligned_alloc(kLargePage, room) : std::malloc(room)));
    m_size = m_bytes != nullptr ? size : 0;
    if (m_bytes != nullptr && isLarge) {
        ::madvise(m_bytes.get(), room, MADV_HUGEPAGE);  // a wish: small pages do as well
    }
}

void FileBytes::Free::operator()(char* bytes) const {
    std::free(bytes);
}

std::optional<FileBytes> unpackGzip(std::string_view packed, std::uint64_t limit) {
    if (packed.size() < kSmallestMember || !packed.starts_with(kGzipMagic)) {
        return std::nullopt;
    }
    const std::uint64_t size = sizeSaid(packed);
    if (size > std::min(limit, kMostAtOneGo) || size / kMostPerByte > packed.size()) {
        return std::nullopt;
    }
    const std::unique_ptr<libdeflate_decompressor, void (*)(libdeflate_decompressor*)> inflate(
        libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
    if (inflate == nullptr) {
        throw std::bad_alloc();
    }
    FileBytes out(size);
    if (!out.holdsMemory()) {
        return std::nullopt;
    }
    std::size_t read = 0;
    std::size_t written = 0;
    const libdeflate_result result = libdeflate_gzip_decompress_ex(inflate.get(), packed.data(), packed.size(),
                                                                   out.data(), out.size(), &read, &written);
    const bool isWhole = result == LIBDEFLATE_SUCCESS && read == packed.size() && written == out.size();
    return isWhole ? std::optional(std::move(out)) : std::nullopt;
}

}  // namespace model::formats
