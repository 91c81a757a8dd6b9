#include "model/formats/kicad/barcodes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/formats/kicad/shapes/regions.h"
#include "model/formats/kicad/text/barcode_symbol.h"
#include "model/formats/kicad/text/values.h"

namespace model::kicad {

namespace {

constexpr double kDefaultSize = 40e6;
constexpr double kDefaultTextHeight = 1.27e6;
constexpr double kPenOfHeight = 1 / 8.0;
constexpr double kTextBelow = 1e6;
constexpr double kMarginStep = 100'000.0;
constexpr double kLeastSize = 10'000.0;

struct Extent {
    PointD min{1e12, 1e12};
    PointD max{-1e12, -1e12};

    void include(PointD p) {
        min = {std::min(min.x, p.x), std::min(min.y, p.y)};
        max = {std::max(max.x, p.x), std::max(max.y, p.y)};
    }
};

EdgeLoops rectangle(PointD min, PointD max) {
    EdgeLoops loops;
    const std::array<PointD, 4> corners = {min, PointD{max.x, min.y}, max, PointD{min.x, max.y}};
    for (std::size_t i = 0; i < corners.size(); ++i) {
        loops.addLine(corners[i], corners[(i + 1) % corners.size()]);
    }
    static_cast<void>(loops.endLoop());
    return loops;
}

/// One barcode, drawn around the origin as it is seen on its side, then laid on the board.
class BarcodeMaker {
public:
    BarcodeMaker(Canvas& canvas, const Item& barcode, std::string text)
        : m_canvas(canvas), m_item(barcode), m_text(std::move(text)) {
        m_size = size(barcode, "size").value_or(PointD{kDefaultSize, kDefaultSize});
        m_size = {std::max(m_size.x, kLeastSize), std::max(m_size.y, kLeastSize)};
    }

    /// Empty, with a message, if there is nothing to draw.
    ShapeSketch draw() {
        addSymbol();
        if (m_dark.empty()) {
            return {};
        }
        const bool isKnockout = m_item.isSet("knockout");
        if (!m_item.isSet("hide")) {
            addText();
        }
        if (!isOnBoard(isKnockout)) {
            report("it is larger than a board can be");
            return {};
        }
        return isKnockout ? without(std::array{boxAround()}, m_dark) : united(m_dark);
    }

private:
    void report(std::string_view why) {
        m_canvas.report(Severity::Warning, m_item.line(), "a barcode is not drawn: " + std::string(why));
    }

    [[nodiscard]] int correction() const {
        const std::string_view word = m_item.find("ecc_level").word(1);
        return word == "M" ? 2 : word == "Q" ? 3 : word == "H" ? 4 : 1;
    }

    void addSymbol() {
        const Item type = m_item.find("type");
        const std::optional<BarcodeKind> kind =
            type.isThere() ? barcodeKindNamed(type.word(1)) : std::optional(BarcodeKind::Qr);
        if (!kind || m_text.empty()) {
            return report(kind ? "it has no text" : "its type is unknown");
        }
        const base::Result<std::vector<BarcodeBar>> bars = barsOf(*kind, m_text, correction());
        bars ? scale(*bars) : report(bars.error().text);
    }

    /// The dark bars fill the size, whatever they measured.
    void scale(const std::vector<BarcodeBar>& bars) {
        Extent all;
        for (const BarcodeBar& bar : bars) {
            all.include({bar.left, bar.bottom});
            all.include({bar.right, bar.top});
        }
        const auto laid = [&](double x, double y) {
            return PointD{std::round(((x - all.min.x) / (all.max.x - all.min.x) - 0.5) * m_size.x),
                          std::round(((y - all.min.y) / (all.max.y - all.min.y) - 0.5) * m_size.y)};
        };
        for (const BarcodeBar& bar : bars) {
            add(rectangle(laid(bar.left, bar.bottom), laid(bar.right, bar.top)));
        }
        m_extent.include({-m_size.x / 2.0, -m_size.y / 2.0});
        m_extent.include({m_size.x / 2.0, m_size.y / 2.0});
    }

    void add(EdgeLoops loops) {
        if (loops.loopCount() > 0) {
            m_dark.push_back(std::move(loops));
        }
    }

    /// Below the middle of the symbol.
    void addText() {
        TextStyle style;
        style.height = style.width = std::max(length(m_item, "text_height", kDefaultTextHeight), 1.0);
        style.pen = style.height * kPenOfHeight;
        const TextStrokes strokes(m_text, style);
        if (strokes.lacksCharacters()) {
            m_canvas.report(Severity::Info, m_item.line(),
                            "a text has characters that the font lacks; they are left out");
        }
        const double half = style.pen / 2.0;
        const PointD move{-(strokes.min().x + strokes.max().x) / 2.0,
                          -m_size.y / 2.0 - kTextBelow - half - strokes.max().y};
        for (const auto& [a, b] : strokes.strokes()) {
            const PointD from{a.x + move.x, a.y + move.y};
            const PointD to{b.x + move.x, b.y + move.y};
            EdgeLoops stroke;
            stroke.addCapsule(from, to, half);
            add(std::move(stroke));
            for (const PointD end : {from, to}) {
                m_extent.include({end.x - half, end.y - half});
                m_extent.include({end.x + half, end.y + half});
            }
        }
    }

    [[nodiscard]] PointD margin() const {
        const double tenth = std::ceil(std::min(m_size.x, m_size.y) / 10.0 / kMarginStep) * kMarginStep;
        const PointD given = size(m_item, "margins").value_or(PointD());
        return {std::max(given.x, tenth), std::max(given.y, tenth)};
    }

    [[nodiscard]] EdgeLoops boxAround() const {
        return rectangle({m_extent.min.x - margin().x, m_extent.min.y - margin().y},
                         {m_extent.max.x + margin().x, m_extent.max.y + margin().y});
    }

    /// Do all of its coordinates keep within what regions can have?
    [[nodiscard]] bool isOnBoard(bool hasMargin) const {
        const PointD beside = hasMargin ? margin() : PointD();
        const double reach = std::max({beside.x - m_extent.min.x, beside.x + m_extent.max.x, beside.y - m_extent.min.y,
                                       beside.y + m_extent.max.y});
        return reach <= base::kMaxCoordinate;
    }

    Canvas& m_canvas;
    const Item& m_item;
    std::string m_text;
    PointD m_size;
    std::vector<EdgeLoops> m_dark;
    Extent m_extent;
};

/// First mirrored, where it is on the back, then turned.
Placement placementOf(Point at, double degrees, bool isOnBack) {
    return {at, std::fmod((isOnBack ? degrees : -degrees) + 720.0, 360.0), isOnBack};
}

}  // namespace

void drawBarcode(Canvas& canvas, const Item& barcode, const Variables& variables, const Origin& origin) {
    const std::optional<PointD> place = point(barcode, "at");
    const std::optional<Point> at = place ? canvas.onGrid(*place, origin.line) : std::nullopt;
    if (!at) {
        return canvas.report(Severity::Warning, barcode.line(), "a barcode has no place; it was left out");
    }
    const std::string text = shownText(canvas, barcode, barcode.find("text").text(1), variables);
    const ShapeSketch sketch = BarcodeMaker(canvas, barcode, text).draw();
    const double degrees = numberOf(barcode.find("at").word(3)).value_or(0.0);
    for (const std::int32_t row : sketch.isEmpty() ? std::vector<std::int32_t>() : canvas.rowsOf(barcode)) {
        const bool isOnBack = canvas.layers().nameOf(row).starts_with("B.");
        ShapeSketch laid;
        laid.append(sketch, placementOf(*at, degrees, isOnBack));
        const std::uint32_t ordinal = canvas.drawnOn(row);
        canvas.drawRegion(row, origin, std::move(laid));
        canvas.step().groups.push_back({"TEXT", {{"text", text}}, {{row, ordinal}}});
    }
}

}  // namespace model::kicad
