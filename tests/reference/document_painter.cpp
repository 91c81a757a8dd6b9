#include "tests/reference/document_painter.h"

namespace reference {

namespace {

Point mm(model::Point p) {
    return {p.x * 1e-6, p.y * 1e-6};
}

void append(Contour& contour, const model::PathNode& node, Point from, Point to, Point centre, bool isMirrored) {
    if (node.edge == model::EdgeKind::Line) {
        contour.push_back(from);
        return;
    }
    appendArc(contour, from, to, centre, (node.edge == model::EdgeKind::ArcClockwise) != isMirrored);
}

void paintShape(const model::Document& document, model::ShapeId shape, const model::Placement& placement,
                Raster& raster) {
    const auto at = [&](model::Point p) {
        const model::PointD placed = placement.apply(base::toDouble(p));
        return Point{placed.x * 1e-6, placed.y * 1e-6};
    };
    std::vector<Contour> contours;
    for (const model::Contour& path : document.shapes.contoursOf(shape)) {
        const auto nodes = document.shapes.nodesOf(path);
        Contour contour;
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            const model::PathNode& next = nodes[(i + 1) % nodes.size()];
            append(contour, nodes[i], at(nodes[i].point), at(next.point), at(nodes[i].centre), placement.isMirrored);
        }
        contours.push_back(wound(contour, path.isHole));
    }
    raster.fill(contours, true);
}

std::vector<Contour> track(const model::PathNode& node, model::Point end, model::Nm width) {
    if (width <= 0) {
        return {};
    }
    if (node.edge == model::EdgeKind::Line) {
        return lineTrack(mm(node.point), mm(end), width * 1e-6);
    }
    return arcTrack(mm(node.point), mm(end), mm(node.centre), node.edge == model::EdgeKind::ArcClockwise, width * 1e-6);
}

std::vector<Contour> squareTrack(const model::LineGeometry& line) {
    const double half = line.width * 0.5e-6;
    const Point a = mm(line.a);
    const Point b = mm(line.b);
    const double sx = b.x >= a.x ? half : -half;
    const double sy = b.y >= a.y ? half : -half;
    return {wound({{a.x - sx, a.y - sy},
                   {a.x + sx, a.y - sy},
                   {b.x + sx, b.y - sy},
                   {b.x + sx, b.y + sy},
                   {b.x - sx, b.y + sy},
                   {a.x - sx, a.y + sy}},
                  false)};
}

}  // namespace

void paint(const model::Document& document, model::ShapeId shape, Raster& raster) {
    paintShape(document, shape, {}, raster);
}

void paint(const model::Document& document, model::ElementId element, Raster& raster) {
    const std::uint32_t row = document.elements.geometry[element.row()];
    switch (document.elements.kind[element.row()]) {
        case model::ElementKind::Line: {
            const model::LineGeometry& line = document.lines[row];
            const bool isSquare = (document.elements.flags[element.row()] & model::kSquarePen) != 0;
            return raster.fill(
                isSquare ? squareTrack(line) : track({line.a, {}, model::EdgeKind::Line}, line.b, line.width), true);
        }
        case model::ElementKind::Arc:
            return raster.fill(track(document.arcs[row].node, document.arcs[row].end, document.arcs[row].width), true);
        case model::ElementKind::Circle: {
            const model::CircleGeometry& disc = document.circles[row];
            std::vector<Contour> contours = {circle(mm(disc.centre), disc.diameter * 0.5e-6)};
            if (disc.innerDiameter > 0) {
                contours.push_back(wound(circle(mm(disc.centre), disc.innerDiameter * 0.5e-6), true));
            }
            return raster.fill(contours, true);
        }
        case model::ElementKind::Trail: {
            const auto nodes = document.nodesOf(document.trails[row]);
            const auto widths = document.widthsOf(document.trails[row]);
            for (std::size_t i = 0; i + 1 < nodes.size(); ++i) {
                raster.fill(track(nodes[i], nodes[i + 1].point, widths[i]), true);
            }
            return;
        }
        case model::ElementKind::Area: {
            const model::AreaGeometry& area = document.areas[row];
            return paintShape(document, area.shape, area.placement, raster);
        }
    }
}

}  // namespace reference
