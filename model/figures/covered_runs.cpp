#include "model/figures/covered_runs.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "model/figures/distance.h"

namespace model {

namespace {

constexpr double kFar = std::numeric_limits<double>::infinity();

/// Where the winding numbers along a row change.
struct Crossing {
    double x = 0.0;
    int island = 0;
    int holes = 0;
};

/// windingAround (geometry/edges.h) along a row: the chord of an edge counts for the points left of it, and what lies
/// between an arc and its chord counts once more.
class RowCrossings {
public:
    explicit RowCrossings(double y) : m_y(y) {}

    void add(const Edge& edge) {
        if ((edge.a.y > m_y) != (edge.b.y > m_y)) {
            crossAt(chordAt(edge), edge.b.y > edge.a.y ? -edge.winding : edge.winding, edge.isHole);
        }
        if (edge.isArc()) {
            addSegment(edge);
        }
    }

    void addRuns(std::vector<CoveredRun>& runs) {
        std::ranges::sort(m_crossings, {}, &Crossing::x);
        int island = 0;
        int holes = 0;
        for (std::size_t i = 0; i < m_crossings.size(); ++i) {
            island += m_crossings[i].island;
            holes += m_crossings[i].holes;
            const double to = i + 1 < m_crossings.size() ? m_crossings[i + 1].x : kFar;
            if (island > 0 && holes <= 0 && to > m_crossings[i].x) {
                runs.push_back({m_crossings[i].x, to});
            }
        }
    }

private:
    void crossAt(double x, int winding, bool isHole) {
        m_crossings.push_back({x, isHole ? 0 : winding, isHole ? winding : 0});
    }

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
            const int winding = arc.isClockwise ? -arc.winding : arc.winding;
            crossAt(from, winding, arc.isHole);
            crossAt(to, -winding, arc.isHole);
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
    std::vector<Crossing> m_crossings;
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
    RowCrossings crossings(y);
    visitEdges(table, row, rowBox(box, y, toX), [&](const Edge& edge) { crossings.add(edge); });
    crossings.addRuns(runs);
}

}  // namespace model
