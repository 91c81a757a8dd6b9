#pragma once

#include <cstdint>
#include <map>
#include <optional>

namespace render::gpu {

/// Which bytes of a block are free, and who gets them: the first range from the beginning that is large enough, so that
/// the end of a block stays whole. Knows offsets only, no memory.
class FreeRanges {
public:
    /// All of a block of so many bytes.
    explicit FreeRanges(std::uint64_t bytes) : m_bytes(bytes), m_ends{{0, bytes}} {}

    /// Takes so many bytes, at least one, at a multiple of `alignment`, a power of two. Returns the first of them;
    /// nothing if no free range holds them.
    [[nodiscard]] std::optional<std::uint64_t> take(std::uint64_t bytes, std::uint64_t alignment);
    /// Frees what was taken there.
    void give(std::uint64_t offset, std::uint64_t bytes);

    /// Of the whole block, free or not.
    [[nodiscard]] std::uint64_t bytes() const { return m_bytes; }
    [[nodiscard]] bool isAllFree() const;

private:
    void keep(std::uint64_t begin, std::uint64_t end);

    std::uint64_t m_bytes;
    std::map<std::uint64_t, std::uint64_t> m_ends;  ///< of each free range by its beginning; no two touch
};

}  // namespace render::gpu
