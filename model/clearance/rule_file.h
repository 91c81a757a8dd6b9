#pragma once

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/result.h"
#include "model/clearance/design_rules.h"

/// Rules as files have them.
namespace model {

/// From JSON:
///
///     {"copperscope_rules": 1, "classes": {"power": ["VCC*", "GND"]},
///      "tolerance_um": 0.5,
///      "rules": [{"kind": "copper-copper", "least_um": 100}, {"kind": "copper-copper", "least_um": 250,
///                 "between": ["power", ""], "on": false}]}
///
/// Rules of holes may name which: "holes": "microvia", of hole-hole two: "holes": ["microvia", "any"]; rules of copper
/// objects: "objects": "pad", of copper-copper two. Rules of one net side name its class by "of" instead of "between".
/// "layer": "outer", "same_net": true, "least_slot_um" of creepage, "most_ratio" of aspect-ratio are as in Rule.
/// A rule without "on" is on; without "tolerance_um" it is kTolerance.
/// Comments are allowed, unknown keys and keys that are there twice are not.
/// Errors: BadInput, saying what is wrong with which rule, key and line.
[[nodiscard]] base::Result<RuleTable> parseRules(std::string_view json);
[[nodiscard]] std::string toJson(const RuleTable& table);
/// The same for people to edit: a rule a line, with comments on what is what. parseRules reads it.
[[nodiscard]] std::string commentedJson(const RuleTable& table);
/// What of a file has no counterpart here or cannot be read: it is not checked.
struct LeftOutRule {
    std::string text;              ///< "min_via_diameter is left out"
    std::uint32_t line = 0;        ///< 0: no line of the file
    std::filesystem::path file{};  ///< empty: the file that was read
    bool operator==(const LeftOutRule&) const = default;
};
/// "line 7: min_via_diameter is left out"
[[nodiscard]] std::string textOf(const LeftOutRule& one);

struct RuleFile {
    RuleTable table;
    std::vector<LeftOutRule> leftOut;
    std::vector<std::string>
        unused{};            ///< which rules are off, which net classes and names no net fits, a sentence each
    bool isOfKicad = false;  ///< a project, board or custom rules of KiCad: see leaveOutUnusedClasses()
};
/// Takes away the rules that name what is beyond the first kMostNetClasses, which `leftOut` tells as of the file
/// `from`, and classes without a rule that there is no room for: they ask for nothing. What makes tables of KiCad's
/// files calls it; parseRules takes no more.
void leaveOutExcessClasses(RuleFile& file, const std::filesystem::path& from = {});
/// From a file, also one of KiCad's custom rules (.kicad_dru, see kicad_rules.h), a project of KiCad or a board that
/// has one (.kicad_pro, .kicad_pcb, see kicad_project_rules.h), or by the name of a preset. Errors:
/// BadInput, also where none of what the file asks for can be checked: all of that is named.
[[nodiscard]] base::Result<RuleFile> readRules(const std::filesystem::path& path);

}  // namespace model
