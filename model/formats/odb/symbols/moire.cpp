// The moire: rings around a dot, and a cross over them. Its outline is put together from exact arcs.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "model/base/units.h"
#include "model/formats/odb/symbols/symbol_shapes.h"

namespace model::odb {

namespace {

constexpr double kQuarter = std::numbers::pi / 2;

/// Two lines with round ends across the centre, seen as four arms that leave it. Radii are distances from the centre.
class Cross {
public:
    Cross(double lineWidth, double length, double degrees)
        : m_half(lineWidth / 2), m_end(length / 2), m_turn(degrees * std::numbers::pi / 180.0) {}

    [[nodiscard]] bool isEmpty() const { return m_half <= 0; }
    /// Where the arms end.
    [[nodiscard]] double tip() const { return isEmpty() ? 0.0 : m_end + m_half; }
    /// Within this radius the arms cover everything: there the sides of neighbouring arms meet.
    [[nodiscard]] double core() const {
        if (isEmpty()) {
            return 0.0;
        }
        return std::numbers::sqrt2 *
               (m_end >= m_half ? m_half : (m_end + std::sqrt(2 * m_half * m_half - m_end * m_end)) / 2);
    }

    /// The side of arm `arm` with the larger angles (`side` 1) or the smaller ones (-1) from one radius to another,
    /// both between core and tip: outwards on the former, inwards on the latter. The edge of the last node is left to
    /// the caller.
    [[nodiscard]] std::vector<PathNode> sideOf(int arm, double side, double from, double to) const {
        std::vector<PathNode> nodes = {atSide(arm, from, side)};
        if (std::max(from, to) > joint()) {
            if (from < joint()) {
                nodes.push_back(atJoint(arm, side));
            }
            roundEnd(nodes.back(), arm, EdgeKind::ArcClockwise);
            if (to < joint()) {
                nodes.push_back(atJoint(arm, side));
            }
        }
        nodes.push_back(atSide(arm, to, side));
        return nodes;
    }

    /// Around the end of an arm, counter-clockwise from its right to its left side at this radius.
    [[nodiscard]] std::vector<PathNode> around(int arm, double radius) const {
        std::vector<PathNode> nodes = {atSide(arm, radius, -1.0)};
        if (radius < joint()) {
            nodes.push_back(atJoint(arm, -1.0));
        }
        roundEnd(nodes.back(), arm, EdgeKind::ArcCounterClockwise);
        if (radius < joint()) {
            nodes.push_back(atJoint(arm, 1.0));
        }
        nodes.push_back(atSide(arm, radius, 1.0));
        return nodes;
    }

private:
    /// Where the straight sides end.
    [[nodiscard]] double joint() const { return std::hypot(m_end, m_half); }
    [[nodiscard]] double direction(int arm) const { return m_turn + kQuarter * arm; }

    /// Half the angle that an arm takes on a circle.
    [[nodiscard]] double halfAngle(double radius) const {
        if (radius <= joint()) {
            return std::asin(std::min(m_half / radius, 1.0));
        }
        const double cosine = (radius * radius + m_end * m_end - m_half * m_half) / (2 * radius * m_end);
        return std::acos(std::clamp(cosine, -1.0, 1.0));
    }

    [[nodiscard]] PathNode atSide(int arm, double radius, double side) const {
        return lineNode(rounded(polar(direction(arm) + side * halfAngle(radius), radius)));
    }
    [[nodiscard]] PathNode atJoint(int arm, double side) const {
        return lineNode(rounded(polar(direction(arm) + side * std::atan2(m_half, m_end), joint())));
    }
    void roundEnd(PathNode& node, int arm, EdgeKind edge) const {
        node.centre = rounded(polar(direction(arm), m_end));
        node.edge = edge;
    }

    double m_half;  ///< of the lines' width
    double m_end;   ///< from the centre to the middle of a round end
    double m_turn;  ///< direction of the first arm, rad
};

void append(std::vector<PathNode>& nodes, const std::vector<PathNode>& more) {
    nodes.insert(nodes.end(), more.begin(), more.end());
}

/// A disc of this radius and the cross: one island.
void addDiscWithCross(ShapeSketch& sketch, double radius, const Cross& cross) {
    if (cross.tip() <= std::max(radius, cross.core())) {
        return addDisc(sketch, 2 * std::max(radius, cross.tip()), false);
    }
    std::vector<PathNode> nodes;
    for (int arm = 0; arm < 4; ++arm) {
        append(nodes, cross.around(arm, std::max(radius, cross.core())));
        if (radius > cross.core()) {
            nodes.back().edge = EdgeKind::ArcCounterClockwise;  // along the disc
        } else {
            nodes.pop_back();  // the next arm begins there
        }
    }
    addPath(sketch, nodes, false);
}

/// What the arms leave of the gap between two circles: a hole between each two arms.
void addQuarters(ShapeSketch& sketch, double inner, double outer, const Cross& cross) {
    const double start = std::max(inner, cross.core());
    for (int arm = 0; arm < 4; ++arm) {
        std::vector<PathNode> nodes = cross.sideOf(arm, 1.0, start, outer);
        nodes.back().edge = EdgeKind::ArcCounterClockwise;
        append(nodes, cross.sideOf(arm + 1, -1.0, outer, start));
        if (inner > cross.core()) {
            nodes.back().edge = EdgeKind::ArcClockwise;
        } else {
            nodes.pop_back();  // both arms meet in the first node
        }
        addPath(sketch, nodes, true);
    }
}

}  // namespace

/// moire: ring width, ring gap, rings, then the cross: line width, length, angle. A dot as wide as the rings is in the
/// middle; the lines of the cross have round ends at their length.
PadShape moire(const SymbolValues& v) {
    const double width = v[0];
    const double gap = v[1];
    const long rings = width > 0 ? std::lround(v[2]) : 0;
    const Cross cross(v[3], v[4], v[5]);
    const double radius = width / 2 + static_cast<double>(rings) * (width + gap);
    if (2 * std::max(radius, cross.tip()) > base::kMaxCoordinate / 2.0) {
        PadShape absurd;
        absurd.problem = "has an absurd size; it draws nothing";
        return absurd;
    }
    ShapeSketch sketch;
    if (radius > 0 || !cross.isEmpty()) {
        addDiscWithCross(sketch, radius, cross);
    }
    // Holes follow the island around them, so gaps from the outermost inwards.
    for (long ring = rings; ring > 0 && gap > 0; --ring) {
        const double outer = width / 2 + static_cast<double>(ring) * (width + gap) - width;
        const double inner = outer - gap;
        if (outer <= cross.core()) {
            break;
        }
        if (outer < cross.tip()) {
            addQuarters(sketch, inner, outer, cross);
            continue;
        }
        addDisc(sketch, 2 * outer, true);
        addDiscWithCross(sketch, inner, cross);
    }
    return regionShape(std::move(sketch));
}

}  // namespace model::odb
