#pragma once

#include <array>
#include <cstdint>
#include <glm/glm.hpp>

namespace render {

/// Pixels along each side of a tile.
inline constexpr int kTilePixels = 256;

/// Which samples of each pixel of a tile are covered, rows from the top: bit i is sample i of what is solid, bit 4 + i
/// of the dark inside of a hole.
using MaskTile = std::array<std::uint8_t, static_cast<std::size_t>(kTilePixels) * kTilePixels>;

/// Vulkan's standard places of four samples, from the upper left corner of the pixel.
inline constexpr std::array<glm::dvec2, 4> kSamplePlaces{
    {{0.375, 0.125}, {0.875, 0.375}, {0.125, 0.625}, {0.625, 0.875}}};

/// One in the middle of each quarter of a pixel's height, in that order: rows of samples are as far from each other.
inline constexpr int kRowsPerPixel = static_cast<int>(kSamplePlaces.size());

/// Sets a bit of the pixels of a row, `columns` as [first, end) within the tile.
void coverSamples(MaskTile& tile, int row, std::size_t bit, glm::ivec2 columns);

/// Draws round shapes into a tile, a row of samples at a time. Lengths are pixels from the tile's upper left corner, y
/// down; shapes may lie anywhere. They cover the samples in their true outlines, where let_impostor.frag looks for
/// them; corners of cells are moved to 1/256 of a pixel, as those of the areas around them (outline_scan.h).
class SampleScan {
public:
    SampleScan(MaskTile& tile, bool isBore) : m_tile(&tile), m_shift(isBore ? 4 : 0) {}

    /// A track with round ends, or a circle; `inner` > 0 leaves out as much inside.
    void track(glm::dvec2 a, glm::dvec2 b, double radius, double inner);
    /// A rectangle without a circle inside.
    void cell(const std::array<glm::dvec2, 4>& corners, glm::dvec2 centre, double radius);
    /// What lies between two circles and `contains(place)`.
    template <class Contains>
    void annulus(glm::dvec2 centre, double outer, double inner, const Contains& contains);

private:
    struct Span {
        double from = 1.0;
        double to = -1.0;  ///< both within; less than `from`: nothing
    };
    /// Where a level line passes through a round track.
    struct Track {
        glm::dvec2 a, b, side, along;
        double radius = 0.0;
        Track(glm::dvec2 first, glm::dvec2 last, double r);
        [[nodiscard]] Span at(double y) const;
    };

    /// Rows of samples, from the tile's top, that what lies between `low` and `high` may cover, as [first, end).
    [[nodiscard]] static glm::ivec2 rowsBetween(double low, double high);
    template <class Visit>
    static void forRows(double low, double high, const Visit& visit);
    /// Beside the tile it covers nothing.
    [[nodiscard]] static bool isBeside(double left, double right) { return right < -1.0 || left > kTilePixels + 1.0; }
    /// Columns of a sample within a span, as [first, end).
    [[nodiscard]] static glm::ivec2 columns(Span span, std::size_t sample);
    void cover(int row, std::size_t sample, glm::ivec2 columns) {
        coverSamples(*m_tile, row, sample + static_cast<std::size_t>(m_shift), columns);
    }
    /// `all` without `none`.
    void coverAround(int row, std::size_t sample, glm::ivec2 all, glm::ivec2 none);

    MaskTile* m_tile;
    int m_shift;
};

/// Samples on an outline belong to the shape on their right and below.
inline constexpr double kBesideSample = 1e-3;

template <class Visit>
void SampleScan::forRows(double low, double high, const Visit& visit) {
    const glm::ivec2 rows = rowsBetween(low, high);
    for (int row = rows.x; row < rows.y; ++row) {
        visit(row / kRowsPerPixel, static_cast<std::size_t>(row % kRowsPerPixel), (row + 0.5) / kRowsPerPixel);
    }
}

template <class Contains>
void SampleScan::annulus(glm::dvec2 centre, double outer, double inner, const Contains& contains) {
    const Track rim(centre, centre, outer);
    const Track hole(centre, centre, inner);
    forRows(centre.y - outer, centre.y + outer, [&](int row, std::size_t sample, double at) {
        const double y = at + kBesideSample;
        const glm::ivec2 all = columns(rim.at(y), sample);
        const glm::ivec2 none = inner > 0.0 ? columns(hole.at(y), sample) : glm::ivec2(0);
        for (int column = all.x; column < all.y; ++column) {
            if (column == none.x + 1 && none.y - 1 > column) {
                column = none.y - 1;  // its ends are asked for: they may lie on the rim
            }
            if (contains(glm::dvec2(column + kSamplePlaces[sample].x + kBesideSample, y))) {
                cover(row, sample, glm::ivec2(column, column + 1));
            }
        }
    });
}

}  // namespace render
