#include "model/formats/kicad/pads.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/formats/kicad/back_drills.h"
#include "model/formats/kicad/pad_forms.h"
#include "model/formats/kicad/post_machining.h"
#include "model/formats/kicad/shapes/pad_outlines.h"
#include "model/formats/kicad/text/values.h"
#include "model/formats/kicad/vias.h"
#include "model/geometry/outlines.h"

namespace model::kicad {

namespace {

using formats::DrawnPackagePin;
using formats::kNoRow;
using formats::PadShape;

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
                    unused != nullptr && (isInner(layer) || !keepsEnds(m_pad)) ? unused->push_back(row)
                                                                               : drawOn(row, {});
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

    /// What it is to vias and pads that touch it.
    [[nodiscard]] UnusedPads::Owner owner() {
        UnusedPads::Owner owner;
        std::ranges::copy_if(m_rows, std::back_inserter(owner.rows),
                             [this](std::int32_t row) { return m_canvas.layers().isCopper(row); });
        std::ranges::sort(owner.rows);
        owner.net = m_origin.net;
        owner.component = m_owner.component;
        const std::string layer = owner.rows.empty() ? "F.Cu" : m_canvas.layers().nameOf(owner.rows.front());
        owner.at = centreOn(layer);
        owner.clockwiseDeg = clockwiseDeg();
        const PadForm& form = m_forms.on(layer).form;
        const PadShape shape = shapeOf(form, {});
        const double smaller = std::min(shape.width, shape.height) / 2.0;
        const bool isRound = form.kind == PadForm::Kind::Circle || form.kind == PadForm::Kind::Oval;
        owner.radius = isRound ? smaller : 0.0;
        owner.core = {shape.width / 2.0 - owner.radius, shape.height / 2.0 - owner.radius};
        owner.hole = m_hasHole ? std::min(m_drill.width, m_drill.height) / 2.0 : 0.0;
        owner.isPad = true;
        owner.waits = waitsForTracks();
        owner.keepsEnds = keepsEnds(m_pad);
        return owner;
    }
    /// Does its copper? That of a heat sink is always kept.
    [[nodiscard]] bool waitsForTracks() const {
        return removesUnused(m_pad) && m_pad.word(2) == "thru_hole" &&
               !m_pad.find("property").hasWord("pad_prop_heatsink");
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
            if (m_pad.word(2).ends_with("thru_hole")) {
                m_canvas.report(Severity::Warning, m_pad.line(), "a pad with a hole names no drill; it has no hole");
            }
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
            drawBackDrills(m_canvas, m_pad, m_origin, m_at);
            drawPostMachining(m_canvas, m_pad, m_origin, m_at, pen);
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
        drawPostMachining(m_canvas, m_pad, m_origin, m_at, 0.0);
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
    PadDrill m_drill;
    PadForms m_forms;
    PointD m_at;
    double m_degrees;
    std::vector<std::int32_t> m_rows;
    Origin m_origin;
    bool m_isPlated = true;
    bool m_hasHole = false;
    bool m_hasCopper = false;
};

}  // namespace

void drawPad(Canvas& canvas, UnusedPads& waiting, const Item& pad, const PadOwner& owner) {
    if (!point(pad, "at")) {
        canvas.report(Severity::Warning, pad.line(), "a pad has no place; it was left out");
        return;
    }
    PadMaker maker(canvas, pad, owner);
    std::vector<std::int32_t> unused;
    maker.draw(maker.waitsForTracks() ? &unused : nullptr);
    const std::size_t number = waiting.add(maker.owner());
    const Item connected = pad.find("zone_layer_connections");
    for (const std::int32_t row : unused) {
        const std::string& layer = canvas.layers().nameOf(row);
        UnusedPads::Waiting copper{row, maker.origin(), 0, maker.centreOn(layer), maker.clockwiseDeg(), 0.0, number};
        copper.symbol = maker.symbolOn(layer, {}, &copper.reach);
        copper.reach = connected.hasWord(layer) ? -1.0 : copper.reach;
        if (copper.symbol != kNoRow) {
            waiting.add(copper);
        }
    }
}

}  // namespace model::kicad
