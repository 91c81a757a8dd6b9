#include "model/figures/severed_tracks.h"

#include <algorithm>

#include "model/figures/distance.h"
#include "model/figures/tracks.h"
#include "model/geometry/vectors.h"

namespace model {

namespace {

Edge circleAround(PointD centre, double radius) {
    Edge circle;
    circle.centre = centre;
    circle.radius = radius;
    circle.a = circle.b = {centre.x + radius, centre.y};
    return circle;
}

/// The edge from one length along it to another.
Edge partOf(const Edge& edge, double from, double to) {
    Edge part = edge;
    part.a = pointAt(edge, from);
    part.b = pointAt(edge, to);
    return part;
}

bool isTrack(const Document& document, ElementId element) {
    const ElementKind kind = document.elements.kind[element.row()];
    const bool isDrawn = kind == ElementKind::Line || kind == ElementKind::Arc || kind == ElementKind::Trail;
    return isDrawn && (document.elements.flags[element.row()] & (kPad | kHole | kSquarePen)) == 0;
}

}  // namespace

SeveringHoles::SeveringHoles(const Document& document) : m_document(document), m_index(std::span<const Box>{}) {
    std::vector<Box> boxes;
    for (std::size_t row = 0; row < document.layers.size(); ++row) {
        if (!document.layers[row].spanTop.isValid()) {
            continue;  // passes no copper
        }
        const auto [first, count] = document.layers[row].elements;
        for (std::uint32_t i = first; i < first + count; ++i) {
            const std::uint8_t flags = document.elements.flags[i];
            if ((flags & kHole) != 0 && !isPlatedHole(flags) && document.elements.kind[i] == ElementKind::Circle) {
                const CircleGeometry& circle = document.circles[document.elements.geometry[i]];
                m_holes.push_back({circleAround(base::toDouble(circle.centre), circle.diameter / 2.0), LayerId{row}});
                boxes.push_back(boxOf(m_holes.back().outline));
            }
        }
    }
    m_index = BoxIndex(boxes);
}

void SeveringHoles::addTo(FigureTable& table, ElementId element, const Placement& placement) const {
    const std::vector<std::vector<Edge>> parts = partsOf(element);
    if (parts.empty()) {
        return table.add(m_document, element, placement);
    }
    for (const std::vector<Edge>& part : parts) {
        table.addTrack(element, part, placement);
    }
}

/// None if no hole severs it, or all of it is drilled away.
std::vector<std::vector<Edge>> SeveringHoles::partsOf(ElementId element) const {
    bool isNear = false;
    if (!m_holes.empty() && isTrack(m_document, element)) {
        m_index.visit(m_document.boxOf(element), [&](std::uint32_t) { isNear = true; });
    }
    if (!isNear) {
        return {};
    }
    std::vector<std::vector<Edge>> parts(1);
    bool isSevered = false;
    forEachTrack(m_document, element, [&](const PathNode& node, Point end, Nm width, Nm) {
        Edge edge = edgeOf(node, end);
        edge.pen = width / 2.0;
        double at = 0.0;
        const std::vector<Cut> cuts = cutsOf(edge, m_document.elements.layer[element.row()]);
        for (const Cut& cut : cuts) {
            if (cut.from > at) {
                parts.back().push_back(partOf(edge, at, cut.from));
            }
            if (!parts.back().empty()) {
                parts.emplace_back();
            }
            at = std::max(at, cut.to);
        }
        const double length = lengthOf(edge);
        if (cuts.empty() || at < length) {
            parts.back().push_back(cuts.empty() ? edge : partOf(edge, at, length));
        }
        isSevered = isSevered || !cuts.empty();
    });
    if (parts.back().empty()) {
        parts.pop_back();
    }
    return isSevered ? parts : std::vector<std::vector<Edge>>{};
}

/// In rising order.
std::vector<SeveringHoles::Cut> SeveringHoles::cutsOf(const Edge& edge, LayerId layer) const {
    std::vector<Cut> cuts;
    if (edge.isFullCircle() || edge.pen <= 0.0) {
        return cuts;
    }
    m_index.visit(boxOf(edge), [&](std::uint32_t row) {
        const Edge& hole = m_holes[row].outline;
        const double beside = distance(nearestOn(edge, hole.centre), hole.centre);
        if (!m_document.layer(m_holes[row].drill).spans(layer) || hole.radius - beside - edge.pen <= kTouchNm) {
            return;
        }
        std::vector<double> ends;
        for (const PointD end : {edge.a, edge.b}) {
            if (distance(end, hole.centre) < hole.radius) {
                ends.push_back(end == edge.a ? 0.0 : lengthOf(edge));
            }
        }
        for (const PointD crossing : crossingsOf(edge, hole)) {
            ends.push_back(lengthTo(edge, crossing));
        }
        std::ranges::sort(ends);
        if (ends.size() >= 2) {
            cuts.push_back({ends.front(), ends.back()});
        }
    });
    std::ranges::sort(cuts, {}, &Cut::from);
    return cuts;
}

}  // namespace model
