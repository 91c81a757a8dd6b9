#include "tar.h"

#include <algorithm>
#include <cstdio>
#include <cstring>

namespace fuzz {

namespace {

constexpr std::size_t kBlock = 512;
constexpr std::size_t kLongestPath = 99;
// Offsets and widths of the V7 header: name 100, mode 8, uid 8, gid 8, size 12, mtime 12, checksum 8.
constexpr std::size_t kMode = 100;
constexpr std::size_t kSize = 124;
constexpr std::size_t kChecksum = 148;

std::string header(const File& file) {
    std::string block(kBlock, '\0');
    block.replace(0, std::min(file.path.size(), kLongestPath), file.path, 0, kLongestPath);
    std::memcpy(block.data() + kMode, "0000644", 7);
    std::snprintf(block.data() + kSize, 12, "%011zo", file.text.size());
    std::memset(block.data() + kChecksum, ' ', 8);
    unsigned sum = 0;
    for (const char c : block) {
        sum += static_cast<unsigned char>(c);
    }
    std::snprintf(block.data() + kChecksum, 8, "%06o", sum);
    return block;
}

}  // namespace

std::string writeTar(std::span<const File> files) {
    std::string tar;
    for (const File& file : files) {
        tar += header(file) + file.text;
        tar.resize((tar.size() + kBlock - 1) / kBlock * kBlock);
    }
    tar.append(2 * kBlock, '\0');
    return tar;
}

}  // namespace fuzz
