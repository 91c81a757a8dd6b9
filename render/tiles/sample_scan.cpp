#include "render/tiles/sample_scan.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace render {

namespace {

constexpr double kFixed = 256.0;  // steps that corners are moved to, per pixel

/// An edge of a polygon between moved corners, from its upper end down; y from `top` to before `bottom`.
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

glm::dvec2 moved(glm::dvec2 corner) {
    const auto toStep = [](double x) {
        return static_cast<double>(static_cast<std::int64_t>(x * kFixed + (x < 0.0 ? -0.5 : 0.5))) / kFixed;
    };
    return {toStep(corner.x), toStep(corner.y)};
}

}  // namespace

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

void SampleScan::track(glm::dvec2 a, glm::dvec2 b, double radius, double inner) {
    if (isBeside(std::min(a.x, b.x) - radius, std::max(a.x, b.x) + radius)) {
        return;
    }
    const Track outline(a, b, radius);
    const Track hole(a, b, inner);
    forRows(std::min(a.y, b.y) - radius, std::max(a.y, b.y) + radius, [&](int row, std::size_t sample, double at) {
        const double y = at + kBesideSample;
        const glm::ivec2 all = columns(outline.at(y), sample);
        const glm::ivec2 none = inner > 0.0 ? columns(hole.at(y), sample) : glm::ivec2(0);
        if (none.x >= none.y) {
            cover(row, sample, all);
        } else {
            cover(row, sample, glm::ivec2(all.x, std::min(all.y, none.x)));
            cover(row, sample, glm::ivec2(std::max(all.x, none.y), all.y));
        }
    });
}

void SampleScan::polygon(std::span<const glm::dvec2> corners, glm::dvec2 centre, double radius) {
    const auto [left, right] = std::ranges::minmax(corners, {}, &glm::dvec2::x);
    if (isBeside(left.x, right.x)) {
        return;
    }
    std::array<Edge, 4> edges;
    std::size_t count = 0;
    double low = 1e30;
    double high = -1e30;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        glm::dvec2 from = moved(corners[i]);
        glm::dvec2 to = moved(corners[i + 1 < corners.size() ? i + 1 : 0]);
        if (from.y > to.y) {
            std::swap(from, to);
        }
        if (from.y < to.y) {
            edges[count++] = {from.y, to.y, from.x, (to.x - from.x) / (to.y - from.y)};
            low = std::min(low, from.y);
            high = std::max(high, to.y);
        }
    }
    const Track hole(centre, centre, radius);
    forRows(low, high, [&](int row, std::size_t sample, double y) {
        if (y < low || y >= high) {
            return;
        }
        const double place = kSamplePlaces[sample].x;
        glm::ivec2 all(kTilePixels + 1, -1);
        for (std::size_t i = 0; i < count; ++i) {
            if (edges[i].top <= y && y < edges[i].bottom) {
                const int column = ceilColumn(edges[i].x + (y - edges[i].top) * edges[i].slope - place);
                all = {std::min(all.x, column), std::max(all.y, column)};
            }
        }
        all = {std::max(all.x, 0), std::min(all.y, kTilePixels)};
        const glm::ivec2 none = radius > 0.0 ? columns(hole.at(y + kBesideSample), sample) : glm::ivec2(0);
        if (none.x >= none.y) {
            cover(row, sample, all);
        } else {
            cover(row, sample, glm::ivec2(all.x, std::min(all.y, none.x)));
            cover(row, sample, glm::ivec2(std::max(all.x, none.y), all.y));
        }
    });
}

}  // namespace render
