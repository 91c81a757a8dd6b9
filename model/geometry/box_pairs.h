#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "model/geometry/box_index.h"

namespace model {

/// Boxes by level strips of the plane, in each in the order of their left sides: what boxes meet is found by looking to
/// the right within a strip. There are so few strips that boxes are in four of them on average at most.
class BoxStrips {
public:
    /// Empty boxes are in no strip.
    explicit BoxStrips(std::span<const base::Box> boxes);

    [[nodiscard]] std::size_t count() const { return m_first.size() - 1; }
    /// The boxes that reach into a strip.
    [[nodiscard]] std::span<const std::uint32_t> rowsOf(std::size_t strip) const {
        return std::span(m_rows).subspan(m_first[strip], m_first[strip + 1] - m_first[strip]);
    }
    [[nodiscard]] std::size_t stripAt(base::Nm y) const;
    /// How many boxes the fullest strip has.
    [[nodiscard]] std::size_t mostRows() const;

private:
    template <class Visit>
    void visitStrips(const base::Box& box, const Visit& visit) const {
        const std::size_t last = stripAt(box.max.y);
        for (std::size_t strip = stripAt(box.min.y); strip <= last; ++strip) {
            visit(strip);
        }
    }

    std::vector<std::uint32_t> m_first;  ///< of m_rows, and the end
    std::vector<std::uint32_t> m_rows;
    base::Nm m_bottom = 0;
    double m_stripsPerNm = 0.0;
};

/// Boxes are swept where no strip has more of them than this; others (long ones one above the other, crowds) are looked
/// up in a BoxIndex.
inline constexpr std::size_t kMostSwept = 2000;

/// As visitPairs(), by an index.
template <class IsWanted, class Visit>
void visitIndexedPairs(std::span<const base::Box> boxes, const IsWanted& isWanted, const Visit& visit) {
    const BoxIndex index(boxes);
    for (std::uint32_t i = 0; i < boxes.size(); ++i) {
        if (isWanted(i)) {
            index.visit(boxes[i], [&](std::uint32_t j) {
                if (j > i || (j < i && !isWanted(j))) {
                    visit(i, j);
                }
            });
        }
    }
}

/// Calls `visit(i, j)` once for every pair of boxes that share a point, of which `isWanted(i)` or `isWanted(j)`; in an
/// order that depends on the boxes only.
template <class IsWanted, class Visit>
void visitPairs(std::span<const base::Box> boxes, const IsWanted& isWanted, const Visit& visit) {
    const BoxStrips strips(boxes);
    if (strips.mostRows() > kMostSwept) {
        return visitIndexedPairs(boxes, isWanted, visit);
    }
    for (std::size_t strip = 0; strip < strips.count(); ++strip) {
        const std::span<const std::uint32_t> rows = strips.rowsOf(strip);
        for (std::size_t k = 0; k < rows.size(); ++k) {
            const std::uint32_t i = rows[k];
            for (std::size_t l = k + 1; l < rows.size() && boxes[rows[l]].min.x <= boxes[i].max.x; ++l) {
                const std::uint32_t j = rows[l];
                // Two that are together in several strips are met in the first of them.
                if (boxes[i].meets(boxes[j]) && (isWanted(i) || isWanted(j)) &&
                    strips.stripAt(std::max(boxes[i].min.y, boxes[j].min.y)) == strip) {
                    visit(i, j);
                }
            }
        }
    }
}

}  // namespace model
