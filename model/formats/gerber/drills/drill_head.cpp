#include <algorithm>
#include <utility>

#include "model/base/ascii.h"
#include "model/base/units.h"
#include "model/formats/gerber/drills/drill_file.h"
#include "model/formats/gerber/text/words.h"

namespace model::gerber {

namespace {

/// What the digits of the coordinates show.
struct Digits {
    bool hasLeadingZero = false;
    bool hasTrailingZero = false;
    std::size_t shortest = 99;
    std::size_t longest = 0;
};

void look(std::string_view line, DrillHead& head, Digits& digits) {
    for (std::size_t i = 0; i < line.size(); ++i) {
        if ((line[i] != 'X' && line[i] != 'Y') || i + 1 >= line.size()) {
            continue;
        }
        std::string_view number = line.substr(i + 1);
        number.remove_prefix(std::min(number.find_first_not_of("+- "), number.size()));
        const std::size_t length = std::min(number.find_first_not_of("0123456789"), number.size());
        const bool hasPoint = length < number.size() && number[length] == '.';
        head.areAllWithPoint = head.areAllWithPoint && hasPoint;
        head.hasHits = true;
        number = number.substr(0, length);
        if (!hasPoint && number.find_first_not_of('0') != std::string_view::npos) {
            digits.hasLeadingZero = digits.hasLeadingZero || number.front() == '0';
            digits.hasTrailingZero = digits.hasTrailingZero || number.back() == '0';
            digits.shortest = std::min(digits.shortest, length);
            digits.longest = std::max(digits.longest, length);
        }
    }
}

/// "4:4", "3.3" or "2,4".
void readDigits(std::string_view text, DrillHead& head) {
    for (std::size_t i = 1; i + 1 < text.size(); ++i) {
        const bool isPair =
            (text[i] == ':' || text[i] == '.') && base::isDigit(text[i - 1]) && base::isDigit(text[i + 1]);
        if (isPair) {
            head.integers = text[i - 1] - '0';
            head.decimals = text[i + 1] - '0';
            return;
        }
    }
}

void readComment(std::string_view text, DrillHead& head) {
    if (holds(text, "FILE_FORMAT")) {
        readDigits(text, head);
    } else if (holds(text, "Format") && text.find('/') != std::string_view::npos && !holds(text, "FORMAT={")) {
        readDigits(text, head);  // Mentor: "Format : 3.3 / Absolute / MM / Leading"
    } else if (holds(text, "FORMAT={")) {
        readDigits(text.substr(0, text.find('/')),
                   head);  // KiCad: "FORMAT={3:3/ absolute / metric / suppress leading zeros}"
    }
}

/// INCH or METRIC with LZ or TZ and 000.000 behind it, M71 and M72.
void readUnit(std::string_view line, DrillHead& head) {
    const bool isInch = line.starts_with("INCH") || line.starts_with("M72");
    const bool isMetric = line.starts_with("METRIC") || line.starts_with("M71");
    if (!isInch && !isMetric) {
        return;
    }
    head.isInch = isInch;
    head.looksLikeDrills = true;
    for (const std::string_view part : split(line, ',')) {
        if (part == "LZ" || part == "TZ") {
            head.isTrailingOmitted = part == "LZ";
        } else if (part.size() > 2 && part.find_first_not_of("0.") == std::string_view::npos) {
            const std::size_t point = std::min(part.find('.'), part.size());
            head.integers = static_cast<int>(point);
            head.decimals = static_cast<int>(part.size() - std::min(point + 1, part.size()));
        }
    }
}

CoordinateFormat formatOf(bool isInch, bool isTrailingOmitted, int integers, int decimals) {
    CoordinateFormat format;
    format.setUnit(isInch);
    format.isTrailingOmitted = isTrailingOmitted;
    format.integers = integers;
    format.decimals = decimals;
    return format;
}

}  // namespace

DrillHead readDrillHead(std::string_view text) {
    DrillHead head;
    Digits digits;
    Lines lines(text);
    while (lines.next()) {
        const std::string_view line = trimmed(lines.line());
        if (line.empty()) {
            continue;
        }
        if (line.front() == ';') {
            readComment(line.substr(1), head);
        } else if (line.front() == 'X' || line.front() == 'Y' || line.starts_with("G0")) {
            look(line, head, digits);
        } else {
            head.hasHeader = head.hasHeader || line.starts_with("M48");
            readUnit(line, head);
        }
    }
    head.looksLikeDrills = head.looksLikeDrills || head.hasHeader;
    const bool isVarying = digits.longest > digits.shortest;
    head.areAllOfOneLength = digits.longest == digits.shortest;
    if (!head.isTrailingOmitted && isVarying && digits.hasLeadingZero != digits.hasTrailingZero) {
        head.isTrailingOmitted = digits.hasLeadingZero;
    }
    return head;
}

std::vector<CoordinateFormat> likelyFormats(const DrillHead& head) {
    const bool isInch = head.isInch.value_or(true);
    const bool isTrailingOmitted = head.isTrailingOmitted.value_or(false);
    std::vector<CoordinateFormat> formats = {formatOf(isInch, isTrailingOmitted, head.integers.value_or(isInch ? 2 : 3),
                                                      head.decimals.value_or(isInch ? 4 : 3))};
    formats[0].hasFormat = head.integers.has_value();
    struct Digits {
        bool isInch;
        int integers;
        int decimals;
    };
    constexpr Digits kUsual[] = {{true, 2, 4},  {false, 3, 3}, {false, 4, 2}, {false, 3, 2}, {true, 2, 3},
                                 {true, 2, 5},  {true, 3, 3},  {false, 4, 4}, {false, 3, 4}, {true, 2, 6},
                                 {true, 3, 5},  {false, 4, 3}, {false, 3, 5}, {false, 4, 5}, {true, 3, 6},
                                 {false, 3, 6}, {true, 4, 4}};
    for (const Digits& digits : kUsual) {
        for (const bool trailing : {isTrailingOmitted, !isTrailingOmitted}) {
            formats.push_back(formatOf(digits.isInch, trailing, digits.integers, digits.decimals));
        }
    }
    // A file that tells its unit, or its zeros or leaves out none, rather means other digits than another of these.
    const bool areZerosKnown = head.isTrailingOmitted || head.areAllOfOneLength;
    std::ranges::stable_sort(formats, {}, [&](const CoordinateFormat& format) {
        const bool isOtherUnit = head.isInch && (format.nmPerUnit == base::kNmPerInch) != isInch;
        return std::pair(isOtherUnit, areZerosKnown && format.isTrailingOmitted != isTrailingOmitted);
    });
    return formats;
}

std::string describe(const CoordinateFormat& format) {
    return std::string(format.nmPerUnit == base::kNmPerInch ? "inch " : "mm ") + std::to_string(format.integers) + "." +
           std::to_string(format.decimals) +
           (format.isTrailingOmitted ? ", leading zeros kept" : ", trailing zeros kept");
}

}  // namespace model::gerber
