#include "model/formats/kicad/texts.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "model/formats/kicad/graphics.h"
#include "model/formats/kicad/shapes/regions.h"
#include "model/formats/kicad/text/values.h"
#include "model/geometry/loops/region_booleans.h"
#include "model/geometry/outlines.h"
#include "model/geometry/region.h"

namespace model::kicad {

namespace {

constexpr double kUnsaidSize = 1.524e6;      ///< KiCad 4 and older write no size that is 60 mil
constexpr double kBareSize = 1.27e6;         ///< of texts without effects
constexpr double kPenOfHeight = 1 / 8.0;     ///< where a text names no pen
constexpr double kBoldPen = 1 / 5.0;         ///< the same of bold texts
constexpr double kThickest = 0.25;           ///< of the smaller size
constexpr double kKnockoutMargin = 1 / 9.0;  ///< of the height
constexpr int kDeepest = 10;                 ///< variables in values of variables
constexpr std::size_t kLongest = 10'000;     ///< characters with values of variables
constexpr const char* kStrokeFont = "KiCad Font";

/// Outlines with the holes behind them.
ShapeSketch polygonOf(Canvas& canvas, const Item& polygon) {
    ShapeSketch region;
    for (const Item pts : polygon) {
        if (pts.head() == "pts") {
            const std::vector<PathNode> nodes = pathOf(canvas, pts, {});
            if (nodes.size() > 2) {
                addPath(region, nodes, !region.isEmpty());
            }
        }
    }
    return region;
}

void drawCache(Canvas& canvas, const Item& cache, std::int32_t row, const Origin& origin) {
    for (const Item polygon : cache) {
        if (polygon.head() == "polygon") {
            canvas.drawRegion(row, origin, polygonOf(canvas, polygon));
        }
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

std::vector<PointD> boxAround(PointD min, PointD max, double margin, const Frame& frame) {
    std::vector<PointD> box;
    for (const PointD corner : {PointD{min.x - margin, min.y - margin}, PointD{max.x + margin, min.y - margin},
                                PointD{max.x + margin, max.y + margin}, PointD{min.x - margin, max.y + margin}}) {
        box.push_back(frame.apply(corner));
    }
    return box;
}

/// What is cut out: strokes, or the polygons of an outline font with their holes.
std::vector<EdgeLoops> charactersOf(Canvas& canvas, const Item& cache, const TextStrokes& strokes, double pen,
                                    const Frame& frame, Box& around) {
    std::vector<EdgeLoops> characters;
    for (const Item polygon : cache) {
        const ShapeSketch region = polygon.head() == "polygon" ? polygonOf(canvas, polygon) : ShapeSketch();
        if (!region.isEmpty()) {
            around.include(boxOf(region));
            for (EdgeLoops& loops : regionsOf(region)) {
                characters.push_back(std::move(loops));
            }
        }
    }
    if (!cache.isThere()) {
        for (const auto& [a, b] : strokes.strokes()) {
            characters.emplace_back().addCapsule(frame.apply(a), frame.apply(b), pen / 2.0);
        }
    }
    return characters;
}

void drawKnockout(Canvas& canvas, const TextPlace& place, const TextStrokes& strokes, const TextStyle& style,
                  const Frame& frame, std::int32_t row, const Origin& origin) {
    const double margin = style.pen / 2.0 + style.height * kKnockoutMargin;
    Box around;
    const Item cache = place.item.find("render_cache");
    const std::vector<EdgeLoops> characters = charactersOf(canvas, cache, strokes, style.pen, frame, around);
    if (characters.empty()) {
        return;
    }
    const std::vector<PointD> corners =
        !place.box.empty() ? place.box
        : cache.isThere()  ? boxAround(base::toDouble(around.min), base::toDouble(around.max), margin, {})
                           : boxAround(strokes.min(), strokes.max(), margin, frame);
    std::vector<PathNode> box;
    for (const PointD corner : corners) {
        const std::optional<Point> node = canvas.onGrid(corner, origin.line);
        if (!node) {
            return;
        }
        box.push_back({*node, {}, EdgeKind::Line});
    }
    canvas.drawRegion(row, origin, without(regionsOf(box), characters));
}

/// What the users call the layer of an item.
std::optional<std::string> layerOf(Canvas& canvas, const Item& item) {
    const std::int32_t row = canvas.layers().row(item.find("layer").word(1));
    return row == formats::kNoRow ? std::nullopt
                                  : std::optional(canvas.job().layers[static_cast<std::size_t>(row)].name);
}

/// Calls for what stands in front of each ${…}, for its name, and at last for what stands behind them.
void splitAtVariables(std::string_view text, const std::function<void(std::string_view)>& plain,
                      const std::function<void(std::string_view)>& variable) {
    for (std::size_t at = 0;;) {
        const std::size_t open = text.find("${", at);
        const std::size_t close = open == std::string_view::npos ? open : text.find('}', open);
        if (close == std::string_view::npos) {
            return plain(text.substr(at));
        }
        plain(text.substr(at, open - at));
        variable(text.substr(open + 2, close - open - 2));
        at = close + 1;
    }
}

/// With the values of its variables, which may hold variables themselves.
std::string filled(std::string_view text, const Variables& variables) {
    std::string all;
    const auto plain = [&](std::string_view part) { all += part; };
    splitAtVariables(text, plain, [&](std::string_view name) {
        const std::optional<std::string> value = all.size() < kLongest ? variables(name) : std::nullopt;
        all += value ? *value : "${" + std::string(name) + "}";
    });
    return all;
}

void reportVariables(Canvas& canvas, const Item& item, std::string_view text) {
    splitAtVariables(
        text, [](std::string_view) {},
        [&](std::string_view name) {
            canvas.report(Severity::Warning, item.line(),
                          "the variable ${" + std::string(name.substr(0, 40)) +
                              "} of a text has no value; it is drawn as it is written");
        });
}

/// Up to the versions before KiCad 6 ~ begins a bar and ends it, as do a blank, } and ), and ~~ is a ~.
std::string withNewBars(std::string_view text) {
    if (text == "~" || text.find("~{") != std::string_view::npos) {  // an empty field; already new
        return std::string(text);
    }
    std::string marked;
    bool isBarred = false;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        const bool isTwice = c == '~' && text.substr(i + 1).starts_with('~');
        const bool isEnd = isBarred && (c == ' ' || c == '}' || c == ')');
        if (isTwice) {
            marked += '~';
            ++i;
        } else if (c == '~') {
            marked += isBarred ? "}" : "~{";
            isBarred = !isBarred;
        } else {
            marked += isEnd ? "}" : "";
            marked += c;
            isBarred = isBarred && !isEnd;
        }
    }
    return isBarred ? marked + "}" : marked;
}

/// What is said of how a text looks and is not there.
void reportStyle(Canvas& canvas, const Item& item) {
    const Item effects = item.find("effects");
    if (!effects.isThere()) {
        canvas.report(Severity::Info, item.line(),
                      "a text does not say how large it is; it is drawn 1.27 mm high, as KiCad does");
    }
    const std::string face = effects.find("font").find("face").text(1);
    if (!face.empty() && face != kStrokeFont && !item.find("render_cache").isThere()) {
        canvas.report(Severity::Warning, item.line(),
                      "the file has no outlines of texts in the font '" + face.substr(0, 40) +
                          "'; they are drawn in KiCad's stroke font");
    }
}

bool isKnockout(const Item& item) {
    return item.find("layer").isSet("knockout") || item.isSet("knockout");
}

}  // namespace

TextStyle styleOf(const Item& item) {
    TextStyle style;
    const Item effects = item.find("effects");
    const Item font = effects.find("font");
    const double unsaid = effects.isThere() ? kUnsaidSize : kBareSize;
    const PointD given = size(font, "size").value_or(PointD{unsaid, unsaid});
    style.height = std::abs(given.x);
    style.width = std::abs(given.y);
    const double smaller = std::min(style.height, style.width);
    style.pen = length(font, "thickness");
    style.pen = style.pen > 0.0 ? style.pen : smaller * (font.isSet("bold") ? kBoldPen : kPenOfHeight);
    style.pen = std::min(style.pen, smaller * kThickest);
    style.isItalic = font.isSet("italic");
    const double spacing = number(font, "line_spacing", 1.0);
    style.lineSpacing = spacing > 0.0 ? spacing : 1.0;
    const Item justify = effects.find("justify");
    style.across = justify.hasWord("left") ? 0.0 : justify.hasWord("right") ? 1.0 : 0.5;
    style.up = justify.hasWord("top") ? 1.0 : justify.hasWord("bottom") ? 0.0 : 0.5;
    style.isMirrored = justify.hasWord("mirror");
    return style;
}

std::string shownText(Canvas& canvas, const Item& item, std::string_view text, const Variables& variables) {
    const Variables all = [&](std::string_view name) {
        return name == "LAYER" ? layerOf(canvas, item) : variables(name);
    };
    std::string shown(text);
    for (int i = 0; i < kDeepest && shown.find("${") != std::string::npos && (i == 0 || shown.size() < kLongest); ++i) {
        shown = filled(shown, all);
    }
    reportVariables(canvas, item, shown);
    shown = nameOf(shown);
    return canvas.settings().hasOldBars() ? withNewBars(shown) : shown;
}

bool isHidden(const Item& item) {
    return item.isSet("hide") || item.find("effects").isSet("hide");
}

void drawText(Canvas& canvas, const TextPlace& place, const Origin& origin) {
    if (place.text.empty()) {
        return;
    }
    const TextStyle style = styleOf(place.item);
    Frame frame = place.frame;
    while (place.isUpright && frame.degrees > 90.0) {
        frame.degrees -= 180.0;
    }
    while (place.isUpright && frame.degrees <= -90.0) {
        frame.degrees += 180.0;
    }
    reportStyle(canvas, place.item);
    const Item cache = place.item.find("render_cache");
    const TextStrokes strokes(place.text, style);
    if (!cache.isThere() && strokes.lacksCharacters()) {
        canvas.report(Severity::Info, origin.line, "a text has characters that the font lacks; they are left out");
    }
    for (const std::int32_t row : canvas.rowsOf(place.item)) {
        const std::uint32_t first = canvas.drawnOn(row);
        if (isKnockout(place.item)) {
            drawKnockout(canvas, place, strokes, style, frame, row, origin);
        } else if (cache.isThere()) {
            drawCache(canvas, cache, row, origin);
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
