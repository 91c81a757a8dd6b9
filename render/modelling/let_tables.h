#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "shaders/shared/let_mesh.h"

namespace render {

/// Which sides of flat prisms face the camera. What can be seen is a run of the sections upper, wall, lower.
struct SeenFaces {
    bool upper = true;
    bool walls = true;
    bool lower = true;
    bool operator==(const SeenFaces&) const = default;
};

/// Indices of one topology and level: upper faces, walls, lower faces.
struct LetTable {
    std::uint32_t first = 0;
    std::array<std::uint32_t, 3> counts{};  ///< of indices: upper, walls, lower
};

/// A run of indices.
struct IndexRun {
    std::uint32_t first = 0;
    std::uint32_t count = 0;
};

/// The index tables all lets share (paper: one table per level). let_mesh.h says what an index is.
struct LetTables {
    std::vector<std::uint32_t> indices;
    std::array<LetTable, shader::kDrawCount> tables{};  ///< by draw of a batch

    /// The run to draw when only `faces` can be seen; flat levels always show exactly one face.
    [[nodiscard]] IndexRun run(std::uint32_t draw, SeenFaces faces) const;
    /// Likewise of quads with walls: boxes, one for draws of no groups.
    [[nodiscard]] IndexRun boxRun(std::uint32_t draw, SeenFaces faces) const {
        return runOf(tables[draw == shader::kLevelQuad ? draw : shader::kDrawOfRest], faces);
    }

private:
    [[nodiscard]] static IndexRun runOf(const LetTable& table, SeenFaces faces);
};

[[nodiscard]] LetTables makeLetTables();

}  // namespace render
