#include "model/formats/kicad/texts.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "model/formats/common/text_layout.h"
#include "model/formats/kicad/graphics.h"
#include "model/formats/kicad/shapes/regions.h"
#include "model/formats/kicad/text/values.h"
#include "model/geometry/outlines.h"

namespace model::kicad {

namespace {

constexpr double kInterline = 1.61;       ///< of the height, from line to line
constexpr double kAdvance = 0.9;          ///< of the width, from character to character
constexpr double kPenOfHeight = 1 / 8.0;  ///< where a text names no pen
constexpr double kDefaultHeight = 1e6;
constexpr double kKnockoutMargin = 0.25;  ///< of the height
constexpr std::size_t kLongest = 10'000;  ///< characters

struct Style {
    double height = kDefaultHeight;
    double width = kDefaultHeight;
    double pen = 0.0;
    double across = 0.0;  ///< where the anchor is: 0 left, 0.5 middle, 1 right
    double up = 0.5;      ///< 0 bottom, 1 top
    bool isMirrored = false;
    bool isItalic = false;
};

Style styleOf(const Item& item) {
    Style style;
    const Item effects = item.find("effects");
    const Item font = effects.find("font");
    if (const std::optional<PointD> given = size(font, "size")) {
        style.height = std::abs(given->x);
        style.width = std::abs(given->y);
    }
    style.pen = length(font, "thickness");
    style.pen = style.pen > 0.0 ? style.pen : std::min(style.height, style.width) * kPenOfHeight;
    style.isItalic = font.isSet("italic");
    const Item justify = effects.find("justify");
    style.across = justify.hasWord("left") ? 0.0 : justify.hasWord("right") ? 1.0 : 0.5;
    style.up = justify.hasWord("top") ? 1.0 : justify.hasWord("bottom") ? 0.0 : 0.5;
    style.isMirrored = justify.hasWord("mirror");
    return style;
}

std::vector<std::string> linesOf(std::string_view text) {
    std::vector<std::string> lines(1);
    for (const char c : text.substr(0, kLongest)) {
        if (c == '\n') {
            lines.emplace_back();
        } else if (c != '\r') {
            lines.back() += c;
        }
    }
    return lines;
}

/// ~{RESET} is drawn without its bar's braces.
std::string withoutMarkup(std::string_view text) {
    std::string plain;
    bool isOpen = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const bool isMark =
            (text[i] == '~' || text[i] == '^' || text[i] == '_') && i + 1 < text.size() && text[i + 1] == '{';
        if (isMark) {
            isOpen = true;
            ++i;
        } else if (isOpen && text[i] == '}') {
            isOpen = false;
        } else {
            plain += text[i];
        }
    }
    return plain;
}

/// A text in its own system, the anchor at the origin.
class TextStrokes {
public:
    TextStrokes(const TextPlace& place, const Style& style, std::string* problem) : m_style(style) {
        const std::vector<std::string> lines = linesOf(place.text);
        const double below = static_cast<double>(lines.size() - 1) * kInterline * style.height;
        const double first = -style.up * (style.height + below) + below;  // base line of the first one
        for (std::size_t i = 0; i < lines.size(); ++i) {
            formats::TextLine line{withoutMarkup(lines[i]), asNm(style.width * kAdvance), asNm(style.height), 0.0};
            const formats::TextLayout layout = formats::layOut(line, formats::standInFont());
            *problem = layout.strokes.empty() || problem->empty() ? layout.problem : *problem;
            add(layout, first - static_cast<double>(i) * kInterline * style.height);
        }
    }

    [[nodiscard]] const std::vector<std::pair<PointD, PointD>>& strokes() const { return m_strokes; }
    [[nodiscard]] PointD min() const { return m_min; }
    [[nodiscard]] PointD max() const { return m_max; }
    [[nodiscard]] PointD placed(PointD p) const { return {m_style.isMirrored ? -p.x : p.x, p.y}; }

private:
    void add(const formats::TextLayout& layout, double baseLine) {
        const double space = m_style.width * (kAdvance - 0.75);
        const double left = -m_style.across * std::max(0.0, layout.length - space);
        const double slant = m_style.isItalic ? 1 / 8.0 : 0.0;
        const auto at = [&](PointD p) { return PointD{left + p.x + slant * p.y, baseLine + p.y}; };
        for (const formats::TextStroke& stroke : layout.strokes) {
            m_strokes.emplace_back(placed(at(stroke.a)), placed(at(stroke.b)));
        }
        m_min = {std::min(m_min.x, left), std::min(m_min.y, baseLine)};
        m_max = {std::max(m_max.x, left + layout.length - space), std::max(m_max.y, baseLine + m_style.height)};
    }

    const Style& m_style;
    std::vector<std::pair<PointD, PointD>> m_strokes;
    PointD m_min{1e12, 1e12};
    PointD m_max{-1e12, -1e12};
};

void drawCache(Canvas& canvas, const Item& cache, std::int32_t row, const Origin& origin) {
    for (const Item polygon : cache) {
        if (polygon.head() != "polygon") {
            continue;
        }
        ShapeSketch region;
        for (const Item pts : polygon) {
            if (pts.head() == "pts") {
                const std::vector<PathNode> nodes = pathOf(canvas, pts, {});
                if (nodes.size() > 2) {
                    addPath(region, nodes, !region.isEmpty());
                }
            }
        }
        canvas.drawRegion(row, origin, std::move(region));
    }
}

void drawStrokes(Canvas& canvas, const TextStrokes& strokes, double pen, const Frame& frame, std::int32_t row,
                 const Origin& origin) {
    for (const auto& [a, b] : strokes.strokes()) {
        const std::optional<Point> from = canvas.onGrid(frame.apply(a), origin.line);
        const std::optional<Point> to = canvas.onGrid(frame.apply(b), origin.line);
        if (from && to) {
            canvas.drawEdge(row, origin, {*from, {}, EdgeKind::Line}, *to, pen);
        }
    }
}

void drawKnockout(Canvas& canvas, const TextStrokes& strokes, const Style& style, const Frame& frame, std::int32_t row,
                  const Origin& origin) {
    const double margin = style.pen + style.height * kKnockoutMargin;
    const PointD min = {strokes.min().x - margin, strokes.min().y - margin};
    const PointD max = {strokes.max().x + margin, strokes.max().y + margin};
    std::vector<PathNode> box;
    for (const PointD corner : {min, PointD{max.x, min.y}, max, PointD{min.x, max.y}}) {
        const std::optional<Point> node = canvas.onGrid(frame.apply(strokes.placed(corner)), origin.line);
        if (!node) {
            return;
        }
        box.push_back({*node, {}, EdgeKind::Line});
    }
    std::vector<EdgeLoops> characters;
    for (const auto& [a, b] : strokes.strokes()) {
        characters.emplace_back().addCapsule(frame.apply(a), frame.apply(b), style.pen / 2.0);
    }
    canvas.drawRegion(row, origin, without(regionsOf(box), characters));
}

}  // namespace

std::string withVariables(std::string_view text, const Variables& variables) {
    std::string filled;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t open = text.find("${", at);
        const std::size_t close = open == std::string_view::npos ? open : text.find('}', open);
        if (close == std::string_view::npos) {
            return filled.append(text.substr(at));
        }
        filled.append(text.substr(at, open - at));
        const std::optional<std::string> value = variables(text.substr(open + 2, close - open - 2));
        filled.append(value ? std::string_view(*value) : text.substr(open, close + 1 - open));
        at = close + 1;
    }
    return filled;
}

bool isHidden(const Item& item) {
    return item.isSet("hide") || item.find("effects").isSet("hide");
}

void drawText(Canvas& canvas, const TextPlace& place, const Origin& origin) {
    if (place.text.empty()) {
        return;
    }
    const Style style = styleOf(place.item);
    Frame frame = place.frame;
    while (place.isUpright && frame.degrees > 90.0) {
        frame.degrees -= 180.0;
    }
    while (place.isUpright && frame.degrees <= -90.0) {
        frame.degrees += 180.0;
    }
    const Item cache = place.item.find("render_cache");
    std::string problem;
    const TextStrokes strokes(place, style, &problem);
    if (!cache.isThere() && !problem.empty()) {
        canvas.report(Severity::Info, origin.line,
                      "a text has characters that the font lacks; they are left out");
    }
    for (const std::int32_t row : canvas.rowsOf(place.item)) {
        const std::uint32_t first = canvas.drawnOn(row);
        if (cache.isThere()) {
            drawCache(canvas, cache, row, origin);
        } else if (place.item.find("layer").isSet("knockout")) {
            drawKnockout(canvas, strokes, style, frame, row, origin);
        } else {
            drawStrokes(canvas, strokes, style.pen, frame, row, origin);
        }
        formats::DrawnGroup group{"TEXT", {{"text", place.text}}, {}};
        for (std::uint32_t i = first; i < canvas.drawnOn(row); ++i) {
            group.features.emplace_back(row, i);
        }
        if (!group.features.empty()) {
            canvas.step().groups.push_back(std::move(group));
        }
    }
}

}  // namespace model::kicad
