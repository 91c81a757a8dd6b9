#include "model/design_rules/board_area.h"

#include <cmath>

#include "model/geometry/discretise.h"

namespace model {

namespace {

Box boxAround(PointD a, PointD b) {
    Box box;
    for (const PointD p : {a, b}) {
        box.include(Point{static_cast<Nm>(std::floor(p.x)), static_cast<Nm>(std::floor(p.y))});
        box.include(Point{static_cast<Nm>(std::ceil(p.x)), static_cast<Nm>(std::ceil(p.y))});
    }
    return box;
}

template <class Side>
std::vector<Box> boxesOf(const std::vector<Side>& sides) {
    std::vector<Box> boxes;
    for (const Side& side : sides) {
        boxes.push_back(boxAround(side.from, side.to));
    }
    return boxes;
}

}  // namespace

BoardArea::BoardArea(const Document& document) : m_index({}) {
    const PolygonSet outline = discretise(document.shapes, document.profile, {.chordToleranceNm = kUnsure});
    for (std::size_t i = 0; i < outline.loopCount(); ++i) {
        const std::span<const Point> loop = outline.loop(i);
        for (std::size_t corner = 0; corner < loop.size(); ++corner) {
            m_extent.include(loop[corner]);
            m_sides.push_back({base::toDouble(loop[corner]), base::toDouble(loop[(corner + 1) % loop.size()])});
        }
    }
    m_index = BoxIndex(boxesOf(m_sides));
}

/// By how often a ray to the right leaves the area or comes into it.
bool BoardArea::holds(PointD p) const {
    const bool isNear = !m_extent.isEmpty() && static_cast<double>(m_extent.min.x) <= p.x &&
                        p.x <= static_cast<double>(m_extent.max.x) && static_cast<double>(m_extent.min.y) <= p.y &&
                        p.y <= static_cast<double>(m_extent.max.y);
    bool isInside = false;
    if (isNear) {
        m_index.visit(boxAround(p, {static_cast<double>(m_extent.max.x), p.y}), [&](std::uint32_t row) {
            const PointD a = m_sides[row].from;
            const PointD b = m_sides[row].to;
            if ((a.y > p.y) != (b.y > p.y) && p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) {
                isInside = !isInside;
            }
        });
    }
    return isInside;
}

}  // namespace model
