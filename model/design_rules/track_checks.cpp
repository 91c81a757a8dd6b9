#include "model/design_rules/track_checks.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "model/design_rules/bridged.h"
#include "model/figures/distance.h"
#include "model/geometry/vectors.h"

namespace model {

namespace {

constexpr double kMeetNm = 1000.0;                          ///< ends this near to a middle line meet it
constexpr double kAcute = 89.5 * std::numbers::pi / 180.0;  ///< right angles of rounded coordinates are none
constexpr double kAlong = 1.0 * std::numbers::pi / 180.0;   ///< less: they run along each other
constexpr double kBesideNotch = 2000.0;                     ///< nm, from its corner to where it must be open

bool isTrack(const RuleContext& context, ElementId element) {
    const Document& document = context.document();
    const ElementKind kind = document.elements.kind[element.row()];
    return kind != ElementKind::Area && kind != ElementKind::Circle && !context.isLand(element) &&
           !context.isAway(element);
}

/// Across the narrowest edge of a track, in its middle.
Spacing narrowestOf(std::span<const Edge> edges) {
    const Edge& edge = *std::ranges::min_element(edges, {}, &Edge::pen);
    const double half = lengthOf(edge) / 2;
    const PointD middle = pointAt(edge, half);
    const PointD ahead = pointAt(edge, half + 1000.0);
    const double length = std::hypot(ahead.x - middle.x, ahead.y - middle.y);
    const PointD across =
        length > 0 ? PointD{-(ahead.y - middle.y) / length, (ahead.x - middle.x) / length} : PointD{0.0, 1.0};
    return {2 * edge.pen,
            {middle.x - across.x * edge.pen, middle.y - across.y * edge.pen},
            {middle.x + across.x * edge.pen, middle.y + across.y * edge.pen}};
}

/// Of the copper that an axis-parallel square pen leaves along a line, in the middle of the line.
Spacing acrossSquarePen(const LineGeometry& line) {
    const PointD a = base::toDouble(line.a);
    const PointD b = base::toDouble(line.b);
    const double length = distance(a, b);
    const PointD along = length > 0 ? PointD{(b.x - a.x) / length, (b.y - a.y) / length} : PointD{1.0, 0.0};
    const double width = static_cast<double>(line.width) * (std::abs(along.x) + std::abs(along.y));
    const PointD middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
    return {width,
            {middle.x + along.y * width / 2, middle.y - along.x * width / 2},
            {middle.x - along.y * width / 2, middle.y + along.x * width / 2}};
}

Spacing acrossTrack(const Document& document, const LayerGeometry& tracks, std::uint32_t row) {
    const bool hasSquarePen = tracks.figures()[row].isFilled;
    return hasSquarePen ? acrossSquarePen(document.lines[document.elements.geometry[tracks.elementOf(row).row()]])
                        : narrowestOf(tracks.figures().edges(row));
}

/// An edge of a track that leaves a point.
struct Arm {
    PointD direction;     ///< of length 1, away from the point
    double length = 0.0;  ///< nm
    double pen = 0.0;
    const Edge* edge = nullptr;
    double start = 0.0;  ///< of the point, along the edge
    bool isOnwards = true;

    /// So far from the point, along the middle line.
    [[nodiscard]] PointD at(double along) const { return pointAt(*edge, isOnwards ? start + along : start - along); }
};

/// The edge from `along` nm after its start, onwards or back.
Arm armOf(const Edge& edge, double along, bool isOnwards) {
    const double length = lengthOf(edge);
    const double step = std::min(1000.0, length / 4);
    const PointD from = pointAt(edge, along);
    const PointD to = pointAt(edge, along + (isOnwards ? step : -step));
    const double d = std::max(distance(from, to), 1e-9);
    return {{(to.x - from.x) / d, (to.y - from.y) / d},
            isOnwards ? length - along : along,
            edge.pen,
            &edge,
            along,
            isOnwards};
}

/// The arms of an edge that leave a point on it: one at its ends, two in between.
std::vector<Arm> armsAt(const Edge& edge, PointD p) {
    if (edge.isFullCircle() || distance(nearestOn(edge, p), p) > kMeetNm) {
        return {};
    }
    const double length = lengthOf(edge);
    if (length <= kMeetNm) {
        return {};
    }
    const double along = std::clamp(lengthTo(edge, nearestOn(edge, p)), 0.0, length);
    std::vector<Arm> arms;
    if (length - along > kMeetNm) {
        arms.push_back(armOf(edge, along, true));
    }
    if (along > kMeetNm) {
        arms.push_back(armOf(edge, along, false));
    }
    return arms;
}

/// Where on the middle line of an arm another arm is nearest; none beyond its end.
std::optional<PointD> nearestOnArm(const Arm& arm, PointD p) {
    const PointD nearest = nearestOn(*arm.edge, p);
    const double along = (lengthTo(*arm.edge, nearest) - arm.start) * (arm.isOnwards ? 1.0 : -1.0);
    return along > 0 && along < arm.length ? std::optional(nearest) : std::nullopt;
}

/// A location between two tracks that is as far from the one as from the other.
struct Opening {
    PointD middle;
    double aside = 0.0;  ///< so far, nm; negative: the tracks overlap there
};

/// So far along the first arm; none beyond the end of the second one.
std::optional<Opening> openingAt(const Arm& a, const Arm& b, double along) {
    constexpr int kHalves = 24;
    const auto beside = [](const Arm& arm, PointD p) { return distance(nearestOn(*arm.edge, p), p) - arm.pen; };
    PointD near = a.at(along);
    const std::optional<PointD> other = nearestOnArm(b, near);
    if (!other) {
        return std::nullopt;
    }
    PointD far = *other;
    Opening opening;
    for (int i = 0; i < kHalves; ++i) {
        opening.middle = {(near.x + far.x) / 2, (near.y + far.y) / 2};
        opening.aside = beside(a, opening.middle);
        (opening.aside < beside(b, opening.middle) ? near : far) = opening.middle;
    }
    return opening;
}

/// The same as notchOf where one of the tracks is an arc, which may bend towards the other one: where they first open,
/// step by step, then by halves.
std::optional<PointD> notchOfBent(const Arm& a, const Arm& b) {
    constexpr double kSteps = 8.0;  // to the width of the narrower track
    constexpr int kHalves = 24;
    const double step = std::max(2 * std::min(a.pen, b.pen) / kSteps, kBesideNotch);
    const auto openAt = [&](double along) {
        const std::optional<Opening> opening = openingAt(a, b, along);
        return opening && opening->aside >= kBesideNotch / 2 ? std::optional(opening->middle) : std::nullopt;
    };
    for (double along = step; along < a.length; along += step) {
        std::optional<PointD> notch = openAt(along);
        double closed = along - step;
        for (int i = 0; notch && i < kHalves; ++i) {
            const double middle = (closed + along) / 2;
            const std::optional<PointD> nearer = openAt(middle);
            notch = nearer ? nearer : notch;
            (nearer ? along : closed) = middle;
        }
        if (notch) {
            return notch;
        }
    }
    return std::nullopt;
}

/// A point just beside the inner corner of two tracks, in the notch; none if they leave no notch.
std::optional<PointD> notchOf(PointD p, const Arm& a, const Arm& b) {
    const double cosine = std::clamp(a.direction.x * b.direction.x + a.direction.y * b.direction.y, -1.0, 1.0);
    const double angle = std::acos(cosine);
    if (angle >= kAcute || angle <= kAlong) {
        return std::nullopt;
    }
    if (a.edge->isArc() || b.edge->isArc()) {
        return notchOfBent(a, b);
    }
    const double along = (b.pen + a.pen * cosine) / std::sin(angle);  // to the inner corner, on either track
    const double alongB = (a.pen + b.pen * cosine) / std::sin(angle);
    if (along + kBesideNotch >= a.length || alongB + kBesideNotch >= b.length) {
        return std::nullopt;
    }
    const double turn = a.direction.x * b.direction.y - a.direction.y * b.direction.x > 0 ? 1.0 : -1.0;
    const PointD corner{p.x + a.direction.x * along - turn * a.direction.y * a.pen,
                        p.y + a.direction.y * along + turn * a.direction.x * a.pen};
    const double away = distance(corner, p);
    const double further = away > 0 ? (away + kBesideNotch) / away : 1.0;
    return PointD{p.x + (corner.x - p.x) * further, p.y + (corner.y - p.y) * further};
}

/// Where an end of one figure's edges meets another figure at an acute angle, with an open notch.
class AcuteAngles {
public:
    AcuteAngles(RuleContext& context, const LayerGeometry& copper) : m_context(context), m_copper(copper) {}

    [[nodiscard]] std::optional<PointD> between(std::uint32_t a, std::uint32_t b) const {
        for (const auto& [ends, other] : {std::pair(a, b), std::pair(b, a)}) {
            for (const Edge& edge : m_copper.figures().edges(ends)) {
                for (const PointD end : {edge.a, edge.b}) {
                    if (meetsAcutely(edge, other, end, ends == other)) {
                        return end;
                    }
                }
            }
            if (a == b) {
                break;
            }
        }
        return std::nullopt;
    }

private:
    [[nodiscard]] bool meetsAcutely(const Edge& edge, std::uint32_t other, PointD at, bool isOwn) const {
        bool isFound = false;
        FigureTable end;
        end.addTrack(at, at, kMeetNm);
        visitEdges(m_copper.figures(), other, end.box(0), [&](const Edge& second) {
            if (isFound || (isOwn && &second == &edge)) {
                return;
            }
            for (const Arm& a : armsAt(edge, at)) {
                for (const Arm& b : armsAt(second, at)) {
                    const std::optional<PointD> notch = notchOf(at, a, b);
                    isFound = isFound || (notch && isOpen(other, *notch));
                }
            }
        });
        return isFound;
    }

    /// No copper of the net there, the two tracks' own included.
    [[nodiscard]] bool isOpen(std::uint32_t row, PointD notch) const {
        const std::uint32_t owner = m_context.owners().of(m_copper.elementOf(row));
        return !isCovered(m_copper, notch, [&](std::uint32_t other) {
            return m_context.owners().of(m_copper.elementOf(other)) == owner;
        });
    }

    RuleContext& m_context;
    const LayerGeometry& m_copper;
};

/// Angles are those of round pens alone.
void reportSquarePens(RuleContext& context, LayerId layer, const LayerGeometry& copper) {
    std::map<std::size_t, std::size_t> counts;  // by rule
    for (std::uint32_t row = 0; row < copper.size(); ++row) {
        const ElementId element = copper.elementOf(row);
        const bool isMissed = isTrack(context, element) && copper.figures()[row].isFilled;
        const auto rule = context.choice().of(RuleKind::AcuteAngle, layer, context.partyOf(element));
        if (isMissed && rule && context.netOf(element).isValid()) {
            ++counts[*rule];
        }
    }
    for (const auto& [rule, count] : counts) {
        context.report().unchecked.push_back({rule, count, count == 1 ? "track" : "tracks",
                                              "drawn with a square pen on layer " +
                                                  context.document().layer(layer).name +
                                                  ", whose angles are not looked at"});
    }
}

/// What is narrower than its rule asks tracks to be.
class NarrowTracks {
public:
    NarrowTracks(RuleContext& context, LayerId layer) : m_context(context), m_layer(layer) {}

    void add(std::size_t rule, ElementId element, const Spacing& across) {
        const RuleTable& table = m_context.table();
        if (!isBroken(table.rules[rule], table.tolerance, across.distance)) {
            return;
        }
        if (isDrawing(element)) {
            ++m_drawings;
        } else {
            m_context.add(rule, m_layer, element, {}, across, FindingReason::TooNarrow);
        }
    }

    void report() const {
        if (m_drawings > 0) {
            m_context.report().notes.push_back(
                std::to_string(m_drawings) + (m_drawings == 1 ? " line" : " lines") +
                " of texts or of no net on layer " + m_context.document().layer(m_layer).name +
                (m_drawings == 1 ? " is" : " are") + " narrower than tracks may be, and no tracks");
        }
    }

private:
    [[nodiscard]] bool isDrawing(ElementId element) {
        const Document& document = m_context.document();
        const bool isOfNoNet = !document.nets.empty() && !m_context.netOf(element).isValid();
        return isOfNoNet || m_context.textStrokes()[element.row()];
    }

    RuleContext& m_context;
    LayerId m_layer;
    std::size_t m_drawings = 0;
};

}  // namespace

void checkTrackWidths(RuleContext& context, LayerId layer) {
    if (!context.isWanted(RuleKind::TrackWidth, layer)) {
        return;
    }
    const LayerGeometry tracks =
        layerGeometry(context.document(), layer, [&](ElementId element) { return isTrack(context, element); });
    NarrowTracks narrow(context, layer);
    for (std::uint32_t row = 0; row < tracks.size(); ++row) {
        const ElementId element = tracks.elementOf(row);
        const auto rule = context.choice().of(RuleKind::TrackWidth, layer, context.partyOf(element));
        if (rule) {
            narrow.add(*rule, element, acrossTrack(context.document(), tracks, row));
        }
    }
    narrow.report();
}

void checkAcuteAngles(RuleContext& context, LayerId layer, const LayerGeometry& copper) {
    if (!context.isWanted(RuleKind::AcuteAngle, layer)) {
        return;
    }
    const AcuteAngles angles(context, copper);
    const auto isWanted = [&](std::uint32_t row) {
        return isTrack(context, copper.elementOf(row)) && !copper.figures()[row].isFilled &&
               context.netOf(copper.elementOf(row)).isValid();
    };
    const auto addAt = [&](std::uint32_t a, std::uint32_t b) {
        const auto rule = context.choice().of(RuleKind::AcuteAngle, layer, context.partyOf(copper.elementOf(a)));
        const std::optional<PointD> at = rule ? angles.between(a, b) : std::nullopt;
        if (at) {
            context.add({*rule,
                         layer,
                         copper.elementOf(a),
                         a == b ? ElementId{} : copper.elementOf(b),
                         {0.0, *at, *at},
                         FindingReason::AcuteAngle});
        }
    };
    PairRequest request;
    request.reach = kTouchNm;
    request.isWanted = [&](std::uint32_t a, std::uint32_t b) {
        return isWanted(a) && isWanted(b) && context.netOf(copper.elementOf(a)) == context.netOf(copper.elementOf(b));
    };
    for (const FigurePair& pair : closestPairs(copper, copper, request, context.progress())) {
        addAt(pair.a, pair.b);
    }
    for (std::uint32_t row = 0; row < copper.size(); ++row) {
        if (isWanted(row) && copper.figures().edges(row).size() > 1) {
            addAt(row, row);
        }
    }
    reportSquarePens(context, layer, copper);
}

}  // namespace model
