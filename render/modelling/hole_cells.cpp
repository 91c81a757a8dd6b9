#include "render/modelling/hole_cells.h"

#include <algorithm>
#include <numeric>

#include "model/base/radix_sort.h"

namespace render {
namespace {

using base::Box;
using base::Nm;

/// Rows of squares are cut in two steps, most boards in four. What peels off one by one (a staircase) is a knot.
constexpr std::uint8_t kDeepest = 24;

Nm along(const base::Point& point, std::uint8_t axis) {
    return axis == 0 ? point.x : point.y;
}

Nm& along(base::Point& point, std::uint8_t axis) {
    return axis == 0 ? point.x : point.y;
}

}  // namespace

HoleFields::HoleFields(std::span<const Box> squares, Nm spacing)
    : m_squares(squares), m_spacing(spacing), m_rows(squares.size()), m_words(2 * squares.size()) {
    if (squares.empty()) {
        return;
    }
    std::iota(m_rows.begin(), m_rows.end(), 0U);
    const auto count = static_cast<std::uint32_t>(squares.size());
    m_fields.push_back({boxAround(0, count), 0, count, 0, 0, 0, 0, false});
    for (std::size_t row = 0; row < m_fields.size(); ++row) {
        cut(row);
    }
    for (std::size_t row = m_fields.size(); row-- > 0;) {
        Field& field = m_fields[row];
        const auto parts = std::span(m_fields).subspan(field.firstPart, field.partCount);
        field.isTiled = field.count == 1 || (!parts.empty() && std::ranges::all_of(parts, &Field::isTiled));
    }
}

void HoleFields::cut(std::size_t row) {
    const Field field = m_fields[row];
    if (field.count > 1 && field.depth < kDeepest) {
        const auto first = static_cast<std::uint8_t>(field.depth % 2);
        if (!cutAlong(row, first)) {
            cutAlong(row, static_cast<std::uint8_t>(1 - first));
        }
    }
}

/// At every location where no square is; false if there is none.
bool HoleFields::cutAlong(std::size_t row, std::uint8_t axis) {
    const Field field = m_fields[row];
    sortAlong(field, axis);
    const auto firstPart = static_cast<std::uint32_t>(m_fields.size());
    const auto add = [&](std::uint32_t first, std::uint32_t end) {
        m_fields.push_back({boxAround(first, end - first), first, end - first, 0, 0, 0,
                            static_cast<std::uint8_t>(field.depth + 1), false});
    };
    std::uint32_t start = field.first;
    std::int64_t reach = along(m_squares[m_rows[start]].max, axis);
    for (std::uint32_t i = start + 1; i < field.first + field.count; ++i) {
        const Box& square = m_squares[m_rows[i]];
        if (along(square.min, axis) > reach + m_spacing) {
            add(start, i);
            start = i;
        }
        reach = std::max<std::int64_t>(reach, along(square.max, axis));
    }
    if (start == field.first) {
        return false;
    }
    add(start, field.first + field.count);
    m_fields[row].axis = axis;
    m_fields[row].firstPart = firstPart;
    m_fields[row].partCount = static_cast<std::uint32_t>(m_fields.size()) - firstPart;
    return true;
}

void HoleFields::sortAlong(const Field& field, std::uint8_t axis) {
    const std::span rows = std::span(m_rows).subspan(field.first, field.count);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const std::int64_t offset = std::int64_t{along(m_squares[rows[i]].min, axis)} - along(field.box.min, axis);
        m_words[i] = static_cast<std::uint64_t>(offset) << 32U | rows[i];
    }
    const std::uint64_t* sorted = base::sortByKey(m_words.data(), m_words.data() + rows.size(), rows.size());
    std::transform(sorted, sorted + rows.size(), rows.begin(),
                   [](std::uint64_t word) { return static_cast<std::uint32_t>(word); });
}

/// Cuts lie in the middle between neighbours.
Box HoleFields::partOf(const Field& field, const Box& box, std::uint32_t part) const {
    const Field* parts = m_fields.data() + field.firstPart;
    const auto boundaryBefore = [&](std::uint32_t i) {
        return static_cast<Nm>(
            (std::int64_t{along(parts[i - 1].box.max, field.axis)} + along(parts[i].box.min, field.axis)) / 2);
    };
    Box result = box;
    if (part > 0) {
        along(result.min, field.axis) = boundaryBefore(part);
    }
    if (part + 1 < field.partCount) {
        along(result.max, field.axis) = boundaryBefore(part + 1);
    }
    return result;
}

Box HoleFields::boxAround(std::uint32_t first, std::uint32_t count) const {
    Box box;
    for (std::uint32_t i = first; i < first + count; ++i) {
        box.include(m_squares[m_rows[i]].min);
        box.include(m_squares[m_rows[i]].max);
    }
    return box;
}

}  // namespace render
