#include "model/board/lone_element.h"

#include <array>

#include "model/board/document_builder.h"

namespace model {

namespace {

Layer emptyLayerLike(const Layer& layer) {
    Layer out;
    out.name = layer.name;
    out.type = layer.type;
    out.context = layer.context;
    out.side = layer.side;
    out.isNegative = layer.isNegative;
    out.isSynthetic = layer.isSynthetic;
    out.z = layer.z;
    out.thickness = layer.thickness;
    out.thicknessSource = layer.thicknessSource;
    return out;
}

ShapeId copyShape(const Document& document, ShapeId shape, DocumentBuilder& builder) {
    ShapeSketch sketch;
    for (const Contour& contour : document.shapes.contoursOf(shape)) {
        sketch.beginContour(contour.isHole);
        for (const PathNode& node : document.shapes.nodesOf(contour)) {
            sketch.addNode(node);
        }
    }
    return builder.addShape(sketch);
}

ElementId copyTrail(const Document& document, const TrailGeometry& trail, const DocumentBuilder::Origin& origin,
                    DocumentBuilder& builder) {
    return trail.innerWidth > 0 ? builder.addTrail(document.nodesOf(trail), trail.width, origin, trail.innerWidth)
                                : builder.addTrail(document.nodesOf(trail), document.widthsOf(trail), origin);
}

ElementId copyElement(const Document& document, ElementId element, DocumentBuilder& builder) {
    DocumentBuilder::Origin origin;
    origin.flags = document.elements.flags[element.row()];
    const std::uint32_t row = document.elements.geometry[element.row()];
    switch (document.elements.kind[element.row()]) {
        case ElementKind::Line: return builder.addLine(document.lines[row], origin);
        case ElementKind::Arc: return builder.addArc(document.arcs[row], origin);
        case ElementKind::Circle: return builder.addCircle(document.circles[row], origin);
        case ElementKind::Trail: return copyTrail(document, document.trails[row], origin, builder);
        case ElementKind::Area: break;
    }
    const AreaGeometry& area = document.areas[row];
    return builder.addArea({copyShape(document, area.shape, builder), area.placement}, origin);
}

ShapeId addBox(const Box& box, DocumentBuilder& builder) {
    ShapeSketch sketch;
    sketch.addPolygon(std::array<Point, 4>{{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}}, false);
    return builder.addShape(sketch);
}

}  // namespace

std::shared_ptr<const Document> elementAlone(const Document& document, ElementId element) {
    DocumentBuilder builder;
    builder.beginLayer(builder.addLayer(emptyLayerLike(document.layer(document.elements.layer[element.row()]))));
    const ElementId copy = copyElement(document, element, builder);
    if (const Body* body = document.bodyOf(element)) {
        builder.addBody({copy, {}, body->height, body->source});
    }
    builder.setProfile(addBox(document.boxOf(element), builder));
    builder.setBoardThickness(document.boardThickness);
    return builder.finish();
}

std::size_t nodeCountOf(const Document& document, ElementId element) {
    const std::uint32_t row = document.elements.geometry[element.row()];
    switch (document.elements.kind[element.row()]) {
        case ElementKind::Circle: return 1;
        case ElementKind::Trail: return document.trails[row].nodeCount;
        case ElementKind::Area: break;
        default: return 2;
    }
    std::size_t nodes = 0;
    for (const Contour& contour : document.shapes.contoursOf(document.areas[row].shape)) {
        nodes += contour.nodeCount;
    }
    return nodes;
}

}  // namespace model
