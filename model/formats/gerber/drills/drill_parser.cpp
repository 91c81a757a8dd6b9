#include "model/formats/gerber/drills/drill_parser.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "model/base/ascii.h"
#include "model/base/units.h"
#include "model/formats/gerber/drills/drill_functions.h"
#include "model/formats/gerber/text/words.h"

namespace model::gerber {

using formats::DrawnFeature;

namespace {

constexpr std::size_t kMostComments = 100;
constexpr int kMostToolNumber = 1'000'000;
/// Letters of numbers that say no place: line, feed, spindle, depth, retraction, hits of a tool, size of a tool.
constexpr std::string_view kOfTheMachine = "NFSZBHC,";

/// Formats, which the head has told, and what only the machine needs to know (R,H resets a counter).
bool isOfTheMachine(std::string_view line) {
    constexpr std::string_view kBeginnings[] = {"FMAT", "VER,", "DETECT", "ATC", "BLKD", "SBK", "TCST", "OSTOP", "R,"};
    return line == "/" || line.starts_with('%') ||
           std::ranges::any_of(kBeginnings, [&](std::string_view word) { return line.starts_with(word); });
}

/// M71 and M72 may have zeros behind them, as METRIC and INCH have.
bool isUnit(std::string_view line) {
    const bool isCode = line.starts_with("M71") || line.starts_with("M72");
    return line.starts_with("INCH") || line.starts_with("METRIC") || (isCode && (line.size() == 3 || line[3] == ','));
}

/// Behind these stands a message for the operator, or a text to drill.
bool isText(const DrillValue& part) {
    return part.letter == 'M' &&
           (part.digits == "45" || part.digits == "47" || part.digits == "97" || part.digits == "98");
}

/// Where Allegro does not select tools, comments list their sizes, and the operator changes them in that order.
bool areToolsChangedByStop(std::string_view text) {
    bool isAnySize = false;
    Lines lines(text);
    while (lines.next()) {
        const std::string_view line = trimmed(lines.line());
        if (line.size() > 1 && line[0] == 'T' && base::isDigit(line[1])) {
            return false;
        }
        isAnySize = isAnySize || (line.starts_with(';') && holds(line, "Holesize"));
    }
    return isAnySize;
}

/// Cycles that drill or rout a figure around a place.
bool isCycle(int code) {
    return code == 32 || code == 33 || code == 82 || code == 83 || code == 84 || code == 87;
}

}  // namespace

Image parseDrills(std::string_view text, std::string_view path, const CoordinateFormat& format) {
    return DrillParser(path, format).run(text);
}

DrillParser::DrillParser(std::string_view path, const CoordinateFormat& format)
    : m_path(path), m_format(format), m_attributes(m_image), m_origin(format.shift) {}

Image DrillParser::run(std::string_view text) {
    m_hasPlunges = text.find("M15") != std::string_view::npos || text.find("M14") != std::string_view::npos;
    m_isInHeader = text.find("M48") != std::string_view::npos;
    m_isToolChangedByStop = areToolsChangedByStop(text);
    m_tool = m_isToolChangedByStop ? 1 : 0;
    Lines lines(text);
    bool hasLine = lines.next();
    for (; hasLine && !m_isDone; hasLine = lines.next()) {
        m_line = lines.number();
        line(trimmed(lines.line()));
    }
    for (; hasLine; hasLine = lines.next()) {
        reportRest(lines.line(), lines.number());
    }
    if (!m_image.hasEnd) {
        report(Severity::Warning, "the drill file ends without M30: it may be cut off");
    }
    finishTools();
    return std::move(m_image);
}

void DrillParser::line(std::string_view text) {
    const std::size_t semicolon = text.find(';');
    if (semicolon != std::string_view::npos) {
        comment(trimmed(text.substr(semicolon + 1)));
    }
    const std::string_view words = trimmed(text.substr(0, semicolon));
    if (!words.empty()) {
        record(words);
    }
}

// ---- comments ----

void DrillParser::comment(std::string_view text) {
    if (text.starts_with("#@!")) {
        text = trimmed(text.substr(3));
        if (text.size() > 2 && m_attributes.command(text.substr(0, 2), text.substr(2))) {
            return;
        }
    }
    if (text.starts_with("TYPE=") || text.starts_with("Contents")) {
        m_section = platingOfWords(text);
    }
    sizeInComment(text);
    if (m_image.comments.size() < kMostComments) {
        m_image.comments.emplace_back(text);
    }
}

/// "T01 Holesize 1. = 12.000000 Tolerance = … PLATED MILS Quantity = 241", with or without the tool before it.
void DrillParser::sizeInComment(std::string_view text) {
    const std::size_t word = text.find("Holesize");
    const std::size_t equals = text.find('=');
    if (word == std::string_view::npos || equals == std::string_view::npos) {
        return;
    }
    std::string_view number =
        word > 0 ? trimmed(text.substr(0, word)) : trimmed(text.substr(word + 8, equals - word - 8));
    number.remove_prefix(number.starts_with('T') ? 1 : 0);
    const std::optional<double> tool = takeReal(number);
    std::string_view rest = text.substr(equals + 1);
    const std::optional<double> size = takeReal(rest);
    if (!tool || !size || *tool < 1 || *tool > 9999) {
        return;
    }
    const double nm = holds(rest, "MILS") ? base::kNmPerMil : holds(rest, "INCH") ? base::kNmPerInch : base::kNmPerMm;
    Tool& entry = m_tools[static_cast<int>(*tool)];
    entry.size = entry.size > 0 ? entry.size : *size * nm;
    entry.plating = entry.plating == Plating::NotSaid ? platingOfWords(rest) : entry.plating;
}

/// Does M00 stop the machine for the next tool, and not the file?
bool DrillParser::changesTool() {
    const bool isChange = m_isToolChangedByStop && m_tools.contains(m_tool + 1);
    m_tool += isChange ? 1 : 0;
    return isChange;
}

/// Some programs fill the rest of the file with blanks, zeros or Ctrl-Z.
void DrillParser::reportRest(std::string_view text, std::uint32_t line) {
    constexpr std::string_view kFillers("% \t\0\x1a", 5);
    text = text.substr(0, text.find(';'));
    if (text.find_first_not_of(kFillers) != std::string_view::npos) {
        m_image.diagnostics.report(Severity::Warning, m_path, line,
                                   "records behind the end of the drill file (M00, M30) are not read");
    }
}

// ---- records ----

void DrillParser::record(std::string_view text) {
    if (text == "%" || text.starts_with("M95")) {
        m_isInHeader = false;
        return;
    }
    if (isUnit(text)) {
        return checkUnit(text);
    }
    if (text.starts_with("FMAT") && text.find('1') != std::string_view::npos) {
        report(Severity::Warning, "commands of format 1 (FMAT,1) are read as those of format 2");
    }
    if (isOfTheMachine(text)) {
        return;
    }
    if (text.starts_with("ICI")) {
        m_isIncremental = holds(text, "ON");
        return;
    }
    if (text.front() == 'R' && text.size() > 1 && base::isDigit(text[1])) {
        return repeat(values(text));
    }
    const std::string_view letters = "XYGMNIJASFCZHBT";
    if (letters.find(text.front()) == std::string_view::npos) {
        return report(Severity::Warning, "a record that is not of Excellon's; it was left out");
    }
    words(values(text));
}

/// The head has found the unit before the file is read.
void DrillParser::checkUnit(std::string_view text) {
    const bool isInch = text.starts_with("INCH") || text.starts_with("M72");
    if (m_isInch && *m_isInch != isInch) {
        const double before = isInch ? base::kNmPerMm : base::kNmPerInch;
        const double now = isInch ? base::kNmPerInch : base::kNmPerMm;
        const bool isOfTools = m_image.features.empty() && m_format.nmPerUnit == now;
        if (isOfTools) {
            scaleTools(before / now);
        }
        report(Severity::Warning,
               isOfTools ? "the file names two units; its tools are read in the first one, its places in the second one"
                         : "the file names two units; one is taken for all of it");
    }
    m_isInch = isInch;
}

/// Those whose sizes come from records so far; comments have units of their own.
void DrillParser::scaleTools(double factor) {
    for (auto& [number, tool] : m_tools) {
        tool.size *= tool.isDefined ? factor : 1.0;
    }
}

/// Without the text that some records end with.
const DrillValues& DrillParser::values(std::string_view text) {
    m_values.clear();
    for (std::size_t i = 0; i < text.size();) {
        const char letter = text[i];
        const std::size_t begin = i + 1;
        i = begin;
        while (i < text.size() && std::string_view("0123456789.+- ").find(text[i]) != std::string_view::npos) {
            ++i;
        }
        m_values.push_back({letter, trimmed(text.substr(begin, i - begin))});
        if (isText(m_values.back())) {
            break;
        }
    }
    return m_values;
}

double DrillParser::length(std::string_view digits) {
    if (digits.find('.') != std::string_view::npos) {
        const std::optional<double> value = parseReal(digits);
        m_isBad = m_isBad || !value;
        return value.value_or(0.0) * m_format.nmPerUnit;
    }
    const bool isNegative = digits.starts_with('-');
    digits.remove_prefix(std::min(digits.find_first_not_of("+-"), digits.size()));
    std::int64_t value = 0;
    for (const char c : digits.substr(0, 18)) {
        m_isBad = m_isBad || c < '0' || c > '9';
        value = value * 10 + (c - '0');
    }
    m_isBad = m_isBad || digits.empty();
    if (!m_isBad && m_format.hasFormat && m_format.isTooLong(value, static_cast<int>(digits.size()))) {
        report(Severity::Warning, "a coordinate has more digits than the file's format; it is read as it stands");
    }
    const double nm =
        m_isBad ? 0.0 : m_format.length(value, static_cast<int>(std::min<std::size_t>(digits.size(), 18)));
    return isNegative ? -nm : nm;
}

/// A tool counts for the hole of its record, wherever it stands there.
void DrillParser::words(const DrillValues& parts) {
    m_isBad = false;
    if (std::ranges::find(parts, 'T', &DrillValue::letter) != parts.end()) {
        tool(parts);
    }
    Target target;
    for (const DrillValue& part : parts) {
        word(part, parts, target);
    }
    if (m_isBad) {
        return report(Severity::Warning, "a coordinate that cannot be read; the record was left out");
    }
    if (m_isDone || m_isConsumed) {
        m_isConsumed = false;
        return;
    }
    if (target.isCycle) {
        return moveTo(target.x, target.y);
    }
    const bool isCircle = m_isRouting && m_motion > 1 && target.hasCentre();
    if (target.isSlot || target.hasPlace() || isCircle) {
        operate(target);
    }
    if (target.lifts) {
        lift();
    }
}

void DrillParser::word(const DrillValue& part, const DrillValues& parts, Target& target) {
    const bool isSecond = (part.letter == 'X' && target.x) || (part.letter == 'Y' && target.y);
    if (isSecond && target.isCycle) {
        return;  // the size of its figure
    }
    if (isSecond && target.isSlot) {
        beginSlot(target);  // G85X1Y1X2Y2: both ends are behind it
    }
    switch (part.letter) {
        case 'X': target.x = length(part.digits); break;
        case 'Y': target.y = length(part.digits); break;
        case 'A': target.radius = length(part.digits); break;
        case 'I': target.i = length(part.digits); break;
        case 'J': target.j = length(part.digits); break;
        case 'G': code(part.digits, parts, target); break;
        case 'M': misc(part.digits, parts, target); break;
        case 'T': break;  // words
        default:
            if (kOfTheMachine.find(part.letter) == std::string_view::npos) {
                report(Severity::Warning, "a word that is not of Excellon's; it was left out");
            }
    }
}

void DrillParser::beginSlot(Target& target) {
    target.isSlot = true;
    moveTo(target.x, target.y);
    m_slotStart = m_position;
    target.x.reset();
    target.y.reset();
}

void DrillParser::code(std::string_view digits, const DrillValues& parts, Target& target) {
    const int number = parseInteger(digits).value_or(-1);
    switch (number) {
        case 0:
            drillPlunge();
            m_isRouting = true;
            m_motion = 0;
            break;
        case 1:
        case 2:
        case 3: m_motion = number; break;
        case 5:
        case 81:
            drillPlunge();
            m_isRouting = false;
            m_motion = 0;
            break;
        case 85: beginSlot(target); break;
        case 90: m_isIncremental = false; break;
        case 91: m_isIncremental = true; break;
        case 92:
        case 93: setOrigin(parts); break;
        case 4:
        case 40: m_isConsumed = number == 4; break;
        case 41:
        case 42:
            report(Severity::Warning, "a routed path beside its tool (G41, G42); it is drawn on the path itself");
            break;
        default:
            target.isCycle = isCycle(number);
            report(Severity::Warning,
                   target.isCycle ? "a canned cycle (G32, G33, G82, G83, G84, G87) is not read; its holes are left out"
                                  : "a G code that has no meaning for drills; it was left out");
    }
}

void DrillParser::misc(std::string_view digits, const DrillValues& parts, Target& target) {
    const int number = parseInteger(digits).value_or(-1);
    switch (number) {
        case 0:
        case 30:
            drillPlunge();
            if (number == 0 && changesTool()) {
                break;
            }
            m_isDone = m_image.hasEnd = true;
            break;
        case 14:
        case 15: plunge(); break;
        case 16:
        case 17:
            target.lifts = target.hasPlace();  // G01X8.0M16 cuts first
            if (!target.lifts) {
                lift();
            }
            break;
        case 25: m_patternBegin = m_image.features.size(); break;
        case 1: m_patternEnd = m_image.features.size(); break;
        case 2: repeatPattern(parts); break;
        case 8: m_patternBegin = m_patternEnd = 0; break;
        case 6:
        case 9:
        case 18:
        case 45:
        case 47:
        case 48:
        case 71:
        case 72: break;
        case 97:
        case 98:
            report(Severity::Warning, "a text to drill (M97, M98) is not drawn");
            m_isConsumed = true;
            break;
        case 70:
        case 80:
        case 90: report(Severity::Warning, "mirrored or swapped axes of drills (M70, M80, M90) are not applied"); break;
        default: report(Severity::Info, "an M code that has no meaning for holes; it was left out");
    }
}

void DrillParser::setOrigin(const DrillValues& parts) {
    for (const DrillValue& part : parts) {
        double* const target = part.letter == 'X' ? &m_origin.x : part.letter == 'Y' ? &m_origin.y : nullptr;
        if (target != nullptr) {
            *target = length(part.digits) + (part.letter == 'X' ? m_format.shift.x : m_format.shift.y);
        }
    }
    m_isConsumed = true;
}

// ---- tools ----

/// T1C0.3F200S65, or T1 that selects a tool.
void DrillParser::tool(const DrillValues& parts) {
    const std::string_view digits = std::ranges::find(parts, 'T', &DrillValue::letter)->digits;
    std::optional<int> number = parseInteger(digits);
    if (!number || *number < 0 || *number > kMostToolNumber) {
        return report(Severity::Warning, "a tool whose number cannot be read; it was left out");
    }
    std::optional<double> size;
    for (const DrillValue& part : parts) {
        if (part.letter == 'C') {
            size = parseReal(part.digits);
        }
    }
    if (!size && digits.size() >= 4 && !m_tools.contains(*number)) {
        number = parseInteger(digits.substr(0, 2));  // T0102: tool 1 with compensation 2
    }
    if (size) {
        define(*number, *size);
    }
    if (!m_isInHeader || !size) {
        m_tool = number.value_or(0);
    }
}

void DrillParser::define(int number, double size) {
    constexpr double kSameSize = 1000.0;  ///< nm
    Tool& tool = m_tools[number];
    const double nm = std::max(size, 0.0) * m_format.nmPerUnit;
    if (tool.isDefined && std::abs(nm - tool.size) > kSameSize) {
        report(Severity::Warning, "a tool is defined again with another size, which counts from here on");
        listTool(number, tool);
        tool.symbol = formats::kNoRow;
    }
    tool.isDefined = true;
    tool.size = nm;
    tool.attributes = m_attributes.apertureSet();
    tool.plating = m_section != Plating::NotSaid ? m_section : tool.plating;
    const DrawnFeature probe = attributed(tool);
    if (probe.attributes >= 0) {
        for (const auto& [name, value] : m_image.attributes[static_cast<std::size_t>(probe.attributes)]) {
            if (name == ".AperFunction") {
                tool.plating = platingOfFunction(value);
            }
        }
    }
}

DrawnFeature DrillParser::attributed(const Tool& tool) {
    DrawnFeature feature;
    m_attributes.apply(feature, tool.attributes);
    return feature;
}

}  // namespace model::gerber
