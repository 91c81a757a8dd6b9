#include "model/formats/kicad/graphics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "model/formats/kicad/shapes/regions.h"
#include "model/formats/kicad/text/values.h"
#include "model/geometry/outlines.h"

namespace model::kicad {

namespace {

constexpr double kThinnest = 100'000.0;  ///< pen of what has no width
constexpr double kFlat = 50.0;           ///< an arc this close to its chord is a line
constexpr int kMostChords = 500;
constexpr std::uint32_t kMostBeforeDashes = 1'000'000;  ///< features of a layer

std::string_view kindOf(std::string_view head) {
    const std::size_t at = head.find('_');
    return at == std::string_view::npos ? head : head.substr(at + 1);
}

/// Points of one graphic, placed.
class GraphicMaker {
public:
    GraphicMaker(Canvas& canvas, const Item& item, const Frame& frame, bool isPrimitive)
        : m_canvas(canvas), m_item(item), m_frame(frame), m_isPrimitive(isPrimitive) {}

    std::optional<Graphic> make() {
        const std::string_view kind = kindOf(m_item.head());
        const bool isMade = kind == "line"     ? line()
                            : kind == "arc"    ? arc()
                            : kind == "circle" ? circle()
                            : kind == "rect"   ? rectangle()
                            : kind == "poly"   ? polygon()
                                               : curve();
        if (!isMade) {
            return {};
        }
        m_graphic.width = widthOf();
        m_graphic.style = styleOfLine(m_item);
        m_graphic.isHatched = m_graphic.isClosed && m_item.find("fill").word(1).ends_with("hatch");
        const bool isSolid = m_graphic.style == LineStyle::Solid;  // KiCad plots no inside of dashed shapes
        m_graphic.isFilled = m_graphic.isClosed && isSolid && !m_graphic.isHatched && isFilled(kind);
        return m_graphic;
    }

private:
    double widthOf() const {
        const Item stroke = m_item.find("stroke");
        return std::max(0.0, stroke.isThere() ? length(stroke, "width") : length(m_item, "width"));
    }

    bool isFilled(std::string_view kind) const {
        const Item fill = m_item.find("fill");
        const std::string_view how = fill.word(1);
        if (fill.isThere()) {
            return how != "no" && how != "none";
        }
        return kind == "poly" || (m_isPrimitive && m_graphic.width == 0.0);
    }

    bool missing() {
        m_canvas.report(Severity::Warning, m_item.line(), "a graphic item lacks coordinates; it was left out");
        return false;
    }

    std::optional<PointD> placed(std::string_view head) const {
        const std::optional<PointD> local = point(m_item, head);
        return local ? std::optional(m_frame.apply(*local)) : std::nullopt;
    }

    bool add(PointD p) {
        const std::optional<Point> node = m_canvas.onGrid(p, m_item.line());
        if (node) {
            m_graphic.nodes.push_back({*node, {}, EdgeKind::Line});
        }
        return node.has_value();
    }

    bool line() {
        const auto start = placed("start");
        const auto end = placed("end");
        return start && end ? add(*start) && add(*end) : missing();
    }

    bool arc() {
        const auto start = placed("start");
        const auto middle = placed("mid");
        const auto end = placed("end");
        if (!start || !end) {
            return missing();
        }
        return middle ? arcByPoints(*start, *middle, *end) : arcByAngle(*start, *end);
    }

    bool arcByPoints(PointD start, PointD middle, PointD end) {
        const std::optional<PathNode> node = arcThrough(m_canvas, m_item.line(), start, middle, end);
        if (!node) {
            return false;
        }
        m_graphic.nodes.push_back(*node);
        return add(end);
    }

    /// Up to KiCad 5: `start` is the centre, `end` where it starts, positive angles are clockwise.
    bool arcByAngle(PointD centre, PointD start) {
        const std::optional<double> angle = numberOf(m_item.find("angle").word(1));
        if (!angle) {
            return missing();
        }
        const double sweep = -std::clamp(*angle, -360.0, 360.0) * std::numbers::pi / 180.0;
        const PointD from = {start.x - centre.x, start.y - centre.y};
        const PointD end = {centre.x + from.x * std::cos(sweep) - from.y * std::sin(sweep),
                            centre.y + from.x * std::sin(sweep) + from.y * std::cos(sweep)};
        const std::optional<Point> grid = m_canvas.onGrid(centre, m_item.line());
        if (!grid || !add(start)) {
            return false;
        }
        m_graphic.nodes[0].centre = *grid;
        m_graphic.nodes[0].edge = sweep < 0 ? EdgeKind::ArcClockwise : EdgeKind::ArcCounterClockwise;
        return add(std::abs(*angle) >= 360.0 ? start : end);
    }

    bool circle() {
        const auto centre = placed("center");
        const auto end = placed("end");
        if (!centre || !end) {
            return missing();
        }
        const std::optional<Point> grid = m_canvas.onGrid(*centre, m_item.line());
        if (!grid || !add({centre->x + std::hypot(end->x - centre->x, end->y - centre->y), centre->y})) {
            return false;
        }
        m_graphic.nodes[0].centre = *grid;
        m_graphic.nodes[0].edge = EdgeKind::ArcCounterClockwise;
        m_graphic.isClosed = true;
        return true;
    }

    bool rectangle() {
        const auto start = point(m_item, "start");
        const auto end = point(m_item, "end");
        if (!start || !end) {
            return missing();
        }
        const double radius = length(m_item, "radius");
        m_graphic.isClosed = true;
        if (radius > 0.0) {
            return roundedRectangle(*start, *end, radius);
        }
        return add(m_frame.apply(*start)) && add(m_frame.apply({end->x, start->y})) && add(m_frame.apply(*end)) &&
               add(m_frame.apply({start->x, end->y}));
    }

    bool roundedRectangle(PointD start, PointD end, double radius) {
        const PointD middle = {(start.x + end.x) / 2.0, (start.y + end.y) / 2.0};
        const double x = std::abs(end.x - start.x) / 2.0;
        const double y = std::abs(end.y - start.y) / 2.0;
        const double r = std::min({radius, x, y});
        constexpr std::array<PointD, 4> kCorners = {{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
        for (std::size_t i = 0; i < 4; ++i) {
            const auto at = [&](double dx, double dy) {
                return m_frame.apply({middle.x + kCorners[i].x * dx, middle.y + kCorners[i].y * dy});
            };
            const bool isSideFirst = i % 2 == 0;
            const std::optional<Point> centre = m_canvas.onGrid(at(x - r, y - r), m_item.line());
            if (!centre || !add(isSideFirst ? at(x, y - r) : at(x - r, y))) {
                return false;
            }
            m_graphic.nodes.back().centre = *centre;
            m_graphic.nodes.back().edge = EdgeKind::ArcCounterClockwise;
            if (!add(isSideFirst ? at(x - r, y) : at(x, y - r))) {
                return false;
            }
        }
        return true;
    }

    bool polygon() {
        m_graphic.nodes = pathOf(m_canvas, m_item.find("pts"), m_frame);
        m_graphic.isClosed = true;
        return m_graphic.nodes.size() >= 2 || missing();
    }

    bool curve() {
        std::vector<PointD> controls;
        for (const Item xy : m_item.find("pts")) {
            const std::optional<PointD> local = xy.isList() ? pointOf(xy) : std::nullopt;
            if (local) {
                controls.push_back(m_frame.apply(*local));
            }
        }
        if (controls.size() != 4) {
            return missing();
        }
        double extent = 0.0;
        for (std::size_t i = 0; i + 1 < 4; ++i) {
            extent += std::hypot(controls[i + 1].x - controls[i].x, controls[i + 1].y - controls[i].y);
        }
        // A chord of a cubic is off by at most 3/4 of the largest second difference, over n²; 1 µm.
        const int chords = std::clamp(static_cast<int>(std::ceil(std::sqrt(extent * 1.5 / 1000.0))), 4, kMostChords);
        for (int i = 0; i <= chords; ++i) {
            const double t = static_cast<double>(i) / chords;
            const double s = 1.0 - t;
            const std::array<double, 4> b = {s * s * s, 3 * s * s * t, 3 * s * t * t, t * t * t};
            PointD p;
            for (std::size_t k = 0; k < 4; ++k) {
                p = {p.x + b[k] * controls[k].x, p.y + b[k] * controls[k].y};
            }
            if (!add(p)) {
                return false;
            }
        }
        return true;
    }

    Canvas& m_canvas;
    const Item& m_item;
    const Frame& m_frame;
    bool m_isPrimitive;
    Graphic m_graphic;
};

void reportStyle(Canvas& canvas, const Item& item, const Graphic& graphic) {
    if (graphic.isHatched) {
        canvas.report(Severity::Warning, item.line(), "of hatched shapes only the outline is drawn");
    }
    if (graphic.width == 0.0 && !graphic.isFilled) {
        canvas.report(Severity::Info, item.line(), "lines without a width are drawn 0.1 mm wide");
    }
}

/// What the solder mask leaves open over a shape on copper.
void drawOpening(Canvas& canvas, const Item& item, std::int32_t row, Graphic opening, const Origin& origin) {
    opening.isFilled = opening.isFilled || opening.isHatched;
    opening.width = opening.width > 0.0 || opening.isFilled ? opening.width : kThinnest;
    opening.width += 2.0 * length(item, "solder_mask_margin", canvas.settings().maskMargin);
    if (opening.width > 0.0 || (opening.width == 0.0 && opening.isFilled)) {
        drawGraphic(canvas, row, opening, origin);
    } else if (opening.isFilled) {
        ShapeSketch region;
        addPath(region, opening.nodes, false);
        canvas.drawRegion(row, origin, grown(region, opening.width / 2.0));
    }
}

}  // namespace

bool isGraphic(std::string_view head) {
    const std::size_t at = head.find('_');
    const std::string_view prefix = head.substr(0, at == std::string_view::npos ? 0 : at);
    const std::string_view kind = kindOf(head);
    return (prefix == "gr" || prefix == "fp") &&
           (kind == "line" || kind == "arc" || kind == "circle" || kind == "rect" || kind == "poly" || kind == "curve");
}

std::optional<Graphic> graphicOf(Canvas& canvas, const Item& item, const Frame& frame, bool isPrimitive) {
    return GraphicMaker(canvas, item, frame, isPrimitive).make();
}

std::vector<PathNode> pathOf(Canvas& canvas, const Item& pts, const Frame& frame) {
    std::vector<PathNode> nodes;
    for (const Item item : pts) {
        if (!item.isList()) {
            continue;
        }
        if (item.head() == "arc") {
            const auto start = point(item, "start");
            const auto middle = point(item, "mid");
            const auto end = point(item, "end");
            const std::optional<PathNode> arc =
                start && middle && end
                    ? arcThrough(canvas, item.line(), frame.apply(*start), frame.apply(*middle), frame.apply(*end))
                    : std::nullopt;
            const std::optional<Point> last = arc ? canvas.onGrid(frame.apply(*end), item.line()) : std::nullopt;
            if (!last) {
                canvas.report(Severity::Warning, item.line(), "an arc of a polygon cannot be read; it was left out");
                continue;
            }
            if (!nodes.empty() && nodes.back().edge == EdgeKind::Line && nodes.back().point == arc->point) {
                nodes.pop_back();
            }
            nodes.push_back(*arc);
            nodes.push_back({*last, {}, EdgeKind::Line});
            continue;
        }
        const std::optional<PointD> local = pointOf(item);
        if (!local) {
            canvas.report(Severity::Warning, item.line(), "a point of a polygon cannot be read; it was left out");
            continue;
        }
        const std::optional<Point> node = canvas.onGrid(frame.apply(*local), item.line());
        if (!node) {
            return {};
        }
        nodes.push_back({*node, {}, EdgeKind::Line});
    }
    if (nodes.size() > 1 && nodes.front().point == nodes.back().point && nodes.back().edge == EdgeKind::Line) {
        nodes.pop_back();
    }
    return nodes;
}

std::optional<PathNode> arcThrough(Canvas& canvas, std::uint32_t line, PointD start, PointD middle, PointD end) {
    const std::optional<Point> from = canvas.onGrid(start, line);
    if (!from || !canvas.onGrid(middle, line) || !canvas.onGrid(end, line)) {
        return {};
    }
    const PointD u = {middle.x - start.x, middle.y - start.y};
    const PointD v = {end.x - start.x, end.y - start.y};
    const double cross = u.x * v.y - u.y * v.x;
    const double chord = std::hypot(v.x, v.y);
    if (chord < 1.0) {  // a full circle, the middle opposite
        const std::optional<Point> centre =
            canvas.onGrid({(start.x + middle.x) / 2.0, (start.y + middle.y) / 2.0}, line);
        return centre ? std::optional(PathNode{*from, *centre, EdgeKind::ArcCounterClockwise}) : std::nullopt;
    }
    if (std::abs(cross) / chord < kFlat) {
        return PathNode{*from, {}, EdgeKind::Line};
    }
    const double uu = u.x * u.x + u.y * u.y;
    const double vv = v.x * v.x + v.y * v.y;
    const PointD centre = {start.x + (v.y * uu - u.y * vv) / (2.0 * cross),
                           start.y + (u.x * vv - v.x * uu) / (2.0 * cross)};
    constexpr double kMost = base::kMaxCoordinate;
    if (std::abs(centre.x) > kMost || std::abs(centre.y) > kMost) {
        canvas.report(Severity::Info, line, "an arc is so flat that its centre lies out of range; drawn as a line");
        return PathNode{*from, {}, EdgeKind::Line};
    }
    return PathNode{*from, rounded(centre), cross < 0 ? EdgeKind::ArcClockwise : EdgeKind::ArcCounterClockwise};
}

void drawGraphic(Canvas& canvas, std::int32_t row, const Graphic& graphic, const Origin& origin) {
    if (graphic.isFilled) {
        ShapeSketch region;
        addPath(region, graphic.nodes, false);
        canvas.drawRegion(row, origin, std::move(region));
    }
    const double width = graphic.width > 0.0 ? graphic.width : graphic.isFilled ? 0.0 : kThinnest;
    for (std::size_t i = 0; i < graphic.edgeCount() && width > 0.0; ++i) {
        drawStyled(canvas, row, origin, {graphic.nodes[i], graphic.endOf(i)}, width, graphic.style);
    }
}

LineStyle styleOfLine(const Item& item) {
    return lineStyleOf(item.find("stroke").find("type").word(1));
}

void drawStyled(Canvas& canvas, std::int32_t row, const Origin& origin, const ChainEdge& edge, double width,
                LineStyle style) {
    const bool isFull = canvas.drawnOn(row) > kMostBeforeDashes;
    if (style != LineStyle::Solid && isFull) {
        canvas.report(Severity::Info, origin.line, "of so many dashed and dotted lines the rest are drawn solid");
    }
    for (const ChainEdge& stroke : dashesOf(edge, width, isFull ? LineStyle::Solid : style, canvas.settings().dashes)) {
        canvas.drawEdge(row, origin, stroke.from, stroke.to, width);
    }
}

void drawGraphic(Canvas& canvas, const Item& item, const Frame& frame, Origin origin) {
    const std::optional<Graphic> graphic = graphicOf(canvas, item, frame);
    if (!graphic) {
        return;
    }
    origin.line = item.line();
    reportStyle(canvas, item, *graphic);
    for (const std::int32_t row : canvas.rowsOf(item)) {
        const bool isMask = item.find("layers").isThere() && canvas.layers().nameOf(row).ends_with(".Mask");
        if (isMask) {
            drawOpening(canvas, item, row, *graphic, origin);
        } else {
            drawGraphic(canvas, row, *graphic, origin);
        }
    }
}

void drawTarget(Canvas& canvas, const Item& item, const Origin& origin) {
    const std::optional<PointD> at = point(item, "at");
    const double size = length(item, "size");
    const std::optional<Point> centre = at ? canvas.onGrid(*at, item.line()) : std::nullopt;
    if (!centre || size <= 0.0) {
        canvas.report(Severity::Warning, item.line(), "a target has no place or size; it was left out");
        return;
    }
    const bool isDiagonal = item.word(1) == "x";
    const double width = length(item, "width", kThinnest);
    const double radius = isDiagonal ? size / 2.0 : size / 3.0;
    const Frame frame{*at, isDiagonal ? 45.0 : 0.0};
    for (const std::int32_t row : canvas.rowsOf(item)) {
        for (const PointD arm : {PointD{size / 2.0, 0.0}, PointD{0.0, size / 2.0}}) {
            const std::optional<Point> from = canvas.onGrid(frame.apply({-arm.x, -arm.y}), item.line());
            const std::optional<Point> to = canvas.onGrid(frame.apply(arm), item.line());
            if (from && to) {
                canvas.drawEdge(row, origin, {*from, {}, EdgeKind::Line}, *to, width);
            }
        }
        if (const std::optional<Point> start = canvas.onGrid({at->x + radius, at->y}, item.line())) {
            canvas.drawEdge(row, origin, {*start, *centre, EdgeKind::ArcCounterClockwise}, *start, width);
        }
    }
}

std::vector<EdgeLoops> coverOf(const Graphic& graphic) {
    std::vector<EdgeLoops> cover;
    const auto append = [&](std::vector<EdgeLoops> regions) {
        for (EdgeLoops& region : regions) {
            cover.push_back(std::move(region));
        }
    };
    if (graphic.isFilled) {
        append(regionsOf(graphic.nodes));
    }
    for (std::size_t i = 0; i < graphic.edgeCount() && graphic.width > 0.0; ++i) {
        append(penAlong(graphic.nodes[i], graphic.endOf(i), graphic.width));
    }
    return cover;
}

}  // namespace model::kicad
