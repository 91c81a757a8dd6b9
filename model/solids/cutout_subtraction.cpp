#include <algorithm>
#include <numeric>

#include "model/geometry/boolean.h"
#include "model/solids/cutouts.h"
#include "model/solids/region_distance.h"

namespace model {

namespace {

/// Contours closer than this are united: twice the chord tolerance, so that the chords of neighbours do not cross.
constexpr double kMargin = 10'000.0;

/// Rows in groups; the lowest row of a group stands for it.
class Groups {
public:
    explicit Groups(std::size_t size) : m_parent(size) { std::iota(m_parent.begin(), m_parent.end(), 0U); }

    std::size_t find(std::size_t row) {
        while (m_parent[row] != row) {
            row = m_parent[row] = m_parent[m_parent[row]];
        }
        return row;
    }
    void join(std::size_t a, std::size_t b) {
        a = find(a);
        b = find(b);
        m_parent[std::max(a, b)] = static_cast<std::uint32_t>(std::min(a, b));
    }

private:
    std::vector<std::uint32_t> m_parent;
};

class Cutter {
public:
    Cutter(const ShapeTable& shapes, ShapeId from, const Cutouts& cutouts, const base::Progress& progress)
        : m_shapes(shapes),
          m_from(from),
          m_cutouts(cutouts),
          m_progress(progress),
          m_outline(discretise(shapes, from, {})),
          m_edges(m_outline),
          m_groups(cutouts.size()) {}

    ShapeSketch run() {
        joinNeighbours();
        sortMembers();
        PolygonSet atOutline;
        for (std::size_t i = 0; i < m_cutouts.size(); ++i) {
            if (m_reachesOutline[m_groups.find(i)] != 0) {
                append(i, atOutline);
            }
        }
        addOutline(atOutline);
        for (std::size_t i = 0; i < m_cutouts.size() && !m_progress.isCancelled(); ++i) {
            if (m_groups.find(i) == i && m_reachesOutline[i] == 0 && m_edges.contains(cornerOf(i))) {
                addGroup(i);
            }
        }
        return m_progress.isCancelled() || m_isGone ? ShapeSketch{} : std::move(m_result);
    }

private:
    /// Sweeps over x with the cutouts that are not yet behind.
    void joinNeighbours() {
        std::vector<std::size_t> order(m_cutouts.size());
        std::iota(order.begin(), order.end(), 0U);
        std::ranges::stable_sort(order, {}, [this](std::size_t i) { return m_cutouts.box(i).min.x; });
        std::vector<std::size_t> open;
        for (const std::size_t i : order) {
            if (m_progress.isCancelled()) {
                return;
            }
            const Box box = m_cutouts.box(i).grownBy(static_cast<Nm>(kMargin));
            std::erase_if(open, [&](std::size_t j) { return m_cutouts.box(j).max.x < box.min.x; });
            for (const std::size_t j : open) {
                const Box& other = m_cutouts.box(j);
                const bool isNear = other.min.y <= box.max.y && other.max.y >= box.min.y;
                if (isNear && m_groups.find(i) != m_groups.find(j) && m_cutouts.touch(i, j, kMargin)) {
                    m_groups.join(i, j);
                }
            }
            open.push_back(i);
        }
    }

    void sortMembers() {
        m_reachesOutline.assign(m_cutouts.size(), 0);
        m_members.assign(m_cutouts.size(), {});
        for (std::size_t i = 0; i < m_cutouts.size() && !m_progress.isCancelled(); ++i) {
            const std::size_t group = m_groups.find(i);
            m_members[group].push_back(i);
            if (m_reachesOutline[group] == 0 && reachesOutline(i)) {
                m_reachesOutline[group] = 1;
            }
        }
    }

    /// Does it come near the outline, or lie around all of a contour?
    [[nodiscard]] bool reachesOutline(std::size_t row) const {
        const PolygonSet& set = m_cutouts.polygons();
        const Box& box = m_cutouts.box(row);
        if (m_edges.comesNear(set, m_cutouts.polygonsOf(row), box, kMargin)) {
            return true;
        }
        for (std::size_t i = 0; i < m_outline.loopCount(); ++i) {
            const Point p = m_outline.loop(i)[0];
            const bool isInBox = box.min.x <= p.x && p.x <= box.max.x && box.min.y <= p.y && p.y <= box.max.y;
            if (isInBox && contains(set, m_cutouts.polygonsOf(row), p)) {
                return true;
            }
        }
        return false;
    }

    void append(std::size_t row, PolygonSet& to) const {
        for (const PolygonSet::Polygon& polygon : m_cutouts.polygonsOf(row)) {
            to.beginPolygon();
            for (std::uint32_t i = 0; i < polygon.loopCount; ++i) {
                to.addLoop(m_cutouts.polygons().loop(polygon.firstLoop + i));
            }
        }
    }

    [[nodiscard]] Point cornerOf(std::size_t row) const {
        return m_cutouts.polygons().loop(m_cutouts.polygonsOf(row)[0].firstLoop)[0];
    }

    void addOutline(const PolygonSet& cutAway) {
        if (!cutAway.polygons.empty()) {
            const PolygonSet left = subtract(m_outline, cutAway);
            m_isGone = left.polygons.empty();
            m_result = sketchOf(left);
            return;
        }
        m_result.append(m_shapes, m_from, {});
    }

    void addGroup(std::size_t group) {
        const std::vector<std::size_t>& members = m_members[group];
        const std::size_t largest = *std::ranges::max_element(
            members, {}, [this](std::size_t i) { return m_cutouts.box(i).width() + m_cutouts.box(i).height(); });
        const auto isCovered = [&](std::size_t i) { return i == largest || m_cutouts.covers(largest, i); };
        if (m_cutouts.isSimple(largest) && std::ranges::all_of(members, isCovered)) {
            return m_cutouts.addInverted(largest, m_result);
        }
        PolygonSet all;
        for (const std::size_t row : members) {
            append(row, all);
        }
        const PolygonSet united = unite(all);
        for (const PolygonSet::Polygon& polygon : united.polygons) {
            for (std::uint32_t i = 0; i < polygon.loopCount; ++i) {
                m_result.addPolygon(united.loop(polygon.firstLoop + i), i == 0);
            }
        }
    }

    const ShapeTable& m_shapes;
    ShapeId m_from;
    const Cutouts& m_cutouts;
    const base::Progress& m_progress;
    PolygonSet m_outline;
    EdgeStrips m_edges;
    Groups m_groups;
    std::vector<std::vector<std::size_t>> m_members;  ///< by the row that represents a group, rising
    std::vector<std::uint8_t> m_reachesOutline;       ///< likewise
    ShapeSketch m_result;
    bool m_isGone = false;
};

}  // namespace

ShapeSketch subtract(const ShapeTable& shapes, ShapeId from, const Cutouts& cutouts, const base::Progress& progress) {
    return Cutter(shapes, from, cutouts, progress).run();
}

}  // namespace model
