#include "model/formats/kicad/shapes/dashes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "model/base/point.h"
#include "model/geometry/outlines.h"
#include "model/geometry/vectors.h"

namespace model::kicad {

namespace {

using base::PointD;

constexpr double kDot = 0.2;             ///< pens
constexpr double kMostStrokes = 2000.0;  ///< of an edge

/// Strokes and gaps in turn, in pens.
std::vector<double> patternOf(LineStyle style, const DashRatios& ratios) {
    const double dash = std::max(ratios.dash - 1.0, 1.0);
    const double gap = std::max(ratios.gap + 1.0, 1.0);
    switch (style) {
        case LineStyle::Dash: return {dash, gap};
        case LineStyle::Dot: return {kDot, gap};
        case LineStyle::DashDot: return {dash, gap, kDot, gap};
        case LineStyle::DashDotDot: return {dash, gap, kDot, gap, kDot, gap};
        case LineStyle::Solid: break;
    }
    return {};
}

/// Within what a row holds, also of arcs that leave it.
Point onGrid(PointD p) {
    constexpr double kFarthest = 2.1e9;
    return rounded({std::clamp(p.x, -kFarthest, kFarthest), std::clamp(p.y, -kFarthest, kFarthest)});
}

double angleOf(Point centre, Point on) {
    const PointD from = base::toDouble(centre);
    const PointD to = base::toDouble(on);
    return std::atan2(to.y - from.y, to.x - from.x);
}

/// An edge by how far along it is, an arc always clockwise.
class Walk {
public:
    explicit Walk(const ChainEdge& edge) : m_from(edge.from), m_to(edge.to) {
        if (m_from.edge == EdgeKind::Line) {
            m_length = distance(m_from.point, m_to);
            return;
        }
        if (m_from.edge == EdgeKind::ArcCounterClockwise) {
            std::swap(m_from.point, m_to);
            m_from.edge = EdgeKind::ArcClockwise;
        }
        const Point c = m_from.centre;
        m_radius = distance(c, m_from.point);
        const bool isCircle = m_from.point == m_to;
        m_angle = isCircle ? 0.0 : angleOf(c, m_from.point);
        double swept = isCircle ? 0.0 : m_angle - angleOf(c, m_to);
        swept += swept <= 0.0 ? 2.0 * std::numbers::pi : 0.0;
        m_length = swept * m_radius;
    }

    [[nodiscard]] double length() const { return m_length; }

    /// What is too short to have two ends is a point, not a whole circle.
    [[nodiscard]] ChainEdge between(double begin, double end) const {
        const Point from = at(begin);
        const Point to = at(end);
        return {from == to && end - begin < m_radius ? PathNode{from, {}, EdgeKind::Line}
                                                     : PathNode{from, m_from.centre, m_from.edge},
                to};
    }

private:
    [[nodiscard]] Point at(double along) const {
        if (m_from.edge == EdgeKind::Line) {
            const PointD a = base::toDouble(m_from.point);
            const PointD b = base::toDouble(m_to);
            const double t = along / m_length;
            return onGrid({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
        }
        const double angle = m_angle - along / m_radius;
        const PointD c = base::toDouble(m_from.centre);
        return onGrid({c.x + m_radius * std::cos(angle), c.y + m_radius * std::sin(angle)});
    }

    PathNode m_from;
    Point m_to;
    double m_radius = 0.0;
    double m_angle = 0.0;  ///< of the beginning of an arc
    double m_length = 0.0;
};

}  // namespace

LineStyle lineStyleOf(std::string_view type) {
    constexpr std::array<std::pair<std::string_view, LineStyle>, 4> kStyles = {
        {{"dash", LineStyle::Dash},
         {"dot", LineStyle::Dot},
         {"dash_dot", LineStyle::DashDot},
         {"dash_dot_dot", LineStyle::DashDotDot}}};
    const auto* const found = std::ranges::find(kStyles, type, &std::pair<std::string_view, LineStyle>::first);
    return found == kStyles.end() ? LineStyle::Solid : found->second;
}

std::vector<ChainEdge> dashesOf(const ChainEdge& edge, double pen, LineStyle style, const DashRatios& ratios) {
    const std::vector<double> pattern = patternOf(style, ratios);
    const Walk walk(edge);
    if (pattern.empty() || pen <= 0.0 || walk.length() <= 0.0 || walk.length() / (pen * pattern[1]) > kMostStrokes) {
        return {edge};
    }
    std::vector<ChainEdge> strokes;
    double at = 0.0;
    for (std::size_t i = 0; at < walk.length(); ++i) {
        const double end = std::min(at + pattern[i % pattern.size()] * pen, walk.length());
        if (i % 2 == 0) {
            strokes.push_back(walk.between(at, end));
        }
        at = end;
    }
    return strokes;
}

}  // namespace model::kicad
