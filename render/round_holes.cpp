#include "render/round_holes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "model/geometry/box_index.h"
#include "model/solids/nearness.h"

namespace render {
namespace {

using model::Box;
using model::Contour;
using model::Nm;
using model::PathNode;
using model::Point;
using model::PolygonSet;

/// Cells keep this far from everything else: lets reach over their edge by less, so that no gap shows.
constexpr Nm kMargin = 2'000;

double radiusOf(const PathNode& node) {
    return std::hypot(double(node.point.x) - node.centre.x, double(node.point.y) - node.centre.y);
}

/// The circle a contour is, if it is one: arcs about one centre that together go round once.
std::optional<RoundHole> circleOf(std::span<const PathNode> nodes) {
    if (nodes.empty()) {
        return std::nullopt;
    }
    const double radius = radiusOf(nodes[0]);
    constexpr double kSmallest = 10e3;
    constexpr double kLargest = 1e8;
    constexpr double kFarthest = 1.9e9;  // a cell there still has coordinates
    constexpr double kRounding = 2.0;
    const auto isPart = [&](const PathNode& node) {
        return node.edge != model::EdgeKind::Line && node.edge == nodes[0].edge && node.centre == nodes[0].centre &&
               std::abs(radiusOf(node) - radius) <= kRounding;
    };
    const bool isThere = std::max(std::abs(double(nodes[0].centre.x)), std::abs(double(nodes[0].centre.y))) < kFarthest;
    if (radius < kSmallest || radius > kLargest || !isThere || !std::ranges::all_of(nodes, isPart)) {
        return std::nullopt;
    }
    double sweep = 0.0;
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        sweep += std::abs(model::sweepOf(nodes[i], nodes[(i + 1) % nodes.size()].point));
    }
    if (std::abs(sweep - 2.0 * std::numbers::pi) > 1e-3) {
        return std::nullopt;
    }
    const auto rounded = static_cast<Nm>(std::llround(radius));
    return RoundHole{nodes[0].centre, rounded, cellAround(rounded)};
}

/// Counter-clockwise corners of a cell.
std::array<Point, 4> cornersOf(const RoundHole& hole) {
    const Box box = cellOf(hole);
    return {box.min, Point{box.max.x, box.min.y}, box.max, Point{box.min.x, box.max.y}};
}

class Punch {
public:
    Punch(const model::ShapeTable& shapes, model::ShapeId shape, const model::Discretisation& how)
        : m_shapes(shapes), m_contours(shapes.contoursOf(shape)), m_how(how) {}

    PunchedShape run() {
        findCircles();
        if (!m_circles.empty()) {
            rejectNeighbours();
            rejectThoseAtEdges();
        }
        assemble();
        return std::move(m_result);
    }

private:
    void findCircles() {
        m_circleOf.assign(m_contours.size(), kNone);
        for (std::size_t i = 0; i < m_contours.size(); ++i) {
            const auto circle =
                m_contours[i].isHole ? circleOf(m_shapes.nodesOf(m_contours[i])) : std::optional<RoundHole>();
            if (circle) {
                m_circleOf[i] = static_cast<std::uint32_t>(m_circles.size());
                m_circles.push_back(*circle);
            }
        }
        m_isAlone.assign(m_circles.size(), 1);
    }

    void rejectNeighbours() {
        std::vector<Box> boxes;
        std::ranges::transform(m_circles, std::back_inserter(boxes), cellOf);
        const model::BoxIndex index(boxes);
        for (std::uint32_t i = 0; i < boxes.size(); ++i) {
            index.visit(boxes[i].grownBy(kMargin),
                        [&](std::uint32_t other) { m_isAlone[i] = other == i ? m_isAlone[i] : std::uint8_t{0}; });
        }
    }

    void rejectThoseAtEdges() {
        PolygonSet others;
        for (std::size_t i = 0; i < m_contours.size(); ++i) {
            if (m_circleOf[i] == kNone) {
                addContour(i, others);
            }
        }
        const model::EdgeStrips edges(others);
        PolygonSet cell;
        for (std::size_t i = 0; i < m_circles.size(); ++i) {
            cell = {};
            cell.beginPolygon();
            cell.addLoop(cornersOf(m_circles[i]));
            const bool isClear = m_isAlone[i] != 0 && edges.contains(m_circles[i].centre) &&
                                 !edges.comesNear(cell, cell.polygons, cellOf(m_circles[i]), kMargin);
            m_isAlone[i] = isClear ? 1 : 0;
        }
    }

    [[nodiscard]] bool isCell(std::size_t contour) const {
        return m_circleOf[contour] != kNone && m_isAlone[m_circleOf[contour]] != 0;
    }

    /// Adds a contour as chords; false if nothing is left of it.
    bool addContour(std::size_t contour, PolygonSet& to) {
        m_loop.clear();
        const std::span<const PathNode> nodes = m_shapes.nodesOf(m_contours[contour]);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            model::discretiseEdge(nodes[i], nodes[i + 1 < nodes.size() ? i + 1 : 0].point, m_how, m_loop);
        }
        if (!m_contours[contour].isHole) {
            to.beginPolygon();
            m_hasOutline = to.addLoop(m_loop);
            if (!m_hasOutline) {
                to.polygons.pop_back();
            }
            return m_hasOutline;
        }
        return m_hasOutline && to.addLoop(m_loop);
    }

    void addCell(const RoundHole& hole) {
        m_result.holes.push_back(hole);
        m_result.polygons.addLoop(cornersOf(hole));
    }

    void assemble() {
        for (std::size_t i = 0; i < m_contours.size(); ++i) {
            if (!isCell(i)) {
                addContour(i, m_result.polygons);
            } else if (m_hasOutline) {
                addCell(m_circles[m_circleOf[i]]);
            }
        }
    }

    static constexpr std::uint32_t kNone = 0xffffffffU;

    const model::ShapeTable& m_shapes;
    std::span<const Contour> m_contours;
    const model::Discretisation& m_how;
    std::vector<RoundHole> m_circles;
    std::vector<std::uint32_t> m_circleOf;  ///< by contour
    std::vector<std::uint8_t> m_isAlone;    ///< by circle
    std::vector<Point> m_loop;
    bool m_hasOutline = false;
    PunchedShape m_result;
};

}  // namespace

model::Box cellOf(const RoundHole& hole) {
    return Box{hole.centre, hole.centre}.grownBy(hole.cell);
}

PunchedShape punch(const model::ShapeTable& shapes, model::ShapeId shape, const model::Discretisation& how) {
    return Punch(shapes, shape, how).run();
}

}  // namespace render
