#pragma once

#include <optional>
#include <span>
#include <vector>

#include "model/base/point.h"
#include "model/geometry/shapes.h"

namespace model::gerber {

/// A flash on a copper layer: where a hole or a point of a netlist may belong.
struct IndexedPad {
    Point position;
    std::int32_t layer = -1;    ///< whatever the maker of the index counts
    std::int32_t feature = -1;  ///< of that layer
};

/// Finds pads by their place.
class PadIndex {
public:
    PadIndex() = default;
    explicit PadIndex(std::vector<IndexedPad> pads);

    /// Those whose middle is at most `reach` away in x and in y.
    template <class Visit>
    void visit(Point p, Nm reach, Visit visit) const {
        for (std::size_t i = firstFrom(p.x - reach); i < m_pads.size() && m_pads[i].position.x <= p.x + reach; ++i) {
            if (m_pads[i].position.y >= p.y - reach && m_pads[i].position.y <= p.y + reach) {
                visit(m_pads[i]);
            }
        }
    }
    [[nodiscard]] bool has(Point p, Nm reach) const;
    [[nodiscard]] std::span<const IndexedPad> pads() const { return m_pads; }
    [[nodiscard]] const Box& box() const { return m_box; }

    /// What has to be added to points that count from another origin so that most of them lie on pads; nothing if less
    /// than half of them can.
    [[nodiscard]] std::optional<Point> shiftOf(std::span<const Point> points, Nm reach) const;

private:
    [[nodiscard]] std::size_t firstFrom(std::int64_t x) const;
    [[nodiscard]] double share(std::span<const Point> points, Point shift, Nm reach) const;
    /// Those that most pairs of a pad and a point agree on, the likeliest first. Votes for one on the edge of the grid
    /// they are counted in are divided among cells, and rows of vias agree with each other one step further, too: so
    /// all of these are to be held against the pads.
    [[nodiscard]] std::vector<Point> likelyShifts(std::span<const Point> points) const;
    /// The pair that a shift comes from is off by rounding, or a part whose place is not the middle of its pins: most
    /// are not.
    [[nodiscard]] Point refined(Point shift, std::span<const Point> points, Nm reach) const;

    std::vector<IndexedPad> m_pads;  ///< by x
    Box m_box;
};

}  // namespace model::gerber
