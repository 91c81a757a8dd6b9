#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string_view>

namespace model::formats {

/// Memory for a file, not filled with anything; moving it leaves the bytes where they are. Large ones lie on large
/// pages where the system has them.
class FileBytes {
public:
    FileBytes() = default;
    /// Holds nothing if there is no memory: `holdsMemory` says so.
    explicit FileBytes(std::size_t size);

    [[nodiscard]] bool holdsMemory() const { return m_bytes != nullptr; }
    [[nodiscard]] char* data() { return m_bytes.get(); }
    [[nodiscard]] std::size_t size() const { return m_size; }
    [[nodiscard]] std::string_view view() const { return {m_bytes.get(), m_size}; }

private:
    struct Free {
        void operator()(char* bytes) const;
    };
    std::unique_ptr<char[], Free> m_bytes;
    std::size_t m_size = 0;
};

/// What gzip members begin with.
inline constexpr std::string_view kGzipMagic = "\x1f\x8b";

/// Most bytes that unpackGzip unpacks at one go: more are left to libarchive, which can be stopped in between.
inline constexpr std::uint64_t kMostAtOneGo = std::uint64_t{256} << 20;

/// What was packed, if the bytes are one whole gzip member, sound by its checksum, and nothing else, and unpack to
/// `limit` or kMostAtOneGo bytes at most. Everything else gives nothing, and is read and judged by libarchive
/// (archive_stream.h): several members, bytes behind them, an early end, damage, no gzip at all. Throws
/// std::bad_alloc where there is no room for the work itself.
[[nodiscard]] std::optional<FileBytes> unpackGzip(std::string_view packed, std::uint64_t limit);

}  // namespace model::formats
