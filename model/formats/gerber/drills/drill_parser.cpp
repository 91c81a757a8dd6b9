#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>

#include "model/base/limits.h"
#include "model/base/units.h"
#include "model/formats/gerber/drills/drill_file.h"
#include "model/formats/gerber/image/attributes.h"
#include "model/formats/gerber/text/words.h"
#include "model/geometry/outlines.h"

namespace model::gerber {

using formats::DrawnFeature;
using formats::DrawnKind;

namespace {

constexpr std::size_t kMostComments = 100;
constexpr Nm kNoSize = 10;  ///< of a tool without one: the hole stays a hole, and nothing is invented

/// The values of one line: X1.5Y2G85X3 gives X, Y, G, X in turn.
struct Value {
    char letter = 0;
    std::string_view digits;
};

class DrillParser {
public:
    DrillParser(std::string_view path, const CoordinateFormat& format)
        : m_path(path), m_format(format), m_attributes(m_image) {}

    Image run(std::string_view text) {
        m_hasPlunges = text.find("M15") != std::string_view::npos || text.find("M14") != std::string_view::npos;
        m_isInHeader = text.find("M48") != std::string_view::npos;
        Lines lines(text);
        while (lines.next() && !m_isDone) {
            m_line = lines.number();
            const std::string_view line = trimmed(lines.line());
            if (line.empty()) {
                continue;
            }
            const std::size_t semicolon = line.find(';');
            if (semicolon != std::string_view::npos) {
                comment(trimmed(line.substr(semicolon + 1)));
            }
            const std::string_view words = trimmed(line.substr(0, semicolon));
            if (!words.empty()) {
                record(words);
            }
        }
        if (!m_image.hasEnd) {
            report(Severity::Warning, "the drill file ends without M30: it may be cut off");
        }
        finishTools();
        return std::move(m_image);
    }

private:
    struct Tool {
        std::int32_t symbol = formats::kNoRow;
        std::int32_t attributes = formats::kNoRow;
        double size = 0.0;  ///< nm; 0 not said
        Plating plating = Plating::NotSaid;
        bool isUsed = false;
    };

    void report(Severity severity, std::string_view text) {
        m_image.diagnostics.report(severity, m_path, m_line, text);
    }

    // ---- comments ----

    void comment(std::string_view text) {
        if (text.starts_with("#@!")) {
            text = trimmed(text.substr(3));
            if (text.size() > 2 && m_attributes.command(text.substr(0, 2), text.substr(2))) {
                return;
            }
        }
        if (text.starts_with("TYPE=") || text.starts_with("Contents")) {
            m_section = platingOf(text);
        }
        sizeInComment(text);
        if (m_image.comments.size() < kMostComments) {
            m_image.comments.emplace_back(text);
        }
    }

    static Plating platingOf(std::string_view text) {
        const bool isNon =
            holds(text, "NON_PLATED") || holds(text, "NON-PLATED") || holds(text, "NONPLATED") || holds(text, "NPTH");
        return isNon                                         ? Plating::NonPlated
               : holds(text, "PLATED") || holds(text, "PTH") ? Plating::Plated
                                                             : Plating::NotSaid;
    }

    /// "T01 Holesize 1. = 12.000000 Tolerance = … PLATED MILS Quantity = 241", with or without the tool before it.
    void sizeInComment(std::string_view text) {
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
        const double nm = holds(rest, "MILS")   ? base::kNmPerMil
                          : holds(rest, "INCH") ? base::kNmPerInch
                                                : base::kNmPerMm;
        Tool& entry = m_tools[static_cast<int>(*tool)];
        entry.size = entry.size > 0 ? entry.size : *size * nm;
        entry.plating = entry.plating == Plating::NotSaid ? platingOf(rest) : entry.plating;
    }

    // ---- records ----

    /// Units and formats, which the head has told, and what only the machine needs to know (R,H resets a counter).
    static bool isOfTheMachine(std::string_view line) {
        constexpr std::string_view kBeginnings[] = {"%",   "INCH", "METRIC", "FMAT", "VER,",  "DETECT",
                                                    "ATC", "BLKD", "SBK",    "TCST", "OSTOP", "R,"};
        return line == "/" ||
               std::ranges::any_of(kBeginnings, [&](std::string_view word) { return line.starts_with(word); });
    }

    void record(std::string_view line) {
        if (line == "%" || line.starts_with("M95")) {
            m_isInHeader = false;
            return;
        }
        if (isOfTheMachine(line)) {
            return;
        }
        if (line.starts_with("ICI")) {
            m_isIncremental = holds(line, "ON");
            return;
        }
        if (line.front() == 'T') {
            return tool(line);
        }
        if (line.front() == 'R' && line.size() > 1 && line[1] >= '0' && line[1] <= '9') {
            return repeat(values(line));
        }
        const std::string_view letters = "XYGMNIJASFCZHB";
        if (letters.find(line.front()) == std::string_view::npos) {
            return report(Severity::Warning, "a record that is not of Excellon's; it was left out");
        }
        words(values(line));
    }

    const std::vector<Value>& values(std::string_view line) {
        m_values.clear();
        for (std::size_t i = 0; i < line.size();) {
            const char letter = line[i];
            const std::size_t begin = i + 1;
            i = begin;
            while (i < line.size() && std::string_view("0123456789.+- ").find(line[i]) != std::string_view::npos) {
                ++i;
            }
            m_values.push_back({letter, trimmed(line.substr(begin, i - begin))});
        }
        return m_values;
    }

    double length(std::string_view digits) {
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

    /// T1C0.3F200S65, or T1 that selects a tool.
    void tool(std::string_view line) {
        const std::vector<Value>& parts = values(line);
        std::optional<int> number = parseInteger(parts[0].digits);
        if (!number || *number < 0) {
            return report(Severity::Warning, "a tool whose number cannot be read; it was left out");
        }
        std::optional<double> size;
        for (const Value& part : parts) {
            if (part.letter == 'C') {
                size = parseReal(part.digits);
            }
        }
        if (!size && parts[0].digits.size() >= 4 && !m_tools.contains(*number)) {
            number = parseInteger(parts[0].digits.substr(0, 2));  // T0102: tool 1 with compensation 2
        }
        if (size) {
            define(*number, *size);
        }
        if (!m_isInHeader || !size) {
            m_tool = number.value_or(0);
        }
    }

    void define(int number, double size) {
        Tool& tool = m_tools[number];
        tool.size = std::max(size, 0.0) * m_format.nmPerUnit;
        tool.attributes = m_attributes.apertureSet();
        tool.plating = m_section != Plating::NotSaid ? m_section : tool.plating;
        const DrawnFeature probe = attributed(tool);
        if (probe.attributes >= 0) {
            for (const auto& [name, value] : m_image.attributes[static_cast<std::size_t>(probe.attributes)]) {
                if (name == ".AperFunction") {
                    tool.plating = holds(value, "ViaDrill") ? Plating::Via : platingOf(value);
                }
            }
        }
    }

    DrawnFeature attributed(const Tool& tool) {
        DrawnFeature feature;
        m_attributes.apply(feature, tool.attributes);
        return feature;
    }

    void words(const std::vector<Value>& parts) {
        std::optional<double> x;
        std::optional<double> y;
        std::optional<double> radius;
        std::optional<double> i;
        std::optional<double> j;
        m_isBad = false;
        bool isSlot = false;
        const auto beginSlot = [&] {
            isSlot = true;
            moveTo(x, y);
            m_slotStart = m_position;
            x.reset();
            y.reset();
        };
        for (const Value& part : parts) {
            if (isSlot && ((part.letter == 'X' && x) || (part.letter == 'Y' && y))) {
                beginSlot();  // G85X1Y1X2Y2: both ends are behind it
            }
            switch (part.letter) {
                case 'X': x = length(part.digits); break;
                case 'Y': y = length(part.digits); break;
                case 'A': radius = length(part.digits); break;
                case 'I': i = length(part.digits); break;
                case 'J': j = length(part.digits); break;
                case 'G':
                    if (part.digits == "85") {
                        beginSlot();
                    } else {
                        code(part.digits, parts);
                    }
                    break;
                case 'M': misc(part.digits, parts); break;
                default: break;
            }
        }
        if (m_isBad) {
            return report(Severity::Warning, "a coordinate that cannot be read; the record was left out");
        }
        if (m_isDone || m_isConsumed) {
            m_isConsumed = false;
            return;
        }
        if (isSlot || x || y) {
            operate(x, y, isSlot, radius, i, j);
        }
    }

    void code(std::string_view digits, const std::vector<Value>& parts) {
        const int number = parseInteger(digits).value_or(-1);
        switch (number) {
            case 0:
                m_isRouting = true;
                m_motion = 0;
                break;
            case 1:
            case 2:
            case 3: m_motion = number; break;
            case 5:
            case 81:
                m_isRouting = false;
                m_motion = 0;
                break;
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
            default: report(Severity::Warning, "a G code that has no meaning for drills; it was left out");
        }
    }

    void misc(std::string_view digits, const std::vector<Value>& parts) {
        const int number = parseInteger(digits).value_or(-1);
        switch (number) {
            case 0:
            case 30: m_isDone = m_image.hasEnd = true; break;
            case 14:
            case 15: m_isDown = true; break;
            case 16:
            case 17: m_isDown = false; break;
            case 25: m_patternBegin = m_image.features.size(); break;
            case 1: m_patternEnd = m_image.features.size(); break;
            case 2: repeatPattern(parts); break;
            case 8: m_patternBegin = m_patternEnd = 0; break;
            case 6:
            case 9:
            case 18:
            case 47:
            case 48:
            case 71:
            case 72: break;
            case 97:
            case 98: m_isConsumed = true; break;  // a text to drill
            case 70:
            case 80:
            case 90:
                report(Severity::Warning, "mirrored or swapped axes of drills (M70, M80, M90) are not applied");
                break;
            default: report(Severity::Info, "an M code that has no meaning for holes; it was left out");
        }
    }

    void setOrigin(const std::vector<Value>& parts) {
        for (const Value& part : parts) {
            double* const target = part.letter == 'X' ? &m_origin.x : part.letter == 'Y' ? &m_origin.y : nullptr;
            if (target != nullptr) {
                *target = length(part.digits);
            }
        }
        m_isConsumed = true;
    }

    // ---- holes ----

    void moveTo(std::optional<double> x, std::optional<double> y) {
        const auto next = [&](std::optional<double> value, double origin, double now) {
            return !value ? now : m_isIncremental ? now + *value : origin + *value;
        };
        m_position = {next(x, m_origin.x, m_position.x), next(y, m_origin.y, m_position.y)};
    }

    void operate(std::optional<double> x, std::optional<double> y, bool isSlot, std::optional<double> radius,
                 std::optional<double> i, std::optional<double> j) {
        const PointD from = isSlot ? m_slotStart : m_position;
        moveTo(x, y);
        if (isSlot) {
            return add(DrawnKind::Line, from, m_position, {});
        }
        if (!m_isRouting) {
            return add(DrawnKind::Pad, m_position, m_position, {});
        }
        const bool cuts = m_motion > 0 && (m_isDown || !m_hasPlunges);
        if (!cuts) {
            return;
        }
        std::optional<PointD> centre;
        if (m_motion > 1 && (i || j)) {
            centre = PointD{from.x + i.value_or(0.0), from.y + j.value_or(0.0)};
        } else if (m_motion > 1 && radius) {
            centre = centreOf(from, m_position, *radius);
        }
        add(centre ? DrawnKind::Arc : DrawnKind::Line, from, m_position, centre.value_or(PointD{}));
    }

    /// Of the arc with this radius that is no more than half a circle.
    [[nodiscard]] std::optional<PointD> centreOf(PointD a, PointD b, double radius) const {
        const double chord = std::hypot(b.x - a.x, b.y - a.y);
        if (chord <= 0 || radius <= 0) {
            return std::nullopt;
        }
        const double height = std::sqrt(std::max(0.0, radius * radius - chord * chord / 4));
        const double side = m_motion == 2 ? 1.0 : -1.0;  // clockwise: the centre is on the right
        return PointD{(a.x + b.x) / 2 + side * height * (b.y - a.y) / chord,
                      (a.y + b.y) / 2 - side * height * (b.x - a.x) / chord};
    }

    void add(DrawnKind kind, PointD a, PointD b, PointD centre) {
        if (m_isInHeader) {
            report(Severity::Info, "a hole before the end of the header");
        }
        const bool isNear = toNm(a.x) && toNm(a.y) && toNm(b.x) && toNm(b.y) && toNm(centre.x) && toNm(centre.y);
        if (!isNear) {
            return report(Severity::Warning, "a coordinate is larger than any board (1.07 m); the hole is left out");
        }
        Tool& tool = m_tools[m_tool];
        if (!tool.isUsed) {
            use(tool);
        }
        DrawnFeature feature = attributed(tool);
        feature.kind = kind;
        feature.isClockwise = m_motion == 2;
        feature.symbol = tool.symbol;
        feature.plating = tool.plating;
        feature.a = rounded(a);
        feature.b = rounded(b);
        feature.centre = rounded(centre);
        feature.line = m_line;
        ++(kind == DrawnKind::Pad ? m_image.flashes : m_image.draws);
        m_image.features.push_back(feature);
    }

    void use(Tool& tool) {
        tool.isUsed = true;
        formats::DrawnSymbol symbol;
        symbol.name = "T" + std::to_string(m_tool) + " " + shortNumber(base::toMm(tool.size)) + " mm";
        symbol.shape.kind = formats::PadShape::Kind::Round;
        const std::optional<Nm> size = toNm(tool.size);
        if (size && *size > 20 * static_cast<Nm>(base::kNmPerMm)) {
            report(Severity::Warning, "a tool of more than 20 mm: its size may be in another unit");
        }
        symbol.shape.width = std::max(size.value_or(kNoSize), kNoSize);
        tool.symbol = static_cast<std::int32_t>(m_image.symbols.size());
        m_image.symbols.push_back(std::move(symbol));
    }

    /// R04X001Y0: the last hole again, so often, each that much farther.
    void repeat(const std::vector<Value>& parts) {
        const int count = parseInteger(parts[0].digits).value_or(0);
        m_isBad = false;
        double dx = 0.0;
        double dy = 0.0;
        for (const Value& part : parts) {
            (part.letter == 'X'   ? dx
             : part.letter == 'Y' ? dy
                                  : m_ignored) = part.letter == 'R' ? 0.0 : length(part.digits);
        }
        if (m_isBad || count < 1 || m_image.features.empty()) {
            return report(Severity::Warning, "a repetition of a hole that cannot be read; it was left out");
        }
        if (!mayRepeat(static_cast<std::size_t>(count))) {
            return;
        }
        for (int i = 0; i < count; ++i) {
            m_position = {m_position.x + dx, m_position.y + dy};
            if (!toNm(m_position.x) || !toNm(m_position.y)) {
                return report(Severity::Warning,
                              "a repetition of a hole goes beyond any board (1.07 m); the rest of it is left out");
            }
            add(DrawnKind::Pad, m_position, m_position, {});
        }
    }

    bool mayRepeat(std::size_t count) {
        m_repeated += count;
        if (m_repeated > base::kMostRepeated) {
            report(Severity::Error,
                   "repetitions draw " + base::moreThan(base::kMostRepeated, "holes") + "; the rest is left out");
        }
        return m_repeated <= base::kMostRepeated;
    }

    /// M02X1Y2: the holes between M25 and M01 again, that much farther than the last time.
    void repeatPattern(const std::vector<Value>& parts) {
        m_isConsumed = true;
        double dx = 0.0;
        double dy = 0.0;
        for (const Value& part : parts) {
            if (part.letter == 'X' || part.letter == 'Y') {
                (part.letter == 'X' ? dx : dy) = length(part.digits);
            }
        }
        const std::size_t count = m_patternEnd - std::min(m_patternBegin, m_patternEnd);
        if (m_isBad) {
            return report(Severity::Warning, "a repeated pattern of holes that cannot be read; it was left out");
        }
        if (!mayRepeat(count)) {
            return;
        }
        for (std::size_t i = 0; i < count; ++i) {
            DrawnFeature feature = m_image.features[m_patternBegin + i];
            for (Point* p : {&feature.a, &feature.b, &feature.centre}) {
                const auto px = toNm(p->x + dx);
                const auto py = toNm(p->y + dy);
                *p = px && py ? Point{*px, *py} : *p;
            }
            m_image.features.push_back(feature);
        }
        m_patternBegin = m_patternEnd;
        m_patternEnd = m_image.features.size();
    }

    void finishTools() {
        for (const auto& [number, tool] : m_tools) {
            DrillTool row;
            row.number = number;
            row.plating = tool.plating;
            row.finishedSize = row.drillSize = std::max(toNm(tool.size).value_or(kNoSize), kNoSize);
            if (tool.isUsed) {
                m_image.tools.push_back(row);
            }
        }
    }

    std::string_view m_path;
    CoordinateFormat m_format;
    Image m_image;
    AttributeState m_attributes;
    std::map<int, Tool> m_tools;
    std::vector<Value> m_values;
    std::uint32_t m_line = 0;
    int m_tool = 0;
    Plating m_section = Plating::NotSaid;
    bool m_isInHeader = false;
    bool m_hasPlunges = false;
    bool m_isRouting = false;
    bool m_isDown = false;
    bool m_isIncremental = false;
    bool m_isDone = false;
    bool m_isBad = false;
    bool m_isConsumed = false;  ///< the numbers of the record are no place
    int m_motion = 0;
    PointD m_position;
    PointD m_slotStart;
    PointD m_origin;
    double m_ignored = 0.0;
    std::size_t m_patternBegin = 0;
    std::size_t m_patternEnd = 0;
    std::size_t m_repeated = 0;
};

}  // namespace

Image parseDrills(std::string_view text, std::string_view path, const CoordinateFormat& format) {
    return DrillParser(path, format).run(text);
}

}  // namespace model::gerber
