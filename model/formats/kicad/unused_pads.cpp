#include "model/formats/kicad/unused_pads.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <numeric>
#include <utility>

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
    std::vector<std::pair<Point, std::int32_t>> ends;  // by x, with their nets
    const auto& features = m_canvas.step().features;
    if (static_cast<std::size_t>(row) < features.size()) {
        for (const formats::DrawnFeature& feature : features[static_cast<std::size_t>(row)]) {
            if (feature.subnet == SubnetKind::Trace) {
                ends.emplace_back(feature.a, feature.net);
                ends.emplace_back(feature.b, feature.net);
            }
        }
    }
    std::ranges::sort(ends);
    for (const Waiting& pad : pads) {
        bool isConnected = pad.reach < 0.0 || isTouched(pad);
        const Point from{asNm(pad.at.x - pad.reach), std::numeric_limits<Nm>::min()};
        for (auto end = std::ranges::lower_bound(ends, std::pair(from, std::numeric_limits<std::int32_t>::min()));
             !isConnected && end != ends.end() && end->first.x <= pad.at.x + pad.reach; ++end) {
            isConnected = end->second == pad.origin.net &&
                          std::hypot(end->first.x - pad.at.x, end->first.y - pad.at.y) <= pad.reach;
        }
        if (isConnected) {
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
