#include "render/tiles/sample_scan.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <optional>
#include <span>

#include "render/tiles/sample_rows.h"

namespace render {

namespace {

constexpr double kMiddleOfRow = 0.5 / kRowsPerPixel;

int floorColumn(double x) {
    const double clamped = std::clamp(x, -2.0, kTilePixels + 1.0);
    const int whole = static_cast<int>(clamped);
    return whole - (clamped < whole ? 1 : 0);
}

/// Columns of a sample `place` from their left that lie between the edges at `y`, as [first, end).
glm::ivec2 columnsBetween(std::span<const SampleEdge> edges, double y, double place) {
    glm::ivec2 all(kTilePixels + 1, -1);
    for (const SampleEdge& edge : edges) {
        if (edge.top <= y && y < edge.bottom) {
            const int column = edge.column(y, place);
            all = {std::min(all.x, column), std::max(all.y, column)};
        }
    }
    return {std::max(all.x, 0), std::min(all.y, kTilePixels)};
}

}  // namespace

void coverSamples(MaskTile& tile, int row, std::size_t bit, glm::ivec2 columns) {
    const auto one = static_cast<std::uint8_t>(1U << bit);
    std::uint8_t* at = tile.data() + static_cast<std::size_t>(row) * kTilePixels;
    int column = columns.x;
    const std::uint64_t bits = std::uint64_t{one} * 0x0101010101010101U;
    for (; column + 8 <= columns.y; column += 8) {
        std::uint64_t eight = 0;
        std::memcpy(&eight, at + column, sizeof(eight));
        eight |= bits;
        std::memcpy(at + column, &eight, sizeof(eight));
    }
    for (; column < columns.y; ++column) {
        at[column] = static_cast<std::uint8_t>(at[column] | one);
    }
}

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

void SampleScan::cell(const std::array<glm::dvec2, 4>& corners, glm::dvec2 centre, double radius) {
    std::array<Corner, 4> moved;
    std::ranges::transform(corners, moved.begin(), &Corner::near);
    const auto [high, low] = std::ranges::minmax(moved, {}, &Corner::y);
    const auto [left, right] = std::ranges::minmax(moved, {}, &Corner::x);
    int row = firstRow(high.y);
    const int end = firstRow(low.y);
    if (row >= end || right.x < 0 || left.x > std::int64_t{kStepsPerPixel} * kTilePixels) {
        return;
    }
    std::array<SampleEdge, 4> edges;
    std::size_t count = 0;
    for (std::size_t i = 0; i < moved.size(); ++i) {
        const Corner& next = moved[(i + 1) % moved.size()];
        if (moved[i].y != next.y) {
            edges[count++] = SampleEdge::between(moved[i], next);
        }
    }
    const Track hole(centre, centre, radius);
    for (; row < end; ++row) {
        const auto sample = static_cast<std::size_t>(row % kRowsPerPixel);
        const double y = heightOf(row);
        const glm::ivec2 all = columnsBetween({edges.data(), count}, y, kSamplePlaces[sample].x);
        coverAround(row / kRowsPerPixel, sample, all, columns(hole.at(y + kBesideSample), sample));
    }
}

}  // namespace render
