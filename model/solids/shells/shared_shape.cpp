#include "model/solids/shells/shared_shape.h"

#include "model/solids/shells/area_shell.h"
#include "model/solids/shells/circle_shell.h"
#include "model/solids/shells/element_shells.h"

namespace model {

std::size_t ShapeKeyHash::operator()(const ShapeKey& key) const {
    std::uint64_t hash = static_cast<std::uint64_t>(key.kind);
    for (const std::int64_t part : {key.first, key.second, std::int64_t{key.bottom}, std::int64_t{key.top}}) {
        hash = (hash ^ static_cast<std::uint64_t>(part)) * 0x9e3779b97f4a7c15U;
        hash ^= hash >> 29U;
    }
    return hash;
}

std::optional<SharedShape> sharedShapeOf(const Document& document, ElementId element) {
    const ElementKind kind = document.elements.kind[element.row()];
    const ZRange z = solidHeightsOf(document, element);
    if (z.top <= z.bottom || (kind != ElementKind::Circle && kind != ElementKind::Area)) {
        return std::nullopt;
    }
    const std::uint32_t row = document.elements.geometry[element.row()];
    if (kind == ElementKind::Circle) {
        const CircleGeometry& circle = document.circles[row];
        return SharedShape{{kind, circle.diameter, circle.innerDiameter, z.bottom, z.top}, {circle.centre, 0.0, false}};
    }
    const AreaGeometry& area = document.areas[row];
    // Mirroring stays in the shape, so that what is placed is only moved and turned: first mirrored x -> -x, then
    // turned, instead of turned clockwise and then mirrored.
    const double angle = area.placement.isMirrored ? -area.placement.clockwiseDeg : area.placement.clockwiseDeg;
    return SharedShape{{kind, area.shape.value, area.placement.isMirrored ? 1 : 0, z.bottom, z.top},
                       {area.placement.origin, angle, false}};
}

ElementOutlines outlinesOf(const Document& document, const ShapeKey& key) {
    if (key.kind == ElementKind::Circle) {
        EdgeLoops loops = circleOutline({{}, static_cast<Nm>(key.first), static_cast<Nm>(key.second)});
        return loops.loopCount() > 0 ? ElementOutlines{{std::move(loops)}, {}} : ElementOutlines{};
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
