#pragma once

#include <span>
#include <string>
#include <vector>

#include "model/clearance/side_names.h"
#include "model/export/clearance_export.h"

/// What the reports on rules have in common.
namespace model {

/// The first ones of a rule.
[[nodiscard]] std::span<const RuleFinding> findingsOf(const StepRules& step, std::size_t rule, std::size_t most);
[[nodiscard]] std::span<const WaivedFinding> waivedOf(const StepRules& step, std::size_t rule, std::size_t most);
/// How many of either are behind those, in words; empty if there are none.
[[nodiscard]] std::vector<std::string> unlistedOf(const StepRules& step, std::size_t rule, std::size_t most);
/// What a rule could not check.
[[nodiscard]] std::vector<std::string> uncheckedOf(const RuleReport& report, std::size_t rule);

/// "3 locations", "1 location, 2 waived"
[[nodiscard]] std::string countsText(const RuleTable& table, const RuleReport& report, std::size_t rule);
/// "at least 250.0 um", "at most 8 : 1"; empty where a kind has no limit.
[[nodiscard]] std::string boundText(const Rule& rule);
/// "copper-copper between power and any net, at least 250.0 um"
[[nodiscard]] std::string limitText(const Rule& rule);
/// "TOP at (12.3456, 7.5000) mm: GND, U1.3, pad and VCC, track", without numbers of elements, which are others in every
/// version of a job.
[[nodiscard]] std::string placeText(const Document& step, const SideNames& names, const RuleFinding& finding);
/// "86.700 um of 100.0 um", and a reason where there is one.
[[nodiscard]] std::string shortfallText(const Rule& rule, const RuleFinding& finding);

/// How many rules of all steps have this verdict.
[[nodiscard]] std::size_t rulesWith(const RuleTable& table, std::span<const StepRules> steps, Verdict verdict);
/// Are all rules of all steps unused or off? That is no pass, whatever a report lists.
[[nodiscard]] bool isNothingChecked(const RuleTable& table, std::span<const StepRules> steps);
inline constexpr const char* kNothingChecked = "nothing was checked: all rules are unused";

}  // namespace model
