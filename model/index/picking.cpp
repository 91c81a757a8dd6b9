#include "model/index/picking.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <tuple>
#include <utility>

#include "model/figures/distance.h"

namespace model {

namespace {

/// Halvings of a line through a layer: to 1 nm of 1 m.
constexpr int kHalvings = 30;

Point rounded(PointD p) {
    const auto clamp = [](double v) {
        return static_cast<Nm>(std::lround(std::clamp<double>(v, -base::kMaxCoordinate, base::kMaxCoordinate)));
    };
    return {clamp(p.x), clamp(p.y)};
}

Box boxAround(PointD a, PointD b, double reach) {
    Box box;
    box.include(rounded(a));
    box.include(rounded(b));
    return box.grownBy(static_cast<Nm>(std::ceil(std::min(reach, 1e8))) + 1);
}

PointD along(PointD a, PointD b, double part) {
    return {a.x + (b.x - a.x) * part, a.y + (b.y - a.y) * part};
}

/// How far the figures are from the track from `a` to `b`; more than `reach` counts as infinitely far.
double spacingTo(const FigureTable& figures, PointD a, PointD b, double reach) {
    FigureTable probe;
    probe.addTrack(a, b, 0.0);
    const auto spacing = spacingBetween(figures, probe, std::max(reach, kTouchNm));
    const double distance = spacing ? spacing->distance : std::numeric_limits<double>::infinity();
    return distance <= kTouchNm ? 0.0 : distance;
}

/// The part of the line from `a` to `b` after which the figures are first touched; they are somewhere on it.
double firstContact(const FigureTable& figures, PointD a, PointD b) {
    if (spacingTo(figures, a, a, 0.0) == 0.0) {
        return 0.0;
    }
    double before = 0.0;
    double after = 1.0;
    for (int i = 0; i < kHalvings; ++i) {
        const double middle = (before + after) / 2.0;
        (spacingTo(figures, a, along(a, b, middle), 0.0) == 0.0 ? after : before) = middle;
    }
    return after;
}

double sizeOf(const Box& box) {
    return std::hypot(static_cast<double>(box.width()), static_cast<double>(box.height()));
}

/// The part of a line of sight between two heights and inside of a box around the board, in steps; empty if first >
/// last.
struct ClippedRange {
    double first = 0.0;
    double last = std::numeric_limits<double>::infinity();

    void clip(double from, double step, double low, double high) {
        if (step == 0.0) {
            if (from < low || from > high) {
                last = -1.0;
            }
            return;
        }
        const double a = (low - from) / step;
        const double b = (high - from) / step;
        first = std::max(first, std::min(a, b));
        last = std::min(last, std::max(a, b));
    }
};

/// The part of a line of sight between two heights and within a box around the board.
ClippedRange partWithin(const SightLine& line, const Box& around, double low, double high) {
    ClippedRange range;
    range.clip(line.z, -line.down, low, high);
    range.clip(line.origin.x, line.direction.x, around.min.x, around.max.x);
    range.clip(line.origin.y, line.direction.y, around.min.y, around.max.y);
    if (line.cutSide) {
        const auto [at, outward] = *line.cutSide;
        range.clip((line.origin.x - at.x) * outward.x + (line.origin.y - at.y) * outward.y,
                   line.direction.x * outward.x + line.direction.y * outward.y,
                   -std::numeric_limits<double>::infinity(), 0.0);
    }
    return range;
}

}  // namespace

/// What is requested: a straight line over the board between two depths. Of a line of sight, the part within a layer.
struct Picker::Probe {
    PointD a;
    PointD b;
    double reach = 0.0;
    double depthA = 0.0;
    double depthB = 0.0;
    std::span<const PickLayer> layers;
    const SightLine* line = nullptr;  ///< nullptr: seen from straight above
    LayerId only = {};                ///< of a line of sight
    bool isMirrored = false;          ///< of `only`, what lies mirrored through the board

    /// Is an element of a layer of a copy, which lies on `onBoard`, looked for?
    [[nodiscard]] bool takes(const Document& step, LayerId own, LayerId onBoard, bool isFlipped) const {
        const bool isOther =
            only.isValid() && (onBoard != only || isMirroredInCopy(step, own, isFlipped) != isMirrored);
        return layers[onBoard.row()].isVisible && !isOther;
    }
    /// The part that passes the board between two heights; none if it does not.
    [[nodiscard]] std::optional<Probe> between(double low, double high) const {
        ClippedRange range{depthA, depthB};
        range.clip(line->z, -line->down, low, high);
        if (range.first > range.last) {
            return std::nullopt;
        }
        const double length = depthB - depthA;
        const auto at = [&](double depth) { return length > 0.0 ? model::along(a, b, (depth - depthA) / length) : a; };
        return Probe{at(range.first), at(range.last), reach, range.first, range.last, layers, line, only, isMirrored};
    }
};

std::pair<double, double> ElementHeights::on(const PickLayer& drawn) const {
    const double bottom = isMirrored ? drawn.faces - drawn.top : drawn.bottom;
    const double top = isMirrored ? drawn.faces - drawn.bottom : drawn.top;
    if (!body) {
        return {bottom, top};
    }
    return growsDown ? std::pair(top - *body, top) : std::pair(bottom, bottom + *body);
}

ElementHeights elementHeights(const Document& step, ElementId element, bool isFlipped) {
    const LayerId layer = step.elements.layer[element.row()];
    ElementHeights heights{isMirroredInCopy(step, layer, isFlipped)};
    if (const Body* body = step.bodyOf(element)) {
        heights.body = body->height;
        heights.growsDown = growsDownInCopy(step, layer, isFlipped);
    }
    return heights;
}

namespace {

bool hasBodies(const Layer& layer) {
    return layer.type == LayerType::ComponentBody;
}

/// Where what is on a layer may be drawn: bodies from both sides of a step stand on it where some copies are flipped,
/// and are as high as they are.
std::pair<double, double> heightsOf(const Document& board, LayerId id, bool isMirrored, const PickLayer& drawn) {
    const Layer& layer = board.layer(id);
    ElementHeights heights{isMirrored};
    if (hasBodies(layer)) {
        const Nm flipped = layer.opposite.isValid() ? board.layer(layer.opposite).thickness : 0;
        heights.body = std::max({double(layer.thickness), double(flipped), drawn.top - drawn.bottom});
        heights.growsDown = growsDownInCopy(board, id, isMirrored);
    }
    return heights.on(drawn);
}

}  // namespace

bool Picker::isHidden(std::uint32_t step, ElementId element) const {
    if (step >= m_hiddenNets.size()) {
        return false;
    }
    const NetId net = m_index->tree.steps[step]->elements.net[element.row()];
    return net.isValid() && net.row() < m_hiddenNets[step].size() && m_hiddenNets[step][net.row()];
}

void Picker::collect(const Probe& probe, std::vector<Hit>& hits) const {
    for (std::uint32_t copy = 0; copy < m_index->tree.copies.size(); ++copy) {
        const StepCopy& placed = m_index->tree.copies[copy];
        const Document& step = *m_index->tree.steps[placed.step];
        const Box box =
            boxAround(unplaced(probe.a, placed.placement), unplaced(probe.b, placed.placement), probe.reach);
        m_index->elements[placed.step].visit(box, [&](std::uint32_t row) {
            const ElementId element{row};
            const LayerId layer = step.layerOfCopy(step.elements.layer[row], placed.isFlipped);
            if (!probe.takes(step, step.elements.layer[row], layer, placed.isFlipped) ||
                isHidden(placed.step, element)) {
                return;
            }
            std::optional<Probe> own = probe;
            if (probe.line != nullptr && hasBodies(step.layer(layer))) {
                const auto [low, high] = elementHeights(step, element, placed.isFlipped).on(probe.layers[layer.row()]);
                own = probe.between(low, high);
            }
            if (!own) {
                return;
            }
            const PointD a = unplaced(own->a, placed.placement);
            const PointD b = unplaced(own->b, placed.placement);
            const std::shared_ptr<const FigureTable> figures = m_index->figuresOf(placed.step, element);
            const double missedBy = spacingTo(*figures, a, b, probe.reach);
            if (missedBy > probe.reach) {
                return;
            }
            const double part = missedBy > 0.0 || own->depthA == own->depthB ? 0.0 : firstContact(*figures, a, b);
            hits.push_back({{copy, element},
                            layer,
                            own->depthA + (own->depthB - own->depthA) * part,
                            missedBy,
                            sizeOf(step.boxOf(element)),
                            (step.elements.flags[row] & (kPad | kHole)) != 0});
        });
    }
}

namespace {

void sortHits(std::vector<Hit>& hits) {
    std::ranges::sort(hits, {}, [](const Hit& hit) {
        return std::tuple(hit.missedBy > 0.0, hit.depth, !hit.isPad, hit.size, hit.missedBy, hit.layer,
                          ~hit.at.element.value, hit.at.copy);
    });
}

}  // namespace

std::vector<Hit> Picker::at(PointD location, double reach, std::span<const PickLayer> layers, bool isFromBelow) const {
    std::vector<Hit> hits;
    collect({location, location, reach, 0.0, 0.0, layers}, hits);
    double nearest = isFromBelow ? std::numeric_limits<double>::infinity() : -std::numeric_limits<double>::infinity();
    for (const PickLayer& layer : layers) {
        nearest = isFromBelow ? std::min(nearest, layer.bottom) : std::max(nearest, layer.top);
    }
    for (Hit& hit : hits) {
        const StepCopy& copy = m_index->tree.copies[hit.at.copy];
        ElementHeights heights = elementHeights(m_index->stepOf(hit.at.copy), hit.at.element, copy.isFlipped);
        heights.body.reset();  // of bodies their layer counts
        const auto [bottom, top] = heights.on(layers[hit.layer.row()]);
        hit.depth = isFromBelow ? bottom - nearest : nearest - top;
    }
    sortHits(hits);
    return hits;
}

std::vector<Hit> Picker::along(const SightLine& line, double reach, std::span<const PickLayer> layers) const {
    Box around = m_index->board->extent;
    around.include(m_index->extents.front());
    around = around.grownBy(1'000'000);
    const bool hasFlipped = std::ranges::any_of(m_index->tree.copies, &StepCopy::isFlipped);
    std::vector<Hit> hits;
    const auto take = [&](LayerId layer, bool isMirrored) {
        const auto [low, high] = heightsOf(*m_index->board, layer, isMirrored, layers[layer.row()]);
        const ClippedRange range = partWithin(line, around, low, high);
        if (range.first > range.last || !std::isfinite(range.last)) {
            return;
        }
        const PointD end = {line.origin.x + line.direction.x, line.origin.y + line.direction.y};
        collect({model::along(line.origin, end, range.first), model::along(line.origin, end, range.last), reach,
                 range.first, range.last, layers, &line, layer, isMirrored},
                hits);
    };
    for (std::size_t row = 0; row < layers.size(); ++row) {
        if (layers[row].isVisible) {
            take(LayerId{row}, false);
        }
        if (layers[row].isVisible && hasFlipped && isMirroredInCopy(*m_index->board, LayerId{row}, true)) {
            take(LayerId{row}, true);
        }
    }
    sortHits(hits);
    return hits;
}

std::vector<BoardElement> Picker::inside(const Box& box, bool isTouching, std::span<const PickLayer> layers) const {
    const std::array<Point, 4> corners = {box.min, Point{box.max.x, box.min.y}, box.max, Point{box.min.x, box.max.y}};
    const auto holds = [&](const Box& other) {
        return other.min.x >= box.min.x && other.min.y >= box.min.y && other.max.x <= box.max.x &&
               other.max.y <= box.max.y;
    };
    std::vector<BoardElement> found;
    for (const CopyInBox& near : copiesIn(*m_index, box)) {
        const StepCopy& placed = m_index->tree.copies[near.copy];
        const Document& step = *m_index->tree.steps[placed.step];
        std::array<PointD, 4> sides;
        std::ranges::transform(corners, sides.begin(),
                               [&](Point corner) { return unplaced(base::toDouble(corner), placed.placement); });
        const auto touches = [&](const FigureTable& figures) {
            bool isTouched = false;
            for (std::size_t i = 0; i < sides.size() && !isTouched; ++i) {
                isTouched = spacingTo(figures, sides[i], sides[(i + 1) % sides.size()], 0.0) == 0.0;
            }
            return isTouched;
        };
        m_index->elements[placed.step].visit(near.box, [&](std::uint32_t row) {
            const LayerId layer = step.layerOfCopy(step.elements.layer[row], placed.isFlipped);
            const ElementId element{row};
            if (!layers[layer.row()].isVisible || isHidden(placed.step, element)) {
                return;
            }
            if (holds(placed.placement.boxOf(step.boxOf(element))) ||
                (isTouching && touches(*m_index->figuresOf(placed.step, element)))) {
                found.push_back({near.copy, element});
            }
        });
    }
    std::ranges::sort(found);
    return found;
}

}  // namespace model
