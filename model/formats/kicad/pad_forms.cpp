#include "model/formats/kicad/pad_forms.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>

#include "model/formats/kicad/graphics.h"
#include "model/formats/kicad/shapes/regions.h"
#include "model/formats/kicad/text/values.h"
#include "model/geometry/outlines.h"

namespace model::kicad {

namespace {

/// None of a word that names no shape.
std::optional<PadForm::Kind> kindOf(std::string_view word) {
    constexpr std::array<std::pair<std::string_view, PadForm::Kind>, 6> kKinds = {
        {{"circle", PadForm::Kind::Circle},
         {"rect", PadForm::Kind::Rectangle},
         {"oval", PadForm::Kind::Oval},
         {"roundrect", PadForm::Kind::RoundRectangle},
         {"trapezoid", PadForm::Kind::Trapezoid},
         {"custom", PadForm::Kind::Custom}}};
    const auto found = std::ranges::find(kKinds, word, [](const auto& kind) { return kind.first; });
    return found == kKinds.end() ? std::nullopt : std::optional(found->second);
}

unsigned cornersOf(const Item& chamfer) {
    return (chamfer.hasWord("top_right") ? 1U : 0U) | (chamfer.hasWord("top_left") ? 2U : 0U) |
           (chamfer.hasWord("bottom_left") ? 4U : 0U) | (chamfer.hasWord("bottom_right") ? 8U : 0U);
}

/// Besides shapes there are boxes for the number of a pad and directions of spokes, which draw nothing.
void reportPrimitive(Canvas& canvas, const Item& primitive) {
    const std::string_view head = primitive.head();
    if (primitive.isList() && head != "gr_bbox" && head != "gr_vector") {
        canvas.reportNotDrawn(primitive);
    }
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
            reportPrimitive(canvas, primitive);
            continue;
        }
        const std::optional<Graphic> graphic = graphicOf(canvas, primitive, {}, true);
        if (graphic && graphic->isHatched) {
            canvas.report(Severity::Warning, primitive.line(), "of hatched shapes only the outline is drawn");
        }
        for (EdgeLoops& region : graphic ? coverOf(*graphic) : std::vector<EdgeLoops>()) {
            regions.push_back(std::move(region));
        }
    }
    return united(regions);
}

/// The form that a pad, or a layer of its pad stack, has.
PadForm formOf(Canvas& canvas, const Item& item, std::string_view shape) {
    PadForm form;
    const std::optional<PadForm::Kind> kind = kindOf(shape);
    if (!kind) {
        canvas.report(Severity::Warning, item.line(), "a pad has a shape that is not known; a rectangle is drawn");
    }
    form.kind = kind.value_or(PadForm::Kind::Rectangle);
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

}  // namespace

PadDrill drillOf(const Item& pad) {
    const Item item = pad.find("drill");
    PadDrill drill;
    const std::size_t first = item.word(1) == "oval" ? 2 : 1;
    drill.width = std::abs(lengthOf(item.word(first)).value_or(0.0));
    drill.height = std::abs(lengthOf(item.word(first + 1)).value_or(drill.width));
    drill.height = first == 2 ? drill.height : drill.width;
    drill.offset = point(item, "offset").value_or(PointD());
    return drill;
}

PadForms::PadForms(Canvas& canvas, const Item& pad, const PadDrill& drill) {
    m_forms.push_back({formOf(canvas, pad, pad.word(3)), drill.offset});
    const Item stack = pad.find("padstack");
    m_isFrontInnerBack = stack.find("mode").word(1) != "custom";
    for (const Item layer : stack) {
        if (layer.head() == "layer") {
            Form form{formOf(canvas, layer, layer.find("shape").word(1)), point(layer, "offset").value_or(PointD())};
            m_layers.emplace_back(layer.text(1), m_forms.size());
            m_forms.push_back(std::move(form));
        }
    }
}

const PadForms::Form& PadForms::on(const std::string& layer) const {
    const std::string copper = layer.starts_with("B.") ? "B.Cu" : layer.starts_with("F.") ? "F.Cu" : layer;
    for (const auto& [name, row] : m_layers) {
        const bool isInner = name == "Inner" && copper.starts_with("In") && m_isFrontInnerBack;
        if (name == copper || isInner) {
            return m_forms[row];
        }
    }
    return m_forms[0];
}

}  // namespace model::kicad
