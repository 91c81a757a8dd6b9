#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

/// Zip archives byte by byte, with names and flags that programs would not write.
namespace zip {

inline constexpr std::uint32_t kUtf8Name = 1U << 11U;  ///< flag of an entry: its name is UTF-8

struct Entry {
    std::string name;
    std::string bytes;
    std::uint32_t flags = 0;
};

/// Little-endian, of at most eight bytes.
inline std::string number(std::size_t value, int bytes) {
    std::string text;
    for (int i = 0; i < bytes; ++i) {
        text += static_cast<char>(value >> static_cast<unsigned>(8 * i) & 0xFFU);
    }
    return text;
}

inline std::uint32_t checksum(std::string_view bytes) {
    std::uint32_t sum = 0xFFFF'FFFFU;
    for (const char byte : bytes) {
        sum ^= static_cast<unsigned char>(byte);
        for (int bit = 0; bit < 8; ++bit) {
            sum = sum >> 1U ^ ((sum & 1U) != 0 ? 0xEDB8'8320U : 0U);
        }
    }
    return ~sum;
}

/// What stands before an entry and in the directory alike: version, flags, stored as it is, day, checksum, sizes.
inline std::string header(const Entry& entry) {
    return number(20, 2) + number(entry.flags, 2) + number(0, 4) + number(0x21, 2) + number(checksum(entry.bytes), 4) +
           number(entry.bytes.size(), 4) + number(entry.bytes.size(), 4) + number(entry.name.size(), 2) + number(0, 2);
}

inline std::string packed(const std::vector<Entry>& entries) {
    const std::string unset(10, '\0');  // comment, disk and attributes
    std::string files;
    std::string directory;
    for (const Entry& entry : entries) {
        directory += "PK\1\2" + number(20, 2) + header(entry) + unset + number(files.size(), 4) + entry.name;
        files += "PK\3\4" + header(entry) + entry.name + entry.bytes;
    }
    const std::string count = number(entries.size(), 2);
    const std::string end =
        "PK\5\6" + number(0, 4) + count + count + number(directory.size(), 4) + number(files.size(), 4) + number(0, 2);
    return files + directory + end;
}

}  // namespace zip
