#include "model/formats/kicad/text/text_strokes.h"

#include <algorithm>
#include <cstddef>
#include <optional>
#include <string>

#include "model/formats/common/text_layout.h"
#include "model/formats/kicad/text/stroke_font.h"

namespace model::kicad {

namespace {

using Run = TextStrokes::Run;

constexpr double kInterline = 1.61;         ///< of the height, from line to line
constexpr double kFirstLine = 1.17;         ///< of the height, what the first line counts
constexpr double kPenAcross = 1 / 1.52;     ///< of the pen, from an anchor at the left or right
constexpr double kPenUp = 0.052;            ///< of the pen, how much higher the base line is
constexpr double kBelow = 1 / kGlyphGrid;   ///< of the height, capitals stand lower than the base line
constexpr double kSlant = 1 / 8.0;          ///< of italics
constexpr double kSmall = 0.8;              ///< of what is raised or lowered
constexpr double kRaised = 0.35 * kSmall;   ///< of the height
constexpr double kLowered = 0.15 * kSmall;  ///< of the height
constexpr double kBar = 1.23;               ///< of the height, where the bar is above the base line
constexpr double kBarTrim = 0.1;            ///< of the width, at both of its ends
constexpr int kTab = 4;                     ///< widths from one tab stop to the next
constexpr std::size_t kLongest = 10'000;    ///< characters
constexpr std::size_t kDeepest = 16;        ///< marks within each other

std::vector<std::string> linesOf(std::string_view text) {
    std::vector<std::string> lines(1);
    for (const char c : text.substr(0, kLongest)) {
        if (c == '\n') {
            lines.emplace_back();
        } else if (c != '\r') {
            lines.back() += c;
        }
    }
    if (lines.size() > 1 && lines.back().empty()) {
        lines.pop_back();
    }
    return lines;
}

double advanceOf(char32_t character) {
    const std::optional<Glyph> glyph = glyphOf(character);
    return (glyph ? glyph : glyphOf(U' '))->advance / kGlyphGrid;
}

/// How far the characters of a run reach, in widths of the text from where the run begins.
class Reach {
public:
    explicit Reach(double scale) : m_scale(scale) {}

    [[nodiscard]] double value() const { return m_value; }
    void add(char32_t character) {
        if (character == U'\t') {
            addTab();
        } else {
            m_value += advanceOf(character) * m_scale;
        }
        ++m_count;
    }

private:
    /// KiCad counts characters to find the next stop, and goes on to one that lies ahead.
    void addTab() {
        m_count = (m_count / kTab + 1) * kTab - 1;
        double stop = m_count + advanceOf(U' ');
        for (; stop <= m_value; stop += kTab) {
            m_count += kTab;
        }
        m_value = stop;
    }

    double m_scale;
    double m_value = 0.0;
    int m_count = 0;
};

std::vector<Run> runsOf(std::string_view line) {
    std::vector<Run> runs(1);
    std::vector<Run> outer;
    std::string characters;
    const auto finish = [&](const Run& next) {
        runs.back().characters = formats::codePoints(characters);
        runs.push_back({{}, next.scale, next.raised, next.hasBar});
        characters.clear();
    };
    for (std::size_t i = 0; i < line.size(); ++i) {
        const char c = line[i];
        const bool isMark = (c == '~' || c == '^' || c == '_') && i + 1 < line.size() && line[i + 1] == '{';
        if (isMark && outer.size() < kDeepest) {
            Run inner = runs.back();
            inner.hasBar = inner.hasBar || c == '~';
            inner.scale = c == '~' ? inner.scale : kSmall;
            inner.raised += c == '^' ? kRaised : c == '_' ? -kLowered : 0.0;
            outer.push_back(runs.back());
            finish(inner);
            ++i;
        } else if (c == '}' && !outer.empty()) {
            finish(outer.back());
            outer.pop_back();
        } else {
            characters += c;
        }
    }
    runs.back().characters = formats::codePoints(characters);
    return runs;
}

double widthOf(const std::vector<Run>& runs, const TextStyle& style) {
    double width = 0.0;
    for (const Run& run : runs) {
        Reach reach(run.scale);
        for (const char32_t character : run.characters) {
            reach.add(character);
        }
        width += reach.value() * style.width;
    }
    return width;
}

}  // namespace

double widthOf(std::string_view line, const TextStyle& style) {
    return widthOf(runsOf(line), style);
}

std::string wrapped(std::string_view text, const TextStyle& style, double width) {
    std::string all;
    for (const std::string& line : linesOf(text)) {
        all += all.empty() ? "" : "\n";
        double used = 0.0;
        for (std::size_t at = 0; at < line.size();) {
            const std::size_t end = std::min(line.find(' ', at + 1), line.size());  // with the blank before it
            const std::string_view word = std::string_view(line).substr(at, end - at);
            const double needed = widthOf(word, style);
            const bool isNewLine = used > 0.0 && used + needed > width;
            const std::size_t blank = isNewLine && word.front() == ' ' ? 1 : 0;
            all += isNewLine ? "\n" : "";
            all += word.substr(blank);
            used = isNewLine ? widthOf(word.substr(blank), style) : used + needed;
            at = end;
        }
    }
    return all;
}

TextStrokes::TextStrokes(std::string_view text, const TextStyle& style) : m_style(style) {
    const std::vector<std::string> lines = linesOf(text);
    const double pitch = kInterline * style.height * style.lineSpacing;
    const double all = kFirstLine * style.height + static_cast<double>(lines.size() - 1) * pitch;
    const double first = kPenUp * style.pen - style.height + (1.0 - style.up) * all;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        addLine(lines[i], first - static_cast<double>(i) * pitch);
    }
}

void TextStrokes::addLine(std::string_view line, double baseLine) {
    const std::vector<Run> runs = runsOf(line);
    const double width = widthOf(runs, m_style);
    double cursor = -m_style.across * width;
    cursor += m_style.across == 0.5 ? 0.0 : (m_style.across < 0.5 ? 1.0 : -1.0) * kPenAcross * m_style.pen;
    for (const Run& run : runs) {
        addRun(run, cursor, baseLine);
    }
}

void TextStrokes::addRun(const Run& run, double& cursor, double baseLine) {
    const double start = cursor;
    const double x = run.scale * m_style.width / kGlyphGrid;
    const double y = run.scale * m_style.height / kGlyphGrid;
    const double slant = m_style.isItalic ? kSlant : 0.0;
    const double from = baseLine + run.raised * m_style.height;
    Reach reach(run.scale);
    for (const char32_t character : run.characters) {
        const std::optional<Glyph> glyph = glyphOf(character);
        m_lacksCharacters = m_lacksCharacters || (!glyph && character != U'\t');
        for (const std::vector<PointD>& line : glyph ? glyph->lines : std::vector<std::vector<PointD>>()) {
            const auto at = [&](PointD p) {
                const double high = p.y * y - kBelow * run.scale * m_style.height;
                return PointD{cursor + p.x * x + slant * high, from + high};
            };
            for (std::size_t i = 0; i + 1 < line.size(); ++i) {
                add(at(line[i]), at(line[i + 1]));
            }
        }
        reach.add(character);
        cursor = start + reach.value() * m_style.width;
    }
    if (run.hasBar && cursor > start) {
        const double high = kBar * m_style.height * run.scale;
        const double trim = kBarTrim * m_style.width * run.scale;
        add({start + trim + slant * high, from + high}, {cursor - trim + slant * high, from + high});
    }
}

void TextStrokes::add(PointD a, PointD b) {
    for (PointD* p : {&a, &b}) {
        p->x = m_style.isMirrored ? -p->x : p->x;
        m_min = {std::min(m_min.x, p->x), std::min(m_min.y, p->y)};
        m_max = {std::max(m_max.x, p->x), std::max(m_max.y, p->y)};
    }
    m_strokes.emplace_back(a, b);
}

}  // namespace model::kicad
