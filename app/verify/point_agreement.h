#pragma once

#include <cstdint>

#include "app/verify/step_file.h"
#include "model/export/solids/solid_plan.h"

namespace app {

/// The paper's measure of a model's accuracy: how many points in and around a board are on the same side of the surface
/// in both models.
struct PointAgreement {
    std::uint64_t points = 0;
    std::uint64_t agreeing = 0;
    std::uint64_t inside = 0;  ///< of the document

    [[nodiscard]] double share() const {
        return points == 0 ? 0.0 : static_cast<double>(agreeing) / static_cast<double>(points);
    }
};

/// Half of the points lie anywhere in the box of the plan, half of them within 50 µm of the walls of its elements. Of
/// the document, the figures that distances are measured with are asked, not the shells that were written; of the file,
/// its solids. The same points for the same seed.
[[nodiscard]] PointAgreement comparePoints(const model::SolidPlan& plan, const StepFile& file, std::uint64_t points,
                                           std::uint64_t seed);

}  // namespace app
