#include "model/formats/gerber/image/coordinates.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "model/base/ascii.h"
#include "model/base/units.h"

namespace model::gerber {

namespace {

constexpr std::array<double, 19> kPowers = {1e0,  1e1,  1e2,  1e3,  1e4,  1e5,  1e6,  1e7,  1e8, 1e9,
                                            1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18};
/// Where the head ends at the latest: behind the format, before which macros may be as long as they like.
std::size_t headSize(std::string_view text) {
    constexpr std::size_t kUsual = 200'000;
    constexpr std::size_t kLongestCommand = 100;
    const std::size_t format = text.find("%FS", std::min(text.size(), kUsual));
    const bool isLate =
        format != std::string_view::npos && text.substr(0, kUsual).find("%FS") == std::string_view::npos;
    return isLate ? format + kLongestCommand : kUsual;
}

int digit(std::string_view text, std::size_t at) {
    return at < text.size() && base::isDigit(text[at]) ? text[at] - '0' : -1;
}

}  // namespace

bool CoordinateFormat::readFormat(std::string_view text) {
    CoordinateFormat read = *this;
    bool hasX = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        read.isTrailingOmitted = c == 'T' || (read.isTrailingOmitted && c != 'L' && c != 'D');
        read.isIncremental = c == 'I' || (read.isIncremental && c != 'A');
        if ((c == 'X' || (c == 'Y' && !hasX)) && digit(text, i + 1) >= 0 && digit(text, i + 2) >= 0) {
            read.integers = digit(text, i + 1);
            read.decimals = digit(text, i + 2);
            read.isAlikeInXAndY = true;
            hasX = true;
        } else if (c == 'Y') {
            read.isAlikeInXAndY = digit(text, i + 1) == read.integers && digit(text, i + 2) == read.decimals;
        }
    }
    read.hasFormat = true;
    if (hasX) {
        *this = read;
    }
    return hasX;
}

double CoordinateFormat::length(std::int64_t value, int digits) const {
    auto scaled = static_cast<double>(value);
    if (isTrailingOmitted) {
        // What stands first are the integers: digits beyond the format are further decimals.
        const int missing = std::clamp(integers + decimals - digits, -18, 18);
        const double power = kPowers[static_cast<std::size_t>(std::abs(missing))];
        scaled = missing < 0 ? scaled / power : scaled * power;
    }
    return scaled * nmPerUnit / kPowers[static_cast<std::size_t>(decimals)];
}

bool CoordinateFormat::isTooLong(std::int64_t value, int digits) const {
    const int room = integers + decimals;
    return isTrailingOmitted ? digits > room : static_cast<double>(value) >= kPowers[static_cast<std::size_t>(room)];
}

CoordinateFormat findFormat(std::string_view text) {
    CoordinateFormat format;
    const std::string_view head = text.substr(0, headSize(text));
    const std::size_t inch = head.find("MOIN");
    const std::size_t millimetre = head.find("MOMM");
    if (inch != std::string_view::npos || millimetre != std::string_view::npos) {
        format.setUnit(inch < millimetre);
    } else if (head.find("G70") != std::string_view::npos || head.find("G71") != std::string_view::npos) {
        format.setUnit(head.find("G70") < head.find("G71"));
    }
    for (std::size_t at = head.find("FS"); at != std::string_view::npos; at = head.find("FS", at + 2)) {
        const std::string_view rest = head.substr(at + 2);
        const std::string_view command = rest.substr(0, std::min<std::size_t>(rest.find('*'), 40));
        if (!command.empty() && std::string_view("LTDAIXN").find(command.front()) != std::string_view::npos &&
            format.readFormat(command)) {
            break;
        }
    }
    return format;
}

}  // namespace model::gerber
