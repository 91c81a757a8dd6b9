#include "model/export/drawings/utf8.h"

namespace model {

namespace {

bool continues(std::string_view text, std::size_t at) {
    return at < text.size() && (static_cast<unsigned char>(text[at]) & 0xC0U) == 0x80U;
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
        return {lead, 1};
    }
    if (lead < 0xC2U || lead > 0xF4U) {
        return {0, 1};
    }
    const std::size_t bytes = lead >= 0xF0U ? 4 : lead >= 0xE0U ? 3 : 2;
    std::uint32_t code = lead & (0x7FU >> bytes);
    for (std::size_t i = 1; i < bytes; ++i) {
        if (!continues(utf8, i)) {
            return {0, i};
        }
        code = code << 6U | (static_cast<unsigned char>(utf8[i]) & 0x3FU);
    }
    return {isForbidden(code, bytes) ? 0 : code, bytes};
}

}  // namespace model
