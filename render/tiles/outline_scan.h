#pragma once

#include <glm/glm.hpp>
#include <span>
#include <vector>

#include "render/tiles/sample_scan.h"

namespace render {

/// Draws areas into a tile by their outlines, a row of samples at a time: what lies inside lines that wind around it,
/// and around its holes the other way. Corners are moved to 1/256 of a pixel, and left and upper edges belong to the
/// area, so that it covers what a rasteriser of Vulkan covers of its triangles, of which there may be many. Lengths are
/// pixels from the tile's upper left corner, y down.
class OutlineScan {
public:
    explicit OutlineScan(MaskTile& tile) : m_tile(&tile) {}

    /// Begins an area. Its lines wind counter-clockwise around it, as they are seen; mirrored the other way.
    void begin(bool isMirrored) { m_isMirrored = isMirrored; }
    /// An edge. Those of an area make closed lines together, in any order.
    void edge(glm::dvec2 from, glm::dvec2 to);
    /// The same of edges in a row that all lie left of the tile, of which these are the first and the last point.
    void edgesOnTheLeft(glm::dvec2 first, glm::dvec2 last);
    /// After its edges: what lies inside.
    void fill();

private:
    /// Where a row of samples passes an edge, sorted by what comes first: row, column and whether it leads inside.
    struct Crossing {
        std::uint32_t bits = 0;

        Crossing() = default;
        Crossing(int row, int column, bool isIn)
            : bits(static_cast<std::uint32_t>(row) << 16U | static_cast<std::uint32_t>(column) << 1U |
                   (isIn ? 1U : 0U)) {}
        [[nodiscard]] int row() const { return static_cast<int>(bits >> 16U); }
        [[nodiscard]] int column() const { return static_cast<int>(bits >> 1U & 0x7fffU); }
        [[nodiscard]] bool isIn() const { return (bits & 1U) != 0; }
        auto operator<=>(const Crossing&) const = default;
    };

    void sort();
    void fillRow(int row, int insideAtLeft, std::span<const Crossing> crossings);

    MaskTile* m_tile;
    bool m_isMirrored = false;
    std::vector<Crossing> m_crossings;
    /// How many more edges left of the tile lead inside than out of it, more than in the row before; empty: there are
    /// none on the left.
    std::vector<std::int32_t> m_leftSteps;
    std::vector<Crossing> m_sorted;
    std::vector<std::uint32_t> m_endOfRow;
};

}  // namespace render
