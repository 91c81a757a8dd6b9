#include "render/tiles/sample_scan.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>

namespace render {

namespace {

constexpr int kFixed = 256;  // steps that corners are moved to, per pixel
constexpr double kMiddleOfRow = 0.5 / kRowsPerPixel;
constexpr int kRowSteps = kFixed / kRowsPerPixel;  // from one row of samples to the next; the first is half as far

/// A corner in steps.
struct Corner {
    std::int64_t x = 0;
    std::int64_t y = 0;
};

/// An edge of a polygon between moved corners, from its upper end down; pixels, y from `top` to before `bottom`.
struct Edge {
    double top = 0.0;
    double bottom = 0.0;
    double x = 0.0;
    double slope = 0.0;
};

// Library calls would cost more than all else of a small shape.
int ceilColumn(double x) {
    const double clamped = std::clamp(x, -1.0, kTilePixels + 1.0);
    const int whole = static_cast<int>(clamped);
    return whole + (clamped > whole ? 1 : 0);
}

int floorColumn(double x) {
    const double clamped = std::clamp(x, -2.0, kTilePixels + 1.0);
    const int whole = static_cast<int>(clamped);
    return whole - (clamped < whole ? 1 : 0);
}

Corner moved(glm::dvec2 corner) {
    const auto toStep = [](double x) { return static_cast<std::int64_t>(x * kFixed + (x < 0.0 ? -0.5 : 0.5)); };
    return {toStep(corner.x), toStep(corner.y)};
}

/// The first row of samples of a tile that is not above `y` (steps).
int firstRow(std::int64_t y) {
    constexpr std::int64_t kRows = std::int64_t{kRowsPerPixel} * kTilePixels;
    return static_cast<int>(std::clamp((y + kRowSteps / 2 - 1) / kRowSteps, std::int64_t{0}, kRows));
}

Edge edgeBetween(Corner from, Corner to) {
    if (from.y > to.y) {
        std::swap(from, to);
    }
    return {static_cast<double>(from.y) / kFixed, static_cast<double>(to.y) / kFixed,
            static_cast<double>(from.x) / kFixed,
            static_cast<double>(to.x - from.x) / static_cast<double>(to.y - from.y)};
}

/// Columns of a sample `place` from their left that lie between the edges at `y`, as [first, end).
glm::ivec2 columnsBetween(std::span<const Edge> edges, double y, double place) {
    glm::ivec2 all(kTilePixels + 1, -1);
    for (const Edge& edge : edges) {
        if (edge.top <= y && y < edge.bottom) {
            const int column = ceilColumn(edge.x + (y - edge.top) * edge.slope - place);
            all = {std::min(all.x, column), std::max(all.y, column)};
        }
    }
    return {std::max(all.x, 0), std::min(all.y, kTilePixels)};
}

}  // namespace

glm::ivec2 SampleScan::rowsBetween(double low, double high) {
    const auto rows = [](double y) { return std::clamp(y * kRowsPerPixel, 0.0, double{kRowsPerPixel} * kTilePixels); };
    const double first = rows(low - 2.0 * kBesideSample - kMiddleOfRow);
    const int whole = static_cast<int>(first);
    return {whole + (whole < first ? 1 : 0), static_cast<int>(rows(high + 2.0 * kBesideSample + kMiddleOfRow))};
}

SampleScan::Track::Track(glm::dvec2 first, glm::dvec2 last, double r)
    : a(first), b(last), along(last - first), radius(r) {
    const double length = glm::length(along);
    side = length > 0.0 ? r / length * glm::dvec2(-along.y, along.x) : glm::dvec2(0.0);
}

SampleScan::Span SampleScan::Track::at(double y) const {
    Span span{1e30, -1e30};
    const auto include = [&](double from, double to) { span = {std::min(span.from, from), std::max(span.to, to)}; };
    const auto disc = [&](glm::dvec2 centre) {
        const double away = y - centre.y;
        const double rest = radius * radius - away * away;
        if (rest >= 0.0 && radius > 0.0) {
            const double half = std::sqrt(rest);
            include(centre.x - half, centre.x + half);
        }
    };
    disc(a);
    if (along == glm::dvec2(0.0)) {
        return span;
    }
    disc(b);
    for (const double sign : {-1.0, 1.0}) {
        const glm::dvec2 start = a + sign * side;
        const double part = along.y != 0.0 ? (y - start.y) / along.y : -1.0;
        if (part >= 0.0 && part <= 1.0) {
            const double x = start.x + part * along.x;
            include(x, x);
        }
    }
    return span;
}

glm::ivec2 SampleScan::columns(Span span, std::size_t sample) {
    const double place = kSamplePlaces[sample].x + kBesideSample;
    if (span.from > span.to) {
        return glm::ivec2(0);
    }
    return {std::max(ceilColumn(span.from - place), 0), std::min(floorColumn(span.to - place) + 1, kTilePixels)};
}

void SampleScan::cover(int row, std::size_t sample, glm::ivec2 columns) {
    const auto bit = static_cast<std::uint8_t>(1U << (sample + static_cast<std::size_t>(m_shift)));
    std::uint8_t* at = m_tile->data() + static_cast<std::size_t>(row) * kTilePixels;
    int column = columns.x;
    const std::uint64_t bits = std::uint64_t{bit} * 0x0101010101010101U;
    for (; column + 8 <= columns.y; column += 8) {
        std::uint64_t eight = 0;
        std::memcpy(&eight, at + column, sizeof(eight));
        eight |= bits;
        std::memcpy(at + column, &eight, sizeof(eight));
    }
    for (; column < columns.y; ++column) {
        at[column] = static_cast<std::uint8_t>(at[column] | bit);
    }
}

void SampleScan::coverAround(int row, std::size_t sample, glm::ivec2 all, glm::ivec2 none) {
    if (none.x >= none.y) {
        cover(row, sample, all);
    } else {
        cover(row, sample, glm::ivec2(all.x, std::min(all.y, none.x)));
        cover(row, sample, glm::ivec2(std::max(all.x, none.y), all.y));
    }
}

void SampleScan::track(glm::dvec2 a, glm::dvec2 b, double radius, double inner) {
    const double low = std::min(a.y, b.y) - radius;
    const double high = std::max(a.y, b.y) + radius;
    const glm::ivec2 rows = rowsBetween(low, high);
    if (rows.x >= rows.y || isBeside(std::min(a.x, b.x) - radius, std::max(a.x, b.x) + radius)) {
        return;
    }
    const Track outline(a, b, radius);
    const std::optional<Track> hole = inner > 0.0 ? std::optional<Track>(std::in_place, a, b, inner) : std::nullopt;
    forRows(low, high, [&](int row, std::size_t sample, double at) {
        const double y = at + kBesideSample;
        coverAround(row, sample, columns(outline.at(y), sample), hole ? columns(hole->at(y), sample) : glm::ivec2(0));
    });
}

/// Of most polygons of a small picture no row of samples is reached: they cost a look at their corners.
void SampleScan::polygon(std::span<const glm::dvec2> corners, glm::dvec2 centre, double radius) {
    std::array<Corner, 4> all;
    std::ranges::transform(corners, all.begin(), moved);
    const std::span<const Corner> own(all.data(), corners.size());
    const auto [high, low] = std::ranges::minmax(own, {}, &Corner::y);
    int row = firstRow(high.y);
    const int end = firstRow(low.y);
    if (row >= end) {
        return;
    }
    const auto [left, right] = std::ranges::minmax(own, {}, &Corner::x);
    if (right.x < 0 || left.x > std::int64_t{kFixed} * kTilePixels) {
        return;
    }
    std::array<Edge, 4> edges;
    std::size_t count = 0;
    for (std::size_t i = 0; i < own.size(); ++i) {
        const Corner& next = own[i + 1 < own.size() ? i + 1 : 0];
        if (own[i].y != next.y) {
            edges[count++] = edgeBetween(own[i], next);
        }
    }
    const Track hole(centre, centre, radius);
    for (; row < end; ++row) {
        const auto sample = static_cast<std::size_t>(row % kRowsPerPixel);
        const double y = (row + 0.5) / kRowsPerPixel;
        const glm::ivec2 columnsHere = columnsBetween({edges.data(), count}, y, kSamplePlaces[sample].x);
        const glm::ivec2 none = radius > 0.0 ? columns(hole.at(y + kBesideSample), sample) : glm::ivec2(0);
        coverAround(row / kRowsPerPixel, sample, columnsHere, none);
    }
}

}  // namespace render
