#include "model/solids/shells/shared_shape.h"

#include <cmath>
#include <limits>
#include <numbers>

#include "model/solids/shells/area_shell.h"
#include "model/solids/shells/circle_shell.h"
#include "model/solids/shells/element_shells.h"

namespace model {

std::size_t ShapeKeyHash::operator()(const ShapeKey& key) const {
    std::uint64_t hash = static_cast<std::uint64_t>(key.kind);
    for (const std::int64_t part :
         {key.first, key.second, std::int64_t{key.bottom}, std::int64_t{key.top}, std::int64_t{key.drilled}}) {
        hash = (hash ^ static_cast<std::uint64_t>(part)) * 0x9e3779b97f4a7c15U;
        hash ^= hash >> 29U;
    }
    return hash;
}

namespace {

SharedShape sharedCircle(const CircleGeometry& circle, const ZRange& z) {
    return {{ElementKind::Circle, circle.diameter, circle.innerDiameter, z.bottom, z.top}, {circle.centre, 0.0, false}};
}

SharedShape sharedArea(const AreaGeometry& area, const ZRange& z) {
    // Mirroring stays in the shape, so that what is placed is only moved and turned: first mirrored x -> -x, then
    // turned, instead of turned clockwise and then mirrored.
    const double angle = area.placement.isMirrored ? -area.placement.clockwiseDeg : area.placement.clockwiseDeg;
    return {{ElementKind::Area, area.shape.value, area.placement.isMirrored ? 1 : 0, z.bottom, z.top},
            {area.placement.origin, angle, false}};
}

/// Along +x from the origin.
std::optional<SharedShape> sharedLine(const LineGeometry& line, const ZRange& z) {
    const std::int64_t dx = std::int64_t{line.b.x} - line.a.x;
    const std::int64_t dy = std::int64_t{line.b.y} - line.a.y;
    const auto squared = static_cast<std::uint64_t>(dx * dx) + static_cast<std::uint64_t>(dy * dy);
    const bool fits = squared > 0 && squared <= static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max());
    if (line.innerWidth > 0 || !fits) {
        return std::nullopt;
    }
    const double clockwiseDeg =
        -std::atan2(static_cast<double>(dy), static_cast<double>(dx)) * 180.0 / std::numbers::pi;
    return SharedShape{{ElementKind::Line, static_cast<std::int64_t>(squared), line.width, z.bottom, z.top},
                       {line.a, clockwiseDeg, false}};
}

}  // namespace

std::optional<SharedShape> sharedShapeOf(const Document& document, ElementId element) {
    const ElementKind kind = document.elements.kind[element.row()];
    const ZRange z = solidHeightsOf(document, element);
    if (z.top <= z.bottom) {
        return std::nullopt;
    }
    const std::uint32_t row = document.elements.geometry[element.row()];
    const bool hasSquarePen = (document.elements.flags[element.row()] & kSquarePen) != 0;
    switch (kind) {
        case ElementKind::Circle: return sharedCircle(document.circles[row], z);
        case ElementKind::Area: return sharedArea(document.areas[row], z);
        case ElementKind::Line: return hasSquarePen ? std::nullopt : sharedLine(document.lines[row], z);
        default: return std::nullopt;
    }
}

ElementOutlines outlinesOf(const Document& document, const ShapeKey& key) {
    if (key.kind == ElementKind::Circle) {
        EdgeLoops loops = circleOutline({{}, static_cast<Nm>(key.first), static_cast<Nm>(key.second)});
        return loops.loopCount() > 0 ? ElementOutlines{{std::move(loops)}, {}} : ElementOutlines{};
    }
    if (key.kind == ElementKind::Line) {
        if (key.second <= 0) {
            return {};
        }
        EdgeLoops loops;
        loops.addCapsule({}, {std::sqrt(static_cast<double>(key.first)), 0.0}, static_cast<double>(key.second) / 2.0);
        return {{std::move(loops)}, {}};
    }
    ElementOutlines outlines = outlinesOf(document, ShapeId{static_cast<std::uint32_t>(key.first)});
    if (key.second != 0) {
        for (EdgeLoops& region : outlines.regions) {
            region = placed(region, {{}, 0.0, true});
        }
    }
    return outlines;
}

}  // namespace model
