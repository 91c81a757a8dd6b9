#include "tests/reference/raster.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <numbers>

namespace reference {

namespace {

constexpr double kTurn = 0.4142;  // radians; no edge of a usual board is then near an axis or a diagonal of the samples
constexpr double kChord = 0.05e-3;
constexpr double kPi = std::numbers::pi;

struct Crossing {
    std::size_t row;
    double x;
    int step;
};

double signedArea(const Contour& contour) {
    double twice = 0.0;
    for (std::size_t i = 0; i < contour.size(); ++i) {
        const Point a = contour[i];
        const Point b = contour[(i + 1) % contour.size()];
        twice += a.x * b.y - b.x * a.y;
    }
    return twice / 2;
}

}  // namespace

Raster::Raster(Point low, Point high, double pitch) : m_pitch(pitch) {
    Point min{1e9, 1e9};
    Point max{-1e9, -1e9};
    for (const Point corner : {low, Point{high.x, low.y}, high, Point{low.x, high.y}}) {
        const Point p = rotated(corner);
        min = {std::min(min.x, p.x), std::min(min.y, p.y)};
        max = {std::max(max.x, p.x), std::max(max.y, p.y)};
    }
    m_left = min.x - pitch;
    m_bottom = min.y - pitch;
    m_columns = static_cast<std::size_t>((max.x - m_left) / pitch) + 2;
    m_rows = static_cast<std::size_t>((max.y - m_bottom) / pitch) + 2;
    m_words = (m_columns + 63) / 64;
    m_bits.resize(m_words * m_rows);
}

Point Raster::rotated(Point p) const {
    return {p.x * std::cos(kTurn) - p.y * std::sin(kTurn), p.x * std::sin(kTurn) + p.y * std::cos(kTurn)};
}

Point Raster::board(std::size_t row, std::size_t column) const {
    const double x = m_left + static_cast<double>(column) * m_pitch;
    const double y = m_bottom + static_cast<double>(row) * m_pitch;
    return {x * std::cos(kTurn) + y * std::sin(kTurn), y * std::cos(kTurn) - x * std::sin(kTurn)};
}

std::size_t Raster::sampleFrom(double at, double origin, std::size_t count) const {
    const double row = std::ceil((at - origin) / m_pitch);
    return static_cast<std::size_t>(std::clamp(row, 0.0, static_cast<double>(count)));
}

void Raster::set(std::size_t row, std::size_t from, std::size_t end, bool value) {
    std::uint64_t* words = m_bits.data() + row * m_words;
    while (from < end) {
        const std::size_t bit = from % 64;
        const std::size_t run = std::min<std::size_t>(64 - bit, end - from);
        const std::uint64_t mask = (run == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << run) - 1) << bit;
        words[from / 64] = value ? words[from / 64] | mask : words[from / 64] & ~mask;
        from += run;
    }
}

void Raster::fill(const std::vector<Contour>& contours, bool value, Rule rule) {
    std::vector<Crossing> crossings;
    for (const Contour& contour : contours) {
        for (std::size_t i = 0; i < contour.size(); ++i) {
            const Point a = rotated(contour[i]);
            const Point b = rotated(contour[(i + 1) % contour.size()]);
            const std::size_t first = sampleFrom(std::min(a.y, b.y), m_bottom, m_rows);
            const std::size_t end = sampleFrom(std::max(a.y, b.y), m_bottom, m_rows);
            for (std::size_t row = first; row < end; ++row) {
                const double y = m_bottom + static_cast<double>(row) * m_pitch;
                crossings.push_back({row, a.x + (b.x - a.x) * (y - a.y) / (b.y - a.y), b.y < a.y ? 1 : -1});
            }
        }
    }
    std::ranges::sort(crossings,
                      [](const Crossing& p, const Crossing& q) { return p.row != q.row ? p.row < q.row : p.x < q.x; });
    int winding = 0;
    for (std::size_t i = 0; i + 1 < crossings.size(); ++i) {
        winding = (i > 0 && crossings[i - 1].row != crossings[i].row ? 0 : winding) + crossings[i].step;
        const bool isInside = rule == Rule::Winding ? winding > 0 : winding % 2 != 0;
        if (isInside && crossings[i + 1].row == crossings[i].row) {
            set(crossings[i].row, sampleFrom(crossings[i].x, m_left, m_columns),
                sampleFrom(crossings[i + 1].x, m_left, m_columns), value);
        }
    }
}

void Raster::fill(Point middle, double reach, const std::function<bool(Point)>& isInside, bool value) {
    const Point m = rotated(middle);
    const std::size_t endRow = sampleFrom(m.y + reach, m_bottom, m_rows);
    const std::size_t endColumn = sampleFrom(m.x + reach, m_left, m_columns);
    for (std::size_t row = sampleFrom(m.y - reach, m_bottom, m_rows); row < endRow; ++row) {
        for (std::size_t column = sampleFrom(m.x - reach, m_left, m_columns); column < endColumn; ++column) {
            if (isInside(board(row, column))) {
                set(row, column, column + 1, value);
            }
        }
    }
}

double Raster::area() const {
    std::size_t count = 0;
    for (const std::uint64_t word : m_bits) {
        count += static_cast<std::size_t>(std::popcount(word));
    }
    return static_cast<double>(count) * m_pitch * m_pitch;
}

double Raster::difference(const Raster& other) const {
    std::size_t count = 0;
    for (std::size_t i = 0; i < m_bits.size(); ++i) {
        count += static_cast<std::size_t>(std::popcount(m_bits[i] ^ other.m_bits[i]));
    }
    return static_cast<double>(count) * m_pitch * m_pitch;
}

double Raster::differenceWider(const Raster& other, std::size_t around) const {
    // A square of differing samples ends at a column whose runs upwards, and those before it, are long enough.
    std::vector<std::uint16_t> above(m_columns);
    std::size_t count = 0;
    for (std::size_t row = 0; row < m_rows; ++row) {
        std::size_t run = 0;
        std::size_t rows = 0;
        for (std::size_t column = 0; column < m_columns; ++column) {
            const std::size_t word = row * m_words + column / 64;
            const bool isOther = ((m_bits[word] ^ other.m_bits[word]) >> (column % 64) & 1) != 0;
            above[column] = static_cast<std::uint16_t>(isOther ? std::min(above[column] + 1, 60'000) : 0);
            run = above[column] > 2 * around ? run + 1 : 0;
            rows += run > 2 * around ? 1 : 0;
        }
        count += rows;
    }
    return static_cast<double>(count) * m_pitch * m_pitch;
}

void appendArc(Contour& contour, Point from, Point to, Point centre, bool isClockwise) {
    const double start = std::atan2(from.y - centre.y, from.x - centre.x);
    double sweep = std::atan2(to.y - centre.y, to.x - centre.x) - start;
    const double radius = std::hypot(from.x - centre.x, from.y - centre.y);
    const double endRadius = std::hypot(to.x - centre.x, to.y - centre.y);
    const bool isFull = from.x == to.x && from.y == to.y;
    if (isClockwise && (sweep >= 0 || isFull)) {
        sweep -= 2 * kPi;
    } else if (!isClockwise && (sweep <= 0 || isFull)) {
        sweep += 2 * kPi;
    }
    if (isFull) {
        sweep = isClockwise ? -2 * kPi : 2 * kPi;
    }
    const double step = 2 * std::acos(std::max(0.9, 1 - kChord / std::max(radius, 1e-6)));
    const int count = std::max(1, static_cast<int>(std::ceil(std::abs(sweep) / step)));
    for (int i = 0; i < count; ++i) {
        const double t = static_cast<double>(i) / count;
        const double r = radius + (endRadius - radius) * t;
        contour.push_back({centre.x + r * std::cos(start + sweep * t), centre.y + r * std::sin(start + sweep * t)});
    }
}

Contour circle(Point centre, double radius) {
    Contour contour;
    appendArc(contour, {centre.x + radius, centre.y}, {centre.x + radius, centre.y}, centre, false);
    return contour;
}

Contour wound(Contour contour, bool isHole) {
    if ((signedArea(contour) < 0) != isHole) {
        std::ranges::reverse(contour);
    }
    return contour;
}

std::vector<Contour> lineTrack(Point a, Point b, double width) {
    const double length = std::hypot(b.x - a.x, b.y - a.y);
    const double r = width / 2;
    if (length == 0.0 || r <= 0.0) {
        return {circle(a, r)};
    }
    const Point side{(a.y - b.y) / length * r, (b.x - a.x) / length * r};
    Contour contour;
    contour.push_back({a.x - side.x, a.y - side.y});
    appendArc(contour, {b.x - side.x, b.y - side.y}, {b.x + side.x, b.y + side.y}, b, false);
    contour.push_back({b.x + side.x, b.y + side.y});
    appendArc(contour, {a.x + side.x, a.y + side.y}, {a.x - side.x, a.y - side.y}, a, false);
    return {contour};
}

std::vector<Contour> arcTrack(Point from, Point to, Point centre, bool isClockwise, double width) {
    // As short lines: their pens overlap, which the winding number allows.
    Contour path;
    appendArc(path, from, to, centre, isClockwise);
    path.push_back(to);
    std::vector<Contour> pieces;
    for (std::size_t i = 0; i + 1 < path.size(); ++i) {
        const std::vector<Contour> piece = lineTrack(path[i], path[i + 1], width);
        pieces.insert(pieces.end(), piece.begin(), piece.end());
    }
    return pieces;
}

}  // namespace reference
