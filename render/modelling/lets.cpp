#include "render/modelling/lets.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>
#include <numeric>

#include "model/base/assert.h"
#include "model/geometry/discretise.h"
#include "render/modelling/morton.h"

namespace render {

using model::ElementKind;
using model::Nm;
using model::PathNode;
using model::Point;

namespace {

/// Lets reach this far over the edges of their cell, so that rounding leaves nothing open.
constexpr Nm kCellOverlap = 1'000;

float mm(Nm length) {
    return static_cast<float>(length / base::kNmPerMm);
}

float radiusMm(Nm width) {
    return static_cast<float>(width / 2.0 / base::kNmPerMm);
}

/// How far a cell reaches from the centre of its hole, nm.
struct Reaches {
    Nm left;
    Nm right;
    Nm down;
    Nm up;
};

Reaches reachesOf(const RoundHole& hole) {
    return {hole.centre.x - hole.cell.min.x, hole.cell.max.x - hole.centre.x, hole.centre.y - hole.cell.min.y,
            hole.cell.max.y - hole.centre.y};
}

/// Two reaches as kLetHole has them, each a little longer.
float packed(Nm back, Nm forth) {
    constexpr Nm kUnit = static_cast<Nm>(base::kNmPerMm) / static_cast<Nm>(shader::kCellUnitsPerMm);
    const auto units = [](Nm reach) { return static_cast<std::uint32_t>((reach + kCellOverlap + kUnit - 1) / kUnit); };
    return std::bit_cast<float>(units(back) | units(forth) << 16U);
}

std::pair<float, float> unpacked(float reach) {
    const auto bits = std::bit_cast<std::uint32_t>(reach);
    const auto toMm = [](std::uint32_t units) { return static_cast<float>(units) / shader::kCellUnitsPerMm; };
    return {toMm(bits & 0xffffU), toMm(bits >> 16U)};
}

/// The axes of cells after placing. A half turn is taken by exchanging the reaches, so that the angle stays within a
/// quarter turn; a mirror turns the y axis over.
struct CellFrame {
    float tanHalfAngle;
    bool isRotated;
    bool isMirrored;

    [[nodiscard]] Reaches rotated(Reaches r) const {
        r = isMirrored ? Reaches{r.left, r.right, r.up, r.down} : r;
        return isRotated ? Reaches{r.right, r.left, r.up, r.down} : r;
    }
};

/// `along`: where the x axis of the shape points on the board.
CellFrame cellFrame(model::PointD along, bool isMirrored) {
    const bool isRotated = along.x < 0.0;
    const double sign = isRotated ? -1.0 : 1.0;
    return {static_cast<float>(sign * along.y / (1.0 + sign * along.x)), isRotated, isMirrored};
}

/// Turns the elements of one layer into lets.
class LetMaker {
public:
    LetMaker(const model::Document& document, Point origin, double chordToleranceNm, const HolesOfShape& holesOf,
             LayerLets& out)
        : m_document(document), m_origin(origin), m_toleranceNm(chordToleranceNm), m_holesOf(holesOf), m_out(out) {}

    void add(model::ElementId element) {
        const model::ElementTable& table = m_document.elements;
        const std::uint32_t row = table.geometry[element.row()];
        m_element = element;
        m_flags = table.flags[element.row()];
        m_layer = table.layer[element.row()].value;
        switch (table.kind[element.row()]) {
            case ElementKind::Line: addLine(m_document.lines[row]); break;
            case ElementKind::Arc:
                addPath(m_document.arcs[row].node, m_document.arcs[row].end, m_document.arcs[row].width,
                        m_document.arcs[row].innerWidth);
                break;
            case ElementKind::Circle: addCircle(m_document.circles[row]); break;
            case ElementKind::Trail: addTrail(m_document.trails[row]); break;
            case ElementKind::Area: addHoles(m_document.areas[row]); break;  // the rest is triangulated
        }
    }

private:
    bool hasWidth(Nm width) {
        if (width > 0) {
            return true;
        }
        if (m_out.zeroWidthTracks++ == 0) {
            m_out.firstZeroWidthLine = m_document.elements.line[m_element.row()];
        }
        return false;
    }

    void addStadium(Point a, Point b, Nm width, Nm innerWidth) {
        const glm::vec2 from = toGpu(base::toDouble(a), m_origin);
        const glm::vec2 to = toGpu(base::toDouble(b), m_origin);
        const std::uint32_t pen = (m_flags & model::kSquarePen) != 0 ? shader::kLetSquarePen : 0;
        push({from.x, from.y, to.x, to.y, radiusMm(width), radiusMm(innerWidth), shader::kLetStadium | pen,
              m_element.value});
        if ((m_flags & model::kHole) != 0 && innerWidth > 0) {
            push({from.x, from.y, to.x, to.y, radiusMm(innerWidth), 0.0F, shader::kLetStadium | shader::kLetBore,
                  m_element.value});
        }
    }

    void addHoles(const model::AreaGeometry& area) {
        const std::span<const RoundHole> holes = m_holesOf ? m_holesOf(area.shape) : std::span<const RoundHole>();
        const model::Placement rotation{{}, area.placement.clockwiseDeg, area.placement.isMirrored};
        const CellFrame frame = cellFrame(rotation.apply(model::PointD{1.0, 0.0}), area.placement.isMirrored);
        for (const RoundHole& hole : holes) {
            const glm::vec2 centre = toGpu(area.placement.apply(base::toDouble(hole.centre)), m_origin);
            const Reaches reaches = frame.rotated(reachesOf(hole));
            push({centre.x, centre.y, packed(reaches.left, reaches.right), packed(reaches.down, reaches.up),
                  frame.tanHalfAngle, mm(hole.radius), shader::kLetHole, m_element.value});
        }
    }

    void addLine(const model::LineGeometry& line) {
        if (hasWidth(line.width)) {
            addStadium(line.a, line.b, line.width, line.innerWidth);
        }
    }

    void addCircle(const model::CircleGeometry& circle) {
        if (hasWidth(circle.diameter)) {
            addStadium(circle.centre, circle.centre, circle.diameter, circle.innerDiameter);
        }
    }

    void addTrail(const model::TrailGeometry& trail) {
        const std::span<const PathNode> nodes = m_document.nodesOf(trail);
        const std::span<const Nm> widths = m_document.widthsOf(trail);
        for (std::size_t i = 0; i < widths.size(); ++i) {
            addPath(nodes[i], nodes[i + 1].point, widths[i], trail.innerWidth);
        }
    }

    /// A track of an arc or a path, and for holes its dark inside. It has no inner wall of its own: tracks of a path
    /// overlap, and walls would lie across the slot.
    void addPath(const PathNode& node, Point end, Nm width, Nm innerWidth) {
        addEdge(node, end, width);
        if ((m_flags & model::kHole) != 0 && innerWidth > 0) {
            m_bore = shader::kLetBore;
            addEdge(node, end, innerWidth);
            m_bore = 0;
        }
    }

    void addEdge(const PathNode& node, Point end, Nm width) {
        if (node.edge != model::EdgeKind::Line) {
            addArc(node, end, width);
        } else if (hasWidth(width)) {
            addStadium(node.point, end, width, 0);
        }
    }

    void addArc(const PathNode& node, Point end, Nm width) {
        if (!hasWidth(width)) {
            return;
        }
        const model::PointD c = base::toDouble(node.centre);
        const double startRadius = std::hypot(node.point.x - c.x, node.point.y - c.y);
        const double endRadius = std::hypot(end.x - c.x, end.y - c.y);
        const double radius = (startRadius + endRadius) / 2.0;
        if (radius < 1.0) {
            addStadium(node.point, end, width, 0);  // an arc of no radius is a dot
            return;
        }
        if (2.0 * radius <= width) {
            addChords(node, end, width);
            return;
        }
        const double start = std::atan2(node.point.y - c.y, node.point.x - c.x);
        const double sweep = model::sweepOf(node, end);
        const double longest = longestLetSweep(radius + width / 2.0);
        const int pieces = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / longest - 1e-9)));
        const glm::vec2 centre = toGpu(c, m_origin);
        for (int i = 0; i < pieces; ++i) {
            push({centre.x, centre.y, static_cast<float>(radius / base::kNmPerMm),
                  static_cast<float>(start + sweep * i / pieces), static_cast<float>(sweep / pieces), radiusMm(width),
                  shader::kLetArc, m_element.value});
        }
    }

    /// A pen wider than the arc turns an arc let's inner edge inside out; tracks along the chords cover the same
    /// region.
    void addChords(const PathNode& node, Point end, Nm width) {
        std::vector<Point> points;
        model::discretiseEdge(node, end, {m_toleranceNm, false}, points);
        points.push_back(end);
        for (std::size_t i = 0; i + 1 < points.size(); ++i) {
            addStadium(points[i], points[i + 1], width, 0);
        }
    }

    /// The sagitta of each of the let's chords is r(1 - cos(sweep / 2 / chords)).
    [[nodiscard]] double longestLetSweep(double outerRadius) const {
        const double halfChord =
            m_toleranceNm >= outerRadius ? std::numbers::pi / 8.0 : std::acos(1.0 - m_toleranceNm / outerRadius);
        return std::min(std::numbers::pi / 2.0, 2.0 * shader::kArcFineChords * halfChord);
    }

    void push(shader::Let let) {
        let.meta |= m_layer << shader::kLetLayerShift | m_bore;
        m_out.lets.push_back(let);
    }

    const model::Document& m_document;
    Point m_origin;
    double m_toleranceNm;
    const HolesOfShape& m_holesOf;
    LayerLets& m_out;
    model::ElementId m_element;
    std::uint8_t m_flags = 0;
    std::uint32_t m_layer = 0;
    std::uint32_t m_bore = 0;  ///< kLetBore while the inside of a hole is added
};

/// About the middle of a let's box.
glm::vec2 middleOf(const shader::Let& let) {
    const glm::vec2 first{let.p0, let.p1};
    switch (let.meta & shader::kLetKindMask) {
        case shader::kLetArc: {
            const float angle = let.p3 + let.p4 / 2.0F;
            return first + let.p2 * glm::vec2(std::cos(angle), std::sin(angle));
        }
        case shader::kLetHole: return first;
        default: return (first + glm::vec2(let.p2, let.p3)) / 2.0F;
    }
}

/// Neighbours come together, so that clusters are small: first those of what is whole, then those of what is milled.
void sortAlongMorton(const IsMilled& isMilled, LayerLets& out) {
    Box2 all;
    std::vector<glm::vec2> middles;
    middles.reserve(out.lets.size());
    for (const shader::Let& let : out.lets) {
        middles.push_back(middleOf(let));
        all.include(middles.back());
    }
    out.order.resize(out.lets.size());
    std::iota(out.order.begin(), out.order.end(), 0U);
    const auto isWhole = [&](std::uint32_t row) {
        return !isMilled || !isMilled(model::ElementId{out.lets[row].element});
    };
    const auto milled = std::stable_partition(out.order.begin(), out.order.end(), isWhole);
    out.wholeCount = static_cast<std::size_t>(milled - out.order.begin());
    const MortonCurve curve(all.min, all.max);
    const auto keyOf = [&](std::uint32_t row) { return curve.key(middles[row]); };
    sortRows(std::span(out.order.begin(), milled), keyOf);
    sortRows(std::span(milled, out.order.end()), keyOf);
}

/// About how many lets the elements of a layer become: so much room is kept for them.
std::size_t expectedLets(const model::Document& document, model::Range elements, const HolesOfShape& holesOf) {
    std::size_t sum = 0;
    for (std::uint32_t row = elements.first; row < elements.first + elements.count; ++row) {
        const std::uint32_t geometry = document.elements.geometry[row];
        const bool isHole = (document.elements.flags[row] & model::kHole) != 0;
        switch (document.elements.kind[row]) {
            case ElementKind::Trail: sum += document.trails[geometry].nodeCount; break;
            case ElementKind::Area: sum += holesOf ? holesOf(document.areas[geometry].shape).size() : 0; break;
            default: sum += isHole ? 2 : 1; break;
        }
    }
    return sum;
}

Box2 boxOfCell(const shader::Let& let) {
    const float t = let.p4;
    const glm::vec2 along = glm::vec2(1.0F - t * t, 2.0F * t) / (1.0F + t * t);
    const auto [left, right] = unpacked(let.p2);
    const auto [down, up] = unpacked(let.p3);
    const auto ends = [](float back, float forth, float slope) { return std::minmax({-back * slope, forth * slope}); };
    const auto xAlongX = ends(left, right, along.x);
    const auto xAlongY = ends(left, right, along.y);
    const auto yAlongX = ends(down, up, -along.y);
    const auto yAlongY = ends(down, up, along.x);
    return {{let.p0 + xAlongX.first + yAlongX.first, let.p1 + xAlongY.first + yAlongY.first},
            {let.p0 + xAlongX.second + yAlongX.second, let.p1 + xAlongY.second + yAlongY.second}};
}

}  // namespace

Box2 boxOf(const shader::Let& let) {
    if ((let.meta & shader::kLetKindMask) == shader::kLetArc) {
        // At most a quarter turn: both ends and the middle pushed out to the tangents' corner enclose it.
        const glm::vec2 centre{let.p0, let.p1};
        const auto at = [&](float t, float radius) {
            const float angle = let.p3 + let.p4 * t;
            return centre + radius * glm::vec2(std::cos(angle), std::sin(angle));
        };
        const glm::vec2 corner = at(0.5F, let.p2 / std::cos(let.p4 / 2.0F));
        Box2 middleLine;
        for (const glm::vec2 point : {at(0.0F, let.p2), at(1.0F, let.p2), corner}) {
            middleLine.include(point);
        }
        return {middleLine.min - let.p5, middleLine.max + let.p5};
    }
    const glm::vec2 a{let.p0, let.p1};
    const glm::vec2 b{let.p2, let.p3};
    if ((let.meta & shader::kLetKindMask) == shader::kLetHole) {
        return boxOfCell(let);
    }
    // A square pen's corner lies a diagonal away, but its sides are axis-parallel: the box is the same.
    return {glm::min(a, b) - let.p4, glm::max(a, b) + let.p4};
}

LayerLets makeLets(const model::Document& document, model::LayerId layer, Point origin, double chordToleranceNm,
                   const HolesOfShape& holesOf, const IsMilled& isMilled) {
    LayerLets out;
    const model::Range range = document.layer(layer).elements;
    out.lets.reserve(expectedLets(document, range, holesOf));
    LetMaker maker(document, origin, chordToleranceNm, holesOf, out);
    for (std::uint32_t i = 0; i < range.count; ++i) {
        maker.add(model::ElementId{range.first + i});
    }
    sortAlongMorton(isMilled, out);
    return out;
}

std::size_t clusterCount(const LayerLets& made) {
    const auto clustersOf = [](std::size_t lets) { return (lets + shader::kClusterSize - 1) / shader::kClusterSize; };
    return clustersOf(made.wholeCount) + clustersOf(made.order.size() - made.wholeCount);
}

void placeLets(const LayerLets& made, model::LayerId layer, std::uint32_t firstLet, std::span<shader::Let> lets,
               std::span<shader::Cluster> clusters) {
    std::size_t placed = 0;
    std::size_t cluster = 0;
    const auto place = [&](std::span<const std::uint32_t> rows, std::uint32_t onlyAs) {
        for (std::size_t done = 0; done < rows.size(); done += shader::kClusterSize) {
            const std::size_t count = std::min<std::size_t>(shader::kClusterSize, rows.size() - done);
            const auto first = firstLet + static_cast<std::uint32_t>(placed);
            Box2 box;
            for (const std::uint32_t row : rows.subspan(done, count)) {
                lets[placed] = made.lets[row];
                box.include(boxOf(lets[placed++]));
            }
            clusters[cluster++] = {box.min, box.max, first, static_cast<std::uint32_t>(count), layer.value, onlyAs};
        }
    };
    const std::span<const std::uint32_t> order(made.order);
    place(order.first(made.wholeCount), 0);
    place(order.subspan(made.wholeCount), shader::kOnlyAsDesigned);
}

}  // namespace render
