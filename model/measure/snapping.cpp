#include "model/measure/snapping.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <tuple>

#include "model/figures/distance.h"
#include "model/geometry/vectors.h"
#include "model/measure/items.h"

namespace model {

namespace {

/// Edges whose crossings are searched for; where more are near nobody can distinguish them.
constexpr std::size_t kMostCrossing = 64;
/// Points nearer to each other are at one location.
constexpr double kSameLocationNm = 1.0;

/// An edge near the pointer, on the board.
struct NearEdge {
    Edge edge;
    BoardElement element;
    LayerId layer;
};

/// The centre of what people take for a dot: a disc, a hole, a pad of any shape.
std::optional<PointD> centreOf(const Document& step, ElementId element) {
    const std::uint32_t row = step.elements.geometry[element.row()];
    const bool isPad = (step.elements.flags[element.row()] & (kPad | kHole)) != 0;
    switch (step.elements.kind[element.row()]) {
        case ElementKind::Circle: return base::toDouble(step.circles[row].centre);
        case ElementKind::Line: {
            const LineGeometry& line = step.lines[row];
            return isPad ? std::optional(
                               PointD{(double{1} * line.a.x + line.b.x) / 2, (double{1} * line.a.y + line.b.y) / 2})
                         : std::nullopt;
        }
        case ElementKind::Area:
            return isPad ? std::optional(base::toDouble(step.areas[row].placement.origin)) : std::nullopt;
        default: return std::nullopt;
    }
}

/// Visits everything near one location and weighs the points that it offers.
class Search {
public:
    Search(const BoardIndex& index, FigureCache& figures, PointD location, double reach,
           std::span<const PickLayer> layers, bool isFromBelow)
        : m_index(index),
          m_figures(figures),
          m_position(location),
          m_reach(reach),
          m_layers(layers),
          m_isFromBelow(isFromBelow) {
        m_best.at = location;
    }

    SnapPoint run() {
        for (std::uint32_t copy = 0; copy < m_index.tree.copies.size(); ++copy) {
            searchCopy(copy);
        }
        offerCrossings();
        return m_best;
    }

private:
    void offer(SnapKind kind, PointD at, BoardElement element, LayerId layer) {
        const SnapPoint point{kind, at, element, layer, distance(at, m_position)};
        if (point.missedBy <= m_reach && (m_best.kind == SnapKind::Free || isBetter(point, m_best))) {
            m_best = point;
        }
    }

    [[nodiscard]] bool isBetter(const SnapPoint& a, const SnapPoint& b) const {
        if (a.kind != b.kind) {
            return a.kind < b.kind;
        }
        if (distance(a.at, b.at) > kSameLocationNm && a.missedBy != b.missedBy) {
            return a.missedBy < b.missedBy;
        }
        const auto rank = [&](const SnapPoint& p) {
            const PickLayer& layer = m_layers[p.layer.row()];
            const bool hasNet = netOf(m_index, p.element).isValid();
            return std::tuple(!hasNet, m_isFromBelow ? layer.bottom : -layer.top, p.element);
        };
        return rank(a) < rank(b);
    }

    void searchCopy(std::uint32_t copy) {
        const StepCopy& how = m_index.tree.copies[copy];
        const Document& step = *m_index.tree.steps[how.step];
        const Box box = boxAround(unplaced(m_position, how.placement), m_reach);
        m_index.elements[how.step].visit(box, [&](std::uint32_t row) {
            const ElementId element{row};
            const LayerId layer = step.layerOfCopy(step.elements.layer[row], how.isFlipped);
            if (!m_layers[layer.row()].isVisible) {
                return;
            }
            const std::optional<PointD> centre = centreOf(step, element);
            if (centre) {
                offer(SnapKind::Centre, how.placement.apply(*centre), {copy, element}, layer);
            }
            const FigureTable& figures = m_figures.of(m_index, how.step, element);
            for (std::size_t figure = 0; figure < figures.size(); ++figure) {
                visitEdges(figures, figure, box, [&](const Edge& edge) {
                    offerEdge({placed(edge, how.placement), {copy, element}, layer}, figures[figure].isFilled,
                              centre.has_value());
                });
            }
        });
    }

    /// `isDot`: the middle line of a pad is nothing that anybody sees.
    void offerEdge(const NearEdge& near, bool isFilled, bool isDot) {
        const auto& [edge, element, layer] = near;
        const PointD onMiddle = nearestOn(edge, m_position);
        const double beside = distance(onMiddle, m_position);
        if (edge.isArc()) {
            offer(SnapKind::ArcCentre, edge.centre, element, layer);
        }
        if (beside > m_reach + edge.pen) {
            return;
        }
        offerRim(near, onMiddle, beside);
        if (isDot && !isFilled) {
            return;
        }
        if (!edge.isFullCircle()) {
            offer(SnapKind::End, edge.a, element, layer);
            offer(SnapKind::End, edge.b, element, layer);
        }
        if (const double full = lengthOf(edge); full > 0 && !edge.isFullCircle()) {
            offer(SnapKind::Middle, pointAt(edge, full / 2), element, layer);
        }
        if (beside <= m_reach && m_near.size() < kMostCrossing) {
            m_near.push_back(near);
        }
    }

    /// The nearest point of the edge that is seen: a boundary itself, or the rim of a track.
    void offerRim(const NearEdge& near, PointD onMiddle, double beside) {
        PointD rim = onMiddle;
        if (near.edge.pen > 0 && beside > 0) {
            const double part = near.edge.pen / beside;
            rim = {onMiddle.x + (m_position.x - onMiddle.x) * part, onMiddle.y + (m_position.y - onMiddle.y) * part};
        }
        if (near.edge.pen == 0 || beside > 0) {
            offer(SnapKind::Edge, rim, near.element, near.layer);
        }
    }

    void offerCrossings() {
        for (std::size_t i = 0; i < m_near.size(); ++i) {
            for (std::size_t j = i + 1; j < m_near.size(); ++j) {
                const NearEdge& a = m_near[i];
                const NearEdge& b = m_near[j];
                if (a.layer != b.layer || a.element == b.element) {
                    continue;
                }
                for (const PointD at : crossingsOf(a.edge, b.edge)) {
                    offer(SnapKind::Crossing, at, std::min(a.element, b.element), a.layer);
                }
            }
        }
    }

    const BoardIndex& m_index;
    FigureCache& m_figures;
    PointD m_position;
    double m_reach;
    std::span<const PickLayer> m_layers;
    bool m_isFromBelow;
    SnapPoint m_best;
    std::vector<NearEdge> m_near;
};

}  // namespace

const char* toString(SnapKind kind) {
    constexpr const char* kNames[] = {"centre", "end", "arc centre", "middle", "crossing", "edge", "free"};
    return kNames[static_cast<std::size_t>(kind)];
}

PointD straightened(PointD from, PointD location, double stepDeg) {
    const double step = stepDeg * std::numbers::pi / 180.0;
    const double angle = std::round(std::atan2(location.y - from.y, location.x - from.x) / step) * step;
    const double length = (location.x - from.x) * std::cos(angle) + (location.y - from.y) * std::sin(angle);
    return {from.x + length * std::cos(angle), from.y + length * std::sin(angle)};
}

SnapPoint Snapper::at(PointD location, double reach, std::span<const PickLayer> layers, bool isFromBelow) {
    return Search(*m_index, m_figures, location, reach, layers, isFromBelow).run();
}

}  // namespace model
