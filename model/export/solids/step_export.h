#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "model/export/solids/solid_plan.h"
#include "model/geometry/loops/split_loops.h"

namespace model {

/// How a layer looks in what is exported; one per layer of the board.
struct SolidLook {
    std::uint32_t rgb = 0x808080;  ///< sRGB
    double opacity = 1.0;
};

/// How solids are written.
struct StepOptions {
    std::vector<SolidLook> looks;  ///< by row of the board's layers; empty: grey
    std::string name;              ///< of the whole: the board's
    std::string time;              ///< ISO 8601, in the file's header
    /// Writes every track, pad and barrel out instead of placing one shape often, for readers without mapped items.
    bool isWrittenOut = false;
    /// Writes chords that follow each other around a bend as one edge and one wall: the same solid in a fraction of the
    /// file, for programs that take walls with bends.
    bool hasPolylines = false;
    bool isPacked = false;  ///< gzip, as readers of .stpz want it
    /// Planes with more edges or holes are written in several solids side by side (splitLarge).
    RegionLimits limits;
};

/// What became of an export.
struct SolidReport {
    std::uint64_t bytes = 0;
    std::uint64_t solids = 0;  ///< written out
    std::uint64_t copies = 0;  ///< placed
    std::vector<MissingSolid> missing;
};

/// What exports of solids and of triangles end with that wrote so many: OutputFailed where there are none, as where
/// drills take all that was chosen.
[[nodiscard]] base::Status checkAnyWritten(std::uint64_t count);

/// What a STEP file of the plan will be, before it is written, unpacked: from the text of a part of its elements.
/// Errors: Cancelled.
struct StepEstimate {
    double bytes = 0.0;
    double seconds = 0.0;  ///< on a core of a laptop
};
[[nodiscard]] base::Result<StepEstimate> estimateStep(const SolidPlan& plan, const StepOptions& options,
                                                      const base::Progress& progress);

/// Writes the plan as a STEP file (AP242; AP214 readers take it too): product in product from the board over its layers
/// to its nets, exact planes and cylinders. Memory does not grow with the board. All of the file or nothing. Errors:
/// OutputFailed; Cancelled.
[[nodiscard]] base::Result<SolidReport> exportStep(const SolidPlan& plan, const StepOptions& options,
                                                   const std::filesystem::path& path, base::Progress& progress);

}  // namespace model
