#include "model/formats/odb/features/surface_parser.h"

namespace model::odb {

void SurfaceParser::beginSurface() {
    m_firstContour = static_cast<std::uint32_t>(m_table.contours.size());
    m_isOpen = false;
    m_hasIsland = false;
}

bool SurfaceParser::record(std::string_view line) {
    if (line.size() < 2 || line[0] != 'O') {
        return false;
    }
    const Fields fields(line.substr(2));
    switch (line[1]) {
        case 'S': segment(fields); return true;
        case 'C': curve(fields); return true;
        case 'B': beginPolygon(fields); return true;
        case 'E': endPolygon(); return true;
        default: return false;
    }
}

void SurfaceParser::beginPolygon(Fields fields) {
    if (m_isOpen) {
        m_at.report(Severity::Warning, "a polygon begins before the one before it has ended");
        endPolygon();
    }
    const Point start = fields.point(m_at.nm);
    const std::string_view letter = fields.word();
    m_isOpen = true;
    m_isHole = letter == "H" || letter == "h";
    m_isBroken = fields.failed() || (!m_isHole && letter != "I" && letter != "i");
    m_firstNode = static_cast<std::uint32_t>(m_table.nodes.size());
    m_table.nodes.push_back({start, {}, EdgeKind::Line});
}

bool SurfaceParser::canAdd(const Fields& fields) {
    if (!m_isOpen) {
        m_at.report(Severity::Warning, "an edge outside of a polygon was left out");
        return false;
    }
    m_isBroken = m_isBroken || fields.failed();
    return !m_isBroken;
}

void SurfaceParser::addEdge(EdgeKind kind, Point centre, Point end) {
    PathNode& last = m_table.nodes.edit().back();
    last.edge = kind;
    last.centre = centre;
    m_table.nodes.push_back({end, {}, EdgeKind::Line});
}

void SurfaceParser::segment(Fields fields) {
    const Point end = fields.point(m_at.nm);
    if (!canAdd(fields)) {
        return;
    }
    // KiCad repeats the first point.
    if (end != m_table.nodes.back().point) {
        addEdge(EdgeKind::Line, {}, end);
    }
}

void SurfaceParser::curve(Fields fields) {
    const Point end = fields.point(m_at.nm);
    const Point centre = fields.point(m_at.nm);
    const std::string_view clockwise = fields.word();
    if (!canAdd(fields)) {
        return;
    }
    const Point start = m_table.nodes.back().point;
    if (start == centre || end == centre) {
        m_at.report(Severity::Warning, "an arc without a radius; taken as a straight edge");
        if (start != end) {
            addEdge(EdgeKind::Line, {}, end);
        }
        return;
    }
    const bool isClockwise = clockwise == "Y" || clockwise == "y";
    addEdge(isClockwise ? EdgeKind::ArcClockwise : EdgeKind::ArcCounterClockwise, centre, end);
}

void SurfaceParser::dropPolygon() {
    m_table.nodes.edit().resize(m_firstNode);
}

void SurfaceParser::endPolygon() {
    if (!m_isOpen) {
        m_at.report(Severity::Warning, "a polygon ends that has not begun");
        return;
    }
    m_isOpen = false;
    if (m_isBroken) {
        m_at.report(Severity::Error, "a polygon with an unreadable record was left out");
        return dropPolygon();
    }
    std::vector<PathNode>& nodes = m_table.nodes.edit();
    if (nodes.size() - m_firstNode > 1 && nodes.back().point == nodes[m_firstNode].point) {
        nodes.pop_back();  // the edge of the node before it now returns to the first node
    } else if (nodes.size() - m_firstNode > 1) {
        m_at.report(Severity::Info, "a polygon is not closed; a straight edge was added");
    }
    const std::size_t count = nodes.size() - m_firstNode;
    const bool isCurved =
        nodes[m_firstNode].edge != EdgeKind::Line || (count > 1 && nodes.back().edge != EdgeKind::Line);
    if (count < 3 && !isCurved) {
        m_at.report(Severity::Info, "a polygon without area was left out");
        return dropPolygon();
    }
    if (m_isHole && !m_hasIsland) {
        m_at.report(Severity::Warning, "a hole that lies in no island was left out");
        return dropPolygon();
    }
    m_hasIsland = m_hasIsland || !m_isHole;
    m_table.contours.push_back({m_firstNode, static_cast<std::uint32_t>(count), m_isHole});
}

std::uint32_t SurfaceParser::endSurface() {
    if (m_isOpen) {
        m_at.report(Severity::Warning, "a surface ends before its last polygon; what was read of it was left out");
        m_isOpen = false;
        dropPolygon();
    }
    ShapeTable::Shape shape;
    shape.firstContour = m_firstContour;
    shape.contourCount = static_cast<std::uint32_t>(m_table.contours.size()) - m_firstContour;
    for (std::uint32_t i = 0; i < shape.contourCount; ++i) {
        shape.box.include(boxOfPath(m_table.nodesOf(m_table.contours[m_firstContour + i]), true));
    }
    m_table.shapes.push_back(shape);
    return static_cast<std::uint32_t>(m_table.shapes.size() - 1);
}

}  // namespace model::odb
