#pragma once

#include "model/base/limits.h"

namespace model::formats {

/// How much an archive may unpack to; beyond, it is refused with a message that names the limit.
struct ArchiveLimits {
    std::uint64_t totalBytes = base::kMostUnpackedBytes;
    std::size_t entries = base::kMostEntries;
    /// Times the packed size that it may unpack to, once it is beyond `freeBytes`.
    std::uint64_t expansion = base::kMostExpansion;
    std::uint64_t freeBytes = base::kFreelyUnpackedBytes;
};

/// Those of somebody who says how much may be unpacked, and so what it may come from.
[[nodiscard]] constexpr ArchiveLimits limitsOfUnpacking(std::uint64_t bytes) {
    return {bytes, base::kMostEntries, bytes, bytes};
}

}  // namespace model::formats
