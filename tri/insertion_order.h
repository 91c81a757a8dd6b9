#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "tri/mesh.h"
#include "tri/threads.h"

namespace tri {

/// Places along a Hilbert curve through the square around some points, in 2^16 x 2^16 cells.
class HilbertGrid {
public:
    explicit HilbertGrid(const base::Box& box);
    /// Points outside count as the nearest one inside.
    [[nodiscard]] std::uint32_t keyOf(Point p) const;

private:
    base::Box m_box;
    std::uint64_t m_factor;
};

inline constexpr std::uint32_t kRounds = 8;
/// First vertex of every round of the insertion order, and the end.
using RoundStarts = std::array<std::uint32_t, kRounds + 1>;

struct VertexOrder {
    std::vector<std::uint32_t> merged;  ///< vertices at which several points came together, in rising order
    RoundStarts roundStart{};
};

/// Numbers the vertices of a mesh in the order in which they are to be inserted, and merges equal positions.
///
/// The order is a biased randomised insertion order: an eighth of an eighth of ... of the points first, each round
/// along a Hilbert curve. Along the curve alone, the points of a circle come one after the other, and every one of them
/// flips the fan of its predecessors: twice the flips.
///
/// `mesh` has room for all points and for two triangles per point; the triangles' room is used to sort in. Sets points,
/// ids (the lowest index at that position) and vertexCount, and `vertexOf`: the vertex of every index.
[[nodiscard]] VertexOrder orderVertices(std::span<const Point> points, Cores cores, Mesh& mesh,
                                        std::uint32_t* vertexOf);

}  // namespace tri
