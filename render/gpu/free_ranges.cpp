#include "render/gpu/free_ranges.h"

#include <bit>
#include <iterator>

#include "model/base/assert.h"

namespace render::gpu {

std::optional<std::uint64_t> FreeRanges::take(std::uint64_t bytes, std::uint64_t alignment) {
    ASSERT(bytes > 0 && std::has_single_bit(alignment));
    for (auto range = m_ends.begin(); range != m_ends.end(); ++range) {
        const auto [begin, end] = *range;
        const std::uint64_t offset = (begin + alignment - 1) & ~(alignment - 1);
        if (offset < end && end - offset >= bytes) {
            m_ends.erase(range);
            keep(begin, offset);
            keep(offset + bytes, end);
            return offset;
        }
    }
    return std::nullopt;
}

void FreeRanges::give(std::uint64_t offset, std::uint64_t bytes) {
    std::uint64_t begin = offset;
    std::uint64_t end = offset + bytes;
    ASSERT(bytes > 0 && end <= m_bytes);
    auto next = m_ends.lower_bound(begin);
    ASSERT(next == m_ends.end() || next->first >= end);  // was it free already?
    if (next != m_ends.end() && next->first == end) {
        end = next->second;
        next = m_ends.erase(next);
    }
    if (next != m_ends.begin()) {
        const auto before = std::prev(next);
        ASSERT(before->second <= begin);
        begin = before->second == begin ? before->first : begin;
    }
    m_ends[begin] = end;
}

bool FreeRanges::isAllFree() const {
    return m_ends.size() == 1 && m_ends.begin()->first == 0 && m_ends.begin()->second == m_bytes;
}

void FreeRanges::keep(std::uint64_t begin, std::uint64_t end) {
    if (begin < end) {
        m_ends[begin] = end;
    }
}

}  // namespace render::gpu
