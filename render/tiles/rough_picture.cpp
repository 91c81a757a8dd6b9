#include "render/tiles/rough_picture.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "model/base/parallel.h"

namespace render {

namespace {

constexpr int kBand = 16;  // rows per task
constexpr std::int32_t kFraction = 256;

/// Where each column or row of the picture lies in a source; pixel -1: beside it.
struct Place {
    std::int32_t pixel = -1;
    std::uint32_t part = 0;  ///< of the next one, of 256
};

std::vector<Place> places(int count, double scale, double offset, int size) {
    std::vector<Place> all(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i) {
        const double at = std::clamp((i + 0.5) * scale + offset - 0.5, -4.0, size + 4.0);
        const auto fixed = static_cast<std::int32_t>(std::floor(at * kFraction));
        if (fixed >= 0 && fixed / kFraction + 1 < size) {
            all[static_cast<std::size_t>(i)] = {fixed / kFraction, static_cast<std::uint32_t>(fixed % kFraction)};
        }
    }
    return all;
}

/// Two channels at a time.
std::uint32_t between(std::uint32_t a, std::uint32_t b, std::uint32_t part) {
    constexpr std::uint32_t kEven = 0x00ff00ffU;
    const std::uint32_t even = ((a & kEven) * (256 - part) + (b & kEven) * part) >> 8U & kEven;
    const std::uint32_t odd = ((a >> 8U & kEven) * (256 - part) + (b >> 8U & kEven) * part) & ~kEven;
    return even | odd;
}

/// A source as the picture sees it.
struct Placed {
    RoughSource source;
    std::vector<Place> columns;
    std::vector<Place> rows;

    Placed(const RoughSource& own, const PlaneMap& map, glm::ivec2 size) : source(own) {
        if (source.pixels != nullptr) {
            const glm::dvec2 scale = source.map.scale / map.scale;
            const glm::dvec2 offset = source.map.offset - map.offset * scale;
            columns = places(size.x, scale.x, offset.x, source.size.x);
            rows = places(size.y, scale.y, offset.y, source.size.y);
        } else {
            columns.resize(static_cast<std::size_t>(size.x));
            rows.resize(static_cast<std::size_t>(size.y));
        }
    }

    /// The run of columns that it reaches, as [first, end).
    [[nodiscard]] glm::ivec2 reach(int row) const {
        if (rows[static_cast<std::size_t>(row)].pixel < 0) {
            return glm::ivec2(0);
        }
        const auto isIn = [](const Place& place) { return place.pixel >= 0; };
        const auto first = std::ranges::find_if(columns, isIn);
        const auto end = std::find_if_not(first, columns.end(), isIn);
        return {first - columns.begin(), end - columns.begin()};
    }

    void paint(int row, int from, int to, std::uint32_t* pixels) const {
        const Place& y = rows[static_cast<std::size_t>(row)];
        const std::uint32_t* upper = source.pixels + static_cast<std::ptrdiff_t>(y.pixel) * source.size.x;
        const std::uint32_t* lower = upper + source.size.x;
        for (int x = from; x < to; ++x) {
            const Place& at = columns[static_cast<std::size_t>(x)];
            const std::uint32_t above = between(upper[at.pixel], upper[at.pixel + 1], at.part);
            const std::uint32_t below = between(lower[at.pixel], lower[at.pixel + 1], at.part);
            pixels[x] = between(above, below, y.part) | 0xff000000U;
        }
    }
};

}  // namespace

void paintScaled(const RoughSource& best, const RoughSource& rest, std::uint32_t ground, const PlaneMap& map,
                 glm::ivec2 size, std::uint32_t* pixels) {
    const Placed first(best, map, size);
    const Placed second(rest, map, size);
    base::parallelFor(static_cast<std::size_t>((size.y + kBand - 1) / kBand), [&](std::size_t band) {
        const int from = static_cast<int>(band) * kBand;
        for (int row = from; row < std::min(from + kBand, size.y); ++row) {
            std::uint32_t* out = pixels + static_cast<std::ptrdiff_t>(row) * size.x;
            const glm::ivec2 own = first.reach(row);
            const glm::ivec2 other = second.reach(row);
            if (own.x > 0 || own.y < size.x) {
                std::fill_n(out, size.x, ground);
                if (other.y > other.x) {
                    second.paint(row, other.x, other.y, out);
                }
            }
            if (own.y > own.x) {
                first.paint(row, own.x, own.y, out);
            }
        }
    });
}

}  // namespace render
