#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string_view>

/// Boards made up to measure: the element counts of the paper's Table 3, laid out like a board (layout.h) and written
/// as an ODB++ job (job_writer.h).
namespace model::generate {

/// Elements by kind, in the order of model::ElementKind: line, arc, circle, trail, area.
using Counts = std::array<std::uint64_t, 5>;

/// A row of the paper's Table 3. `tracksPerTrail` is ours: with it, and with the paper's fixed segments, a generated
/// board has about the number of triangles that Table 2 gives for the row.
struct PaperModel {
    std::string_view name;
    Counts counts;
    int tracksPerTrail = 0;
    std::uint64_t paperTriangles = 0;  ///< Table 2
};

[[nodiscard]] std::span<const PaperModel> paperModels();
[[nodiscard]] const PaperModel* findPaperModel(std::string_view name);  ///< null if there is none

}  // namespace model::generate
