#include "model/measure/snapping.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <tuple>

#include "model/figures/distance.h"
#include "model/geometry/vectors.h"

namespace model {

namespace {

/// Edges whose crossings are searched for; where more are near nobody can distinguish them.
constexpr std::size_t kMostCrossing = 64;
/// Points that are tried, the best first; where more are near they lie within each other's pixels.
constexpr std::size_t kMostTried = 256;
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
    Search(const BoardIndex& index, const FigureTable& outline, PointD location, double reach,
           std::span<const PickLayer> layers, bool isFromBelow)
        : m_index(index),
          m_outline(outline),
          m_position(location),
          m_reach(reach),
          m_layers(layers),
          m_isFromBelow(isFromBelow) {}

    SnapPoint run(std::size_t skip) {
        offerOutline();
        forEachNear(m_position, m_reach, [&](const Placed& near, const Box& box) { offerPointsOf(near, box); });
        offerCrossings();
        const auto tried = static_cast<std::ptrdiff_t>(std::min(m_points.size(), kMostTried));
        std::ranges::partial_sort(m_points, m_points.begin() + tried, {},
                                  [&](const SnapPoint& p) { return rankOf(p); });
        m_points.resize(static_cast<std::size_t>(tried));
        return chosen(skip);
    }

    [[nodiscard]] std::optional<BoardElement> empty() const {
        std::optional<BoardElement> found;
        forEachNear(m_position, m_reach, [&](const Placed& near, const Box&) {
            if (piecesOf(m_index, std::array{near.element}).pieces.empty()) {
                found = found ? std::min(*found, near.element) : near.element;
            }
        });
        return found;
    }

private:
    void offer(SnapKind kind, PointD at, BoardElement element, LayerId layer) {
        const SnapPoint point{kind, at, element, layer, distance(at, m_position)};
        if (point.missedBy <= m_reach) {
            m_points.push_back(point);
        }
    }

    /// The board's edge is on all layers, so nothing lies over it.
    [[nodiscard]] double depthOf(LayerId layer) const {
        if (!layer.isValid()) {
            return -std::numeric_limits<double>::infinity();
        }
        return m_isFromBelow ? m_layers[layer.row()].bottom : -m_layers[layer.row()].top;
    }

    /// What is wanted most comes first.
    [[nodiscard]] std::tuple<SnapKind, double, bool, double, BoardElement> rankOf(const SnapPoint& p) const {
        const bool hasNet = netOf(m_index, p.element).isValid();
        return {p.kind, std::floor(p.missedBy / kSameLocationNm), !hasNet, depthOf(p.layer), p.element};
    }

    SnapPoint chosen(std::size_t skip) {
        std::vector<SnapPoint> hidden;
        std::vector<SnapPoint> passed;
        for (const SnapPoint& point : m_points) {
            const Cover cover = coverOf(point);
            if (cover == Cover::Seen && passed.size() == skip) {
                return point;
            }
            if (cover != Cover::Buried) {
                (cover == Cover::Seen ? passed : hidden).push_back(point);
            }
        }
        if (passed.empty()) {
            passed.push_back(nothing());
        }
        passed.insert(passed.end(), hidden.begin(), hidden.end());
        return passed[skip % passed.size()];
    }

    [[nodiscard]] SnapPoint nothing() const {
        SnapPoint point;
        point.at = m_position;
        return point;
    }

    enum class Cover : std::uint8_t { Seen, Hidden, Buried };

    /// Of copper over a point: is it nearer to the viewer, or on the layer of an edge that is none then?
    [[nodiscard]] Cover coverOf(const SnapPoint& point) {
        Cover cover = Cover::Seen;
        if (!point.layer.isValid()) {
            return cover;
        }
        forEachNear(point.at, kSameLocationNm, [&](const Placed& near, const Box&) {
            const bool isNearer =
                depthOf(near.layer) < depthOf(point.layer) && !m_layers[near.layer.row()].isSeenThrough;
            const bool isBeside =
                point.kind == SnapKind::Edge && near.layer == point.layer && near.element != point.element;
            if ((isNearer || isBeside) && isCopper(near) && isWithin(near, point.at)) {
                cover = isBeside ? Cover::Buried : std::max(cover, Cover::Hidden);
            }
        });
        return cover;
    }

    /// An element of a copy near a location.
    struct Placed {
        const Document& step;
        const StepCopy& copy;
        BoardElement element;
        LayerId layer;
    };

    [[nodiscard]] bool isCopper(const Placed& near) const {
        return m_index.board->layer(near.layer).isCopper() &&
               (near.step.elements.flags[near.element.element.row()] & kHole) == 0;
    }

    /// Does an element cover a location, and not only touch it?
    [[nodiscard]] bool isWithin(const Placed& near, PointD location) {
        const std::shared_ptr<const FigureTable> kept = m_index.figuresOf(near.copy.step, near.element.element);
        const FigureTable& figures = *kept;
        const PointD at = unplaced(location, near.copy.placement);
        for (std::size_t row = 0; row < figures.size(); ++row) {
            if (figures[row].isFilled ? isInArea(figures, row, at) : isInTrack(figures, row, at)) {
                return true;
            }
        }
        return false;
    }

    static bool isInArea(const FigureTable& figures, std::size_t row, PointD at) {
        bool isOnEdge = false;
        visitEdges(figures, row, boxAround(at, kSameLocationNm), [&](const Edge& edge) {
            isOnEdge = isOnEdge || distance(nearestOn(edge, at), at) <= kSameLocationNm;
        });
        return !isOnEdge && isInside(figures, row, at);
    }

    static bool isInTrack(const FigureTable& figures, std::size_t row, PointD at) {
        bool isIn = false;
        visitEdges(figures, row, boxAround(at, kSameLocationNm), [&](const Edge& edge) {
            isIn = isIn || distance(nearestOn(edge, at), at) < edge.pen - kSameLocationNm;
        });
        return isIn;
    }

    /// Calls `visit(Placed, box in the coordinates of the step)` for the elements of visible layers near a location.
    template <class Visit>
    void forEachNear(PointD location, double reach, const Visit& visit) const {
        for (std::uint32_t copy = 0; copy < m_index.tree.copies.size(); ++copy) {
            const StepCopy& how = m_index.tree.copies[copy];
            const Document& step = *m_index.tree.steps[how.step];
            const Box box = boxAround(unplaced(location, how.placement), reach);
            m_index.elements[how.step].visit(box, [&](std::uint32_t row) {
                const ElementId element{row};
                const LayerId layer = step.layerOfCopy(step.elements.layer[row], how.isFlipped);
                if (m_layers[layer.row()].isVisible) {
                    visit(Placed{step, how, {copy, element}, layer}, box);
                }
            });
        }
    }

    void offerPointsOf(const Placed& near, const Box& box) {
        const std::optional<PointD> centre = centreOf(near.step, near.element.element);
        if (centre) {
            offer(SnapKind::Centre, near.copy.placement.apply(*centre), near.element, near.layer);
        }
        const std::shared_ptr<const FigureTable> kept = m_index.figuresOf(near.copy.step, near.element.element);
        const FigureTable& figures = *kept;
        for (std::size_t figure = 0; figure < figures.size(); ++figure) {
            visitEdges(figures, figure, box, [&](const Edge& edge) {
                offerEdge({placed(edge, near.copy.placement), near.element, near.layer}, figures[figure].isFilled,
                          centre.has_value());
            });
        }
    }

    /// `isDot`: the middle line of a pad is nothing that anybody sees.
    void offerEdge(const NearEdge& near, bool isFilled, bool isDot) {
        const auto& [edge, element, layer] = near;
        const PointD onMiddle = nearestOn(edge, m_position);
        const double beside = distance(onMiddle, m_position);
        if (edge.isArc() && !edge.isOfCurve) {
            offer(SnapKind::ArcCentre, edge.centre, element, layer);
        }
        if (beside > m_reach + edge.pen) {
            return;
        }
        offerRim(near, onMiddle, beside);
        if (isDot && !isFilled) {
            return;
        }
        if (!edge.isFullCircle() && edge.startsThere()) {
            offer(SnapKind::End, edge.a, element, layer);
        }
        if (!edge.isFullCircle() && edge.endsThere()) {
            offer(SnapKind::End, edge.b, element, layer);
        }
        if (const double full = lengthOf(edge); full > 0 && !edge.isFullCircle() && !edge.isOfCurve) {
            offer(SnapKind::Middle, pointAt(edge, full / 2), element, layer);
        }
        if (beside <= m_reach && m_near.size() < kMostCrossing) {
            m_near.push_back(near);
        }
    }

    void offerOutline() {
        m_onOutline = nearestOnEdge(m_outline, m_position, m_reach);
        for (std::size_t row = 0; m_onOutline && row < m_outline.size(); ++row) {
            visitEdges(m_outline, row, boxAround(m_position, m_reach), [&](const Edge& edge) {
                offerEdge({edge, {}, {}}, false, false);
            });
        }
    }

    /// Is it a side of the pen that draws the board's edge?
    [[nodiscard]] bool isBesideOutline(const NearEdge& near, PointD rim) const {
        return m_onOutline && near.edge.pen > 0 && !m_index.board->layer(near.layer).isCopper() &&
               distance(*m_onOutline, rim) <= near.edge.pen + kSameLocationNm;
    }

    /// The nearest point of the edge that is seen: a boundary itself, or the rim of a track.
    void offerRim(const NearEdge& near, PointD onMiddle, double beside) {
        PointD rim = onMiddle;
        if (near.edge.pen > 0 && beside > 0) {
            const double part = near.edge.pen / beside;
            rim = {onMiddle.x + (m_position.x - onMiddle.x) * part, onMiddle.y + (m_position.y - onMiddle.y) * part};
        }
        if ((near.edge.pen == 0 || beside > 0) && !isBesideOutline(near, rim)) {
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
    const FigureTable& m_outline;
    PointD m_position;
    double m_reach;
    std::span<const PickLayer> m_layers;
    bool m_isFromBelow;
    std::optional<PointD> m_onOutline;  ///< nearest, within reach
    std::vector<SnapPoint> m_points;
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

SnapPoint Snapper::at(PointD location, double reach, std::span<const PickLayer> layers, bool isFromBelow,
                      std::size_t skip) const {
    return Search(*m_index, m_outline, location, reach, layers, isFromBelow).run(skip);
}

std::optional<BoardElement> Snapper::emptyAt(PointD location, double reach, std::span<const PickLayer> layers) const {
    return Search(*m_index, m_outline, location, reach, layers, false).empty();
}

}  // namespace model
