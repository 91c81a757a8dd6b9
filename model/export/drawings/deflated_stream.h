#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>

namespace model {

/// Compresses text into a zlib stream (RFC 1950) on all cores, in parts that do not refer to one another: a little
/// longer than in one part, and the same bits with any number of threads. Errors: std::bad_alloc.
class DeflatedStream {
public:
    /// Hands what is compressed to `write`, piece by piece.
    explicit DeflatedStream(std::function<void(std::string_view)> write);

    void add(std::string_view text);
    void end();

private:
    void compress();

    std::function<void(std::string_view)> m_write;
    std::string m_pending;         ///< not yet compressed
    std::uint32_t m_checksum = 1;  ///< Adler-32 of what is compressed
};

}  // namespace model
