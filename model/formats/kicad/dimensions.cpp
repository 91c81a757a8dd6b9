#include "model/formats/kicad/dimensions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "model/formats/kicad/graphics.h"
#include "model/formats/kicad/text/values.h"

namespace model::kicad {

namespace {

constexpr double kDefaultPen = 100'000.0;
constexpr double kArrowDegrees = 27.5;  ///< between an arrow's arm and its line

using Line = std::pair<PointD, PointD>;

PointD operator+(PointD a, PointD b) {
    return {a.x + b.x, a.y + b.y};
}

PointD operator-(PointD a, PointD b) {
    return {a.x - b.x, a.y - b.y};
}

PointD operator*(PointD a, double f) {
    return {a.x * f, a.y * f};
}

double sizeOf(PointD a) {
    return std::hypot(a.x, a.y);
}

PointD unit(PointD a) {
    const double size = sizeOf(a);
    return size > 0.0 ? a * (1.0 / size) : PointD();
}

PointD turned(PointD a, double degrees) {
    return Frame{{}, degrees}.apply(a);
}

/// The box around a text, as it lies on the board.
struct TextArea {
    Frame frame;
    PointD min;
    PointD max;
    bool isThere = false;

    /// The part of a line within the box, from 0 to 1; empty if the first is not below the second.
    [[nodiscard]] std::pair<double, double> within(const Line& line) const {
        const Frame back{{}, -frame.degrees};
        const PointD a = back.apply(line.first - frame.origin);
        const PointD d = back.apply(line.second - frame.origin) - a;
        double first = 0.0;
        double last = isThere ? 1.0 : -1.0;
        for (const auto& [from, step, low, high] :
             {std::array{a.x, d.x, min.x, max.x}, std::array{a.y, d.y, min.y, max.y}}) {
            if (step == 0.0) {
                last = from < low || from > high ? -1.0 : last;
                continue;
            }
            const double t = (low - from) / step;
            const double u = (high - from) / step;
            first = std::max(first, std::min(t, u));
            last = std::min(last, std::max(t, u));
        }
        return {first, last};
    }
};

/// One dimension.
class DimensionMaker {
public:
    DimensionMaker(Canvas& canvas, const Item& dimension)
        : m_canvas(canvas), m_item(dimension), m_style(dimension.find("style")), m_rows(canvas.rowsOf(dimension)) {
        m_origin.line = dimension.line();
        const double old = length(dimension, "width");
        m_pen = old > 0.0 ? old : length(m_style, "thickness", kDefaultPen);
        m_pen = m_pen > 0.0 ? m_pen : kDefaultPen;
    }

    void draw(const Variables& variables) {
        drawTexts(variables);
        if (drawStored()) {
            return;
        }
        const std::vector<PathNode> nodes = pathOf(m_canvas, m_item.find("pts"), {});
        const std::string_view type = m_item.find("type").word(1);
        if (nodes.size() != 2) {
            m_canvas.report(Severity::Warning, m_item.line(),
                            "a dimension lacks its two points; only its text is drawn");
            return;
        }
        const PointD a = base::toDouble(nodes[0].point);
        const PointD b = base::toDouble(nodes[1].point);
        if (type == "aligned" || type == "orthogonal") {
            addMeasure(a, b, type == "aligned");
        } else if (type == "leader") {
            addLeader(a, b);
        } else if (type == "radial") {
            addRadius(a, b);
        } else if (type == "center") {
            addCross(a, b - a);
        } else {
            m_canvas.report(Severity::Warning, m_item.line(),
                            "a dimension is of an unknown type; only its text is drawn");
        }
        drawLines();
    }

private:
    void drawTexts(const Variables& variables) {
        for (const Item item : m_item) {
            if (item.head() != "gr_text") {
                continue;
            }
            const std::optional<PointD> at = point(item, "at");
            if (!at) {
                m_canvas.report(Severity::Warning, item.line(), "a text has no place; it was left out");
                continue;
            }
            Origin origin;
            origin.line = item.line();
            const TextPlace place{item,
                                  shownText(m_canvas, item, item.text(1), variables),
                                  {*at, numberOf(item.find("at").word(3)).value_or(0.0)}};
            drawText(m_canvas, place, origin);
            m_textAt = at;
            setArea(place);
        }
    }

    /// Wider by half a character, which keeps lines off the text.
    void setArea(const TextPlace& place) {
        const TextStyle style = styleOf(place.item);
        const TextStrokes strokes(place.text, style);
        if (strokes.strokes().empty()) {
            return;
        }
        m_text.frame = place.frame;
        m_text.min = strokes.min() - PointD{style.width / 2.0, 0.0};
        m_text.max = strokes.max() + PointD{style.width / 2.0, 0.0};
        m_text.isThere = true;
    }

    /// The lines that KiCad 4 and 5 write, (crossbar (pts …)), (feature1 (pts …)), (arrow1a (pts …)).
    bool drawStored() {
        bool hasLines = false;
        for (const Item item : m_item) {
            const Item pts =
                item.isList() && item.head() != "pts" && item.head() != "gr_text" ? item.find("pts") : Item();
            const std::vector<PathNode> nodes = pts.isThere() ? pathOf(m_canvas, pts, {}) : std::vector<PathNode>();
            for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
                hasLines = true;
                for (const std::int32_t row : m_rows) {
                    m_canvas.drawEdge(row, m_origin, nodes[i], nodes[i + 1].point, m_pen);
                }
            }
        }
        return hasLines;
    }

    [[nodiscard]] double offset() const { return length(m_style, "extension_offset"); }
    [[nodiscard]] double arrowLength() const { return length(m_style, "arrow_length", 1'270'000.0); }

    void addMeasure(PointD a, PointD b, bool isAligned) {
        const double height = length(m_item, "height");
        const bool isUpright = number(m_item, "orientation") == 1.0;
        const PointD along = unit(b - a);
        // y is turned up here, positive heights are to the right of the way from a to b on the screen of KiCad
        const PointD aside = isAligned   ? PointD{along.y * height, -along.x * height}
                             : isUpright ? PointD{height, 0.0}
                                         : PointD{0.0, -height};
        const PointD c = a + aside;
        const PointD d = isAligned ? b + aside : isUpright ? PointD{c.x, b.y} : PointD{b.x, c.y};
        addExtension(a, c);
        addExtension(b, d);
        addBroken({c, d});
        const bool isInward = m_style.find("arrow_direction").word(1) == "inward";
        addArrow(c, isInward ? c - d : d - c);
        addArrow(d, isInward ? d - c : c - d);
    }

    void addExtension(PointD from, PointD to) {
        const PointD way = unit(to - from);
        m_lines.emplace_back(from + way * offset(), to + way * length(m_style, "extension_height"));
    }

    /// Two arms from the tip.
    void addArrow(PointD tip, PointD along) {
        const PointD arm = unit(along) * arrowLength();
        m_lines.emplace_back(tip, tip + turned(arm, kArrowDegrees));
        m_lines.emplace_back(tip, tip + turned(arm, -kArrowDegrees));
    }

    void addCross(PointD centre, PointD arm) {
        const PointD other = turned(arm, 90.0);
        m_lines.emplace_back(centre - arm, centre + arm);
        m_lines.emplace_back(centre - other, centre + other);
    }

    /// Without the part where the text is.
    void addBroken(const Line& line) {
        const auto [first, last] = m_text.within(line);
        if (first >= last) {
            m_lines.push_back(line);
            return;
        }
        const PointD way = line.second - line.first;
        if (first > 0.0) {
            m_lines.emplace_back(line.first, line.first + way * first);
        }
        if (last < 1.0) {
            m_lines.emplace_back(line.first + way * last, line.second);
        }
    }

    /// As far as the text, or its frame.
    void addToText(PointD from) {
        if (!m_textAt) {
            return;
        }
        const PointD way = *m_textAt - from;
        const double end = isRound() ? std::max(0.0, sizeOf(way) - frameRadius()) / std::max(sizeOf(way), 1.0)
                                     : m_text.within({from, *m_textAt}).first;
        m_lines.emplace_back(from, from + way * std::min(end, 1.0));
    }

    void addLeader(PointD tip, PointD bend) {
        const PointD way = unit(bend - tip);
        const PointD start = tip + way * offset();
        m_lines.emplace_back(start, bend);
        addArrow(start, way);
        addFrame();
        addToText(bend);
    }

    void addRadius(PointD centre, PointD end) {
        addCross(centre, {arrowLength(), 0.0});
        const PointD way = unit(end - centre);
        const PointD bend = end + way * length(m_item, "leader_length");
        addBroken({end, bend});
        addArrow(end, way);
        addToText(bend);
    }

    [[nodiscard]] bool isRound() const { return number(m_style, "text_frame") == 2.0 && m_text.isThere; }
    [[nodiscard]] double frameRadius() const { return sizeOf(m_text.max - m_text.min) / 2.0; }

    /// Around the text of a leader: a rectangle or a circle.
    void addFrame() {
        if (isRound()) {
            const std::optional<Point> centre = m_canvas.onGrid(*m_textAt, m_origin.line);
            const std::optional<Point> start = m_canvas.onGrid(*m_textAt + PointD{frameRadius(), 0.0}, m_origin.line);
            for (const std::int32_t row : centre&& start ? m_rows : std::vector<std::int32_t>()) {
                m_canvas.drawEdge(row, m_origin, {*start, *centre, EdgeKind::ArcCounterClockwise}, *start, m_pen);
            }
        } else if (number(m_style, "text_frame") == 1.0 && m_text.isThere) {
            const std::array<PointD, 4> corners = {m_text.min, PointD{m_text.max.x, m_text.min.y}, m_text.max,
                                                   PointD{m_text.min.x, m_text.max.y}};
            for (std::size_t i = 0; i < 4; ++i) {
                m_lines.emplace_back(m_text.frame.apply(corners[i]), m_text.frame.apply(corners[(i + 1) % 4]));
            }
        }
    }

    void drawLines() {
        for (const auto& [from, to] : m_lines) {
            const std::optional<Point> a = m_canvas.onGrid(from, m_origin.line);
            const std::optional<Point> b = m_canvas.onGrid(to, m_origin.line);
            for (const std::int32_t row : a&& b ? m_rows : std::vector<std::int32_t>()) {
                m_canvas.drawEdge(row, m_origin, {*a, {}, EdgeKind::Line}, *b, m_pen);
            }
        }
    }

    Canvas& m_canvas;
    const Item& m_item;
    Item m_style;
    std::vector<std::int32_t> m_rows;
    Origin m_origin;
    double m_pen = 0.0;
    std::optional<PointD> m_textAt;
    TextArea m_text;
    std::vector<Line> m_lines;
};

}  // namespace

void drawDimension(Canvas& canvas, const Item& dimension, const Variables& variables) {
    DimensionMaker(canvas, dimension).draw(variables);
}

}  // namespace model::kicad
