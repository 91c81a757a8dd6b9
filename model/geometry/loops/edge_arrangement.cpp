#include "model/geometry/loops/edge_arrangement.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <tuple>

#include "model/geometry/box_pairs.h"
#include "model/geometry/loops/edge_meetings.h"
#include "model/geometry/vectors.h"

namespace model {

namespace {

constexpr double kCellNm = 64.0;
/// Vertices and edges nearer to an edge than this part of the snap are on it: below √½, so that what is cut there is
/// not cut at its other vertices in turn.
constexpr double kTouch = 0.625;
constexpr double kSame = 0.5;    ///< fragments between the same vertices nearer than this part of the snap are one
constexpr double kFlatNm = 0.1;  ///< arcs this near to their chord are lines
constexpr double kShortestArcNm = 8.0;
constexpr int kMostRounds = 12;
constexpr std::uint32_t kNone = std::numeric_limits<std::uint32_t>::max();
constexpr std::array<PointD, 4> kAxes{{{1, 0}, {0, 1}, {-1, 0}, {0, -1}}};

std::uint64_t cellKey(double x, double y) {
    const auto column = static_cast<std::uint64_t>(static_cast<std::int64_t>(x));
    const auto row = static_cast<std::uint64_t>(static_cast<std::int64_t>(y));
    return column << 32 ^ (row & 0xffffffffu);
}

/// The axis that comes next after a direction, counter-clockwise.
std::size_t nextAxis(PointD v) {
    if (v.x > 0 && v.y >= 0) {
        return 1;
    }
    if (v.x <= 0 && v.y > 0) {
        return 2;
    }
    return v.x < 0 ? 3 : 0;
}

/// An arc that starts at an extreme has left it: coming round to it, it would run through its whole circle once more.
bool isAlong(PointD v, PointD axis) {
    return cross(v, axis) == 0 && dot(v, axis) > 0;
}

Box boxAroundEdge(const Edge& edge, double reach) {
    const auto [left, right] = std::minmax(edge.a.x, edge.b.x);
    const auto [lower, upper] = std::minmax(edge.a.y, edge.b.y);
    return {{toNm(left - reach), toNm(lower - reach)}, {toNm(right + reach), toNm(upper + reach)}};
}

}  // namespace

Edge arcThrough(PointD a, PointD b, const EdgeArrangement::Circle& circle, bool isClockwise) {
    Edge edge;
    edge.a = a;
    edge.b = b;
    const PointD chord = minus(b, a);
    const double squared = dot(chord, chord);
    if (squared < 8 * kFlatNm * circle.radius || squared < kShortestArcNm * kShortestArcNm) {
        return edge;
    }
    const PointD middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
    const double along = dot(minus(circle.centre, middle), chord) / squared;
    edge.centre = {circle.centre.x - along * chord.x, circle.centre.y - along * chord.y};
    edge.radius = length(minus(a, edge.centre));
    edge.isClockwise = isClockwise;
    return edge;
}

void EdgeArrangement::add(const EdgeLoops& region, int count) {
    for (std::size_t i = 0; i < region.loopCount(); ++i) {
        addLoop(region.loop(i), count);
    }
}

/// A point is looked up once, as the end of an edge: with more vertices around, another one may be the nearest.
void EdgeArrangement::addLoop(std::span<const Edge> loop, int count) {
    const std::uint32_t first = vertexAt(loop.front().a);
    std::uint32_t from = first;
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const std::uint32_t to = i + 1 == loop.size() ? first : vertexAt(loop[i].b);
        if (loop[i].isArc()) {
            addArc(loop[i], from, to, count);
        } else {
            addFragment(from, to, kLine, count);
        }
        from = to;
    }
}

/// All in one direction, so that counts of what covers each other do not add up to 0: arcs counter-clockwise, lines
/// towards one side of a direction across which nobody draws.
void EdgeArrangement::addEdge(const Edge& edge) {
    constexpr PointD kAhead{1.0, 0.3217};
    const bool isForward = edge.isArc() ? !edge.isClockwise : dot(minus(edge.b, edge.a), kAhead) >= 0.0;
    const Edge ahead = isForward ? edge : reversed(edge);
    const std::uint32_t from = vertexAt(ahead.a);
    const std::uint32_t to = vertexAt(ahead.b);
    ahead.isArc() ? addArc(ahead, from, to, 1) : addFragment(from, to, kLine, 1);
}

/// Counter-clockwise, whatever its sense.
void EdgeArrangement::addArc(const Edge& arc, std::uint32_t from, std::uint32_t to, int count) {
    if (arc.isClockwise) {
        return addArc(reversed(arc), to, from, -count);
    }
    const auto circle = static_cast<std::int32_t>(m_circles.size());
    m_circles.push_back({arc.centre, arc.radius});
    const PointD out = minus(arc.a, arc.centre);
    std::size_t axis = nextAxis(out);
    for (int i = 0; i < 4 && !isAlong(out, kAxes[axis]) && passes(arc, kAxes[axis]); ++i, axis = (axis + 1) % 4) {
        const std::uint32_t extreme =
            vertexAt({arc.centre.x + kAxes[axis].x * arc.radius, arc.centre.y + kAxes[axis].y * arc.radius});
        addFragment(from, extreme, circle, count);
        from = extreme;
    }
    addFragment(from, to, circle, count);
}

void EdgeArrangement::addFragment(std::uint32_t a, std::uint32_t b, std::int32_t circle, int count) {
    if (a != b) {
        m_fragments.push_back({a, b, circle, false, true, count});
    }
}

std::uint32_t EdgeArrangement::vertexAt(PointD p) {
    std::uint32_t nearest = kNone;
    double least = m_snapNm * m_snapNm;
    for (double x = std::floor((p.x - m_snapNm) / kCellNm); x * kCellNm <= p.x + m_snapNm; ++x) {
        for (double y = std::floor((p.y - m_snapNm) / kCellNm); y * kCellNm <= p.y + m_snapNm; ++y) {
            const auto cell = m_cells.find(cellKey(x, y));
            for (std::uint32_t v = cell == m_cells.end() ? kNone : cell->second; v != kNone; v = m_before[v]) {
                const PointD delta = minus(m_vertices[v], p);
                if (dot(delta, delta) < least) {
                    least = dot(delta, delta);
                    nearest = v;
                }
            }
        }
    }
    if (nearest != kNone) {
        return nearest;
    }
    const auto vertex = static_cast<std::uint32_t>(m_vertices.size());
    const auto [cell, isNew] =
        m_cells.try_emplace(cellKey(std::floor(p.x / kCellNm), std::floor(p.y / kCellNm)), kNone);
    m_vertices.push_back(p);
    m_before.push_back(cell->second);
    cell->second = vertex;
    return vertex;
}

Edge EdgeArrangement::edgeOf(const Fragment& fragment) const {
    const PointD a = m_vertices[fragment.a];
    const PointD b = m_vertices[fragment.b];
    if (fragment.circle != kLine) {
        return arcThrough(a, b, circle(fragment.circle), fragment.isClockwise);
    }
    Edge edge;
    edge.a = a;
    edge.b = b;
    return edge;
}

/// How far its middle lies to the right of its chord.
double EdgeArrangement::bulgeOf(const Fragment& fragment) const {
    const Edge edge = edgeOf(fragment);
    if (!edge.isArc()) {
        return 0.0;
    }
    const double half = distance(edge.a, edge.b) / 2;
    const double squared = (edge.radius - half) * (edge.radius + half);
    const double bulge = edge.radius - std::sqrt(std::max(squared, 0.0));
    return edge.isClockwise ? -bulge : bulge;
}

void EdgeArrangement::mergeEqual() {
    struct Keyed {
        Fragment fragment;
        double bulge;
        std::uint32_t row;
    };
    std::vector<Keyed> all;
    all.reserve(m_fragments.size());
    for (Fragment fragment : m_fragments) {
        if (fragment.a > fragment.b) {
            std::swap(fragment.a, fragment.b);
            fragment.isClockwise = !fragment.isClockwise;
            fragment.count = -fragment.count;
        }
        all.push_back({fragment, bulgeOf(fragment), static_cast<std::uint32_t>(all.size())});
    }
    std::ranges::sort(all, {}, [](const Keyed& k) { return std::tuple(k.fragment.a, k.fragment.b, k.bulge, k.row); });
    m_fragments.clear();
    for (std::size_t i = 0; i < all.size();) {
        Fragment kept = all[i].fragment;
        std::size_t next = i + 1;
        for (; next < all.size() && all[next].fragment.a == kept.a && all[next].fragment.b == kept.b &&
               all[next].bulge - all[i].bulge < kSame * m_snapNm;
             ++next) {
            kept.count += all[next].fragment.count;
            kept.isNew = kept.isNew || all[next].fragment.isNew;
        }
        if (kept.count != 0) {
            m_fragments.push_back(kept);
        }
        i = next;
    }
}

bool EdgeArrangement::settle() {
    mergeEqual();
    for (int round = 0; round < kMostRounds; ++round) {
        findCuts();
        if (m_cuts.empty()) {
            return true;
        }
        applyCuts();
        mergeEqual();
    }
    return false;
}

void EdgeArrangement::findCuts() {
    m_cuts.clear();
    m_edges.clear();
    std::vector<Box> boxes;
    boxes.reserve(m_fragments.size());
    m_edges.reserve(m_fragments.size());
    for (const Fragment& fragment : m_fragments) {
        m_edges.push_back(edgeOf(fragment));
        boxes.push_back(boxAroundEdge(m_edges.back(), m_snapNm + 1.0));
    }
    visitPairs(
        boxes, [&](std::uint32_t row) { return m_fragments[row].isNew; },
        [&](std::uint32_t i, std::uint32_t j) { compare(i, j); });
}

void EdgeArrangement::compare(std::uint32_t i, std::uint32_t j) {
    const Fragment& e = m_fragments[i];
    const Fragment& f = m_fragments[j];
    const auto isEnd = [](const Fragment& fragment, std::uint32_t v) { return fragment.a == v || fragment.b == v; };
    if (isEnd(e, f.a) && isEnd(e, f.b)) {
        return;
    }
    for (const std::uint32_t v : {f.a, f.b}) {
        if (!isEnd(e, v)) {
            cutWhereNear(i, v);
        }
    }
    for (const std::uint32_t v : {e.a, e.b}) {
        if (!isEnd(f, v)) {
            cutWhereNear(j, v);
        }
    }
    const Meetings meetings = meetingsOf(m_edges[i], m_edges[j]);
    for (int k = 0; k < meetings.count; ++k) {
        const PointD p = meetings.at[static_cast<std::size_t>(k)];
        const std::uint32_t vertex = vertexAt(p);
        cutAt(i, vertex);
        cutAt(j, vertex);
    }
    if (meetings.count == 0 && (m_edges[i].isArc() || m_edges[j].isArc())) {
        cutWhereClosest(i, j);
    }
}

/// Circles that nearly touch, between their ends.
void EdgeArrangement::cutWhereClosest(std::uint32_t i, std::uint32_t j) {
    const Edge& e = m_edges[i];
    const Edge& f = m_edges[j];
    const Spacing spacing = spacingBetween(e, f);
    if (spacing.distance > kTouch * m_snapNm) {
        return;
    }
    const PointD p{(spacing.from.x + spacing.to.x) / 2, (spacing.from.y + spacing.to.y) / 2};
    const std::uint32_t vertex = vertexAt(p);
    cutAt(i, vertex);
    cutAt(j, vertex);
}

void EdgeArrangement::cutWhereNear(std::uint32_t fragment, std::uint32_t vertex) {
    const Edge& edge = m_edges[fragment];
    const PointD p = m_vertices[vertex];
    if (edge.isArc()) {
        const PointD v = minus(p, edge.centre);
        if (std::abs(length(v) - edge.radius) < kTouch * m_snapNm && passes(edge, v)) {
            cutAt(fragment, vertex);
        }
        return;
    }
    const PointD delta = minus(edge.b, edge.a);
    const double side = cross(delta, minus(p, edge.a));
    if (side * side < kTouch * kTouch * m_snapNm * m_snapNm * dot(delta, delta)) {
        cutAt(fragment, vertex);
    }
}

void EdgeArrangement::cutAt(std::uint32_t fragment, std::uint32_t vertex) {
    const Edge& edge = m_edges[fragment];
    const PointD chord = minus(edge.b, edge.a);
    const double along = dot(minus(m_vertices[vertex], edge.a), chord) / dot(chord, chord);
    if (along > 0 && along < 1 && vertex != m_fragments[fragment].a && vertex != m_fragments[fragment].b) {
        m_cuts.push_back({fragment, along, vertex});
    }
}

void EdgeArrangement::applyCuts() {
    std::ranges::sort(m_cuts, {}, [](const Cut& cut) { return std::tuple(cut.fragment, cut.along, cut.vertex); });
    const std::vector<Fragment> whole = std::move(m_fragments);
    m_fragments.clear();
    auto cut = m_cuts.cbegin();
    for (std::uint32_t i = 0; i < whole.size(); ++i) {
        Fragment piece = whole[i];
        piece.isNew = cut != m_cuts.cend() && cut->fragment == i;
        for (; cut != m_cuts.cend() && cut->fragment == i; ++cut) {
            if (cut->vertex != piece.a) {
                piece.b = cut->vertex;
                m_fragments.push_back(piece);
                piece.a = cut->vertex;
            }
        }
        piece.b = whole[i].b;
        if (piece.a != piece.b) {
            m_fragments.push_back(piece);
        }
    }
}

}  // namespace model
