#pragma once

#include <memory>

#include "render/tiles/sample_colours.h"
#include "render/tiles/sample_scan.h"

namespace render {

/// A value per pixel of a tile, rows from the top.
using PixelTile = std::array<std::uint32_t, static_cast<std::size_t>(kTilePixels) * kTilePixels>;

/// Pixels of a tile, `from` to before `to`.
struct TilePart {
    glm::ivec2 from{0};
    glm::ivec2 to{kTilePixels};
    [[nodiscard]] bool holds(const TilePart& other) const {
        return glm::all(glm::lessThanEqual(from, other.from)) && glm::all(glm::greaterThanEqual(to, other.to));
    }
};

/// Samples get this byte where a mask covers them, four to a pixel of `samples`.
void stamp(const MaskTile& mask, bool isBore, std::uint8_t byte, PixelTile& samples);

/// What is seen at each sample of a part of a tile, as rows of `colours`, a byte each: this stays as it is while the
/// colours change and while something stands out. `masks` by layer, null where a layer has nothing here.
void paintSamples(std::span<const Paint> paints, const SampleColours& colours,
                  std::span<const std::unique_ptr<MaskTile>> masks, const TilePart& part, PixelTile& samples);

/// The pixels, 0xffRRGGBB, of such samples; `over` has a byte per sample, 0 for nothing, else 1 + row of
/// SampleColours::over, and may be null.
void paintPixels(const SampleColours& colours, const PixelTile& samples, const PixelTile* over, const TilePart& part,
                 PixelTile& picture);

/// The same where only what lies over it is another than `before`.
void repaintPixels(const SampleColours& colours, const PixelTile& samples, const PixelTile* before,
                   const PixelTile* over, const TilePart& part, PixelTile& picture);

}  // namespace render
