#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "model/base/limits.h"
#include "model/formats/gerber/image/image_parser.h"
#include "model/formats/gerber/text/words.h"

namespace model::gerber {

namespace {

constexpr std::size_t kLongestName = 60;

std::size_t countLines(const char* begin, const char* end) {
    return static_cast<std::size_t>(std::count(begin, end, '\n'));
}

/// Numbers between X: "0.3X0.1".
std::optional<std::vector<double>> numbersOf(std::string_view text) {
    std::vector<double> numbers;
    std::string upper = upperCase(text);
    for (const std::string_view part : split(upper, 'X')) {
        const std::optional<double> value = parseReal(part);
        if (!value && !part.empty()) {
            return std::nullopt;
        }
        numbers.push_back(value.value_or(0.0));
    }
    return numbers;
}

/// The number behind a letter: 'I' of "X2Y3I5.0J4.0".
std::optional<double> valueOf(std::string_view text, char letter) {
    const std::size_t at = text.find(letter);
    if (at == std::string_view::npos) {
        return std::nullopt;
    }
    text.remove_prefix(at + 1);
    return takeReal(text);
}

/// "A1.5B0": does a number stand behind every letter that is there?
bool isReadable(std::string_view text) {
    return std::ranges::all_of(std::string_view("AB"), [text](char letter) {
        return text.find(letter) == std::string_view::npos || valueOf(text, letter);
    });
}

/// "A0B0" of an image that stays where it is; L and C push it to an edge or the middle of the film.
bool isWithoutOffset(std::string_view text) {
    return text.find_first_of("LC") == std::string_view::npos && isReadable(text) &&
           valueOf(text, 'A').value_or(0.0) == 0.0 && valueOf(text, 'B').value_or(0.0) == 0.0;
}

std::string nameOf(std::string_view name, std::span<const double> parameters) {
    std::string text(name);
    for (std::size_t i = 0; i < parameters.size() && text.size() < kLongestName; ++i) {
        text += (i == 0 ? " " : " x ") + shortNumber(parameters[i]);
    }
    return text;
}

std::string withoutBlanks(std::string_view text) {
    std::string plain;
    std::ranges::copy_if(text, std::back_inserter(plain), [](char c) { return c != '\n' && c != '\r'; });
    return plain;
}

}  // namespace

/// From one % to the next: commands that end with *.
void ImageParser::extended() {
    ++m_at;
    for (;;) {
        skipBlanks();
        if (m_at == m_end) {
            return report(Severity::Warning, "the file ends within a command");
        }
        if (*m_at == '%') {
            ++m_at;
            return;
        }
        if (*m_at == '*') {
            ++m_at;
            continue;
        }
        const std::string_view rest(m_at, static_cast<std::size_t>(m_end - m_at));
        const bool isMacro = rest.starts_with("AM");
        const std::size_t length = isMacro ? rest.find('%') : rest.find_first_of("*%");
        const std::string_view text = rest.substr(0, length);
        if (length == std::string_view::npos) {
            report(Severity::Warning, "the file ends within a command");
        }
        if (isMacro) {
            macro(text.substr(2));
        } else {
            command(text);
        }
        m_line += static_cast<std::uint32_t>(countLines(text.data(), text.data() + text.size()));
        m_at += text.size();
    }
}

void ImageParser::command(std::string_view raw) {
    const std::string plain = raw.find_first_of("\r\n") == std::string_view::npos ? std::string() : withoutBlanks(raw);
    const std::string_view text = trimmed(plain.empty() ? raw : std::string_view(plain));
    const std::string_view code = text.substr(0, 2);
    const std::string_view rest = text.substr(std::min<std::size_t>(2, text.size()));
    if (text.starts_with("G04") || m_attributes.command(code, rest)) {
        return;
    }
    if (!parameter(code, rest) && !imageParameter(code, rest)) {
        report(Severity::Warning, "a command between % that is not known; it was left out");
    }
}

bool ImageParser::parameter(std::string_view code, std::string_view rest) {
    bool isGood = true;
    if (code == "AD") {
        define(rest);
    } else if (code == "AB") {
        block(rest);
    } else if (code == "SR") {
        repeat(rest);
    } else if (code == "LP") {
        m_isClear = rest.starts_with('C');
        isGood = m_isClear || rest.starts_with('D');
    } else if (code == "LM") {
        m_isMirroredX = rest.find('X') != std::string_view::npos;
        m_isMirroredY = rest.find('Y') != std::string_view::npos;
        isGood = !rest.empty() && rest.find_first_not_of("NXY") == std::string_view::npos;
    } else if (code == "LR") {
        isGood = parseReal(rest).has_value();
        m_rotation = parseReal(rest).value_or(0.0);
    } else if (code == "LS") {
        const double scale = parseReal(rest).value_or(1.0);
        isGood = parseReal(rest) && scale > 0.0 && scale < 1e6;
        m_scale = isGood ? scale : 1.0;
    } else {
        return false;
    }
    if (!isGood) {
        report(Severity::Warning,
               "a polarity, mirroring, rotation or scale (LP, LM, LR, LS) that cannot be read; none applies");
    }
    if (code.front() == 'L') {
        m_flashed.placement = placementOf(m_isMirroredX, m_isMirroredY, m_rotation);
        m_flashed.scale = m_scale;
    }
    return true;
}

/// Commands for the image as a whole. Most of them are outdated.
bool ImageParser::imageParameter(std::string_view code, std::string_view rest) {
    if (code == "FS" || code == "MO") {
        checkFormat(code, rest);
    } else if (code == "LN" || code == "IN") {
        m_image.comments.emplace_back(rest);
    } else if (code == "IP") {
        m_image.isNegative = rest.starts_with("NEG");
        if (!m_image.isNegative && !rest.starts_with("POS")) {
            report(Severity::Warning, "a polarity of the image (IP) that cannot be read; taken as positive");
        }
    } else if (code == "IJ" || code == "IO") {
        if (!isWithoutOffset(rest)) {
            report(Severity::Warning,
                   "the image is moved on its film by an outdated command (IJ, IO), which was not applied");
        }
    } else if (code == "IF" || code == "KO") {
        report(Severity::Warning, "included files and knockouts, long outdated, are not read");
    } else {
        return code == "IC" || code == "PF" || transformImage(code, rest);
    }
    return true;
}

/// The first ones of the file have been found before it is read (findFormat).
void ImageParser::checkFormat(std::string_view code, std::string_view rest) {
    if (code == "MO") {
        const bool isOther = m_format.hasUnit && (rest == "IN" || rest == "MM") &&
                             m_format.nmPerUnit != (rest == "IN" ? base::kNmPerInch : base::kNmPerMm);
        if (isOther) {
            report(Severity::Warning, "the file names a second unit (MO); the first one is taken for all of it");
        }
        return;
    }
    CoordinateFormat format = m_format;
    const bool isRead = format.readFormat(rest);
    const bool isOther = format.integers != m_format.integers || format.decimals != m_format.decimals ||
                         format.isTrailingOmitted != m_format.isTrailingOmitted;
    if (m_format.hasFormat && (!isRead || isOther)) {
        report(Severity::Warning,
               "the file says a second time how its coordinates are written (FS); the first is taken for all of it");
    } else if (isRead && !format.isAlikeInXAndY) {
        report(Severity::Warning, "x and y are written with different digits (FS); both are read with those of x");
    }
}

/// Moves and rotates all of the image, or mirrors and scales its coordinates: not apertures, nor the distances of
/// repeated steps (Gerber specification 8.1.7 and 8.1.9). False for other commands.
bool ImageParser::transformImage(std::string_view code, std::string_view rest) {
    const double a = valueOf(rest, 'A').value_or(0.0);
    const double b = valueOf(rest, 'B').value_or(0.0);
    bool isNeutral = true;
    bool isGood = true;
    if (code == "OF") {
        isNeutral = a == 0.0 && b == 0.0;
        const std::optional<Nm> x = toNm(a * m_format.nmPerUnit);
        const std::optional<Nm> y = toNm(b * m_format.nmPerUnit);
        isGood = x && y && isReadable(rest);
        m_imageOffset = isGood ? Point{*x, *y} : Point{};
    } else if (code == "MI") {
        isNeutral = a == 0.0 && b == 0.0;
        isGood = isReadable(rest);
        m_isImageMirroredA = a != 0.0;
        m_isImageMirroredB = b != 0.0;
    } else if (code == "IR") {
        m_imageRotation = parseReal(rest).value_or(0.0);
        isNeutral = m_imageRotation == 0.0;
        isGood = parseReal(rest).has_value();
    } else if (code == "AS") {
        m_isAxesSwapped = rest.starts_with("AY");
        isNeutral = !m_isAxesSwapped;
        isGood = m_isAxesSwapped || rest.starts_with("AX");
    } else if (code == "SF") {
        isNeutral = (a == 0.0 || a == 1.0) && (b == 0.0 || b == 1.0);
        isGood = isReadable(rest);
        if (!isNeutral && a == b && a > 0.0 && a < 1e6) {
            m_imageScale = a;
        } else if (!isNeutral) {
            report(Severity::Warning, "the image is scaled differently in x and y; it is drawn unscaled");
            return true;
        }
    } else {
        return false;
    }
    if (!isGood) {
        report(Severity::Warning,
               "a move, mirroring, rotation or scale of the image (OF, MI, IR, AS, SF) that cannot be read");
    } else if (!isNeutral) {
        report(Severity::Info,
               "the image is moved, mirrored, rotated or scaled by an outdated command, which was applied");
    }
    return true;
}

void ImageParser::macro(std::string_view text) {
    const std::size_t star = text.find('*');
    const std::string name(trimmed(text.substr(0, star)));
    m_macros.insert_or_assign(name, Macro(star == std::string_view::npos ? std::string_view() : text.substr(star + 1)));
}

/// "D10C,0.3" or "D10ROUNDED,1X2".
void ImageParser::define(std::string_view rest) {
    const std::size_t digits = rest.find_first_not_of("0123456789", 1);
    const std::optional<int> code = rest.starts_with('D') ? parseInteger(rest.substr(1, digits - 1)) : std::nullopt;
    if (!code || *code < 10 || digits == std::string_view::npos) {
        return report(Severity::Warning, "an aperture whose definition cannot be read; it was left out");
    }
    const std::size_t comma = rest.find(',', digits);
    const std::string_view name = trimmed(rest.substr(digits, comma - digits));
    std::optional<std::vector<double>> parameters = std::vector<double>();
    if (comma != std::string_view::npos) {
        parameters = numbersOf(rest.substr(comma + 1));
    }
    if (!parameters) {
        report(Severity::Warning, "an aperture whose sizes cannot be read; it draws nothing");
        parameters.emplace();
    }
    formats::DrawnSymbol symbol{nameOf(name, *parameters), {}};
    std::vector<std::string> problems;
    const auto found = m_macros.find(name);
    bool isKnown = found != m_macros.end();
    if (isKnown) {
        symbol.shape = found->second.shape(*parameters, m_format.nmPerUnit, problems);
    } else if (name.size() == 1) {
        symbol.shape = standardAperture(name[0], *parameters, m_format.nmPerUnit, problems, isKnown);
    }
    if (!isKnown) {
        problems.emplace_back("an aperture of a macro that is not defined; it draws nothing");
    } else if (!symbol.shape.problem.empty()) {
        problems.push_back(std::exchange(symbol.shape.problem, {}));
    }
    for (const std::string& problem : problems) {
        report(Severity::Warning, problem);
    }
    if (m_apertures.contains(*code)) {
        report(Severity::Info, "an aperture is defined again; the new definition counts from here on");
    }
    m_apertures[*code] = {static_cast<std::int32_t>(m_image.symbols.size()), formats::kNoRow,
                          m_attributes.apertureSet()};
    m_image.symbols.push_back(std::move(symbol));
    m_aperture = nullptr;
    if (const auto selected = m_apertures.find(m_selected); selected != m_apertures.end()) {
        m_aperture = &selected->second;
    }
}

/// "D12" begins a block, nothing ends it.
void ImageParser::block(std::string_view rest) {
    if (rest.empty()) {
        if (m_frames.empty() || !m_frames.back().isBlock) {
            return report(Severity::Warning, "the end of a block that was not begun");
        }
        return endFrame();
    }
    const std::optional<int> code = parseInteger(rest.substr(1));
    if (m_frames.size() >= base::kMostBlockDepth) {
        return report(Severity::Warning,
                      "a block in " + base::moreThan(base::kMostBlockDepth, "others") + "; its parts are drawn");
    }
    if (!rest.starts_with('D') || !code || *code < 10) {
        return report(Severity::Warning, "a block whose number cannot be read; its parts are drawn");
    }
    Frame frame;
    frame.isBlock = true;
    frame.aperture = *code;
    frame.attributes = m_attributes.apertureSet();
    m_frames.push_back(std::move(frame));
}

/// "X2Y3I5.0J4.0" begins a repeated step, nothing (or one copy) ends it.
void ImageParser::repeat(std::string_view rest) {
    if (!m_frames.empty() && !m_frames.back().isBlock) {
        endFrame();
    }
    const double nx = valueOf(rest, 'X').value_or(rest.find('X') == std::string_view::npos ? 1.0 : 0.0);
    const double ny = valueOf(rest, 'Y').value_or(rest.find('Y') == std::string_view::npos ? 1.0 : 0.0);
    if (rest.empty() || (nx == 1.0 && ny == 1.0)) {
        return;
    }
    if (m_frames.size() >= base::kMostBlockDepth) {
        return report(Severity::Warning,
                      "a repeated step in " + base::moreThan(base::kMostBlockDepth, "others") + "; it is drawn once");
    }
    if (!(nx >= 1 && ny >= 1 && nx <= static_cast<double>(base::kMostCopies) &&
          ny <= static_cast<double>(base::kMostCopies))) {
        return report(Severity::Warning, "a repeated step whose counts cannot be read or draw " +
                                             base::moreThan(base::kMostCopies, "copies") + "; it is drawn once");
    }
    Frame frame;
    frame.nx = static_cast<int>(nx);
    frame.ny = static_cast<int>(ny);
    frame.dx = valueOf(rest, 'I').value_or(0.0) * m_format.nmPerUnit;
    frame.dy = valueOf(rest, 'J').value_or(0.0) * m_format.nmPerUnit;
    m_frames.push_back(std::move(frame));
}

}  // namespace model::gerber
