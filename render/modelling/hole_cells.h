#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "model/base/point.h"

namespace render {

/// Squares that stand apart, grouped so that one rectangle can take the place of many of them: wherever a straight line
/// passes between squares of a field, the field is cut there, again and again, until each part holds one square. The
/// parts of a field then tile it.
///
/// Squares at which no line passes between (a whirl, or squares that touch) are a knot, whose field cannot be tiled.
class HoleFields {
public:
    /// `spacing`: squares closer than this, nm, count as touching.
    HoleFields(std::span<const base::Box> squares, base::Nm spacing);

    struct Field {
        base::Box box;            ///< around its squares; no square of another field reaches into it
        std::uint32_t first = 0;  ///< its squares: a run of `rows`
        std::uint32_t count = 0;
        std::uint32_t firstPart = 0;  ///< the fields it is cut into, from low to high; none: one square, or a knot
        std::uint32_t partCount = 0;
        std::uint8_t axis = 0;   ///< its parts lie side by side along x (0) or y (1)
        std::uint8_t depth = 0;  ///< cuts above it
        bool isTiled = false;    ///< no knot in it
    };

    /// The first one holds all squares, parts come after their field; empty without squares.
    [[nodiscard]] std::span<const Field> fields() const { return m_fields; }
    [[nodiscard]] std::span<const std::uint32_t> squaresOf(const Field& field) const {
        return std::span(m_rows).subspan(field.first, field.count);
    }

    /// Tiles a field that has no knot: calls `visit(row of the square, its part of the box)`.
    template <class Visit>
    void tile(const Field& field, const base::Box& box, const Visit& visit) const {
        if (field.partCount == 0) {
            visit(m_rows[field.first], box);
        }
        for (std::uint32_t i = 0; i < field.partCount; ++i) {
            tile(m_fields[field.firstPart + i], partOf(field, box, i), visit);
        }
    }

private:
    void cut(std::size_t row);
    bool cutAlong(std::size_t row, std::uint8_t axis);
    void sortAlong(const Field& field, std::uint8_t axis);
    [[nodiscard]] base::Box partOf(const Field& field, const base::Box& box, std::uint32_t part) const;
    [[nodiscard]] base::Box boxAround(std::uint32_t first, std::uint32_t count) const;

    std::span<const base::Box> m_squares;
    base::Nm m_spacing;
    std::vector<std::uint32_t> m_rows;
    std::vector<std::uint64_t> m_words;  ///< to sort in
    std::vector<Field> m_fields;
};

}  // namespace render
