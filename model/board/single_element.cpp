#include "model/board/single_element.h"

#include <algorithm>
#include <cstdlib>

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

bool isNearer(Point a, Point b, Nm distance) {
    return std::max(std::abs(a.x - b.x), std::abs(a.y - b.y)) < distance;
}

/// Contours without nodes nearer to each other than `detail`; those smaller than it are left out, but for the first.
ShapeSketch coarse(const Document& document, ShapeId shape, Nm detail) {
    ShapeSketch sketch;
    for (const Contour& contour : document.shapes.contoursOf(shape)) {
        const PathNodes nodes = document.shapes.nodesOf(contour);
        const Box box = boxOfPath(nodes, true);
        if (std::max(box.width(), box.height()) < detail && !sketch.isEmpty()) {
            continue;
        }
        sketch.beginContour(contour.isHole);
        Point last = nodes.front().point;
        EdgeKind before =
            EdgeKind::ArcClockwise;  // of the edge that comes to a node; others than lines keep both their ends
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const PathNode& node = nodes[i];
            if (node.edge != EdgeKind::Line || before != EdgeKind::Line || !isNearer(node.point, last, detail)) {
                sketch.addNode(nodes, i);
                last = node.point;
            }
            before = node.edge;
        }
    }
    return sketch;
}

}  // namespace

std::shared_ptr<const Document> elementAlone(const Document& document, ElementId element, Nm detail) {
    DocumentBuilder builder;
    builder.beginLayer(builder.addLayer(emptyLayerLike(document.layer(document.elements.layer[element.row()]))));
    DocumentBuilder::Origin origin;
    origin.flags = document.elements.flags[element.row()];
    const bool isCoarse = detail > 0 && document.elements.kind[element.row()] == ElementKind::Area;
    const auto addCoarse = [&] {
        const AreaGeometry& area = document.areas[document.elements.geometry[element.row()]];
        return builder.addArea({builder.addShape(coarse(document, area.shape, detail)), area.placement}, origin);
    };
    const ElementId copy = isCoarse ? addCoarse() : ElementCopier(builder, document).copy(element, origin);
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
