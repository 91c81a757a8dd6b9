#include "model/figures/row_cover.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/figures/distance.h"

namespace model {

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

/// Where the winding numbers along a row change.
struct Turn {
    double x = 0.0;
    int island = 0;
    int holes = 0;
};

/// windingAround (geometry/edges.h) along a row: the chord of an edge counts for the points left of it, and what lies
/// between an arc and its chord counts once more.
class RowTurns {
public:
    explicit RowTurns(double y) : m_y(y) {}

    void add(const Edge& edge) {
        if ((edge.a.y > m_y) != (edge.b.y > m_y)) {
            turnAt(chordAt(edge), edge.b.y > edge.a.y ? -edge.winding : edge.winding, edge.isHole);
        }
        if (edge.isArc()) {
            addSegment(edge);
        }
    }

    void addRuns(std::vector<CoveredRun>& runs) {
        std::ranges::sort(m_turns, {}, &Turn::x);
        int island = 0;
        int holes = 0;
        for (std::size_t i = 0; i < m_turns.size(); ++i) {
            island += m_turns[i].island;
            holes += m_turns[i].holes;
            const double to = i + 1 < m_turns.size() ? m_turns[i + 1].x : kFar;
            if (island > 0 && holes <= 0 && to > m_turns[i].x) {
                runs.push_back({m_turns[i].x, to});
            }
        }
    }

private:
    void turnAt(double x, int turn, bool isHole) { m_turns.push_back({x, isHole ? 0 : turn, isHole ? turn : 0}); }

    [[nodiscard]] double chordAt(const Edge& edge) const {
        return edge.a.x + (m_y - edge.a.y) / (edge.b.y - edge.a.y) * (edge.b.x - edge.a.x);
    }

    void addSegment(const Edge& arc) {
        const double squared = (arc.radius - (m_y - arc.centre.y)) * (arc.radius + (m_y - arc.centre.y));
        if (squared < 0) {
            return;
        }
        double from = arc.centre.x - std::sqrt(squared);
        double to = arc.centre.x + std::sqrt(squared);
        if (!arc.isFullCircle()) {
            clipToSegment(arc, from, to);
        }
        if (from < to) {
            const int turn = arc.isClockwise ? -arc.winding : arc.winding;
            turnAt(from, turn, arc.isHole);
            turnAt(to, -turn, arc.isHole);
        }
    }

    /// Of a counter-clockwise arc the segment lies to the right of its chord.
    void clipToSegment(const Edge& arc, double& from, double& to) const {
        const double up = arc.b.y - arc.a.y;
        if (up != 0) {
            const bool isBeyond = (up > 0) != arc.isClockwise;
            isBeyond ? from = std::max(from, chordAt(arc)) : to = std::min(to, chordAt(arc));
            return;
        }
        const double side = (arc.b.x - arc.a.x) * (m_y >= arc.a.y ? 1.0 : -1.0);
        if ((side > 0) != arc.isClockwise) {
            to = from;
        }
    }

    double m_y;
    std::vector<Turn> m_turns;
};

Box rowBox(const Box& figure, double y, double toX) {
    const auto low = static_cast<Nm>(std::floor(y));
    const double right = std::clamp(std::ceil(toX), double{1} * figure.min.x, double{1} * figure.max.x);
    return {{figure.min.x, low}, {static_cast<Nm>(right), low + 1}};
}

}  // namespace

void addCoveredRuns(const FigureTable& table, std::size_t row, double y, double toX, std::vector<CoveredRun>& runs) {
    const Box& box = table.box(row);
    if (!table[row].isFilled || y < box.min.y || y > box.max.y || toX < box.min.x) {
        return;
    }
    RowTurns turns(y);
    visitEdges(table, row, rowBox(box, y, toX), [&](const Edge& edge) { turns.add(edge); });
    turns.addRuns(runs);
}

}  // namespace model
