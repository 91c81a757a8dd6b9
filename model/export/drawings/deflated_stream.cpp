#include "model/export/drawings/deflated_stream.h"

#include <zlib.h>

#include <memory>
#include <new>
#include <utility>
#include <vector>

#include "model/base/assert.h"
#include "model/base/parallel.h"

namespace model {

namespace {

constexpr std::size_t kPart = std::size_t{256} << 10U;  // eight times as far as deflate looks back
constexpr std::size_t kGathered = 64 * kPart;           // parts for many cores, in 16 MiB

using namespace std::string_view_literals;
constexpr int kLevel = 5;                              // 0.6 % longer than the usual 6, in 0.6 of its time
constexpr std::string_view kHeader = "\x78\x5E"sv;     // deflate, looking back 32 KiB, of levels 2 to 5
constexpr std::string_view kLastBlock = "\x03\x00"sv;  // with nothing in it

struct Part {
    std::string_view text;
    std::string packed{};  // whole bytes, to be followed by further blocks
    uLong checksum = 0;
};

struct EndDeflate {
    void operator()(z_stream* stream) const { deflateEnd(stream); }
};

void pack(Part& part) {
    part.checksum = adler32(adler32(0, nullptr, 0), reinterpret_cast<const Bytef*>(part.text.data()),
                            static_cast<uInt>(part.text.size()));
    part.packed.resize(compressBound(static_cast<uLong>(part.text.size())) + 16);  // an empty block ends it
    z_stream stream{};
    if (deflateInit2(&stream, kLevel, Z_DEFLATED, -MAX_WBITS, MAX_MEM_LEVEL - 1, Z_DEFAULT_STRATEGY) != Z_OK) {
        throw std::bad_alloc();
    }
    const std::unique_ptr<z_stream, EndDeflate> ended(&stream);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(part.text.data()));
    stream.avail_in = static_cast<uInt>(part.text.size());
    stream.next_out = reinterpret_cast<Bytef*>(part.packed.data());
    stream.avail_out = static_cast<uInt>(part.packed.size());
    const int state = deflate(&stream, Z_SYNC_FLUSH);
    ASSERT(state == Z_OK && stream.avail_in == 0 && stream.avail_out > 0);
    part.packed.resize(part.packed.size() - stream.avail_out);
}

}  // namespace

DeflatedStream::DeflatedStream(std::function<void(std::string_view)> write) : m_write(std::move(write)) {
    m_write(kHeader);
}

void DeflatedStream::add(std::string_view text) {
    m_pending += text;
    if (m_pending.size() >= kGathered) {
        compress();
    }
}

void DeflatedStream::end() {
    compress();
    m_write(kLastBlock);
    const std::uint32_t sum = m_checksum;
    const char bytes[] = {static_cast<char>(sum >> 24U), static_cast<char>(sum >> 16U), static_cast<char>(sum >> 8U),
                          static_cast<char>(sum)};
    m_write({bytes, sizeof bytes});
}

void DeflatedStream::compress() {
    std::vector<Part> parts;
    for (std::size_t at = 0; at < m_pending.size(); at += kPart) {
        parts.push_back({std::string_view(m_pending).substr(at, kPart)});
    }
    base::parallelFor(parts.size(), [&](std::size_t i) { pack(parts[i]); });
    for (const Part& part : parts) {
        m_write(part.packed);
        m_checksum = static_cast<std::uint32_t>(
            adler32_combine(m_checksum, part.checksum, static_cast<z_off_t>(part.text.size())));
    }
    m_pending.clear();
}

}  // namespace model
