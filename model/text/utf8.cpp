#include "model/text/utf8.h"

namespace model {

namespace {

bool continues(std::string_view text, std::size_t at) {
    return at < text.size() && !beginsCharacter(text[at]);
}

/// Written with more bytes than it needs, half of a UTF-16 pair, or beyond Unicode.
bool isForbidden(std::uint32_t code, std::size_t bytes) {
    const bool isTooLong = (bytes == 3 && code < 0x800U) || (bytes == 4 && code < 0x10000U);
    return isTooLong || (code >= 0xD800U && code <= 0xDFFFU) || code > 0x10FFFFU;
}

}  // namespace

Character firstCharacter(std::string_view utf8) {
    const auto lead = static_cast<unsigned char>(utf8.front());
    if (lead < 0x80U) {
        return {lead, 1, true};
    }
    if (lead < 0xC2U || lead > 0xF4U) {
        return {0, 1, false};
    }
    const std::size_t bytes = lead >= 0xF0U ? 4 : lead >= 0xE0U ? 3 : 2;
    std::uint32_t code = lead & (0x7FU >> bytes);
    for (std::size_t i = 1; i < bytes; ++i) {
        if (!continues(utf8, i)) {
            return {0, i, false};
        }
        code = code << 6U | (static_cast<unsigned char>(utf8[i]) & 0x3FU);
    }
    return isForbidden(code, bytes) ? Character{0, bytes, false} : Character{code, bytes, true};
}

bool isUtf8(std::string_view text) {
    while (!text.empty()) {
        const Character first = firstCharacter(text);
        if (!first.isSound) {
            return false;
        }
        text.remove_prefix(first.bytes);
    }
    return true;
}

std::size_t cutWithin(std::string_view text, std::size_t most) {
    constexpr std::size_t kMostBehindFirst = 3;  // bytes of a character
    if (text.size() <= most) {
        return text.size();
    }
    for (std::size_t back = 0; back <= kMostBehindFirst && back < most; ++back) {
        if (beginsCharacter(text[most - back])) {
            return most - back;
        }
    }
    return most;
}

void appendUtf8(std::string& text, std::uint32_t code) {
    if (code < 0x80U) {
        text += static_cast<char>(code);
        return;
    }
    const unsigned more = code < 0x800U ? 1 : code < 0x10000U ? 2 : 3;  // bytes behind the first one
    constexpr std::uint32_t kLead[] = {0, 0xC0U, 0xE0U, 0xF0U};
    text += static_cast<char>(kLead[more] | (code >> (6U * more)));
    for (unsigned i = more; i-- > 0;) {
        text += static_cast<char>(0x80U | ((code >> (6U * i)) & 0x3FU));
    }
}

void moveCharacter(std::string_view& from, std::string& to) {
    const Character first = firstCharacter(from);
    if (first.isSound) {
        to += from.substr(0, first.bytes);
        from.remove_prefix(first.bytes);
    } else {
        appendUtf8(to, static_cast<unsigned char>(from.front()));
        from.remove_prefix(1);
    }
}

}  // namespace model
