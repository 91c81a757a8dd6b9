#include "render/modelling/round_holes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "model/geometry/box_index.h"
#include "model/solids/region_distance.h"
#include "render/modelling/hole_cells.h"

namespace render {
namespace {

using model::Box;
using model::Contour;
using model::Nm;
using model::PathNode;
using model::Point;
using model::PolygonSet;

/// Cells keep this far from everything else: lets reach over their edge by less, so that nothing shows through.
constexpr Nm kMargin = 2'000;

double radiusOf(const PathNode& node) {
    return std::hypot(double(node.point.x) - node.centre.x, double(node.point.y) - node.centre.y);
}

Box squareAround(Point centre, Nm radius) {
    return Box{centre, centre}.grownBy(cellAround(radius));
}

/// The circle a contour is, if it is one: arcs about one centre that together go round once.
std::optional<RoundHole> circleOf(std::span<const PathNode> nodes) {
    if (nodes.empty()) {
        return std::nullopt;
    }
    const double radius = radiusOf(nodes[0]);
    constexpr double kSmallest = 10e3;
    constexpr double kLargest = 6e7;     // its square is a cell
    constexpr double kFarthest = 1.9e9;  // a cell there still has coordinates
    constexpr double kRounding = 2.0;
    const auto isPart = [&](const PathNode& node) {
        return model::isArc(node.edge) && node.edge == nodes[0].edge && node.centre == nodes[0].centre &&
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
    return RoundHole{nodes[0].centre, rounded, squareAround(nodes[0].centre, rounded)};
}

/// Counter-clockwise corners.
std::array<Point, 4> cornersOf(const Box& box) {
    return {box.min, Point{box.max.x, box.min.y}, box.max, Point{box.min.x, box.max.y}};
}

/// May a let fill this cell?
bool isInReach(const RoundHole& hole, const Box& cell) {
    const std::int64_t reaches[] = {std::int64_t{hole.centre.x} - cell.min.x, std::int64_t{cell.max.x} - hole.centre.x,
                                    std::int64_t{hole.centre.y} - cell.min.y, std::int64_t{cell.max.y} - hole.centre.y};
    return std::ranges::max(reaches) <= kLargestCell;
}

class Punch {
public:
    Punch(const model::ShapeTable& shapes, model::ShapeId shape, const model::Discretisation& how)
        : m_shapes(shapes), m_contours(shapes.contoursOf(shape)), m_how(how) {}

    PunchedShape run() {
        findCircles();
        makeChords();
        if (!m_circles.empty()) {
            placeFields();
        }
        assemble();
        return std::move(m_result);
    }

private:
    static constexpr std::uint32_t kNone = 0xffffffffU;

    struct Circle {
        RoundHole hole;
        std::uint32_t outline;        ///< the one it is in
        std::uint32_t field = kNone;  ///< none: it becomes chords
    };

    void findCircles() {
        m_circleOf.assign(m_contours.size(), kNone);
        std::uint32_t outline = 0;
        for (std::size_t i = 0; i < m_contours.size(); ++i) {
            outline += m_contours[i].isHole ? 0 : 1;
            const auto circle =
                m_contours[i].isHole ? circleOf(m_shapes.nodesOf(m_contours[i])) : std::optional<RoundHole>();
            if (circle) {
                m_circleOf[i] = static_cast<std::uint32_t>(m_circles.size());
                m_circles.push_back({*circle, outline});
                m_squares.push_back(circle->cell);
            }
        }
    }

    void placeFields() {
        PolygonSet others;
        for (std::size_t i = 0; i < m_contours.size(); ++i) {
            if (m_circleOf[i] == kNone) {
                addContour(i, others);
            }
        }
        m_edges.emplace(others);
        const HoleFields fields(m_squares, kMargin);
        place(fields, fields.fields()[0]);
    }

    /// A field of its own if possible, else one for each of its parts.
    void place(const HoleFields& fields, const HoleFields::Field& field) {
        const std::span<const std::uint32_t> circles = fields.squaresOf(field);
        if (field.isTiled && isClear(field.box, circles) && tile(fields, field)) {
            return;
        }
        if (field.partCount == 0 && field.count > 1) {
            placeKnot(circles);
        }
        for (std::uint32_t i = 0; i < field.partCount; ++i) {
            place(fields, fields.fields()[field.firstPart + i]);
        }
    }

    /// Those that touch none of the others get a field each.
    void placeKnot(std::span<const std::uint32_t> circles) {
        std::vector<Box> squares;
        std::ranges::transform(circles, std::back_inserter(squares), [&](std::uint32_t i) { return m_squares[i]; });
        const model::BoxIndex index(squares);
        for (std::uint32_t i = 0; i < squares.size(); ++i) {
            bool isAlone = true;
            index.visit(squares[i].grownBy(kMargin), [&](std::uint32_t other) { isAlone = isAlone && other == i; });
            if (isAlone && isClear(squares[i], circles.subspan(i, 1))) {
                m_circles[circles[i]].field = static_cast<std::uint32_t>(m_fields.size());
                m_fields.push_back(squares[i]);
            }
        }
    }

    /// Does the box lie in the shape, in one island of it, with nothing but these circles in it?
    [[nodiscard]] bool isClear(const Box& box, std::span<const std::uint32_t> circles) const {
        const auto isOfOneOutline = [&](std::uint32_t i) {
            return m_circles[i].outline == m_circles[circles[0]].outline;
        };
        return std::ranges::all_of(circles, isOfOneOutline) && m_edges->contains(box.min) &&
               !m_edges->meets(box.grownBy(kMargin));
    }

    bool tile(const HoleFields& fields, const HoleFields::Field& field) {
        bool isPossible = true;
        fields.tile(field, field.box, [&](std::uint32_t circle, const Box& cell) {
            m_circles[circle].hole.cell = cell;
            m_circles[circle].field = static_cast<std::uint32_t>(m_fields.size());
            isPossible = isPossible && isInReach(m_circles[circle].hole, cell);
        });
        if (isPossible) {
            m_fields.push_back(field.box);
            return true;
        }
        for (const std::uint32_t circle : fields.squaresOf(field)) {
            m_circles[circle].field = kNone;
        }
        return false;
    }

    /// Contours but circles as chords, once: they are gone through twice.
    void makeChords() {
        for (std::size_t i = 0; i < m_contours.size(); ++i) {
            m_firstChord.push_back(m_chords.size());
            if (m_circleOf[i] == kNone) {
                addChords(i, m_chords);
            }
        }
        m_firstChord.push_back(m_chords.size());
    }

    void addChords(std::size_t contour, std::vector<Point>& to) const {
        const model::PathNodes nodes = m_shapes.nodesOf(m_contours[contour]);
        for (std::size_t i = 0; i < nodes.size(); ++i) {
            model::discretiseEdge(nodes, i, m_how, to);
        }
    }

    /// As long as it is the only one looked at.
    std::span<const Point> chordsOf(std::size_t contour) {
        if (m_circleOf[contour] == kNone) {
            return std::span(m_chords).subspan(m_firstChord[contour],
                                               m_firstChord[contour + 1] - m_firstChord[contour]);
        }
        m_loop.clear();
        addChords(contour, m_loop);
        return m_loop;
    }

    /// Adds a contour as chords; false if nothing is left of it.
    bool addContour(std::size_t contour, PolygonSet& to) {
        const std::span<const Point> loop = chordsOf(contour);
        if (!m_contours[contour].isHole) {
            to.beginPolygon();
            m_hasOutline = to.addLoop(loop);
            if (!m_hasOutline) {
                to.polygons.pop_back();
            }
            return m_hasOutline;
        }
        return m_hasOutline && to.addLoop(loop);
    }

    void assemble() {
        std::vector<std::uint8_t> isAdded(m_fields.size(), 0);
        for (std::size_t i = 0; i < m_contours.size(); ++i) {
            const Circle* circle = m_circleOf[i] == kNone ? nullptr : &m_circles[m_circleOf[i]];
            if (circle == nullptr || circle->field == kNone) {
                addContour(i, m_result.polygons);
            } else if (m_hasOutline) {
                addHole(*circle, isAdded[circle->field]);
            }
        }
    }

    /// With the field it lies in, unless that is there already.
    void addHole(const Circle& circle, std::uint8_t& isFieldAdded) {
        m_result.holes.push_back(circle.hole);
        if (isFieldAdded == 0) {
            isFieldAdded = 1;
            m_result.fields.push_back(m_fields[circle.field]);
            m_result.polygons.addLoop(cornersOf(m_result.fields.back()));
        }
    }

    const model::ShapeTable& m_shapes;
    std::span<const Contour> m_contours;
    const model::Discretisation& m_how;
    std::vector<Circle> m_circles;
    std::vector<Box> m_squares;             ///< by circle: the smallest cell
    std::vector<std::uint32_t> m_circleOf;  ///< by contour
    std::vector<Box> m_fields;
    std::optional<model::EdgeStrips> m_edges;  ///< of all contours but circles
    std::vector<Point> m_chords;               ///< of all contours but circles
    std::vector<std::size_t> m_firstChord;     ///< by contour, and the end
    std::vector<Point> m_loop;
    bool m_hasOutline = false;
    PunchedShape m_result;
};

}  // namespace

PunchedShape punch(const model::ShapeTable& shapes, model::ShapeId shape, const model::Discretisation& how) {
    return Punch(shapes, shape, how).run();
}

}  // namespace render
