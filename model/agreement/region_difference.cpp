#include "model/agreement/region_difference.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>
#include <utility>

#include "model/base/disjoint_sets.h"
#include "model/base/parallel.h"

namespace model {

namespace {

/// Differences are collected by square cells of so many pixels: a word of a row, and as many rows.
constexpr std::int64_t kCell = 64;
/// Rows that one task holds.
constexpr std::int64_t kBandRows = 2 * kCell;

/// Where the pixels are; the middle of a pixel decides.
struct Grid {
    Point origin;  ///< lower left corner
    double pixel = 1.0;
    std::int64_t columns = 0;
    std::int64_t rows = 0;

    [[nodiscard]] double middleOf(std::int64_t row) const {
        return origin.y + (static_cast<double>(row) + 0.5) * pixel;
    }
    /// The first column whose middle is not left of x.
    [[nodiscard]] std::int64_t columnAt(double x) const {
        return static_cast<std::int64_t>(std::ceil((x - origin.x) / pixel - 0.5));
    }
    /// The first row whose middle is not below y.
    [[nodiscard]] std::int64_t rowAt(double y) const {
        return static_cast<std::int64_t>(std::ceil((y - origin.y) / pixel - 0.5));
    }
};

/// Some rows of pixels, 64 in a word.
class Bitmap {
public:
    Bitmap(std::int64_t columns, std::int64_t rows)
        : m_words(static_cast<std::size_t>((columns + 63) / 64)), m_bits(m_words * static_cast<std::size_t>(rows)) {}

    [[nodiscard]] std::size_t words() const { return m_words; }
    [[nodiscard]] std::uint64_t* row(std::int64_t row) {
        return m_bits.data() + static_cast<std::size_t>(row) * m_words;
    }
    [[nodiscard]] const std::uint64_t* row(std::int64_t row) const {
        return m_bits.data() + static_cast<std::size_t>(row) * m_words;
    }

    /// Columns from `first` up to, not including, `last`.
    void set(std::int64_t inRow, std::int64_t first, std::int64_t last) {
        std::uint64_t* bits = row(inRow);
        const auto firstWord = static_cast<std::size_t>(first / 64);
        const auto lastWord = static_cast<std::size_t>((last - 1) / 64);
        const std::uint64_t head = ~std::uint64_t{0} << (first % 64);
        const std::uint64_t tail = ~std::uint64_t{0} >> (63 - (last - 1) % 64);
        if (firstWord == lastWord) {
            bits[firstWord] |= head & tail;
            return;
        }
        bits[firstWord] |= head;
        std::fill(bits + firstWord + 1, bits + lastWord, ~std::uint64_t{0});
        bits[lastWord] |= tail;
    }

private:
    std::size_t m_words;
    std::vector<std::uint64_t> m_bits;
};

struct Crossing {
    std::int64_t row = 0;
    double x = 0.0;
    int winding = 0;
};

/// A polygon of a set with the rows it reaches.
struct PolygonRows {
    const PolygonSet* set = nullptr;
    std::size_t polygon = 0;
    std::int64_t first = 0;
    std::int64_t last = 0;  ///< not included
};

std::vector<PolygonRows> rowsOf(const PolygonSet& set, const Grid& grid) {
    std::vector<PolygonRows> rows;
    rows.reserve(set.polygons.size());
    for (std::size_t i = 0; i < set.polygons.size(); ++i) {
        if (set.polygons[i].loopCount == 0) {
            continue;
        }
        const auto [low, high] = std::ranges::minmax(set.loop(set.polygons[i].firstLoop), {}, &Point::y);
        rows.push_back({&set, i, grid.rowAt(low.y), grid.rowAt(high.y)});
    }
    return rows;
}

/// Fills polygons into the rows of a band.
class BandFiller {
public:
    BandFiller(const Grid& grid, std::int64_t first, std::int64_t last, Bitmap& bits)
        : m_grid(grid), m_first(first), m_last(last), m_bits(bits) {}

    void fill(const PolygonRows& polygon) {
        if (polygon.last <= m_first || polygon.first >= m_last) {
            return;
        }
        m_crossings.clear();
        const PolygonSet::Polygon& loops = polygon.set->polygons[polygon.polygon];
        for (std::size_t i = loops.firstLoop; i < loops.firstLoop + loops.loopCount; ++i) {
            const std::span<const Point> loop = polygon.set->loop(i);
            for (std::size_t node = 0; node < loop.size(); ++node) {
                cross(loop[node], loop[node + 1 < loop.size() ? node + 1 : 0]);
            }
        }
        std::ranges::sort(m_crossings, [](const Crossing& a, const Crossing& b) {
            return a.row != b.row ? a.row < b.row : a.x < b.x;
        });
        fillBetweenCrossings();
    }

private:
    void cross(Point a, Point b) {
        const int winding = a.y < b.y ? 1 : -1;
        const auto [low, high] = a.y < b.y ? std::pair(a, b) : std::pair(b, a);
        const std::int64_t first = std::max(m_first, m_grid.rowAt(low.y));
        const std::int64_t last = std::min(m_last, m_grid.rowAt(high.y));
        const double slope =
            low.y == high.y ? 0.0 : (static_cast<double>(high.x) - low.x) / (static_cast<double>(high.y) - low.y);
        for (std::int64_t row = first; row < last; ++row) {
            m_crossings.push_back({row, low.x + slope * (m_grid.middleOf(row) - low.y), winding});
        }
    }

    void fillBetweenCrossings() {
        int winding = 0;
        for (std::size_t i = 0; i + 1 < m_crossings.size(); ++i) {
            winding += m_crossings[i].winding;
            if (m_crossings[i].row != m_crossings[i + 1].row) {
                winding = 0;
            }
            if (winding != 0) {
                const std::int64_t first = std::max<std::int64_t>(0, m_grid.columnAt(m_crossings[i].x));
                const std::int64_t last = std::min(m_grid.columns, m_grid.columnAt(m_crossings[i + 1].x));
                if (first < last) {
                    m_bits.set(m_crossings[i].row - m_first, first, last);
                }
            }
        }
    }

    const Grid& m_grid;
    std::int64_t m_first;
    std::int64_t m_last;
    Bitmap& m_bits;
    std::vector<Crossing> m_crossings;
};

/// What differs in a cell; columns and rows in pixels of the grid.
struct DifferingCell {
    std::int64_t column = 0;  ///< in cells
    std::int64_t row = 0;
    std::int64_t only[2]{};
    std::int64_t lowest[2]{};  ///< column and row of its first pixel that differs
    std::int64_t minColumn = 0, maxColumn = -1, minRow = 0, maxRow = -1;

    void note(std::int64_t first, std::int64_t last, std::int64_t inRow) {
        if (maxRow < 0) {
            lowest[0] = minColumn = first;
            lowest[1] = minRow = inRow;
        }
        minColumn = std::min(minColumn, first);
        maxColumn = std::max(maxColumn, last);
        maxRow = inRow;
    }
};

/// What the task of a band finds.
struct BandCount {
    std::int64_t areas[2]{};
    std::vector<DifferingCell> cells;  ///< row by row
};

/// Counts the rows of a band that are its own; one more row on either side belongs to its neighbours.
class BandCounter {
public:
    /// `firstRow` of the grid is row 0 of the bitmaps.
    BandCounter(const Bitmap& a, const Bitmap& b, std::int64_t firstRow)
        : m_bits{&a, &b}, m_firstRow(firstRow), m_cells(a.words()) {}

    BandCount count(std::int64_t first, std::int64_t last) {
        for (std::int64_t row = first; row < last; ++row) {
            for (const int side : {0, 1}) {
                for (std::size_t word = 0; word < m_bits[side]->words(); ++word) {
                    m_count.areas[side] += std::popcount(m_bits[side]->row(row)[word]);
                    countWord(side, row, word);
                }
            }
            if (row + 1 == last || (m_firstRow + row + 1) % kCell == 0) {
                endCells((m_firstRow + row) / kCell);
            }
        }
        return std::move(m_count);
    }

private:
    /// What only this side covers.
    [[nodiscard]] std::uint64_t excess(int side, std::int64_t row, std::size_t word) const {
        return m_bits[side]->row(row)[word] & ~m_bits[1 - side]->row(row)[word];
    }
    /// The same where it has excess to the left and right too.
    [[nodiscard]] std::uint64_t innerExcess(int side, std::int64_t row, std::size_t word) const {
        const std::uint64_t here = excess(side, row, word);
        const std::uint64_t left = word > 0 ? excess(side, row, word - 1) >> 63 : 0;
        const std::uint64_t right = word + 1 < m_bits[side]->words() ? excess(side, row, word + 1) << 63 : 0;
        return here & (here << 1 | left) & (here >> 1 | right);
    }

    void countWord(int side, std::int64_t row, std::size_t word) {
        if (excess(side, row, word) == 0) {
            return;
        }
        const std::uint64_t eroded =
            innerExcess(side, row - 1, word) & innerExcess(side, row, word) & innerExcess(side, row + 1, word);
        if (eroded == 0) {
            return;
        }
        m_cells[word].only[side] += std::popcount(eroded);
        const auto column = kCell * static_cast<std::int64_t>(word);
        m_cells[word].note(column + std::countr_zero(eroded), column + 63 - std::countl_zero(eroded), m_firstRow + row);
    }

    void endCells(std::int64_t row) {
        for (std::size_t column = 0; column < m_cells.size(); ++column) {
            if (m_cells[column].maxRow >= 0) {
                m_cells[column].column = static_cast<std::int64_t>(column);
                m_cells[column].row = row;
                m_count.cells.push_back(std::exchange(m_cells[column], {}));
            }
        }
    }

    const Bitmap* m_bits[2];
    std::int64_t m_firstRow;
    std::vector<DifferingCell> m_cells;  ///< of the row of cells that is being counted
    BandCount m_count;
};

/// A pixel more on all sides, so that what is beyond counts as empty.
Grid gridAround(const PolygonSet& a, const PolygonSet& b, Nm pixel) {
    Box box;
    for (const PolygonSet* set : {&a, &b}) {
        for (const Point point : set->points) {
            box.include(point);
        }
    }
    if (box.isEmpty()) {
        return {};
    }
    Grid grid;
    grid.pixel = pixel;
    grid.origin = {static_cast<Nm>(box.min.x - pixel), static_cast<Nm>(box.min.y - pixel)};
    grid.columns = box.width() / pixel + 3;
    grid.rows = box.height() / pixel + 3;
    return grid;
}

BandCount countBand(const Grid& grid, const std::vector<PolygonRows> (&polygons)[2], std::int64_t first) {
    const std::int64_t last = std::min(grid.rows, first + kBandRows);
    const std::int64_t rows = last - first + 2;
    Bitmap a(grid.columns, rows);
    Bitmap b(grid.columns, rows);
    Bitmap* bits[2] = {&a, &b};
    for (const int side : {0, 1}) {
        BandFiller filler(grid, first - 1, last + 1, *bits[side]);
        for (const PolygonRows& polygon : polygons[side]) {
            filler.fill(polygon);
        }
    }
    return BandCounter(a, b, first - 1).count(1, rows - 1);
}

Point cornerOf(const Grid& grid, std::int64_t column, std::int64_t row) {
    return {static_cast<Nm>(grid.origin.x + static_cast<double>(column) * grid.pixel),
            static_cast<Nm>(grid.origin.y + static_cast<double>(row) * grid.pixel)};
}

/// Sets of cells, which come row by row, that touch at a side or corner.
DisjointSets joined(const std::vector<DifferingCell>& cells) {
    DisjointSets sets(cells.size());
    const auto joinWith = [&](std::size_t cell, std::int64_t column, std::int64_t row) {
        const auto found = std::ranges::lower_bound(cells, std::pair(row, column), {}, [](const DifferingCell& each) {
            return std::pair(each.row, each.column);
        });
        if (found != cells.end() && found->row == row && found->column == column) {
            sets.join(static_cast<std::uint32_t>(cell), static_cast<std::uint32_t>(found - cells.begin()));
        }
    };
    for (std::size_t i = 0; i < cells.size(); ++i) {
        joinWith(i, cells[i].column - 1, cells[i].row);
        for (const std::int64_t beside : {-1, 0, 1}) {
            joinWith(i, cells[i].column + beside, cells[i].row - 1);
        }
    }
    return sets;
}

void addCell(RegionDifference::Place& place, const DifferingCell& cell, const Grid& grid) {
    const Point at = cornerOf(grid, cell.lowest[0], cell.lowest[1]);
    if (place.box.isEmpty() || std::pair(at.y, at.x) < std::pair(place.at.y, place.at.x)) {
        place.at = at;
    }
    place.box.include(cornerOf(grid, cell.minColumn, cell.minRow));
    place.box.include(cornerOf(grid, cell.maxColumn + 1, cell.maxRow + 1));
    for (const int side : {0, 1}) {
        place.only[side] += grid.pixel * grid.pixel * static_cast<double>(cell.only[side]);
    }
}

std::vector<RegionDifference::Place> placesOf(const std::vector<DifferingCell>& cells, const Grid& grid) {
    DisjointSets sets = joined(cells);
    std::vector<RegionDifference::Place> places;
    std::vector<std::size_t> placeOf(cells.size());
    for (std::uint32_t i = 0; i < cells.size(); ++i) {
        const std::uint32_t root = sets.find(i);  // the first of its set
        if (root == i) {
            placeOf[i] = places.size();
            places.emplace_back();
        }
        addCell(places[placeOf[root]], cells[i], grid);
    }
    std::ranges::stable_sort(places, std::greater(), [](const auto& place) { return place.only[0] + place.only[1]; });
    return places;
}

}  // namespace

double RegionDifference::share() const {
    const double larger = std::max(areas[0], areas[1]);
    return larger > 0.0 ? (only[0] + only[1]) / larger : 0.0;
}

RegionDifference differenceOf(const PolygonSet& a, const PolygonSet& b, Nm pixel) {
    const Grid grid = gridAround(a, b, pixel);
    const std::vector<PolygonRows> polygons[2] = {rowsOf(a, grid), rowsOf(b, grid)};
    std::vector<BandCount> bands(static_cast<std::size_t>((grid.rows + kBandRows - 1) / kBandRows));
    base::parallelFor(bands.size(), [&](std::size_t band) {
        bands[band] = countBand(grid, polygons, static_cast<std::int64_t>(band) * kBandRows);
    });
    RegionDifference sum;
    std::vector<DifferingCell> cells;
    for (const BandCount& band : bands) {
        for (const int side : {0, 1}) {
            sum.areas[side] += grid.pixel * grid.pixel * static_cast<double>(band.areas[side]);
        }
        cells.insert(cells.end(), band.cells.begin(), band.cells.end());
    }
    sum.places = placesOf(cells, grid);
    for (const RegionDifference::Place& place : sum.places) {
        sum.only[0] += place.only[0];
        sum.only[1] += place.only[1];
        sum.box.include(place.box);
    }
    return sum;
}

}  // namespace model
