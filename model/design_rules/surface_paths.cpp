#include "model/design_rules/surface_paths.h"

#include <algorithm>
#include <cmath>

#include "model/figures/distance.h"
#include "model/figures/element_polygons.h"
#include "model/geometry/vectors.h"

namespace model {

namespace {

constexpr Discretisation kChords{.chordToleranceNm = 2000.0};
constexpr double kAside = 1.0;  ///< nm: what is nearer to a line than this does not lie beyond it

double cross(PointD a, PointD b, PointD p) {
    return (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
}

PointD middleOf(PointD a, PointD b) {
    return {(a.x + b.x) / 2, (a.y + b.y) / 2};
}

/// Do the insides of two lines cross? Not if one only touches the other.
bool doCross(PointD a, PointD b, PointD c, PointD d) {
    const double along = distance(a, b);
    const double across = distance(c, d);
    const auto areApart = [](double left, double right, double length) {
        return (left > kAside * length && right < -kAside * length) ||
               (left < -kAside * length && right > kAside * length);
    };
    return areApart(cross(a, b, c), cross(a, b, d), along) && areApart(cross(c, d, a), cross(c, d, b), across);
}

Box boxAround(PointD a, PointD b, double more = 1.0) {
    Box box;
    for (const PointD p : {a, b}) {
        box.include(Point{static_cast<Nm>(std::floor(p.x - more)), static_cast<Nm>(std::floor(p.y - more))});
        box.include(Point{static_cast<Nm>(std::ceil(p.x + more)), static_cast<Nm>(std::ceil(p.y + more))});
    }
    return box;
}

/// Between the two nearest parallel lines that hold a loop.
double narrowestOf(std::span<const Point> loop) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const PointD a = base::toDouble(loop[i]);
        const PointD b = base::toDouble(loop[(i + 1) % loop.size()]);
        double low = 0.0;
        double high = 0.0;
        for (const Point point : loop) {
            const double height = cross(a, b, base::toDouble(point)) / distance(a, b);
            low = std::min(low, height);
            high = std::max(high, height);
        }
        least = std::min(least, high - low);
    }
    return least;
}

/// The shorter one, if there are two.
void keepShorter(std::optional<Spacing>& best, const std::optional<Spacing>& other) {
    if (other && (!best || other->distance < best->distance)) {
        best = other;
    }
}

}  // namespace

SurfacePaths::SurfacePaths(const Document& document, Nm leastOpening) {
    if (document.profile.isValid()) {
        const PolygonSet outline = discretise(document.shapes, document.profile, kChords);
        for (const PolygonSet::Polygon& polygon : outline.polygons) {
            for (std::uint32_t i = 0; i < polygon.loopCount; ++i) {
                const std::span<const Point> loop = outline.loop(polygon.firstLoop + i);
                if (i == 0 || narrowestOf(loop) >= static_cast<double>(leastOpening)) {
                    addLoop(loop, i == 0);
                }
            }
        }
    }
    for (std::uint32_t row = 0; row < document.elements.size(); ++row) {
        const std::uint8_t flags = document.elements.flags[row];
        if ((flags & kHole) != 0 && !isPlatedHole(flags)) {
            add(model::discretise(document, ElementId{row}, kChords), leastOpening);
        }
    }
    std::vector<Box> edges;
    std::vector<Box> points;
    for (std::size_t i = 0; i < m_corners.size(); ++i) {
        edges.push_back(boxAround(m_corners[i], m_corners[m_next[i]]));
        points.push_back(boxAround(m_corners[i], m_corners[i]));
    }
    m_edges.emplace(edges);
    m_points.emplace(points);
}

void SurfacePaths::add(const PolygonSet& polygons, Nm leastOpening) {
    for (const PolygonSet::Polygon& polygon : polygons.polygons) {
        const std::span<const Point> loop = polygons.loop(polygon.firstLoop);
        if (narrowestOf(loop) >= static_cast<double>(leastOpening)) {
            addLoop(loop, false);
        }
    }
}

void SurfacePaths::addLoop(std::span<const Point> loop, bool isOutline) {
    const auto first = static_cast<std::uint32_t>(m_corners.size());
    Opening opening{first, static_cast<std::uint32_t>(loop.size()), isOutline, {}};
    for (std::uint32_t i = 0; i < opening.count; ++i) {
        m_corners.push_back(base::toDouble(loop[i]));
        m_next.push_back(first + (i + 1) % opening.count);
        opening.box.include(loop[i]);
    }
    m_openings.push_back(opening);
}

bool SurfacePaths::isOnEdge(PointD p) const {
    bool isOn = false;
    m_edges->visit(boxAround(p, p), [&](std::uint32_t i) {
        const PointD a = m_corners[i];
        const PointD b = m_corners[m_next[i]];
        isOn = isOn || std::abs(cross(a, b, p)) <= kAside * distance(a, b);
    });
    return isOn;
}

bool SurfacePaths::isInside(const Opening& opening, PointD p) const {
    bool isInside = false;
    const bool isNear =
        opening.box.min.x <= p.x && p.x <= opening.box.max.x && opening.box.min.y <= p.y && p.y <= opening.box.max.y;
    for (std::uint32_t i = opening.first; isNear && i < opening.first + opening.count; ++i) {
        const PointD a = m_corners[i];
        const PointD b = m_corners[m_next[i]];
        if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) {
            isInside = !isInside;
        }
    }
    return isInside;
}

bool SurfacePaths::isMissing(PointD p) const {
    const auto isOutline = [](const Opening& opening) { return opening.isOutline; };
    const auto isCutOut = [&](const Opening& opening) { return !opening.isOutline && isInside(opening, p); };
    const auto isBoard = [&](const Opening& opening) { return opening.isOutline && isInside(opening, p); };
    return !isOnEdge(p) && (std::ranges::any_of(m_openings, isCutOut) ||
                            (std::ranges::any_of(m_openings, isOutline) && std::ranges::none_of(m_openings, isBoard)));
}

bool SurfacePaths::isClear(PointD from, PointD to) const {
    bool isCrossed = false;
    bool isNearEdge = false;
    m_edges->visit(boxAround(from, to), [&](std::uint32_t i) {
        isNearEdge = true;
        isCrossed = isCrossed || doCross(from, to, m_corners[i], m_corners[m_next[i]]);
    });
    // A line along the corners of one opening crosses none of its edges.
    return !isCrossed && !(isNearEdge && distance(from, to) > 2 * kAside && isMissing(middleOf(from, to)));
}

std::optional<Spacing> SurfacePaths::straight(const FigureTable& figures, std::uint32_t row, PointD p,
                                              double limit) const {
    FigureTable point;
    point.addTrack(p, p, 0.0);
    const std::optional<Spacing> nearest = spacingBetween(point, 0, figures, row, limit);
    if (!nearest || isClear(p, nearest->to)) {
        return nearest;
    }
    std::optional<Spacing> best;
    visitEdges(figures, row, boxAround(p, p, limit), [&](const Edge& edge) {
        const Spacing s = spacingBetween(point.edges(0).front(), edge);
        if (s.distance < limit && isClear(p, s.to)) {
            keepShorter(best, s);
        }
    });
    return best;
}

std::optional<Spacing> SurfacePaths::straight(const FigureTable& figures, std::uint32_t a, std::uint32_t b,
                                              double limit) const {
    const std::optional<Spacing> nearest = spacingBetween(figures, a, figures, b, limit);
    if (!nearest || nearest->distance <= kTouchNm || isClear(nearest->from, nearest->to) || isMissing(nearest->from) ||
        isMissing(nearest->to)) {
        return nearest;
    }
    std::optional<Spacing> best;
    visitEdges(figures, a, figures.box(b).grownBy(static_cast<Nm>(limit)), [&](const Edge& first) {
        visitEdges(figures, b, boxOf(first).grownBy(static_cast<Nm>(limit)), [&](const Edge& second) {
            const Spacing s = spacingBetween(first, second);
            if (s.distance < limit && (!best || s.distance < best->distance) && isClear(s.from, s.to)) {
                best = s;
            }
        });
    });
    return best;
}

std::vector<SurfacePaths::Corner> SurfacePaths::cornersBetween(const FigureTable& figures, std::uint32_t a,
                                                               std::uint32_t b, double limit) const {
    std::vector<Corner> corners;
    m_points->visit(figures.box(a).grownBy(static_cast<Nm>(limit)), [&](std::uint32_t i) {
        FigureTable point;
        point.addTrack(m_corners[i], m_corners[i], 0.0);
        const auto toA = spacingBetween(point, 0, figures, a, limit);
        const auto toB = toA ? spacingBetween(point, 0, figures, b, limit - toA->distance) : std::nullopt;
        if (toB) {
            corners.push_back({.at = m_corners[i]});
        }
    });
    for (Corner& corner : corners) {
        if (const auto way = straight(figures, a, corner.at, limit)) {
            corner.fromA = way->distance;
            corner.start = way->to;
        }
        if (const auto way = straight(figures, b, corner.at, limit)) {
            corner.toB = way->distance;
            corner.end = way->to;
        }
    }
    return corners;
}

/// From corner to corner, the nearest one first.
std::optional<Spacing> SurfacePaths::shortest(std::vector<Corner>& corners, double limit) const {
    std::optional<Spacing> best;
    for (;;) {
        Corner* nearest = nullptr;
        for (Corner& corner : corners) {
            if (!corner.isDone && corner.fromA < limit && (nearest == nullptr || corner.fromA < nearest->fromA)) {
                nearest = &corner;
            }
        }
        if (nearest == nullptr || (best && nearest->fromA >= best->distance)) {
            return best;
        }
        nearest->isDone = true;
        const double whole = nearest->fromA + nearest->toB;
        if (whole < limit) {
            keepShorter(best, Spacing{whole, nearest->start, nearest->end});
        }
        for (Corner& corner : corners) {
            const double way = nearest->fromA + distance(nearest->at, corner.at);
            if (!corner.isDone && way < corner.fromA && way < limit && isClear(nearest->at, corner.at)) {
                corner.fromA = way;
                corner.start = nearest->start;
            }
        }
    }
}

std::optional<Spacing> SurfacePaths::between(const FigureTable& figures, std::uint32_t a, std::uint32_t b,
                                             double limit) const {
    std::optional<Spacing> best = straight(figures, a, b, limit);
    const double below = best ? best->distance : limit;
    std::vector<Corner> corners = cornersBetween(figures, a, b, below);
    keepShorter(best, shortest(corners, below));
    return best;
}

}  // namespace model
