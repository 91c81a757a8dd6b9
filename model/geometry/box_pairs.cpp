#include "model/geometry/box_pairs.h"

#include <limits>
#include <utility>

namespace model {

namespace {

/// A strip is to hold about so many boxes.
constexpr double kBoxesOfStrip = 128.0;
/// Boxes are in at most one strip more than this on average.
constexpr double kMostStripsOfBox = 3.0;

/// Rows of boxes that are not empty, from left to right.
std::vector<std::pair<base::Nm, std::uint32_t>> fromLeft(std::span<const base::Box> boxes) {
    std::vector<std::pair<base::Nm, std::uint32_t>> order;
    order.reserve(boxes.size());
    for (std::size_t row = 0; row < boxes.size(); ++row) {
        if (!boxes[row].isEmpty()) {
            order.emplace_back(boxes[row].min.x, static_cast<std::uint32_t>(row));
        }
    }
    std::ranges::sort(order);
    return order;
}

}  // namespace

BoxStrips::BoxStrips(std::span<const base::Box> boxes) {
    const auto order = fromLeft(boxes);
    m_bottom = std::numeric_limits<base::Nm>::max();
    base::Nm top = std::numeric_limits<base::Nm>::min();
    double heights = 0.0;
    for (const auto& [left, row] : order) {
        m_bottom = std::min(m_bottom, boxes[row].min.y);
        top = std::max(top, boxes[row].max.y);
        heights += static_cast<double>(boxes[row].max.y) - boxes[row].min.y;
    }
    const double height = std::max(static_cast<double>(top) - m_bottom, 1.0);
    const double size = static_cast<double>(order.size());
    const double most = kMostStripsOfBox * size * height / std::max(heights, 1.0);
    const auto strips = static_cast<std::size_t>(std::max(std::min(size / kBoxesOfStrip, most), 1.0));
    m_stripsPerNm = static_cast<double>(strips) / (height + 1.0);
    m_first.assign(strips + 1, 0);
    for (const auto& [left, row] : order) {
        visitStrips(boxes[row], [&](std::size_t strip) { ++m_first[strip + 1]; });
    }
    for (std::size_t strip = 0; strip < strips; ++strip) {
        m_first[strip + 1] += m_first[strip];
    }
    m_rows.resize(m_first.back());
    std::vector<std::uint32_t> next(m_first.begin(), m_first.end() - 1);
    for (const auto& [left, row] : order) {
        visitStrips(boxes[row], [&, row = row](std::size_t strip) { m_rows[next[strip]++] = row; });
    }
}

std::size_t BoxStrips::stripAt(base::Nm y) const {
    return static_cast<std::size_t>((static_cast<double>(y) - m_bottom) * m_stripsPerNm);
}

std::size_t BoxStrips::mostRows() const {
    std::size_t most = 0;
    for (std::size_t strip = 0; strip < count(); ++strip) {
        most = std::max(most, rowsOf(strip).size());
    }
    return most;
}

}  // namespace model
