#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/result.h"
#include "model/clearance/rule_report.h"
#include "model/clearance/side_names.h"

/// Findings of design rules that somebody has looked at and accepts.
namespace model {

/// One side of what is waived, for people: model::Side without the number of its element.
struct WaivedSide {
    std::string net;
    std::string pin;   ///< empty if it belongs to none
    std::string kind;  ///< empty for the edge of the board
    bool operator==(const WaivedSide&) const = default;
};

/// Why a finding is no fault. It is known again by where it is, not by rows of the job, which another version numbers
/// anew: see WaiverMatch.
struct Waiver {
    RuleKind kind = RuleKind::CopperToCopper;
    FindingReason fault = FindingReason::TooClose;
    std::string step;
    std::string layer;
    Point from;  ///< the two ends of the spacing, nm of the step
    Point to;
    double distance = 0.0;  ///< nm, as it was when it was waived: what is less is not
    std::array<WaivedSide, 2> sides;
    std::string reason;  ///< not empty
    std::string author;  ///< not empty
    std::string date;    ///< "2026-11-23"
    double depth = 0.0;  ///< nm, of a hole that is too deep: what is deeper for its width is not waived; else 0
    bool operator==(const Waiver&) const = default;
};

/// Both ends of a spacing lie within this of those of a waiver that holds for it.
inline constexpr Nm kWaiverReach = 10'000;

/// Of a finding, with what a person has to say about it.
[[nodiscard]] Waiver waiverOf(const Document& step, const SideNames& names, const RuleTable& table,
                              const RuleFinding& finding, const Waiver& said);
/// Are they for the same finding?
[[nodiscard]] bool areOfOnePlace(const Waiver& a, const Waiver& b);

/// "copper-copper on TOP at (12.3456, 7.5000) mm, 86.700 um, GND, U1.3, pad and VCC, track"
[[nodiscard]] std::string placeOf(const Waiver& waiver);
/// "reviewed with the fabricator (A. Meier, 2026-11-23)"
[[nodiscard]] std::string reasonOf(const Waiver& waiver);

/// From JSON:
///
///     {"copperscope_waivers": 1,
///      "waivers": [{"kind": "copper-copper", "step": "pcb", "layer": "TOP", "from_nm": [0, 0], "to_nm": [86700, 0],
///                   "distance_nm": 86700, "sides": [{"net": "GND", "pin": "U1.3", "kind": "pad"}, {"net": "VCC"}],
///                   "reason": "reviewed with the fabricator", "author": "A. Meier", "date": "2026-11-23"}]}
///
/// A waiver of a pad that the drill removes has "fault": "pad-removed", of a hole without a pad "no-pad", and so on;
/// one of a hole that is too deep has "fault": "too-deep" and "depth_nm". Comments are allowed, unknown keys and keys
/// that are there twice are not. Errors: BadInput, saying what is wrong with which waiver, key and line; also for two
/// waivers of one location.
[[nodiscard]] base::Result<std::vector<Waiver>> parseWaivers(std::string_view json);
[[nodiscard]] std::string toJson(std::span<const Waiver> waivers);
/// From a file. Errors: BadInput.
[[nodiscard]] base::Result<std::vector<Waiver>> readWaivers(const std::filesystem::path& path);

}  // namespace model
