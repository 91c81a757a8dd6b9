#include "render/tiles/rough_picture.h"

#include <algorithm>
#include <cmath>

#include "render/tiles/pixel_between.h"

namespace render {

namespace {

constexpr std::int32_t kFraction = 256;
constexpr std::size_t kChannels = 4;

/// The same for a row, which the compiler does many bytes at a time.
void betweenRows(const std::uint32_t* a, const std::uint32_t* b, std::uint32_t part, int count, std::uint32_t* out) {
    const auto* upper = reinterpret_cast<const std::uint8_t*>(a);
    const auto* lower = reinterpret_cast<const std::uint8_t*>(b);
    auto* bytes = reinterpret_cast<std::uint8_t*>(out);
    const auto other = static_cast<std::uint16_t>(kFraction - static_cast<std::int32_t>(part));
    const auto own = static_cast<std::uint16_t>(part);
    for (std::size_t i = 0; i < kChannels * static_cast<std::size_t>(count); ++i) {
        bytes[i] = static_cast<std::uint8_t>(static_cast<std::uint16_t>(upper[i] * other + lower[i] * own) >> 8U);
    }
    for (int i = 0; i < count; ++i) {
        out[i] |= 0xff000000U;
    }
}

}  // namespace

/// Rows of a source with some of the picture's columns, the last two that were asked for.
class RoughPicture::StretchedRows {
public:
    StretchedRows(const Placed& placed, int from, int to) : m_placed(placed), m_from(from), m_to(to) {}

    /// Of a row and the next one neither takes the place of the other.
    const std::uint32_t* row(int y) {
        Row& row = m_rows[static_cast<std::size_t>(y) % m_rows.size()];
        if (row.y != y) {
            row.y = y;
            row.pixels.resize(static_cast<std::size_t>(m_to - m_from));
            const std::uint32_t* source = m_placed.source.pixels + std::ptrdiff_t{y} * m_placed.source.size.x;
            for (int x = m_from; x < m_to; ++x) {
                const Place& at = m_placed.columns[static_cast<std::size_t>(x)];
                row.pixels[static_cast<std::size_t>(x - m_from)] =
                    pixelBetween(source[at.pixel], source[at.pixel + 1], at.part);
            }
        }
        return row.pixels.data();
    }

private:
    struct Row {
        int y = -1;
        std::vector<std::uint32_t> pixels;
    };

    const Placed& m_placed;
    int m_from;
    int m_to;
    std::array<Row, 2> m_rows;
};

std::vector<RoughPicture::Place> RoughPicture::places(int count, double scale, double offset, int size) {
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

glm::ivec2 RoughPicture::reach(const std::vector<Place>& places) {
    const auto isIn = [](const Place& place) { return place.pixel >= 0; };
    const auto first = std::ranges::find_if(places, isIn);
    const auto end = std::find_if_not(first, places.end(), isIn);
    return {first - places.begin(), end - places.begin()};
}

RoughPicture::Placed RoughPicture::placed(const RoughSource& source, const PlaneMap& map, glm::ivec2 size) {
    Placed placed{source, {}, {}, glm::ivec2(0), glm::ivec2(0)};
    if (source.pixels != nullptr) {
        const glm::dvec2 scale = source.map.scale / map.scale;
        const glm::dvec2 offset = source.map.offset - map.offset * scale;
        placed.columns = places(size.x, scale.x, offset.x, source.size.x);
        placed.rows = places(size.y, scale.y, offset.y, source.size.y);
        placed.across = reach(placed.columns);
        placed.down = reach(placed.rows);
    }
    return placed;
}

RoughPicture::RoughPicture(const RoughSource& best, const RoughSource& rest, std::uint32_t ground, const PlaneMap& map,
                           glm::ivec2 size)
    : m_sources{placed(rest, map, size), placed(best, map, size)}, m_ground(ground), m_size(size) {}

void RoughPicture::paint(glm::ivec2 from, glm::ivec2 to, std::uint32_t* pixels) const {
    const auto rowAt = [&](int y) { return pixels + std::ptrdiff_t{y} * m_size.x; };
    const auto covers = [&](const Placed& own) {
        return own.across.x <= from.x && own.across.y >= to.x && own.down.x <= from.y && own.down.y >= to.y;
    };
    const bool isCovered = covers(m_sources[1]);
    for (int y = from.y; !isCovered && y < to.y; ++y) {
        std::fill(rowAt(y) + from.x, rowAt(y) + to.x, m_ground);
    }
    for (std::size_t i = isCovered ? 1 : 0; i < m_sources.size(); ++i) {
        const Placed& own = m_sources[i];
        const int left = std::max(from.x, own.across.x);
        const int right = std::min(to.x, own.across.y);
        StretchedRows rows(own, left, std::max(left, right));
        for (int y = std::max(from.y, own.down.x); left < right && y < std::min(to.y, own.down.y); ++y) {
            const Place& at = own.rows[static_cast<std::size_t>(y)];
            const std::uint32_t* upper = rows.row(at.pixel);
            betweenRows(upper, rows.row(at.pixel + 1), at.part, right - left, rowAt(y) + left);
        }
    }
}

}  // namespace render
