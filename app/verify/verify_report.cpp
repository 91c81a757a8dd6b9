#include "app/verify/verify_report.h"

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "model/text/formatting.h"
#include "model/text/json_text.h"

namespace app {

namespace {

constexpr double kVolumeLimit = 1e-6;
constexpr double kPointLimit = 0.9999;
constexpr double kPictureLimit = 0.001;

ShapeReport& rowFor(VerifyReport& report, std::string_view shape) {
    const auto found = std::ranges::find(report.shapes, shape, &ShapeReport::shape);
    return found != report.shapes.end() ? *found : report.shapes.emplace_back(ShapeReport{shape});
}

/// Empty if the solid keeps the limits.
std::string faultOf(const StepSolid& solid, double volumeError) {
    return !solid.isValid               ? "it is not valid"
           : !solid.isClosed            ? "it is not one closed shell"
           : volumeError > kVolumeLimit ? model::formatted("its volume is %.2e off", volumeError)
                                        : "";
}

bool isGood(const ShapeReport& shape) {
    return shape.invalid == 0 && shape.open == 0 && shape.volumeError <= kVolumeLimit;
}

}  // namespace

bool VerifyReport::isPassed() const {
    const bool arePicturesLike =
        std::ranges::all_of(pictures, [](const PictureAgreement& picture) { return picture.greyMse <= kPictureLimit; });
    return solids == expected && std::ranges::all_of(shapes, isGood) &&
           (points.points == 0 || points.share() >= kPointLimit) && arePicturesLike;
}

void compareSolids(const StepFile& file, const std::vector<ExpectedSolid>& expected, VerifyReport& report) {
    report.solids = file.size();
    report.expected = expected.size();
    for (std::size_t i = 0; i < std::min(file.size(), expected.size()); ++i) {
        const StepSolid solid = file.solid(i);
        ShapeReport& row = rowFor(report, expected[i].shape);
        ++row.solids;
        row.invalid += solid.isValid ? 0 : 1;
        row.open += solid.isClosed ? 0 : 1;
        const double volumeError = std::abs(solid.volume / expected[i].volume - 1.0);
        row.volumeError = std::max(row.volumeError, volumeError);
        if (std::string what = faultOf(solid, volumeError); !what.empty()) {
            report.faults.push_back({expected[i].shape, expected[i].element, std::move(what), solid.box});
        }
        row.tolerance = std::max(row.tolerance, solid.tolerance);
    }
}

std::string verifyText(const VerifyReport& report) {
    std::string text =
        model::formatted("%zu solids in the file, %zu expected\n\n%-26s %8s %8s %8s %14s %14s\n", report.solids,
                         report.expected, "shape", "solids", "invalid", "open", "volume error", "tolerance nm");
    for (const ShapeReport& row : report.shapes) {
        text += model::formatted("%-26s %8zu %8zu %8zu %14.2e %14.3f\n", std::string(row.shape).c_str(), row.solids,
                                 row.invalid, row.open, row.volumeError, row.tolerance);
    }
    for (const SolidFault& fault : report.faults) {
        text += model::formatted("element %u, %s, at %.3f %.3f to %.3f %.3f mm: %s\n", fault.element.value,
                                 std::string(fault.shape).c_str(), fault.box[0] / 1e6, fault.box[1] / 1e6,
                                 fault.box[3] / 1e6, fault.box[4] / 1e6, fault.what.c_str());
    }
    if (report.points.points > 0) {
        text += model::formatted("\n%llu of %llu points agree: %.4f %% (%llu inside)\n",
                                 static_cast<unsigned long long>(report.points.agreeing),
                                 static_cast<unsigned long long>(report.points.points), 100 * report.points.share(),
                                 static_cast<unsigned long long>(report.points.inside));
    }
    for (const PictureAgreement& picture : report.pictures) {
        text += model::formatted("grey MSE, %s: %.6f\n", picture.view.c_str(), picture.greyMse);
    }
    return text + (report.isPassed() ? "passed\n" : "NOT passed\n");
}

std::string verifyJson(const VerifyReport& report) {
    nlohmann::ordered_json shapes = nlohmann::ordered_json::array();
    for (const ShapeReport& row : report.shapes) {
        shapes.push_back({{"shape", row.shape},
                          {"solids", row.solids},
                          {"invalid", row.invalid},
                          {"open", row.open},
                          {"volume_error", row.volumeError},
                          {"tolerance_nm", row.tolerance}});
    }
    nlohmann::ordered_json faults = nlohmann::ordered_json::array();
    for (const SolidFault& fault : report.faults) {
        faults.push_back(
            {{"shape", fault.shape}, {"element", fault.element.value}, {"box_nm", fault.box}, {"what", fault.what}});
    }
    nlohmann::ordered_json pictures = nlohmann::ordered_json::array();
    for (const PictureAgreement& picture : report.pictures) {
        pictures.push_back({{"view", picture.view}, {"grey_mse", picture.greyMse}});
    }
    const PointAgreement& points = report.points;
    const nlohmann::ordered_json all = {{"solids", report.solids},
                                        {"expected", report.expected},
                                        {"shapes", shapes},
                                        {"faults", faults},
                                        {"points",
                                         {{"count", points.points},
                                          {"agreeing", points.agreeing},
                                          {"inside", points.inside},
                                          {"share", points.share()}}},
                                        {"pictures", pictures},
                                        {"passed", report.isPassed()}};
    return model::jsonText(all);
}

}  // namespace app
