#include "model/formats/gerber/image/image_parser.h"

#include <algorithm>
#include <cmath>

#include "model/base/ascii.h"
#include "model/formats/gerber/text/words.h"

namespace model::gerber {

namespace {

constexpr std::size_t kMostComments = 100;

/// Room for this many objects is made before reading: growing step by step would copy them, and have the system hand
/// out memory, twice over, which took most of the time of reading.
std::size_t likelyObjects(std::string_view text) {
    constexpr std::size_t kMost = 1'000'000;
    std::size_t count = 0;
    for (std::size_t at = text.find('*', 1); at != std::string_view::npos && count < kMost;
         at = text.find('*', at + 1)) {
        count += text[at - 1] == '1' || text[at - 1] == '3' ? 1 : 0;  // D01 and D03, and few others
    }
    return count;
}

}  // namespace

Image parseImage(std::string_view text, std::string_view path, base::PointD shift) {
    return ImageParser(text, path, shift).run();
}

ImageParser::ImageParser(std::string_view text, std::string_view path, base::PointD shift)
    : m_at(text.data()),
      m_end(text.data() + text.size()),
      m_path(path),
      m_attributes(m_image),
      m_mover(m_image),
      m_format(findFormat(text)) {
    m_format.shift = shift;
    if (text.starts_with("\xef\xbb\xbf")) {
        m_at += 3;
    }
}

Image ImageParser::run() {
    if (!m_format.hasFormat) {
        report(Severity::Warning,
               "the file does not say how its coordinates are written (FS); taken as 2 digits before "
               "and 5 behind the point");
    }
    if (!m_format.hasUnit) {
        report(Severity::Warning, "the file does not say its unit (MO); taken as inch");
    }
    m_image.features.reserve(likelyObjects({m_at, m_end}));
    while (!m_isDone) {
        skipBlanks();
        if (m_at == m_end) {
            break;
        }
        if (*m_at == '*') {
            ++m_at;
        } else if (*m_at == '%') {
            extended();
        } else {
            word();
        }
    }
    finish();
    reportRest();
    m_image.isInInches = m_format.nmPerUnit == base::kNmPerInch;
    return std::move(m_image);
}

void ImageParser::skipBlanks() {
    while (m_at != m_end && base::isBlank(*m_at)) {
        m_line += *m_at == '\n' ? 1 : 0;
        ++m_at;
    }
}

int ImageParser::readInteger() {
    int value = 0;
    skipBlanks();
    while (m_at != m_end && base::isDigit(*m_at)) {
        value = std::min(value * 10 + (*m_at - '0'), 100'000'000);
        ++m_at;
    }
    return value;
}

double ImageParser::readLength() {
    skipBlanks();
    bool isNegative = false;
    while (m_at != m_end && (*m_at == '-' || *m_at == '+')) {
        isNegative = *m_at == '-';
        ++m_at;
    }
    std::int64_t value = 0;
    int digits = 0;
    int behindPoint = -1;
    for (; m_at != m_end; ++m_at) {
        if (base::isDigit(*m_at)) {
            if (digits < 18) {
                value = value * 10 + (*m_at - '0');
                ++digits;
                behindPoint += behindPoint >= 0 ? 1 : 0;
            } else if (behindPoint < 0) {
                value = 1'000'000'000'000'000'000;  // too long to mean anything: beyond every board
            }
        } else if (*m_at == '.' && behindPoint < 0) {
            behindPoint = 0;
        } else {
            break;
        }
    }
    if (digits == 0) {
        report(Severity::Warning, "a coordinate without digits; it is taken as 0");
    } else if (behindPoint < 0 && m_format.hasFormat && m_format.isTooLong(value, digits)) {
        // Where zeros in front are left out, there is no doubt what further digits in front are.
        report(m_format.isTrailingOmitted ? Severity::Warning : Severity::Info,
               "a coordinate has more digits than the file's format (FS); it is read as it stands");
    }
    const auto magnitude = behindPoint >= 0
                               ? static_cast<double>(value) * m_format.nmPerUnit / std::pow(10.0, behindPoint)
                               : m_format.length(value, digits);
    return isNegative ? -magnitude : magnitude;
}

void ImageParser::comment() {
    const char* const begin = m_at;
    while (m_at != m_end && *m_at != '*') {
        const bool isOpen = *m_at == '%' && m_at + 1 != m_end && (m_at[1] == '\n' || m_at[1] == '\r');
        if (isOpen) {
            ++m_at;
            return report(Severity::Warning, "a comment that ends with % in place of *; what follows is read");
        }
        m_line += *m_at == '\n' ? 1 : 0;
        ++m_at;
    }
    std::string_view text = trimmed({begin, static_cast<std::size_t>(m_at - begin)});
    if (text.starts_with("#@!")) {
        text = trimmed(text.substr(3));
        text.remove_prefix(text.starts_with('%') ? 1 : 0);
        if (text.size() >= 2 && m_attributes.command(text.substr(0, 2), text.substr(2))) {
            return;
        }
    }
    if (!text.empty() && m_image.comments.size() < kMostComments) {
        m_image.comments.emplace_back(text);
    }
}

void ImageParser::word() {
    Word data;
    while (m_at != m_end && *m_at != '*' && *m_at != '%') {
        const char c = *m_at++;
        switch (c) {
            case 'X':
                data.x = readLength();
                data.hasX = data.hasData = true;
                break;
            case 'Y':
                data.y = readLength();
                data.hasY = data.hasData = true;
                break;
            case 'I':
                data.i = readLength();
                data.hasData = true;
                break;
            case 'J':
                data.j = readLength();
                data.hasData = true;
                break;
            case 'D': {
                const int code = readInteger();
                if (code < 10) {
                    data.operation = code;
                } else {
                    select(code);
                }
                break;
            }
            case 'G': {
                const int code = readInteger();
                if (code == 4) {
                    return comment();
                }
                gCode(code);
                break;
            }
            case 'M': mCode(readInteger()); break;
            case 'N': (void)readInteger(); break;
            case '\n': ++m_line; break;
            case ' ':
            case '\r':
            case '\t': break;
            default: report(Severity::Warning, "a command that is not of Gerber's; it was left out"); return comment();
        }
    }
    endWord(data);
    if (m_at != m_end && *m_at == '*') {
        ++m_at;
    }
}

void ImageParser::endWord(const Word& data) {
    if (data.operation != 0 || data.hasData) {
        operate(data);
    }
}

void ImageParser::select(int code) {
    m_selected = code;
    const auto found = m_apertures.find(code);
    m_aperture = found == m_apertures.end() ? nullptr : &found->second;
    if (m_aperture == nullptr) {
        report(Severity::Warning, "an aperture that is not defined; what is drawn with it is left out");
    }
}

void ImageParser::mCode(int code) {
    m_isDone = m_isDone || code == 0 || code == 2 || code == 30;
    m_image.hasEnd = m_image.hasEnd || m_isDone;
    if (!m_isDone && code != 1) {  // M01 is a stop that one may ignore
        report(Severity::Warning, "an M code that has no meaning for images; it was left out");
    }
}

/// Some programs fill the rest of the file with blanks, zeros or Ctrl-Z; EasyEDA ends it twice, with M00 and M02.
void ImageParser::reportRest() {
    constexpr std::string_view kFillers("*% \t\r\n\0\x1a", 8);
    const std::string_view rest(m_at, static_cast<std::size_t>(m_end - m_at));
    std::size_t first = rest.find_first_not_of(kFillers);
    while (first != std::string_view::npos &&
           (rest.substr(first).starts_with("M02") || rest.substr(first).starts_with("M00"))) {
        first = rest.find_first_not_of(kFillers, first + 3);
    }
    if (first != std::string_view::npos) {
        m_line += static_cast<std::uint32_t>(
            std::count(rest.begin(), rest.begin() + static_cast<std::ptrdiff_t>(first), '\n'));
        report(Severity::Warning, "commands behind the end of the image (M00, M02) are not read");
    }
}

void ImageParser::gCode(int code) {
    switch (code) {
        case 0:
        case 1: m_mode = Mode::Linear; break;
        case 2: m_mode = Mode::Clockwise; break;
        case 3: m_mode = Mode::CounterClockwise; break;
        case 36: beginRegion(); break;
        case 37: endRegion(); break;
        case 54:
        case 55: break;  // before D: select, flash
        case 70:
        case 71:
            if (m_format.hasUnit && m_format.nmPerUnit != (code == 70 ? base::kNmPerInch : base::kNmPerMm)) {
                report(Severity::Warning, "G70 or G71 names another unit than MO; MO is believed");
            } else {
                m_format.setUnit(code == 70);
            }
            break;
        case 74:
        case 75:
            m_isSingleQuadrant = code == 74;
            m_hasQuadrant = true;
            break;
        case 90: m_format.isIncremental = false; break;
        case 91: m_format.isIncremental = true; break;
        default: report(Severity::Warning, "a G code that has no meaning for images; it was left out");
    }
}

}  // namespace model::gerber
