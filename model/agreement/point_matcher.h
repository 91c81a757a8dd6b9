#pragma once

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <numeric>
#include <optional>
#include <vector>

#include "model/base/point.h"

namespace model {

/// Points of one job, each of which is matched once with a point of another.
class PointMatcher {
public:
    explicit PointMatcher(std::vector<base::Point> points)
        : m_points(std::move(points)), m_order(m_points.size()), m_isTaken(m_points.size()) {
        std::iota(m_order.begin(), m_order.end(), std::size_t{0});
        std::ranges::sort(m_order, {}, [this](std::size_t i) { return std::pair(m_points[i].x, m_points[i].y); });
    }

    /// The free point within `reach` (in x and in y) that is least unlike by `unlike(row)`, and among equals the
    /// nearest; it is taken then. One of which that is negative is no match. None if there is no free point.
    template <class Unlike>
    std::optional<std::size_t> take(base::Point at, base::Nm reach, Unlike unlike) {
        std::optional<std::size_t> best;
        std::pair<int, std::int64_t> leastUnlike;
        auto next = std::ranges::lower_bound(m_order, std::int64_t{at.x} - reach, {},
                                             [this](std::size_t i) { return std::int64_t{m_points[i].x}; });
        for (; next != m_order.end() && m_points[*next].x <= std::int64_t{at.x} + reach; ++next) {
            const std::int64_t dx = std::abs(std::int64_t{m_points[*next].x} - at.x);
            const std::int64_t dy = std::abs(std::int64_t{m_points[*next].y} - at.y);
            if (dy > reach || m_isTaken[*next] != 0) {
                continue;
            }
            const std::pair<int, std::int64_t> found(unlike(*next), std::max(dx, dy));
            if (found.first >= 0 && (!best || found < leastUnlike)) {
                best = *next;
                leastUnlike = found;
            }
        }
        if (best) {
            m_isTaken[*best] = 1;
        }
        return best;
    }

    [[nodiscard]] bool isTaken(std::size_t row) const { return m_isTaken[row] != 0; }

private:
    std::vector<base::Point> m_points;
    std::vector<std::size_t> m_order;  ///< by x
    std::vector<std::uint8_t> m_isTaken;
};

}  // namespace model
