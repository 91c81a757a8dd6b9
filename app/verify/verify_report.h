#pragma once

#include <array>
#include <string>
#include <vector>

#include "app/verify/expected_solids.h"
#include "app/verify/picture_agreement.h"
#include "app/verify/point_agreement.h"

namespace app {

/// The solids of one shape.
struct ShapeReport {
    std::string_view shape;
    std::size_t solids = 0;
    std::size_t invalid = 0;
    std::size_t open = 0;
    double volumeError = 0.0;  ///< the largest, as a part of the volume
    double tolerance = 0.0;    ///< the largest, nm
};

/// A solid that does not keep the limits.
struct SolidFault {
    std::string_view shape;
    model::ElementId element;     ///< of its step
    std::string what;             ///< in words
    std::array<double, 6> box{};  ///< StepSolid::box
};

struct VerifyReport {
    std::size_t solids = 0;    ///< in the file
    std::size_t expected = 0;  ///< of the plan
    std::vector<ShapeReport> shapes;
    std::vector<SolidFault> faults;  ///< of solids, in their order
    PointAgreement points;
    std::vector<PictureAgreement> pictures;

    /// Does everything keep the limits of `verify`?
    [[nodiscard]] bool isPassed() const;
};

/// Compares the solids of a file one by one with those that are expected.
void compareSolids(const StepFile& file, const std::vector<ExpectedSolid>& expected, VerifyReport& report);

[[nodiscard]] std::string verifyText(const VerifyReport& report);
[[nodiscard]] std::string verifyJson(const VerifyReport& report);

}  // namespace app
