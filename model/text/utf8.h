#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

/// Texts as UTF-8: each character in as few bytes as it needs, no half of a UTF-16 pair, none beyond Unicode.
namespace model {

struct Character {
    std::uint32_t code = 0;  ///< of Unicode; 0 if the bytes are no UTF-8
    std::size_t bytes = 1;   ///< that it takes, or that cannot be read
    bool isSound = false;
};

/// The first character of a text that is not empty.
[[nodiscard]] Character firstCharacter(std::string_view utf8);
[[nodiscard]] bool isUtf8(std::string_view text);

/// Does a byte of UTF-8 begin a character?
[[nodiscard]] constexpr bool beginsCharacter(char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
}
/// Where to cut a text that has room for so many bytes: behind them, or up to three before where a character would be
/// cut. Never 0 where there is room for a byte, whatever the bytes are.
[[nodiscard]] std::size_t cutWithin(std::string_view text, std::size_t most);

/// Adds a character of Unicode to a text.
void appendUtf8(std::string& text, std::uint32_t code);
/// Takes the first character off a text that is not empty and adds it to another one. A byte that is no UTF-8 is taken
/// as Latin-1.
void moveCharacter(std::string_view& from, std::string& to);

}  // namespace model
