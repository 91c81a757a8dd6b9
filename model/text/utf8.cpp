#include "model/text/utf8.h"

#include <algorithm>

namespace model {

namespace {

/// No character is written longer than it must be, none is half of a pair (U+D800 to U+DFFF), none beyond U+10FFFF.
bool mayFollow(unsigned char lead, unsigned char second) {
    switch (lead) {
        case 0xE0: return second >= 0xA0;
        case 0xED: return second < 0xA0;
        case 0xF0: return second >= 0x90;
        case 0xF4: return second < 0x90;
        default: return true;
    }
}

}  // namespace

std::size_t utf8Length(std::string_view text) {
    const auto lead = static_cast<unsigned char>(text[0]);
    const std::size_t length = lead < 0x80   ? 1
                               : lead < 0xC2 ? 0
                               : lead < 0xE0 ? 2
                               : lead < 0xF0 ? 3
                               : lead < 0xF5 ? 4
                                             : 0;
    const auto isContinuation = [](char c) { return (static_cast<unsigned char>(c) & 0xC0U) == 0x80U; };
    const bool isWhole =
        length <= text.size() && length > 0 && std::ranges::all_of(text.substr(1, length - 1), isContinuation);
    return isWhole && (length < 2 || mayFollow(lead, static_cast<unsigned char>(text[1]))) ? length : 0;
}

bool isUtf8(std::string_view text) {
    while (!text.empty()) {
        const std::size_t length = utf8Length(text);
        if (length == 0) {
            return false;
        }
        text.remove_prefix(length);
    }
    return true;
}

}  // namespace model
