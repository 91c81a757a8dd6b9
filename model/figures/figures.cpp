#include "model/figures/figures.h"

#include <algorithm>
#include <utility>

#include "model/board/single_element.h"
#include "model/figures/tracks.h"
#include "model/geometry/curve_edges.h"

namespace model {

namespace {

/// Spreads 32 bits to the even ones of 64.
std::uint64_t spread(std::uint64_t bits) {
    constexpr std::uint64_t kMasks[] = {0x0000ffff0000ffff, 0x00ff00ff00ff00ff, 0x0f0f0f0f0f0f0f0f, 0x3333333333333333,
                                        0x5555555555555555};
    for (int step = 0, shift = 16; step < 5; ++step, shift /= 2) {
        bits = (bits | (bits << shift)) & kMasks[step];
    }
    return bits;
}

/// The location of a point on the Morton curve.
std::uint64_t mortonOf(PointD p) {
    constexpr double kOffset = 2147483648.0;  // coordinates reach ±2^31
    return spread(static_cast<std::uint64_t>(p.x + kOffset)) |
           (spread(static_cast<std::uint64_t>(p.y + kOffset)) << 1U);
}

/// Sorts edges by where they begin on the Morton curve, those that begin together as they were.
void sortAlongCurve(std::span<Edge> edges) {
    std::vector<std::pair<std::uint64_t, std::uint32_t>> order;
    order.reserve(edges.size());
    for (std::uint32_t row = 0; row < edges.size(); ++row) {
        order.emplace_back(mortonOf(edges[row].a), row);
    }
    std::ranges::sort(order);
    std::vector<Edge> sorted;
    sorted.reserve(edges.size());
    for (const auto& [location, row] : order) {
        sorted.push_back(edges[row]);
    }
    std::ranges::copy(sorted, edges.begin());
}

/// Corners of what an axis-parallel square covers on its path: the hull of the square at both ends, counter-clockwise.
std::vector<PointD> sweptSquare(const LineGeometry& line) {
    const double r = line.width / 2.0;
    const PointD a = base::toDouble(line.a.x <= line.b.x ? line.a : line.b);
    const PointD b = base::toDouble(line.a.x <= line.b.x ? line.b : line.a);
    if (a.x == b.x || a.y == b.y) {
        const PointD low = {a.x, std::min(a.y, b.y)};
        const PointD high = {b.x, std::max(a.y, b.y)};
        return {{low.x - r, low.y - r}, {high.x + r, low.y - r}, {high.x + r, high.y + r}, {low.x - r, high.y + r}};
    }
    if (b.y > a.y) {
        return {{a.x - r, a.y - r}, {a.x + r, a.y - r}, {b.x + r, b.y - r},
                {b.x + r, b.y + r}, {b.x - r, b.y + r}, {a.x - r, a.y + r}};
    }
    return {{a.x - r, a.y - r}, {b.x - r, b.y - r}, {b.x + r, b.y - r},
            {b.x + r, b.y + r}, {a.x + r, a.y + r}, {a.x - r, a.y + r}};
}

/// Moves edges to where they are placed. Flipped, a contour runs the other way round.
void lay(std::span<Edge> edges, const Placement& placement) {
    if (isIdentity(placement)) {
        return;
    }
    for (Edge& edge : edges) {
        edge = placed(edge, placement);
        edge.winding = static_cast<std::int8_t>(placement.isMirrored ? -edge.winding : edge.winding);
    }
}

/// For so many more at once; else they grow as ever, lest adding many small areas copies all edges each time.
void makeRoom(std::vector<Edge>& edges, std::size_t more) {
    if (edges.capacity() - edges.size() < more) {
        edges.reserve(std::max(2 * edges.capacity(), edges.size() + more));
    }
}

}  // namespace

void FigureTable::begin(ElementId element, bool isFilled) {
    Figure figure;
    figure.element = element;
    figure.firstEdge = static_cast<std::uint32_t>(m_edges.size());
    figure.firstBox = static_cast<std::uint32_t>(m_boxes.size());
    figure.isFilled = isFilled;
    m_figures.push_back(figure);
}

void FigureTable::finish() {
    Figure& figure = m_figures.back();
    figure.edgeCount = static_cast<std::uint32_t>(m_edges.size()) - figure.firstEdge;
    if (figure.edgeCount == 0) {
        m_figures.pop_back();
        return;
    }
    const auto edges = std::span(m_edges).subspan(figure.firstEdge);
    lay(edges, m_placement);
    figure.anchor = edges.front().a;
    if (edges.back().isHole) {
        sortAlongCurve(edges);
    }
    for (std::uint32_t first = 0; first < figure.edgeCount; first += kBranch) {
        Box box;
        for (std::uint32_t i = first; i < std::min(first + kBranch, figure.edgeCount); ++i) {
            box.include(boxOf(m_edges[figure.firstEdge + i]));
        }
        m_boxes.push_back(box);
    }
    std::size_t level = figure.firstBox;
    while (m_boxes.size() - level > 1) {
        const std::size_t end = m_boxes.size();
        for (std::size_t first = level; first < end; first += kBranch) {
            Box box;
            for (std::size_t i = first; i < std::min<std::size_t>(first + kBranch, end); ++i) {
                box.include(m_boxes[i]);
            }
            m_boxes.push_back(box);
        }
        level = end;
    }
    figure.boxCount = static_cast<std::uint32_t>(m_boxes.size()) - figure.firstBox;
}

std::vector<Box> FigureTable::outerBoxes() const {
    std::vector<Box> outer;
    for (std::size_t row = 0; row < size(); ++row) {
        outer.push_back(box(row));
    }
    return outer;
}

void FigureTable::addTrack(Edge edge, double width) {
    if (width > 0) {
        edge.pen = width / 2;
        m_edges.push_back(edge);
    }
}

void FigureTable::add(const Document& document, ElementId element, const Placement& placement) {
    m_placement = placement;
    addElement(document, element);
    m_placement = {};
}

void FigureTable::addEdgewise(const Document& document, ElementId element) {
    if (document.elements.kind[element.row()] != ElementKind::Trail) {
        return addElement(document, element);
    }
    forEachTrack(document, element, [&](const PathNode& node, Point end, Nm width, Nm) {
        begin(element, false);
        addTrack(edgeOf(node, end), width);
        finish();
    });
}

void FigureTable::addElement(const Document& document, ElementId element) {
    const std::uint32_t row = document.elements.geometry[element.row()];
    const std::uint8_t flags = document.elements.flags[element.row()];
    const ElementKind kind = document.elements.kind[element.row()];
    if (kind == ElementKind::Area) {
        return addArea(document, element);
    }
    begin(element, false);
    if ((flags & kSquarePen) != 0) {
        addSquareTrack(document.lines[row]);
    } else if (kind == ElementKind::Circle && document.circles[row].innerDiameter > 0 && (flags & kHole) == 0) {
        addRing(document.circles[row]);
    } else {
        forEachTrack(document, element,
                     [this](const PathNode& node, Point end, Nm width, Nm) { addTrack(edgeOf(node, end), width); });
    }
    finish();
}

void FigureTable::addOutline(const ShapeTable& shapes, ShapeId shape) {
    for (const Contour& contour : shapes.contoursOf(shape)) {
        begin({}, false);
        addContour(shapes.nodesOf(contour), false, {});
        finish();
    }
}

void FigureTable::addTrack(ElementId element, std::span<const Edge> edges, const Placement& placement) {
    m_placement = placement;
    begin(element, false);
    m_edges.insert(m_edges.end(), edges.begin(), edges.end());
    finish();
    m_placement = {};
}

void FigureTable::addDisc(Point centre, double radius) {
    addTrack(base::toDouble(centre), base::toDouble(centre), radius);
}

void FigureTable::addTrack(PointD a, PointD b, double radius) {
    begin({}, false);
    Edge edge;
    edge.a = a;
    edge.b = b;
    edge.pen = radius;
    m_edges.push_back(edge);
    finish();
}

void FigureTable::addSquareTrack(const LineGeometry& line) {
    if (line.width <= 0) {
        return;
    }
    m_figures.back().isFilled = true;
    const std::vector<PointD> corners = sweptSquare(line);
    for (std::size_t i = 0; i < corners.size(); ++i) {
        Edge side;
        side.a = corners[i];
        side.b = corners[i + 1 < corners.size() ? i + 1 : 0];
        m_edges.push_back(side);
    }
}

/// A track along the circle half way between the two edges of the ring.
void FigureTable::addRing(const CircleGeometry& circle) {
    Edge middle;
    middle.centre = base::toDouble(circle.centre);
    middle.radius = (double{1} * circle.diameter + circle.innerDiameter) / 4;
    middle.a = middle.b = {middle.centre.x + middle.radius, middle.centre.y};
    addTrack(middle, (double{1} * circle.diameter - circle.innerDiameter) / 2);
}

void FigureTable::addArea(const Document& document, ElementId element) {
    const AreaGeometry& area = document.areas[document.elements.geometry[element.row()]];
    makeRoom(m_edges, nodeCountOf(document, element));  // curves need more
    bool isOpen = false;
    for (const Contour& contour : document.shapes.contoursOf(area.shape)) {
        if (!contour.isHole) {
            if (isOpen) {
                finish();
            }
            begin(element, true);
            isOpen = true;
        }
        if (isOpen) {
            addContour(document.shapes.nodesOf(contour), contour.isHole, area.placement);
        }
    }
    if (isOpen) {
        finish();
    }
}

void FigureTable::addContour(const PathNodes& path, bool isHole, const Placement& placement) {
    const std::size_t first = m_edges.size();
    double area = 0;
    forEachEdge(path, [&](Edge edge) {
        if (!edge.isArc() && path.size() > 1 && edge.a == edge.b) {
            return;  // a repeated point
        }
        edge = placed(edge, placement);
        edge.isHole = isHole;
        m_edges.push_back(edge);
        area += areaUnder(edge, m_edges[first].a);
    });
    for (std::size_t i = first; i < m_edges.size(); ++i) {
        m_edges[i].winding = area < 0 ? -1 : 1;
    }
}

}  // namespace model
