#include "model/formats/kicad/unused_pads.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <numbers>
#include <numeric>
#include <optional>
#include <span>
#include <utility>

#include "model/geometry/box_index.h"
#include "model/geometry/edges.h"
#include "model/geometry/loops/region_booleans.h"
#include "model/geometry/loops/region_search.h"
#include "model/geometry/vectors.h"

namespace model::kicad {

namespace {

using Owner = UnusedPads::Owner;

bool isOn(const Owner& owner, std::int32_t row) {
    return std::ranges::find(owner.rows, row) != owner.rows.end();
}

/// Has it its copper on a row of its own in any case?
bool hasCopper(const Owner& owner, std::int32_t row) {
    return !owner.waits || (owner.keepsEnds && (row == owner.rows.front() || row == owner.rows.back()));
}

/// From a point to the rectangle that the copper of an owner lies
/// around.
double distanceToCore(PointD from, const Owner& owner) {
    const double turn = owner.clockwiseDeg * std::numbers::pi / 180.0;
    const PointD d{from.x - owner.at.x, from.y - owner.at.y};
    const double along = std::abs(d.x * std::cos(turn) - d.y * std::sin(turn));
    const double across = std::abs(d.x * std::sin(turn) + d.y * std::cos(turn));
    return std::hypot(std::max(along - owner.core.x, 0.0), std::max(across - owner.core.y, 0.0));
}

/// On a row that both are on. The first is taken for round.
bool touchOn(std::int32_t row, const Owner& a, const Owner& b) {
    const double ours = hasCopper(a, row) ? a.radius : a.hole;
    const double apart =
        hasCopper(b, row) ? distanceToCore(a.at, b) - b.radius : std::hypot(a.at.x - b.at.x, a.at.y - b.at.y) - b.hole;
    return apart <= ours;
}

bool touch(const Owner& a, const Owner& b) {
    return std::ranges::any_of(a.rows, [&](std::int32_t row) { return isOn(b, row) && touchOn(row, a, b); });
}

/// How far from its middle the copper of an owner may be.
double farthestOf(const Owner& owner) {
    return std::hypot(owner.core.x, owner.core.y) + owner.radius;
}

std::span<const formats::DrawnFeature> featuresOn(const formats::DrawnStep& step, std::int32_t row) {
    const auto layer = static_cast<std::size_t>(row);
    return layer < step.features.size() ? std::span<const formats::DrawnFeature>(step.features[layer])
                                        : std::span<const formats::DrawnFeature>();
}

/// Those of a layer.
class Tracks {
public:
    Tracks(const formats::DrawnStep& step, std::int32_t row) : m_index(take(step, row)) {}

    /// As KiCad has it: does one end on the pad, or run over its middle?
    [[nodiscard]] bool keep(const UnusedPads::Waiting& pad) const {
        bool isKept = false;
        m_index.visit(boxAround(pad.at, pad.reach), [&](std::uint32_t i) {
            const Edge& edge = m_edges[i];
            const double ends = std::min(distance(edge.a, pad.at), distance(edge.b, pad.at));
            isKept = isKept || (m_nets[i] == pad.origin.net &&
                                (ends <= pad.reach || distance(nearestOn(edge, pad.at), pad.at) <= edge.pen));
        });
        return isKept;
    }

private:
    /// Gives back the boxes of the tracks.
    std::vector<Box> take(const formats::DrawnStep& step, std::int32_t row) {
        std::vector<Box> boxes;
        for (const formats::DrawnFeature& feature : featuresOn(step, row)) {
            if (feature.subnet == SubnetKind::Trace) {
                const EdgeKind kind = feature.kind != formats::DrawnKind::Arc ? EdgeKind::Line
                                      : feature.isClockwise                   ? EdgeKind::ArcClockwise
                                                                              : EdgeKind::ArcCounterClockwise;
                Edge& edge = m_edges.emplace_back(edgeOf({feature.a, feature.centre, kind}, feature.b));
                edge.pen = step.symbols[static_cast<std::size_t>(feature.symbol)].shape.width / 2.0;
                m_nets.push_back(feature.net);
                boxes.push_back(boxOf(edge));
            }
        }
        return boxes;
    }

    std::vector<Edge> m_edges;
    std::vector<std::int32_t> m_nets;  ///< of each
    BoxIndex m_index;
};

/// What zones fill on a layer.
class Fills {
public:
    Fills(const formats::DrawnStep& step, std::int32_t row) : m_index(take(step, row)) {}

    /// Does one of its net come within `reach` of the middle of the pad?
    [[nodiscard]] bool keep(const UnusedPads::Waiting& pad, double reach) const {
        bool isKept = false;
        const Box box = boxAround(pad.at, reach);
        m_index.visit(box, [&](std::uint32_t i) {
            if (isKept || pad.origin.net == formats::kNoRow || m_nets[i] != pad.origin.net) {
                return;
            }
            isKept = m_fills[i].holds(pad.at);
            m_fills[i].visitNear(
                box, [&](const Edge& edge) { isKept = isKept || distance(nearestOn(edge, pad.at), pad.at) <= reach; });
        });
        return isKept;
    }

private:
    /// Gives back the boxes of the fills.
    std::vector<Box> take(const formats::DrawnStep& step, std::int32_t row) {
        std::vector<Box> boxes;
        for (const formats::DrawnFeature& feature : featuresOn(step, row)) {
            if (feature.subnet != SubnetKind::Plane || feature.kind != formats::DrawnKind::Region) {
                continue;
            }
            for (EdgeLoops& region : regionsOf(step.regions[static_cast<std::size_t>(feature.region)])) {
                boxes.push_back(m_fills.emplace_back(std::move(region)).box());
                m_nets.push_back(feature.net);
            }
        }
        return boxes;
    }

    std::vector<RegionSearch> m_fills;
    std::vector<std::int32_t> m_nets;  ///< of each
    BoxIndex m_index;
};

}  // namespace

std::size_t UnusedPads::add(Owner owner) {
    m_farthest = std::max(m_farthest, farthestOf(owner));
    m_owners.push_back(std::move(owner));
    return m_owners.size() - 1;
}

void UnusedPads::draw() {
    m_byNet.resize(m_owners.size());
    std::iota(m_byNet.begin(), m_byNet.end(), std::size_t{0});
    std::ranges::sort(m_byNet, {}, [this](std::size_t i) { return std::pair(m_owners[i].net, m_owners[i].at.x); });
    std::vector<std::int32_t> rows;
    for (const Waiting& waiting : m_waiting) {
        rows.push_back(waiting.row);
    }
    std::ranges::sort(rows);
    rows.erase(std::unique(rows.begin(), rows.end()), rows.end());
    for (const std::int32_t row : rows) {
        std::vector<Waiting> pads;
        std::ranges::copy_if(m_waiting, std::back_inserter(pads), [&](const Waiting& w) { return w.row == row; });
        drawOn(row, pads);
    }
    m_waiting.clear();
}

void UnusedPads::drawOn(std::int32_t row, const std::vector<Waiting>& pads) {
    const Tracks tracks(m_canvas.step(), row);
    std::optional<Fills> fills;
    if (m_canvas.settings().keepsPadsInFills()) {
        fills.emplace(m_canvas.step(), row);
    }
    for (const Waiting& pad : pads) {
        const Owner& owner = m_owners[pad.owner];
        const double least = std::min(owner.core.x, owner.core.y) + owner.radius;
        if (pad.reach < 0.0 || tracks.keep(pad) || isTouched(pad) || (fills && fills->keep(pad, least))) {
            m_canvas.drawPad(row, pad.origin, pad.symbol, pad.at, pad.clockwiseDeg);
        }
    }
}

/// As KiCad has it: not by pads of its own footprint, and of two pads not by one whose copper waits too.
bool UnusedPads::isTouched(const Waiting& pad) const {
    const Owner& own = m_owners[pad.owner];
    const double reach = farthestOf(own) + m_farthest;
    const auto key = [this](std::size_t i) { return std::pair(m_owners[i].net, m_owners[i].at.x); };
    for (auto i = std::ranges::lower_bound(m_byNet, std::pair(own.net, own.at.x - reach), {}, key);
         i != m_byNet.end() && key(*i) <= std::pair(own.net, own.at.x + reach); ++i) {
        const Owner& other = m_owners[*i];
        const bool isSibling = own.component != formats::kNoRow && own.component == other.component;
        const bool doBothWait = own.isPad && other.isPad && own.waits && other.waits;
        const double most = farthestOf(own) + farthestOf(other);
        const bool isFar = std::abs(other.at.x - own.at.x) > most || std::abs(other.at.y - own.at.y) > most;
        if (!isFar && *i != pad.owner && own.net != formats::kNoRow && !isSibling && !doBothWait &&
            isOn(other, pad.row) && touch(own, other)) {
            return true;
        }
    }
    return false;
}

}  // namespace model::kicad
