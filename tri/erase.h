#pragma once

#include <cstdint>
#include <vector>

#include "tri/contours.h"
#include "tri/cores.h"
#include "tri/mesh.h"
#include "tri/triangulate.h"

namespace tri {

/// Triangle erasing: keeps the triangles inside the contours. Where every contour is an edge of the mesh, no triangle
/// crosses one, so looking along one edge from one corner tells on which side the whole triangle lies: constant time,
/// no flooding, no point-in-polygon test, and every triangle for itself.
class Eraser {
public:
    /// `states` is overwritten by decide().
    Eraser(const Mesh& mesh, const Contours& contours, Cores cores, Scratch<std::uint8_t>& states);

    /// Decides for every triangle, and in the same pass counts the contour edges that are edges of the mesh. Only if
    /// those are all of them (contours.edgeCount()), the decisions are right and write() may follow.
    std::size_t decide();

    /// Appends the triangles that stay as indices into the polygon's points. Proves the result: they border on erased
    /// ones exactly along the contours, each on the left, so they cover what the contours surround once, and nothing
    /// else. Crossing if that cannot be (a region within a region, a contour that winds the wrong way), Degenerate if
    /// nothing stays.
    [[nodiscard]] Status write(std::vector<std::uint32_t>& triangles);

private:
    /// The work of one task: a run of triangles.
    struct Chunk {
        std::uint32_t first = 0;
        std::uint32_t end = 0;
        std::size_t present = 0;  ///< contour edges that are edges of its triangles
        std::size_t staying = 0;
        std::size_t borders = 0;
        std::size_t firstOut = 0;  ///< where its triangles go
        std::vector<std::uint32_t> undecided;
        Status status;
    };

    void decideChunk(Chunk& chunk);
    void writeChunk(Chunk& chunk, std::uint32_t* out) const;
    void decideTheRest();
    [[nodiscard]] Status conclude() const;

    const Mesh& m_mesh;
    const Contours& m_contours;
    Cores m_cores;
    Scratch<std::uint8_t>& m_states;
    std::vector<Chunk> m_chunks;
};

}  // namespace tri
