#include "model/geometry/loops/edge_faults.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "model/geometry/box_pairs.h"
#include "model/geometry/loops/edge_meetings.h"
#include "model/geometry/vectors.h"

namespace model {

namespace {

constexpr double kLeastSpacingNm = 1.0;
constexpr std::size_t kFewEdges = 32;  ///< looked through without an index

bool isLongEnough(PointD chord) {
    return dot(chord, chord) >= 4 * kLeastSpacingNm * kLeastSpacingNm;
}

/// Does a line go on as an arc of at most half a circle that is tangent to it? `line` leads away from the arc's start.
bool isTangent(PointD line, const Edge& arc) {
    const PointD u = minus(arc.a, arc.centre);
    const PointD w = minus(arc.b, arc.centre);
    const double sense = arc.isClockwise ? -1.0 : 1.0;
    const PointD tangent{-sense * u.y, sense * u.x};
    const double across = cross(line, tangent);
    return dot(line, tangent) > 0 && across * across < 1e-4 * dot(line, line) * dot(tangent, tangent) &&
           sense * cross(u, w) > -1e-6 * arc.radius * arc.radius;
}

/// The usual neighbours, quickly: `e` goes on as `f` so that they have nothing but their joint in common.
bool leadsAway(const Edge& e, const Edge& f) {
    const PointD ofE = minus(e.b, e.a);
    const PointD ofF = minus(f.b, f.a);
    if (!isLongEnough(ofE) || !isLongEnough(ofF) || (e.isArc() && f.isArc())) {
        return false;
    }
    if (f.isArc()) {
        return isTangent(ofE, f);
    }
    if (e.isArc()) {
        return isTangent({-ofF.x, -ofF.y}, reversed(e));
    }
    const double along = dot(ofE, ofF);  // turns by less than 150°
    return along > 0 || along * along < 0.75 * dot(ofE, ofE) * dot(ofF, ofF);
}

class FaultSearch {
public:
    explicit FaultSearch(const EdgeLoops& loops) : m_loops(loops), m_edges(loops.edges) {}

    std::optional<LoopFault> find() {
        findOpen();
        if (!m_fault && m_edges.size() <= kFewEdges) {
            compareFew();
        } else if (!m_fault) {
            compareMany();
        }
        return std::move(m_fault);
    }

private:
    void report(std::string what, PointD at) {
        if (!m_fault) {
            m_fault = LoopFault{std::move(what), at};
        }
    }

    void findOpen() {
        for (std::size_t i = 0; i < m_loops.loopCount(); ++i) {
            const std::span<const Edge> loop = m_loops.loop(i);
            for (std::size_t k = 0; k < loop.size(); ++k) {
                const PointD next = loop[k + 1 < loop.size() ? k + 1 : 0].a;
                if (loop[k].b != next || !std::isfinite(next.x) || !std::isfinite(next.y)) {
                    return report("a loop is not closed", next);
                }
            }
        }
    }

    void compareFew() {
        std::array<Box, kFewEdges> boxes;
        std::size_t loop = 0;
        std::array<std::uint32_t, kFewEdges> loopOf{};
        for (std::size_t i = 0; i < m_edges.size(); ++i) {
            boxes[i] = boxOf(m_edges[i]).grownBy(1);
            loop += i == m_loops.loopStart[loop + 1] ? 1 : 0;
            loopOf[i] = static_cast<std::uint32_t>(loop);
        }
        for (std::uint32_t i = 0; i < m_edges.size() && !m_fault; ++i) {
            for (std::uint32_t j = i + 1; j < m_edges.size() && !m_fault; ++j) {
                if (boxes[i].meets(boxes[j])) {
                    compare(i, j, loopOf[i], loopOf[j]);
                }
            }
        }
        if (!m_fault && m_loops.loopCount() > 1) {
            findMisplacedHoles(std::span(boxes).first(m_edges.size()));
        }
    }

    void compareMany() {
        std::vector<Box> boxes;
        std::vector<std::uint32_t> loopOf;
        boxes.reserve(m_edges.size());
        loopOf.reserve(m_edges.size());
        for (std::size_t i = 0; i < m_loops.loopCount(); ++i) {
            for (const Edge& edge : m_loops.loop(i)) {
                boxes.push_back(boxOf(edge).grownBy(1));
                loopOf.push_back(static_cast<std::uint32_t>(i));
            }
        }
        visitPairs(
            boxes, [](std::uint32_t) { return true; },
            [&](std::uint32_t i, std::uint32_t j) {
                if (!m_fault) {
                    i < j ? compare(i, j, loopOf[i], loopOf[j]) : compare(j, i, loopOf[j], loopOf[i]);
                }
            });
        if (!m_fault && m_loops.loopCount() > 1) {
            findMisplacedHoles(boxes);
        }
    }

    /// `i` before `j`.
    void compare(std::uint32_t i, std::uint32_t j, std::uint32_t loopOfI, std::uint32_t loopOfJ) {
        if (loopOfI == loopOfJ) {
            const std::uint32_t first = m_loops.loopStart[loopOfI];
            const std::uint32_t last = m_loops.loopStart[loopOfI + 1] - 1;
            const bool isNext = j == i + 1;
            const bool isRoundTheEnd = i == first && j == last;
            if (isNext || isRoundTheEnd) {
                return isNext ? compareNeighbours(i, j, isRoundTheEnd) : compareNeighbours(j, i, false);
            }
        }
        const Spacing spacing = spacingBetween(m_edges[i], m_edges[j]);
        if (spacing.distance < kLeastSpacingNm) {
            report(wordsFor(loopOfI, loopOfJ), spacing.from);
        }
    }

    static std::string wordsFor(std::uint32_t i, std::uint32_t j) {
        if (i == j) {
            return i == 0 ? "the outline touches or crosses itself" : "a hole touches or crosses itself";
        }
        return i == 0 || j == 0 ? "a hole touches or crosses the outline" : "two holes touch or cross each other";
    }

    /// `e` ends where `f` begins; both ends are common in loops of two edges.
    void compareNeighbours(std::uint32_t i, std::uint32_t j, bool areBothEndsCommon) {
        const Edge& e = m_edges[i];
        const Edge& f = m_edges[j];
        if (!areBothEndsCommon && leadsAway(e, f)) {
            return;
        }
        if (!areBothEndsCommon && (distanceTo(e, f.b) < kLeastSpacingNm || distanceTo(f, e.a) < kLeastSpacingNm)) {
            return report("neighbouring edges fold back", e.b);
        }
        if (areBothEndsCommon && !e.isArc() && !f.isArc()) {
            return report("neighbouring edges fold back", e.b);
        }
        if (!e.isArc() && !f.isArc()) {
            return;
        }
        // Where circle and line, or two circles, nearly touch, their meeting is known no better.
        const double reach = std::max(2.0, std::sqrt(1e-5 * std::max(e.radius, f.radius)));
        const Meetings meetings = meetingsOf(e, f);
        for (int k = 0; k < meetings.count; ++k) {
            const PointD p = meetings.at[static_cast<std::size_t>(k)];
            if (length(minus(p, e.b)) > reach && !(areBothEndsCommon && length(minus(p, e.a)) <= reach)) {
                return report("neighbouring edges cross each other", p);
            }
        }
    }

    /// Every hole has to lie in the outline and in no other hole. A line is swept upwards over the starts of holes; the
    /// edges that it meets are those around them.
    void findMisplacedHoles(std::span<const Box> boxes) {
        std::vector<std::uint32_t> holes;
        for (std::uint32_t i = 1; i < m_loops.loopCount(); ++i) {
            holes.push_back(i);
        }
        const auto start = [&](std::uint32_t hole) { return m_edges[m_loops.loopStart[hole]].a; };
        std::ranges::sort(holes, {}, [&](std::uint32_t hole) { return std::pair(start(hole).y, hole); });
        std::vector<std::pair<Nm, std::uint32_t>> coming;  // edges by their lower ends
        for (std::uint32_t row = 0; row < boxes.size(); ++row) {
            coming.emplace_back(boxes[row].min.y, row);
        }
        std::ranges::sort(coming);
        std::vector<std::uint32_t> met;
        auto next = coming.begin();
        for (const std::uint32_t hole : holes) {
            const PointD p = start(hole);
            std::erase_if(met, [&](std::uint32_t row) { return boxes[row].max.y < p.y; });
            for (; next != coming.end() && next->first <= p.y; ++next) {
                if (boxes[next->second].max.y >= p.y) {
                    met.push_back(next->second);
                }
            }
            reportMisplaced(hole, p, boxes, met);
        }
    }

    /// `met` are the edges at the height of `p`.
    void reportMisplaced(std::uint32_t hole, PointD p, std::span<const Box> boxes, std::span<const std::uint32_t> met) {
        const std::uint32_t first = m_loops.loopStart[hole];
        const std::uint32_t last = m_loops.loopStart[hole + 1];
        int winding = 0;
        for (const std::uint32_t row : met) {
            const bool isOther = row < first || row >= last;
            winding += isOther && boxes[row].max.x >= p.x ? windingAround(m_edges[row], p) : 0;
        }
        if (winding != 1) {
            report(winding < 1 ? "a hole lies outside the outline or in another hole" : "a hole winds like an outline",
                   p);
        }
    }

    const EdgeLoops& m_loops;
    std::span<const Edge> m_edges;
    std::optional<LoopFault> m_fault;
};

}  // namespace

std::optional<LoopFault> findFault(const EdgeLoops& loops) {
    return FaultSearch(loops).find();
}

}  // namespace model
