#include "model/board/single_element.h"

#include "model/board/element_copy.h"
#include "model/geometry/outlines.h"

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

}  // namespace

std::shared_ptr<const Document> elementAlone(const Document& document, ElementId element) {
    DocumentBuilder builder;
    builder.beginLayer(builder.addLayer(emptyLayerLike(document.layer(document.elements.layer[element.row()]))));
    DocumentBuilder::Origin origin;
    origin.flags = document.elements.flags[element.row()];
    const ElementId copy = ElementCopier(builder, document).copy(element, origin);
    if (const Body* body = document.bodyOf(element)) {
        builder.addBody({copy, {}, body->height, body->source});
    }
    ShapeSketch outline;
    addBox(outline, document.boxOf(element));
    builder.setProfile(builder.addShape(outline));
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
