#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace base {

/// Asks the system to back memory that is about to be filled by large pages, which take a fraction of the time at their
/// first touch that the small ones they stand for take. Has no effect where the system knows none.
void preferLargePages(std::span<const std::byte> memory);

/// Resizes an empty table that will be large, and filled at once.
template <class Row>
void resizeLarge(std::vector<Row>& table, std::size_t count) {
    table.reserve(count);
    preferLargePages(std::as_bytes(std::span(table.data(), count)));
    table.resize(count);
}

}  // namespace base
