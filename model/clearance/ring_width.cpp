#include "model/clearance/ring_width.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <queue>
#include <vector>

#include "model/figures/distance.h"
#include "model/geometry/vectors.h"

namespace model {

namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();

Edge lineBetween(PointD a, PointD b) {
    Edge line;
    line.a = a;
    line.b = b;
    return line;
}

Edge arcAround(PointD centre, double radius, PointD a, PointD b, bool isClockwise = false) {
    Edge arc = lineBetween(a, b);
    arc.centre = centre;
    arc.radius = radius;
    arc.isClockwise = isClockwise;
    return arc;
}

Edge circleAround(PointD centre, double radius) {
    const PointD start{centre.x + radius, centre.y};
    return arcAround(centre, radius, start, start);
}

PointD moved(PointD p, PointD by, double times) {
    return {p.x + times * by.x, p.y + times * by.y};
}

PointD scaled(PointD v, double to) {
    const double size = length(v);
    return size > 0 ? PointD{v.x * to / size, v.y * to / size} : PointD{};
}

/// To the right of a straight track.
PointD besideOf(const Edge& line) {
    return scaled({line.b.y - line.a.y, line.a.x - line.b.x}, 1.0);
}

void addOutlineOfLine(const Edge& track, std::vector<Edge>& outline) {
    const PointD beside = besideOf(track);
    const PointD a = moved(track.a, beside, track.pen);
    const PointD b = moved(track.b, beside, track.pen);
    const PointD c = moved(track.b, beside, -track.pen);
    const PointD d = moved(track.a, beside, -track.pen);
    outline.insert(outline.end(), {lineBetween(a, b), arcAround(track.b, track.pen, b, c), lineBetween(c, d),
                                   arcAround(track.a, track.pen, d, a)});
}

void addOutlineOfArc(const Edge& track, std::vector<Edge>& outline) {
    const auto at = [&](PointD end, double radius) {
        return moved(track.centre, minus(end, track.centre), radius / track.radius);
    };
    const double outer = track.radius + track.pen;
    const double inner = track.radius - track.pen;
    outline.push_back(arcAround(track.centre, outer, at(track.a, outer), at(track.b, outer), track.isClockwise));
    if (inner > 0) {
        outline.push_back(arcAround(track.centre, inner, at(track.a, inner), at(track.b, inner), track.isClockwise));
    }
    const bool isClockwise = track.isClockwise;  // the round ends lead on around the track
    outline.push_back(arcAround(track.b, track.pen, at(track.b, outer), at(track.b, inner), isClockwise));
    outline.push_back(arcAround(track.a, track.pen, at(track.a, inner), at(track.a, outer), isClockwise));
}

/// The outline of what a round pen draws along an edge.
std::vector<Edge> outlineOf(const Edge& track) {
    std::vector<Edge> outline;
    if (track.isFullCircle()) {
        outline.push_back(circleAround(track.centre, track.radius + track.pen));
        if (track.radius > track.pen) {
            outline.push_back(circleAround(track.centre, track.radius - track.pen));
        }
    } else if (track.isArc()) {
        addOutlineOfArc(track, outline);
    } else if (track.a.x == track.b.x && track.a.y == track.b.y) {
        outline.push_back(circleAround(track.a, track.pen));
    } else {
        addOutlineOfLine(track, outline);
    }
    return outline;
}

bool covers(const Edge& track, PointD p) {
    return spacingBetween(lineBetween(p, p), track).distance <= 0;
}

/// The largest distance of an edge from the middle line of a track. It is taken at an end of the edge, or where an arc
/// is farthest from an end, the centre or the side of the middle line.
double farthestFrom(const Edge& track, const Edge& edge) {
    const auto distanceOf = [&](PointD p) { return distance(p, nearestOn(track, p)); };
    double farthest = std::max(distanceOf(edge.a), distanceOf(edge.b));
    if (!edge.isArc()) {
        return farthest;
    }
    const PointD beside = besideOf(track);
    const PointD ways[] = {minus(edge.centre, track.a),
                           minus(edge.centre, track.b),
                           track.isArc() ? minus(edge.centre, track.centre) : beside,
                           {-beside.x, -beside.y}};
    for (const PointD way : ways) {
        for (const double radius : {edge.radius, -edge.radius}) {
            const PointD out = scaled(way, radius);
            const bool isOnArc = (out.x != 0 || out.y != 0) && passes(edge, out);
            farthest = isOnArc ? std::max(farthest, distanceOf(moved(edge.centre, out, 1.0))) : farthest;
        }
    }
    return farthest;
}

/// A part of a hole: what the drill takes along one edge, or a routed area.
struct HolePart {
    std::vector<Edge> outline;
    Box box;
    std::function<bool(PointD)> covers;          ///< is the point within?
    std::function<bool(const Edge&)> coversAll;  ///< is all of an edge within, or on the outline?
    PointD beside;                               ///< a point right outside, on the outline of an area
};

PointD pointBeside(const Edge& track) {
    const double reach = track.pen + kTouchNm;
    if (track.isArc()) {
        return moved(track.a, scaled(minus(track.a, track.centre), reach), 1.0);
    }
    const PointD beside = besideOf(track);
    return beside.x == 0 && beside.y == 0 ? PointD{track.a.x + reach, track.a.y} : moved(track.a, beside, reach);
}

HolePart partOf(const Edge& track) {
    return {outlineOf(track), boxOf(track), [track](PointD p) { return covers(track, p); },
            [track](const Edge& edge) { return farthestFrom(track, edge) <= track.pen + kTouchNm; },
            pointBeside(track)};
}

HolePart partOf(const FigureTable& hole, std::size_t row) {
    const std::span<const Edge> outline = hole.edges(row);
    return {{outline.begin(), outline.end()},
            hole.box(row),
            [&hole, row](PointD p) { return isInside(hole, row, p); },
            [](const Edge&) { return false; },
            outline.front().a};
}

std::vector<HolePart> partsOf(const FigureTable& hole) {
    std::vector<HolePart> parts;
    for (std::size_t row = 0; row < hole.size(); ++row) {
        if (hole[row].isFilled) {
            parts.push_back(partOf(hole, row));
            continue;
        }
        for (const Edge& track : hole.edges(row)) {
            parts.push_back(partOf(track));
        }
    }
    return parts;
}

/// Copper around a part of a hole: its outline edge by edge, and what lies within.
class RingSearch {
public:
    RingSearch(const HolePart& hole, double below) : m_hole(hole), m_below(below) {}

    /// A piece of the outline of the copper.
    void see(const Edge& edge) {
        Spacing nearest{kEndless, {}, {}};
        for (const Edge& side : m_hole.outline) {
            const Spacing spacing = spacingBetween(side, edge);
            nearest = spacing.distance < nearest.distance ? spacing : nearest;
        }
        const bool isWithin = nearest.distance <= kTouchNm ? m_hole.coversAll(edge) : m_hole.covers(edge.a);
        if (isWithin) {
            m_hasInner = true;
            m_touch = nearest.distance <= kTouchNm ? nearest.from : m_touch;
        } else if (nearest.distance < m_least.distance) {
            m_least = nearest;
        }
    }

    /// `isInside`: does the copper cover a point?
    [[nodiscard]] RingWidth result(const std::function<bool(PointD)>& isInside) const {
        if (m_least.distance <= kTouchNm) {
            return {RingState::BreaksOut, {0.0, m_least.from, m_least.from}};
        }
        if (isInside(m_hole.beside)) {
            return {RingState::Around, m_least.distance < m_below ? m_least : Spacing{kEndless, {}, {}}};
        }
        return {m_hasInner ? RingState::Removed : RingState::Apart, {0.0, m_touch, m_touch}};
    }

private:
    const HolePart& m_hole;
    double m_below;
    Spacing m_least{kEndless, {}, {}};  ///< to what of the outline does not lie within the hole
    bool m_hasInner = false;
    PointD m_touch;  ///< where the outlines meet, if the copper's does not cross that of the hole
};

RingWidth ringOf(const HolePart& hole, const FigureTable& copper, std::size_t row, double below) {
    RingSearch search(hole, below);
    visitEdges(copper, row, hole.box.grownBy(static_cast<Nm>(below) + 1), [&](const Edge& e) { search.see(e); });
    return search.result([&](PointD p) { return isInside(copper, row, p); });
}

RingWidth ringOf(const HolePart& hole, const Edge& track, double below) {
    RingSearch search(hole, below);
    for (const Edge& edge : outlineOf(track)) {
        search.see(edge);
    }
    return search.result([&](PointD p) { return covers(track, p); });
}

/// Copper with an outline of its own: an area, or an edge of a track.
struct Piece {
    std::vector<Edge> outline;
    std::function<bool(PointD)> covers;
};

std::vector<Piece> piecesOf(const FigureTable& copper, std::span<const std::uint32_t> rows, const Box& near) {
    std::vector<Piece> pieces;
    for (const std::uint32_t row : rows) {
        if (copper[row].isFilled) {
            Piece piece{{}, [&copper, row](PointD p) { return isInside(copper, row, p); }};
            visitEdges(copper, row, near, [&](const Edge& edge) { piece.outline.push_back(edge); });
            pieces.push_back(std::move(piece));
            continue;
        }
        for (const Edge& track : copper.edges(row)) {
            pieces.push_back({outlineOf(track), [track](PointD p) { return covers(track, p); }});
        }
    }
    return pieces;
}

/// The nearest location of the outline of pieces together. Edges of all pieces wait in the order of their distance from
/// the hole; one whose nearest point another piece covers is dropped if that piece covers it all, else halved.
class UnionSearch {
public:
    UnionSearch(const HolePart& hole, std::vector<Piece> pieces) : m_hole(hole), m_pieces(std::move(pieces)) {
        for (std::size_t piece = 0; piece < m_pieces.size(); ++piece) {
            for (const Edge& edge : m_pieces[piece].outline) {
                add(piece, edge);
            }
        }
    }

    [[nodiscard]] RingWidth run(double below) {
        const Spacing least = nearest(below);
        if (least.distance <= kTouchNm) {
            return {RingState::BreaksOut, {0.0, least.from, least.from}};
        }
        const auto coversBeside = [&](const Piece& piece) { return piece.covers(m_hole.beside); };
        if (std::ranges::any_of(m_pieces, coversBeside)) {
            return {RingState::Around, least};
        }
        return {m_hasInner ? RingState::Removed : RingState::Apart, {}};
    }

private:
    struct Waiting {
        Spacing spacing;  ///< from the outline of the hole to the edge
        std::size_t piece = 0;
        Edge edge;
        bool operator<(const Waiting& other) const { return spacing.distance > other.spacing.distance; }
    };

    void add(std::size_t piece, const Edge& edge) {
        const Spacing spacing = nearestTo(edge, m_hole.outline);
        if (spacing.distance <= kTouchNm ? m_hole.coversAll(edge) : m_hole.covers(edge.a)) {
            m_hasInner = true;
        } else {
            m_waiting.push({spacing, piece, edge});
        }
    }

    static Spacing nearestTo(const Edge& edge, const std::vector<Edge>& outline) {
        Spacing nearest{kEndless, {}, {}};
        for (const Edge& side : outline) {
            const Spacing spacing = spacingBetween(side, edge);
            nearest = spacing.distance < nearest.distance ? spacing : nearest;
        }
        return nearest;
    }

    Spacing nearest(double below) {
        while (!m_waiting.empty() && m_waiting.top().spacing.distance < below) {
            const Waiting first = m_waiting.top();
            m_waiting.pop();
            const Piece* over = coverOf(first);
            if (over == nullptr) {
                return first.spacing;
            }
            if (!isAllWithin(first.edge, *over)) {
                halve(first);
            }
        }
        return {kEndless, {}, {}};
    }

    /// Another piece that covers the nearest point, which is not on its outline.
    [[nodiscard]] const Piece* coverOf(const Waiting& waiting) const {
        const PointD p = waiting.spacing.to;
        for (std::size_t other = 0; other < m_pieces.size(); ++other) {
            const Piece& piece = m_pieces[other];
            if (other != waiting.piece && piece.covers(p) &&
                nearestTo(lineBetween(p, p), piece.outline).distance > kTouchNm) {
                return &piece;
            }
        }
        return nullptr;
    }

    static bool isAllWithin(const Edge& edge, const Piece& piece) {
        return nearestTo(edge, piece.outline).distance > kTouchNm && piece.covers(edge.a);
    }

    void halve(const Waiting& waiting) {
        constexpr double kShortest = 1.0;
        const double size = lengthOf(waiting.edge);
        if (size < kShortest) {
            return;
        }
        Edge first = waiting.edge;
        Edge second = waiting.edge;
        first.b = second.a = pointAt(waiting.edge, size / 2);
        add(waiting.piece, first);
        add(waiting.piece, second);
    }

    const HolePart& m_hole;
    std::vector<Piece> m_pieces;
    std::priority_queue<Waiting> m_waiting;
    bool m_hasInner = false;
};

/// A hole is as well surrounded as its worst part; copper within one part and apart from the other is within the hole.
RingWidth worseOf(const RingWidth& a, const RingWidth& b) {
    if (a.state == b.state) {
        return b.width.distance < a.width.distance ? b : a;
    }
    const auto [low, high] = std::minmax(a.state, b.state);
    if (low == RingState::Apart && high == RingState::Removed) {
        return {RingState::Removed, {}};
    }
    const PointD at = a.state == RingState::BreaksOut ? a.width.from : b.width.from;
    return {RingState::BreaksOut, {0.0, at, at}};
}

/// Of one copper, or of one edge of it, with all parts of a hole. `ringOf` finds that of a part.
template <class RingOf>
RingWidth overParts(const std::vector<HolePart>& parts, const RingOf& ringOf) {
    std::optional<RingWidth> worst;
    for (const HolePart& part : parts) {
        const RingWidth ring = ringOf(part);
        worst = worst ? worseOf(*worst, ring) : ring;
    }
    return worst.value_or(RingWidth{});
}

bool isWider(const RingWidth& a, const RingWidth& b) {
    return a.state != b.state ? a.state > b.state : a.width.distance > b.width.distance;
}

}  // namespace

RingWidth ringAround(const FigureTable& hole, const FigureTable& copper, std::size_t row, double below) {
    const std::vector<HolePart> parts = partsOf(hole);
    if (copper[row].isFilled) {
        return overParts(parts, [&](const HolePart& part) { return ringOf(part, copper, row, below); });
    }
    RingWidth widest;
    for (const Edge& track : copper.edges(row)) {
        const RingWidth ring = overParts(parts, [&](const HolePart& part) { return ringOf(part, track, below); });
        widest = isWider(ring, widest) ? ring : widest;
    }
    return widest;
}

RingWidth ringAround(const FigureTable& hole, const FigureTable& copper, std::span<const std::uint32_t> rows,
                     double below) {
    return overParts(partsOf(hole), [&](const HolePart& part) {
        const Box near = part.box.grownBy(static_cast<Nm>(below) + 1);
        return UnionSearch(part, piecesOf(copper, rows, near)).run(below);
    });
}

}  // namespace model
