#include "model/formats/kicad/pads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <limits>
#include <string>
#include <utility>

#include "model/formats/kicad/graphics.h"
#include "model/formats/kicad/shapes/pad_outlines.h"
#include "model/formats/kicad/shapes/regions.h"
#include "model/formats/kicad/text/values.h"
#include "model/geometry/outlines.h"

namespace model::kicad {

namespace {

using formats::DrawnPackagePin;
using formats::kNoRow;
using formats::PadShape;

PadForm::Kind kindOf(std::string_view word) {
    return word == "circle"      ? PadForm::Kind::Circle
           : word == "oval"      ? PadForm::Kind::Oval
           : word == "roundrect" ? PadForm::Kind::RoundRectangle
           : word == "trapezoid" ? PadForm::Kind::Trapezoid
           : word == "custom"    ? PadForm::Kind::Custom
                                 : PadForm::Kind::Rectangle;
}

unsigned cornersOf(const Item& chamfer) {
    return (chamfer.hasWord("top_right") ? 1U : 0U) | (chamfer.hasWord("top_left") ? 2U : 0U) |
           (chamfer.hasWord("bottom_left") ? 4U : 0U) | (chamfer.hasWord("bottom_right") ? 8U : 0U);
}

ShapeSketch customShape(Canvas& canvas, const Item& item, PointD size) {
    ShapeSketch anchor;
    if (item.find("options").find("anchor").word(1) == "rect") {
        addBox(anchor, size.x, size.y, false);
    } else {
        addDisc(anchor, size.x, false);
    }
    std::vector<EdgeLoops> regions = regionsOf(anchor.contour(0));
    for (const Item primitive : item.find("primitives")) {
        if (!isGraphic(primitive.head())) {
            continue;
        }
        const std::optional<Graphic> graphic = graphicOf(canvas, primitive, {}, true);
        for (EdgeLoops& region : graphic ? coverOf(*graphic) : std::vector<EdgeLoops>()) {
            regions.push_back(std::move(region));
        }
    }
    return united(regions);
}

/// The form that a pad, or a layer of its pad stack, has.
PadForm formOf(Canvas& canvas, const Item& item, std::string_view shape) {
    PadForm form;
    form.kind = kindOf(shape);
    const PointD given = size(item, "size").value_or(PointD());
    form.size = {std::abs(given.x), std::abs(given.y)};
    constexpr double kMost = base::kMaxCoordinate;
    if (form.size.x > kMost || form.size.y > kMost) {
        canvas.report(Severity::Error, item.line(), "a pad is larger than the coordinate range; it draws nothing");
        form.size = {};
    }
    if (form.kind == PadForm::Kind::Circle) {
        form.size.y = form.size.x;
    }
    form.radiusRatio = number(item, "roundrect_rratio", 0.25);
    form.chamferRatio = number(item, "chamfer_ratio");
    form.chamfers = cornersOf(item.find("chamfer"));
    form.delta = size(item, "rect_delta").value_or(PointD());
    if (form.kind == PadForm::Kind::Custom) {
        form.custom = customShape(canvas, item, form.size);
        form.customName = std::string(item.find("options").source()) + std::string(item.find("primitives").source());
    }
    return form;
}

/// Of the hole, in the pad's own frame.
struct Drill {
    double width = 0.0;
    double height = 0.0;
    PointD offset;
};

Drill drillOf(const Item& pad) {
    const Item item = pad.find("drill");
    Drill drill;
    const std::size_t first = item.word(1) == "oval" ? 2 : 1;
    drill.width = std::abs(lengthOf(item.word(first)).value_or(0.0));
    drill.height = std::abs(lengthOf(item.word(first + 1)).value_or(drill.width));
    drill.height = first == 2 ? drill.height : drill.width;
    drill.offset = point(item, "offset").value_or(PointD());
    return drill;
}

/// The layers of a pad with the forms they have there.
class PadForms {
public:
    struct Form {
        PadForm form;
        PointD offset;
    };

    PadForms(Canvas& canvas, const Item& pad, const Drill& drill) {
        m_forms.push_back({formOf(canvas, pad, pad.word(3)), drill.offset});
        const Item stack = pad.find("padstack");
        m_isFrontInnerBack = stack.find("mode").word(1) != "custom";
        for (const Item layer : stack) {
            if (layer.head() == "layer") {
                Form form{formOf(canvas, layer, layer.find("shape").word(1)),
                          point(layer, "offset").value_or(PointD())};
                m_layers.emplace_back(layer.text(1), m_forms.size());
                m_forms.push_back(std::move(form));
            }
        }
    }

    /// On a layer by its name; those of mask and paste are as the copper of their side.
    [[nodiscard]] const Form& on(const std::string& layer) const {
        const std::string copper = layer.starts_with("B.") ? "B.Cu" : layer.starts_with("F.") ? "F.Cu" : layer;
        for (const auto& [name, row] : m_layers) {
            const bool isInner = name == "Inner" && copper.starts_with("In") && m_isFrontInnerBack;
            if (name == copper || isInner) {
                return m_forms[row];
            }
        }
        return m_forms[0];
    }

private:
    std::vector<Form> m_forms;
    std::vector<std::pair<std::string, std::size_t>> m_layers;
    bool m_isFrontInnerBack = true;
};

/// One pad.
class PadMaker {
public:
    PadMaker(Canvas& canvas, const Item& pad, const PadOwner& owner)
        : m_canvas(canvas),
          m_pad(pad),
          m_owner(owner),
          m_drill(drillOf(pad)),
          m_forms(canvas, pad, m_drill),
          m_at(owner.frame.apply(point(pad, "at").value_or(PointD()))),
          m_degrees(numberOf(pad.find("at").word(3)).value_or(0.0)),
          m_rows(canvas.layers().rows(pad.find("layers"))) {
        m_origin.line = pad.line();
        m_origin.component = owner.component;
        m_origin.net = canvas.netOf(pad);
        m_isPlated = pad.word(2) != "np_thru_hole";
        m_hasHole = m_drill.width > 0.0 && (pad.word(2) == "thru_hole" || !m_isPlated);
        m_hasCopper = std::ranges::any_of(m_rows, [&](std::int32_t row) { return canvas.layers().isCopper(row); });
    }

    void draw(std::vector<std::int32_t>* unused) {
        addPin();
        setAttributes();
        for (const std::int32_t row : m_rows) {
            const std::string& layer = m_canvas.layers().nameOf(row);
            if (m_canvas.layers().isCopper(row)) {
                if (!isWithoutCopper(m_forms.on(layer).form)) {
                    unused != nullptr&& isInner(layer) ? unused->push_back(row) : drawOn(row, {});
                }
            } else {
                drawOn(row, layer.ends_with(".Mask")    ? maskMargin(layer)
                            : layer.ends_with(".Paste") ? pasteMargin(layer)
                                                        : PointD());
            }
        }
        if (m_rows.empty()) {
            m_canvas.report(Severity::Info, m_pad.line(), "a pad lies on no layer that the board has; it was left out");
        }
        drawHole();
    }

    [[nodiscard]] const Origin& origin() const { return m_origin; }
    [[nodiscard]] double clockwiseDeg() const { return -m_degrees; }
    [[nodiscard]] PointD centreOn(const std::string& layer) const {
        return Frame{m_at, m_degrees}.apply(m_forms.on(layer).offset);
    }
    std::int32_t symbolOn(const std::string& layer, PointD margin, double* reach = nullptr) {
        const PadForms::Form& form = m_forms.on(layer);
        PadShape shape = shapeOf(form.form, margin);
        if (reach != nullptr) {
            *reach = std::max(shape.width, shape.height) / 2.0;
        }
        if (shape.kind == PadShape::Kind::Nothing) {
            return kNoRow;
        }
        return m_canvas.symbol(nameOf(form.form, margin), std::move(shape));
    }

private:
    static bool isInner(const std::string& layer) { return layer.starts_with("In"); }

    void drawOn(std::int32_t row, PointD margin) {
        const std::string& layer = m_canvas.layers().nameOf(row);
        const std::int32_t symbol = symbolOn(layer, margin);
        if (symbol != kNoRow) {
            m_canvas.drawPad(row, m_origin, symbol, centreOn(layer), clockwiseDeg());
        }
    }

    /// Is its copper no larger than its hole, which has no plating?
    [[nodiscard]] bool isWithoutCopper(const PadForm& form) const {
        const bool isCentred = m_drill.offset == PointD();
        return !m_isPlated && isCentred && (form.kind == PadForm::Kind::Circle || form.kind == PadForm::Kind::Oval) &&
               form.size.x <= m_drill.width && form.size.y <= m_drill.height;
    }

    [[nodiscard]] PointD maskMargin(const std::string& layer) const {
        const std::optional<double> own = lengthOf(m_pad.find("solder_mask_margin").word(1));
        const double margin = own ? *own : m_owner.maskMargin.value_or(m_canvas.settings().maskMargin);
        if (!m_hasCopper) {
            return {};
        }
        const PointD size = m_forms.on(layer).form.size;
        const double least = -std::min(size.x, size.y) / 2.0;
        return {std::max(margin, least), std::max(margin, least)};
    }

    [[nodiscard]] PointD pasteMargin(const std::string& layer) const {
        if (!m_hasCopper) {
            return {};
        }
        const std::optional<double> own = lengthOf(m_pad.find("solder_paste_margin").word(1));
        const std::optional<double> ownRatio = numberOf(m_pad.find("solder_paste_margin_ratio").word(1));
        const double margin = own ? *own : m_owner.pasteMargin.value_or(m_canvas.settings().pasteMargin);
        const double ratio = ownRatio ? *ownRatio : m_owner.pasteRatio.value_or(m_canvas.settings().pasteRatio);
        const PointD size = m_forms.on(layer).form.size;
        return {std::max(margin + ratio * size.x, -size.x / 2.0), std::max(margin + ratio * size.y, -size.y / 2.0)};
    }

    void drawHole() {
        if (!m_hasHole) {
            return;
        }
        const std::int32_t row = m_canvas.layers().drills(kNoRow, kNoRow, m_isPlated, m_canvas.job());
        if (row == kNoRow) {
            return;
        }
        Origin origin = m_origin;
        origin.plating = m_isPlated ? Plating::Plated : Plating::NonPlated;
        const double pen = std::min(m_drill.width, m_drill.height);
        const double reach = (std::max(m_drill.width, m_drill.height) - pen) / 2.0;
        if (reach < 1.0) {
            m_canvas.drawPad(row, origin, m_canvas.pen(pen), m_at, 0.0);
            return;
        }
        const bool isFlat = m_drill.width > m_drill.height;
        const PointD half = isFlat ? PointD{reach, 0.0} : PointD{0.0, reach};
        const Frame frame{m_at, m_degrees};
        const std::optional<Point> a = m_canvas.onGrid(frame.apply({-half.x, -half.y}), origin.line);
        const std::optional<Point> b = m_canvas.onGrid(frame.apply(half), origin.line);
        if (a && b) {
            m_canvas.drawEdge(row, origin, {*a, {}, EdgeKind::Line}, *b, pen);
        }
    }

    // ---- pins ----

    void addPin() {
        if (m_owner.component == kNoRow) {
            return;
        }
        const std::optional<Point> at = m_canvas.onGrid(m_at, m_pad.line());
        if (!at) {
            return;
        }
        formats::DrawnComponent& component = m_canvas.step().components[static_cast<std::size_t>(m_owner.component)];
        formats::DrawnPackage& package = m_canvas.step().packages[static_cast<std::size_t>(component.package)];
        m_origin.pin = static_cast<std::int32_t>(component.pins.size());
        component.pins.push_back({m_pad.text(1), *at, m_origin.net, static_cast<std::int32_t>(package.pins.size())});
        package.pins.push_back(packagePin());
    }

    [[nodiscard]] DrawnPackagePin packagePin() {
        const PointD local = point(m_pad, "at").value_or(PointD());
        // Packages are seen from the top; what is on the back is stored turned over its horizontal axis.
        const Placement flip{{}, m_owner.isOnBack ? 180.0 : 0.0, m_owner.isOnBack};
        const PadForms::Form& form = m_forms.on(m_owner.isOnBack ? "B.Cu" : "F.Cu");
        const double degrees = m_degrees - m_owner.frame.degrees;
        const PointD centre = Frame{local, degrees}.apply(form.offset);
        DrawnPackagePin pin;
        pin.name = m_pad.text(1);
        pin.kind = m_hasHole ? PinKind::Through : PinKind::Surface;
        pin.position = rounded(flip.apply(local));
        const PadShape shape = shapeOf(form.form, {});
        constexpr double kMost = base::kMaxCoordinate / 2.0;
        if (shape.kind != PadShape::Kind::Nothing && std::abs(centre.x) < kMost && std::abs(centre.y) < kMost) {
            ShapeSketch turned;
            turned.append(formats::outlineOf(shape), {rounded(centre), -degrees, false});
            pin.outline.append(turned, flip);
        }
        return pin;
    }

    void setAttributes() {
        formats::Words words;
        for (const char* head : {"pinfunction", "pintype"}) {
            const std::string value = m_pad.find(head).text(1);
            if (!value.empty()) {
                words.emplace_back(head, nameOf(value));
            }
        }
        m_origin.attributes = m_canvas.attributes(words);
    }

    static std::string nameOf(std::string_view text) { return kicad::nameOf(text); }
    static std::string nameOf(const PadForm& form, PointD margin) { return kicad::nameOf(form, margin); }

    Canvas& m_canvas;
    const Item& m_pad;
    const PadOwner& m_owner;
    Drill m_drill;
    PadForms m_forms;
    PointD m_at;
    double m_degrees;
    std::vector<std::int32_t> m_rows;
    Origin m_origin;
    bool m_isPlated = true;
    bool m_hasHole = false;
    bool m_hasCopper = false;
};

bool removesUnused(const Item& item) {
    return item.isSet("remove_unused_layers") || item.isSet("remove_unused_layer");
}

/// On which sides solder mask covers a via: what it says itself, else the board.
std::array<bool, 2> tentingOf(const Item& via, std::array<bool, 2> board) {
    const Item tenting = via.find("tenting");
    if (!tenting.isThere()) {
        return board;
    }
    std::array<bool, 2> sides{};
    for (std::size_t i = 0; i < 2; ++i) {
        const std::string_view side = i == 0 ? "front" : "back";
        const Item list = tenting.find(side);
        sides[i] = list.isThere() && list.word(1) != "yes" && list.word(1) != "no" ? board[i] : tenting.isSet(side);
    }
    return sides;
}

double viaSizeOn(const Item& via, const std::string& layer) {
    const Item stack = via.find("padstack");
    for (const Item item : stack) {
        const bool isInner = item.word(1) == "Inner" && layer.starts_with("In");
        if (item.head() == "layer" && (item.word(1) == layer || isInner)) {
            return length(item, "size", length(via, "size"));
        }
    }
    return length(via, "size");
}

}  // namespace

void Pads::drawPad(const Item& pad, const PadOwner& owner) {
    if (!point(pad, "at")) {
        m_canvas.report(Severity::Warning, pad.line(), "a pad has no place; it was left out");
        return;
    }
    PadMaker maker(m_canvas, pad, owner);
    std::vector<std::int32_t> unused;
    maker.draw(removesUnused(pad) && pad.word(2) == "thru_hole" ? &unused : nullptr);
    const Item connected = pad.find("zone_layer_connections");
    for (const std::int32_t row : unused) {
        const std::string& layer = m_canvas.layers().nameOf(row);
        Waiting waiting{row, maker.origin(), 0, maker.centreOn(layer), maker.clockwiseDeg(), 0.0};
        waiting.symbol = maker.symbolOn(layer, {}, &waiting.reach);
        waiting.reach = connected.hasWord(layer) ? -1.0 : waiting.reach;
        if (waiting.symbol != kNoRow) {
            m_waiting.push_back(waiting);
        }
    }
}

void Pads::drawVia(const Item& via) {
    const std::optional<PointD> at = point(via, "at");
    const double size = length(via, "size");
    if (!at || size <= 0.0) {
        m_canvas.report(Severity::Warning, via.line(), "a via has no place or size; it was left out");
        return;
    }
    BoardLayers& layers = m_canvas.layers();
    const Item names = via.find("layers");
    const std::vector<std::int32_t> span = layers.span(layers.row(names.word(1)), layers.row(names.word(2)));
    if (span.empty()) {
        return;
    }
    Origin origin;
    origin.line = via.line();
    origin.net = m_canvas.netOf(via);
    origin.subnet = SubnetKind::Via;
    origin.plating = Plating::Via;
    for (const char* type : {"blind", "buried", "micro"}) {
        if (via.hasWord(type)) {
            origin.attributes = m_canvas.attributes({{"via_type", type}});
        }
    }
    const Item connected = via.find("zone_layer_connections");
    for (const std::int32_t row : span) {
        const double width = viaSizeOn(via, layers.nameOf(row));
        const bool isEnd = row == span.front() || row == span.back();
        const bool isKept = isEnd && (via.isSet("keep_end_layers") || !via.find("keep_end_layers").isThere());
        if (removesUnused(via) && !isKept && !connected.hasWord(layers.nameOf(row))) {
            m_waiting.push_back({row, origin, m_canvas.pen(width), *at, 0.0, width / 2.0});
        } else {
            m_canvas.drawPad(row, origin, m_canvas.pen(width), *at, 0.0);
        }
    }
    const std::array<bool, 2> isTented = tentingOf(via, m_canvas.settings().isViaTented);
    for (std::size_t i = 0; i < 2; ++i) {
        const std::int32_t mask = layers.row(i == 0 ? "F.Mask" : "B.Mask");
        const bool reaches =
            (i == 0 ? span.front() : span.back()) == (i == 0 ? layers.copper().front() : layers.copper().back());
        if (!isTented[i] && mask != kNoRow && reaches) {
            const double width = size + 2.0 * m_canvas.settings().maskMargin;
            m_canvas.drawPad(mask, origin, m_canvas.pen(std::max(width, 0.0)), *at, 0.0);
        }
    }
    double drill = length(via, "drill", m_canvas.settings().viaDrill);
    if (drill <= 0.0) {
        drill = size / 2.0;
        m_canvas.report(Severity::Warning, via.line(), "a via names no drill; half of its pad was taken");
    }
    const std::int32_t row = layers.drills(span.front(), span.back(), true, m_canvas.job());
    m_canvas.drawPad(row, origin, m_canvas.pen(drill), *at, 0.0);
    if (via.find("backdrill").isThere() || via.find("tertiary_drill").isThere()) {
        m_canvas.report(Severity::Warning, via.line(),
                        "back-drills of vias are not read; the whole hole is shown plated");
    }
}

void Pads::finish() {
    std::vector<std::int32_t> rows;
    for (const Waiting& waiting : m_waiting) {
        rows.push_back(waiting.row);
    }
    std::ranges::sort(rows);
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    for (const std::int32_t row : rows) {
        std::vector<Waiting> pads;
        std::ranges::copy_if(m_waiting, std::back_inserter(pads), [&](const Waiting& w) { return w.row == row; });
        drawWaiting(std::move(pads), row);
    }
    m_waiting.clear();
}

void Pads::drawWaiting(std::vector<Waiting> pads, std::int32_t row) {
    std::vector<std::pair<Point, std::int32_t>> ends;  // by x, with their nets
    const auto& features = m_canvas.step().features;
    if (static_cast<std::size_t>(row) < features.size()) {
        for (const formats::DrawnFeature& feature : features[static_cast<std::size_t>(row)]) {
            if (feature.subnet == SubnetKind::Trace) {
                ends.emplace_back(feature.a, feature.net);
                ends.emplace_back(feature.b, feature.net);
            }
        }
    }
    std::ranges::sort(ends);
    for (const Waiting& pad : pads) {
        bool isConnected = pad.reach < 0.0;
        const Point from{asNm(pad.at.x - pad.reach), std::numeric_limits<Nm>::min()};
        for (auto end = std::ranges::lower_bound(ends, std::pair(from, std::numeric_limits<std::int32_t>::min()));
             !isConnected && end != ends.end() && end->first.x <= pad.at.x + pad.reach; ++end) {
            isConnected = end->second == pad.origin.net &&
                          std::hypot(end->first.x - pad.at.x, end->first.y - pad.at.y) <= pad.reach;
        }
        if (isConnected) {
            m_canvas.drawPad(row, pad.origin, pad.symbol, pad.at, pad.clockwiseDeg);
        }
    }
}

}  // namespace model::kicad
