#include "render/tiles/tile_painter.h"

#include <algorithm>
#include <cstring>
#include <vector>

namespace render {

namespace {

constexpr std::uint64_t kLowNibbles = 0x0f0f0f0f0f0f0f0fU;
constexpr int kStep = 8;  // pixels looked at together
constexpr std::size_t kRow = kTilePixels;

/// Four bits to four bytes.
constexpr std::array<std::uint32_t, 16> kSpread = [] {
    std::array<std::uint32_t, 16> spread{};
    for (std::uint32_t bits = 0; bits < spread.size(); ++bits) {
        for (std::uint32_t i = 0; i < 4; ++i) {
            spread[bits] |= (bits >> i & 1U) != 0 ? 0xffU << 8U * i : 0U;
        }
    }
    return spread;
}();

std::uint64_t eightAt(const std::uint8_t* at) {
    std::uint64_t eight = 0;
    std::memcpy(&eight, at, sizeof(eight));
    return eight;
}

void coverMixed(std::uint64_t masks, std::uint32_t colour, std::uint32_t* samples) {
    for (int i = 0; i < kStep; ++i, masks >>= 8U) {
        samples[i] ^= (samples[i] ^ colour) & kSpread[masks & 0xfU];
    }
}

/// Samples of a pixel as a translucent paint leaves them.
std::uint32_t seenThrough(const std::array<std::uint8_t, 256>& after, std::uint32_t samples) {
    return after[samples & 0xffU] | std::uint32_t{after[samples >> 8U & 0xffU]} << 8U |
           std::uint32_t{after[samples >> 16U & 0xffU]} << 16U | std::uint32_t{after[samples >> 24U]} << 24U;
}

void blendEight(std::uint64_t masks, const std::array<std::uint8_t, 256>& after, std::uint32_t* samples) {
    std::uint32_t last = samples[0];
    std::uint32_t through = seenThrough(after, last);
    for (int i = 0; i < kStep; ++i, masks >>= 8U) {
        if (samples[i] != last) {
            last = samples[i];
            through = seenThrough(after, last);
        }
        samples[i] ^= (samples[i] ^ through) & kSpread[masks & 0xfU];
    }
}

/// A paint with something in this tile.
struct Plane {
    const std::uint8_t* masks;
    const std::array<std::uint8_t, 256>* after;
    std::uint32_t colour;
    bool isBore;
    bool isOpaque;

    /// Samples that it covers of eight pixels.
    [[nodiscard]] std::uint64_t covered(std::size_t at) const {
        const std::uint64_t both = eightAt(masks + at);
        if (isOpaque || isBore) {
            return (isBore ? both >> 4U : both) & kLowNibbles;
        }
        return both & ~(both >> 4U) & kLowNibbles;  // of one layer only what is nearer is blended
    }
};

/// Eight pixels: from the front, which samples of each plane nothing opaque hides; then those from the back.
void paintEight(std::span<const Plane> planes, std::size_t at, std::uint64_t* seen, std::uint32_t* samples) {
    std::uint64_t open = kLowNibbles;
    std::size_t first = planes.size();
    while (first > 0 && open != 0) {
        const Plane& plane = planes[--first];
        const std::uint64_t own = plane.covered(at) & open;
        seen[first] = own;
        if (plane.isOpaque) {
            open &= ~own;
        }
    }
    std::fill_n(samples, kStep, 0U);
    for (std::size_t i = first; i < planes.size(); ++i) {
        if (seen[i] == 0) {
            continue;
        }
        if (!planes[i].isOpaque) {
            blendEight(seen[i], *planes[i].after, samples);
        } else if (seen[i] == kLowNibbles) {
            std::fill_n(samples, kStep, planes[i].colour);
        } else {
            coverMixed(seen[i], planes[i].colour, samples);
        }
    }
}

/// Pixels of a part of a tile in colours, eight at a time.
class PixelPainter {
public:
    explicit PixelPainter(const SampleColours& colours) : m_colours(colours) { m_mixed.fill({0, colours.pixel(0)}); }

    /// `over` may be null.
    void paint(const std::uint32_t* samples, const std::uint32_t* over, std::uint32_t* pixels) {
        std::array<std::uint32_t, kStep> own{};
        std::copy_n(samples, kStep, own.begin());
        if (over != nullptr && !areAll(over, 0)) {
            putOver(over, own);
        }
        if (areAll(own.data(), own[0])) {
            std::fill_n(pixels, kStep, pixel(own[0]));
            return;
        }
        std::ranges::transform(own, pixels, [this](std::uint32_t four) { return pixel(four); });
    }

    static bool areAll(const std::uint32_t* eight, std::uint32_t value) {
        std::uint32_t other = 0;
        for (int i = 0; i < kStep; ++i) {
            other |= eight[i] ^ value;
        }
        return other == 0;
    }

private:
    void putOver(const std::uint32_t* over, std::array<std::uint32_t, kStep>& samples) const {
        for (std::size_t x = 0; x < samples.size(); ++x) {
            for (std::uint32_t shift = 0; shift < 32 && over[x] != 0; shift += 8) {
                if (const std::uint32_t row = over[x] >> shift & 0xffU; row != 0) {
                    samples[x] = (samples[x] & ~(0xffU << shift)) | std::uint32_t{m_colours.over()[row - 1]} << shift;
                }
            }
        }
    }

    /// Along edges the same mixtures come again and again.
    std::uint32_t pixel(std::uint32_t samples) {
        Mixed& known = m_mixed[samples * 0x9e3779b1U >> 24U];
        if (known.samples != samples) {
            known = {samples, m_colours.pixel(samples)};
        }
        return known.pixel;
    }

    struct Mixed {
        std::uint32_t samples;
        std::uint32_t pixel;
    };
    const SampleColours& m_colours;
    std::array<Mixed, 256> m_mixed{};
};

/// Visits the first of each eight pixels of a part, whose columns are rounded to whole steps.
template <class Visit>
void forSteps(const TilePart& part, const Visit& visit) {
    for (int y = part.from.y; y < part.to.y; ++y) {
        for (int x = part.from.x / kStep * kStep; x < part.to.x; x += kStep) {
            visit(static_cast<std::size_t>(y) * kRow + static_cast<std::size_t>(x));
        }
    }
}

}  // namespace

void stamp(const MaskTile& mask, bool isBore, std::uint8_t byte, PixelTile& samples) {
    for (std::size_t i = 0; i < mask.size(); i += kStep) {
        const std::uint64_t both = eightAt(mask.data() + i);
        const std::uint64_t own = (isBore ? both >> 4U : both) & kLowNibbles;
        if (own != 0) {
            coverMixed(own, byte * 0x01010101U, samples.data() + i);
        }
    }
}

void paintSamples(std::span<const Paint> paints, const SampleColours& colours,
                  std::span<const std::unique_ptr<MaskTile>> masks, const TilePart& part, PixelTile& samples) {
    std::vector<Plane> planes;
    for (std::size_t i = 0; i < paints.size(); ++i) {
        if (const MaskTile* mask = masks[paints[i].layer].get(); mask != nullptr) {
            const std::array<std::uint8_t, 256>& after = colours.after()[i];
            planes.push_back({mask->data(), &after, after[SampleColours::kBackground] * 0x01010101U, paints[i].isBore,
                              paints[i].isOpaque()});
        }
    }
    std::vector<std::uint64_t> seen(planes.size());
    forSteps(part, [&](std::size_t at) { paintEight(planes, at, seen.data(), &samples[at]); });
}

void paintPixels(const SampleColours& colours, const PixelTile& samples, const PixelTile* over, const TilePart& part,
                 PixelTile& picture) {
    PixelPainter painter(colours);
    forSteps(part, [&](std::size_t at) {
        painter.paint(&samples[at], over != nullptr ? &(*over)[at] : nullptr, &picture[at]);
    });
}

void repaintPixels(const SampleColours& colours, const PixelTile& samples, const PixelTile* before,
                   const PixelTile* over, const TilePart& part, PixelTile& picture) {
    constexpr std::array<std::uint32_t, kStep> kNothing{};
    PixelPainter painter(colours);
    forSteps(part, [&](std::size_t at) {
        const std::uint32_t* then = before != nullptr ? &(*before)[at] : kNothing.data();
        const std::uint32_t* now = over != nullptr ? &(*over)[at] : kNothing.data();
        if (std::memcmp(then, now, sizeof(kNothing)) != 0) {
            painter.paint(&samples[at], now, &picture[at]);
        }
    });
}

}  // namespace render
