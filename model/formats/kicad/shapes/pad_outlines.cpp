#include "model/formats/kicad/shapes/pad_outlines.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <vector>

#include "model/formats/kicad/shapes/regions.h"
#include "model/geometry/outlines.h"

namespace model::kicad {

namespace {

using formats::PadShape;

Nm asNm(double length) {
    return static_cast<Nm>(std::llround(std::clamp(length, 0.0, static_cast<double>(base::kMaxCoordinate))));
}

PadShape simple(PadShape::Kind kind, double width, double height) {
    PadShape shape;
    shape.kind = width >= 1.0 && height >= 1.0 ? kind : PadShape::Kind::Nothing;
    shape.width = asNm(width);
    shape.height = asNm(height);
    return shape;
}

PadShape region(ShapeSketch sketch, double width, double height) {
    PadShape shape = simple(sketch.isEmpty() ? PadShape::Kind::Nothing : PadShape::Kind::Region, std::max(width, 1.0),
                            std::max(height, 1.0));
    shape.region = std::move(sketch);
    return shape;
}

PadShape oval(double width, double height) {
    return simple(asNm(width) == asNm(height) ? PadShape::Kind::Round : PadShape::Kind::Oval, width, height);
}

PadShape roundRectangle(double width, double height, double radius) {
    if (width < 1.0 || height < 1.0) {
        return {};
    }
    const double smaller = std::min(width, height);
    if (2.0 * radius >= smaller - 1.0) {
        return oval(width, height);
    }
    ShapeSketch sketch;
    addCornerBox(sketch, width, height, radius, kAllCorners, CornerStyle::Rounded, false);
    return region(std::move(sketch), width, height);
}

/// Chosen corners are cut, the others rounded; cut by nothing, they are sharp.
ShapeSketch chamferedRectangle(const PadForm& form, double width, double height) {
    constexpr std::array<PointD, 4> kCorners = {{{1, 1}, {-1, 1}, {-1, -1}, {1, -1}}};
    const double smaller = std::min(width, height);
    const double radius = std::clamp(form.radiusRatio, 0.0, 0.5) * smaller;
    const double chamfer = std::clamp(form.chamferRatio, 0.0, 0.5) * smaller;
    std::vector<PathNode> nodes;
    for (std::size_t i = 0; i < 4; ++i) {
        const bool isCut = (form.chamfers >> i & 1U) != 0;
        const double r = isCut ? chamfer : radius;
        const PointD corner = {kCorners[i].x * width / 2, kCorners[i].y * height / 2};
        const PointD centre = {corner.x - kCorners[i].x * r, corner.y - kCorners[i].y * r};
        const bool isSideFirst = i % 2 == 0;
        const PointD onSide = {corner.x, centre.y};
        const PointD onFlat = {centre.x, corner.y};
        const EdgeKind edge = isCut ? EdgeKind::Line : EdgeKind::ArcCounterClockwise;
        if (r <= 0.0) {
            nodes.push_back({rounded(corner), {}, EdgeKind::Line});
            continue;
        }
        nodes.push_back({rounded(isSideFirst ? onSide : onFlat), isCut ? Point() : rounded(centre), edge});
        nodes.push_back({rounded(isSideFirst ? onFlat : onSide), {}, EdgeKind::Line});
    }
    ShapeSketch sketch;
    addPath(sketch, nodes, false);
    return sketch;
}

ShapeSketch trapezoid(const PadForm& form) {
    const double x = form.size.x / 2;
    const double y = form.size.y / 2;
    const double dx = form.delta.x / 2;
    const double dy = form.delta.y / 2;
    ShapeSketch sketch;
    addLoop(sketch, std::array<PointD, 4>{{{-x - dy, -y - dx}, {x + dy, -y + dx}, {x - dy, y - dx}, {-x + dy, y + dx}}},
            false);
    return sketch;
}

PadShape followed(const ShapeSketch& sketch, double margin) {
    ShapeSketch shape = margin == 0.0 ? sketch : grown(sketch, margin);
    const Box box = boxOf(shape);
    return region(std::move(shape), static_cast<double>(box.width()), static_cast<double>(box.height()));
}

const char* wordOf(PadForm::Kind kind) {
    switch (kind) {
        case PadForm::Kind::Circle: return "circle";
        case PadForm::Kind::Oval: return "oval";
        case PadForm::Kind::Rectangle: return "rect";
        case PadForm::Kind::RoundRectangle: return "roundrect";
        case PadForm::Kind::Trapezoid: return "trapezoid";
        case PadForm::Kind::Custom: break;
    }
    return "custom";
}

}  // namespace

formats::PadShape shapeOf(const PadForm& form, PointD margin) {
    const double width = form.size.x + 2.0 * margin.x;
    const double height = form.size.y + 2.0 * margin.y;
    switch (form.kind) {
        case PadForm::Kind::Circle: return simple(PadShape::Kind::Round, width, width);
        case PadForm::Kind::Oval: return oval(width, height);
        case PadForm::Kind::Rectangle:
            return roundRectangle(width, height, std::max(0.0, std::min(margin.x, margin.y)));
        case PadForm::Kind::RoundRectangle:
            if (form.chamfers == 0) {
                return roundRectangle(width, height, form.radiusRatio * std::min(width, height));
            }
            return margin.x == margin.y ? followed(chamferedRectangle(form, form.size.x, form.size.y), margin.x)
                                        : followed(chamferedRectangle(form, width, height), 0.0);
        case PadForm::Kind::Trapezoid: return followed(trapezoid(form), margin.x);
        case PadForm::Kind::Custom: break;
    }
    return followed(form.custom, margin.x);
}

std::string nameOf(const PadForm& form, PointD margin) {
    std::array<char, 256> name{};
    const bool isSame = margin.x == margin.y;
    const double width = form.size.x + 2.0 * margin.x;
    const double height = form.size.y + 2.0 * margin.y;
    std::snprintf(name.data(), name.size(), "%s %.6g x %.6g", wordOf(form.kind), width / 1e6, height / 1e6);
    std::string text = name.data();
    if (form.kind == PadForm::Kind::RoundRectangle) {
        std::snprintf(name.data(), name.size(), " r %.6g", form.radiusRatio * std::min(width, height) / 1e6);
        text += name.data();
        if (form.chamfers != 0) {
            std::snprintf(name.data(), name.size(), " chamfer %.6g corners %u",
                          form.chamferRatio * std::min(form.size.x, form.size.y) / 1e6, form.chamfers);
            text += name.data();
        }
    } else if (form.kind == PadForm::Kind::Trapezoid) {
        std::snprintf(name.data(), name.size(), " delta %.6g %.6g", form.delta.x / 1e6, form.delta.y / 1e6);
        text += name.data();
    } else if (form.kind == PadForm::Kind::Custom) {
        text += " " + form.customName;
    }
    const bool isFollowed = form.kind != PadForm::Kind::Circle && form.kind != PadForm::Kind::Oval &&
                            (form.kind != PadForm::Kind::RoundRectangle || form.chamfers != 0);
    if (isFollowed && (margin.x != 0.0 || !isSame)) {
        std::snprintf(name.data(), name.size(), " margin %.6g", margin.x / 1e6);
        text += name.data();
    }
    return text;
}

}  // namespace model::kicad
