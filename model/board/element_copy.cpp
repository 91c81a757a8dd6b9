#include "model/board/element_copy.h"

#include "model/geometry/region.h"

namespace model {

ElementId ElementCopier::copy(ElementId element, const DocumentBuilder::Origin& origin) {
    const std::uint32_t row = m_from.elements.geometry[element.row()];
    switch (m_from.elements.kind[element.row()]) {
        case ElementKind::Line: return m_builder.addLine(m_from.lines[row], origin);
        case ElementKind::Arc: return m_builder.addArc(m_from.arcs[row], origin);
        case ElementKind::Circle: return m_builder.addCircle(m_from.circles[row], origin);
        case ElementKind::Trail: {
            const TrailGeometry& trail = m_from.trails[row];
            return trail.innerWidth > 0
                       ? m_builder.addTrail(m_from.nodesOf(trail), trail.width, origin, trail.innerWidth)
                       : m_builder.addTrail(m_from.nodesOf(trail), m_from.widthsOf(trail), origin);
        }
        case ElementKind::Area: break;
    }
    const AreaGeometry& area = m_from.areas[row];
    return m_builder.addArea({shape(area.shape), area.placement}, origin);
}

ShapeId ElementCopier::shape(ShapeId shape) {
    const auto [location, isNew] = m_shapes.try_emplace(shape);
    if (isNew) {
        location->second = m_builder.addShape(sketchOf(m_from.shapes, shape));
    }
    return location->second;
}

}  // namespace model
