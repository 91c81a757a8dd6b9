#include "model/formats/kicad/text_boxes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "model/formats/kicad/graphics.h"
#include "model/formats/kicad/text/values.h"

namespace model::kicad {

namespace {

constexpr double kOldMargin = 0.75;        ///< of the text's height, where a file names no margins (KiCad 7)
constexpr double kDefaultPen = 100'000.0;  ///< of borders without a width
constexpr std::size_t kMostColumns = 10'000;

/// A box along its text.
struct TextBox {
    Frame turn;  ///< from the text's directions to the footprint's
    PointD min;
    PointD max;

    [[nodiscard]] std::array<PointD, 4> corners() const {
        return {turn.apply(min), turn.apply({max.x, min.y}), turn.apply(max), turn.apply({min.x, max.y})};
    }
};

/// From two corners, or all of them where the box is turned; none if they are not there.
std::optional<TextBox> boxOf(const Item& item) {
    std::vector<PointD> corners;
    const std::optional<PointD> start = point(item, "start");
    const std::optional<PointD> end = point(item, "end");
    if (start && end) {
        corners = {*start, {start->x, end->y}, *end, {end->x, start->y}};
    }
    for (const Item xy : item.find("pts")) {
        const std::optional<PointD> corner = xy.isList() ? pointOf(xy) : std::nullopt;
        if (corner) {
            corners.push_back(*corner);
        }
    }
    if (corners.size() < 3) {
        return {};
    }
    TextBox box;
    box.turn.degrees = numberOf(item.find("angle").word(1)).value_or(0.0);
    const Frame back{{}, -box.turn.degrees};
    box.min = box.max = back.apply(corners[0]);
    for (const PointD corner : corners) {
        const PointD p = back.apply(corner);
        box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
        box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
    }
    return box;
}

double penOf(const Item& item) {
    const Item stroke = item.find("stroke");
    return stroke.isThere() ? length(stroke, "width") : 0.0;
}

/// Left, top, right, bottom.
std::array<double, 4> marginsOf(const Item& item, const TextStyle& style) {
    const Item given = item.find("margins");
    std::array<double, 4> margins{};
    margins.fill(std::max(penOf(item), 0.0) / 2.0 + style.height * kOldMargin);
    for (std::size_t i = 0; i < 4 && given.isThere(); ++i) {
        margins[i] = lengthOf(given.word(i + 1)).value_or(0.0);
    }
    return margins;
}

/// The text of a box or cell, at the edges where it is anchored.
void drawBoxedText(Canvas& canvas, const Item& item, const TextBox& box, const Frame& frame, const Variables& variables,
                   const Origin& origin) {
    const TextStyle style = styleOf(item);
    const auto [left, top, right, bottom] = marginsOf(item, style);
    const double across = style.isMirrored ? 1.0 - style.across : style.across;
    const PointD anchor = {across == 0.5  ? (box.min.x + box.max.x) / 2.0
                           : across < 0.5 ? box.min.x + left
                                          : box.max.x - right,
                           style.up == 0.5  ? (box.min.y + box.max.y) / 2.0
                           : style.up < 0.5 ? box.min.y + bottom
                                            : box.max.y - top};
    const std::string text = shownText(canvas, item, item.text(1), variables);
    const double width = box.max.x - box.min.x - left - right;
    TextPlace place{item,
                    wrapped(text, style, width),
                    {frame.apply(box.turn.apply(anchor)), frame.degrees + box.turn.degrees},
                    false};
    for (const PointD corner : box.corners()) {
        place.box.push_back(frame.apply(corner));
    }
    drawText(canvas, place, origin);
}

/// With the (stroke …) of an item.
void drawLine(Canvas& canvas, std::int32_t row, PointD from, PointD to, const Item& stroked, const Origin& origin) {
    const std::optional<Point> a = canvas.onGrid(from, origin.line);
    const std::optional<Point> b = canvas.onGrid(to, origin.line);
    if (a && b) {
        const double pen = penOf(stroked);
        drawStyled(canvas, row, origin, {{*a, {}, EdgeKind::Line}, *b}, pen > 0.0 ? pen : kDefaultPen,
                   styleOfLine(stroked));
    }
}

/// One table.
class TableMaker {
public:
    TableMaker(Canvas& canvas, const Item& table, const Frame& frame, const Origin& origin)
        : m_canvas(canvas), m_table(table), m_frame(frame), m_origin(origin), m_rows(canvas.rowsOf(table)) {}

    void draw(const Variables& variables) {
        readCells();
        for (const Cell& cell : m_cells) {
            if (!cell.text.empty() && cell.columns > 0 && cell.rows > 0) {
                Origin origin = m_origin;
                origin.line = cell.item.line();
                drawBoxedText(m_canvas, cell.item, cell.box, m_frame, variables, origin);
            }
            drawSeparators(cell);
        }
        drawAround();
    }

private:
    struct Cell {
        Item item;
        TextBox box;
        std::string text;
        std::size_t row = 0;
        std::size_t column = 0;
        std::size_t columns = 1;  ///< that it spans; 0: another one spans it
        std::size_t rows = 1;
    };

    void readCells() {
        const double given = std::floor(number(m_table, "column_count", 1.0));
        if (!(given >= 1.0 && given <= static_cast<double>(kMostColumns))) {
            m_canvas.report(Severity::Warning, m_table.line(), "a table has no number of columns; one was assumed");
        }
        m_columnCount = static_cast<std::size_t>(std::clamp(given, 1.0, static_cast<double>(kMostColumns)));
        std::size_t index = 0;
        for (const Item item : m_table.find("cells")) {
            if (item.head() != "table_cell") {
                continue;
            }
            const std::optional<TextBox> box = boxOf(item);
            if (box) {
                const Item span = item.find("span");
                m_cells.push_back({item, *box, item.text(1), index / m_columnCount, index % m_columnCount,
                                   spanOf(span.word(1)), spanOf(span.word(2))});
            } else {
                m_canvas.report(Severity::Warning, item.line(), "a cell of a table has no place; it was left out");
            }
            ++index;
        }
        m_rowCount = (index + m_columnCount - 1) / m_columnCount;
        if (m_cells.empty()) {
            m_canvas.report(Severity::Warning, m_table.line(), "a table has no cells; it draws nothing");
        }
    }

    static std::size_t spanOf(std::string_view word) {
        return static_cast<std::size_t>(std::clamp(numberOf(word).value_or(1.0), 0.0, 1e4));
    }

    void drawOnRows(PointD from, PointD to, const TextBox& box, const Item& stroked) {
        for (const std::int32_t row : m_rows) {
            drawLine(m_canvas, row, m_frame.apply(box.turn.apply(from)), m_frame.apply(box.turn.apply(to)), stroked,
                     m_origin);
        }
    }

    /// Below the cell and to its right, where others follow.
    void drawSeparators(const Cell& cell) {
        if (cell.columns == 0 || cell.rows == 0) {
            return;
        }
        const Item border = m_table.find("border");
        const Item separators = m_table.find("separators");
        const TextBox& box = cell.box;
        if (separators.isSet("cols") && cell.column + cell.columns < m_columnCount) {
            drawOnRows({box.max.x, box.min.y}, box.max, box, separators);
        }
        const bool isHeader = cell.row + cell.rows == 1 && border.isSet("header");
        if ((isHeader || separators.isSet("rows")) && cell.row + cell.rows < m_rowCount) {
            drawOnRows(box.min, {box.max.x, box.min.y}, box, isHeader ? border : separators);
        }
    }

    void drawAround() {
        const Item border = m_table.find("border");
        if (m_cells.empty() || !border.isSet("external")) {
            return;
        }
        TextBox all = m_cells.front().box;
        for (const Cell& cell : m_cells) {
            all.min = {std::min(all.min.x, cell.box.min.x), std::min(all.min.y, cell.box.min.y)};
            all.max = {std::max(all.max.x, cell.box.max.x), std::max(all.max.y, cell.box.max.y)};
        }
        const PointD right = {all.max.x, all.min.y};
        const PointD left = {all.min.x, all.max.y};
        for (const auto& [from, to] : {std::pair(all.min, right), std::pair(right, all.max), std::pair(all.max, left),
                                       std::pair(left, all.min)}) {
            drawOnRows(from, to, all, border);
        }
    }

    Canvas& m_canvas;
    const Item& m_table;
    const Frame& m_frame;
    Origin m_origin;
    std::vector<std::int32_t> m_rows;
    std::vector<Cell> m_cells;
    std::size_t m_columnCount = 1;
    std::size_t m_rowCount = 0;
};

}  // namespace

void drawTextBox(Canvas& canvas, const Item& item, const Frame& frame, const Variables& variables,
                 const Origin& origin) {
    const std::optional<TextBox> box = boxOf(item);
    if (!box) {
        canvas.report(Severity::Warning, item.line(), "a text box has no place; it was left out");
        return;
    }
    drawBoxedText(canvas, item, *box, frame, variables, origin);
    const Item border = item.find("border");
    if ((border.isThere() && border.word(1) == "no") || penOf(item) < 0.0) {
        return;
    }
    const std::array<PointD, 4> corners = box->corners();
    for (const std::int32_t row : canvas.rowsOf(item)) {
        for (std::size_t i = 0; i < 4; ++i) {
            drawLine(canvas, row, frame.apply(corners[i]), frame.apply(corners[(i + 1) % 4]), item, origin);
        }
    }
}

void drawTable(Canvas& canvas, const Item& table, const Frame& frame, const Variables& variables,
               const Origin& origin) {
    TableMaker(canvas, table, frame, origin).draw(variables);
}

}  // namespace model::kicad
