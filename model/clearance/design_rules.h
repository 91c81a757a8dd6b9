#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/base/result.h"
#include "model/board/document.h"

/// What a board must keep: distances and rings, by net class.
namespace model {

enum class RuleKind : std::uint8_t {
    CopperToCopper,  ///< between nets, on one layer; walls of plated holes count as copper
    CopperToHole,    ///< from copper to holes as drilled: NPTHs, and plated ones of other nets
    CopperToEdge,    ///< from copper to the board's outline and cut-outs
    HoleToHole,      ///< between holes as drilled that pass a common copper layer
    AnnularRing,     ///< what is left of a pad around a plated hole, on every layer where it has one
    MaskSliver       ///< what is left of solder mask between two openings
};
inline constexpr std::size_t kRuleKindCount = 6;
/// As rule files and tables have it: "copper-copper", "copper-hole", …
[[nodiscard]] const char* nameOf(RuleKind kind);
[[nodiscard]] std::optional<RuleKind> ruleKindOf(std::string_view name);

/// Which holes a rule is for: those that a laser drills (HoleSpan::Micro) are made otherwise than drilled ones.
enum class HoleClass : std::uint8_t { Any, Plated, Microvia, NonPlated };
inline constexpr std::size_t kHoleClassCount = 4;
/// As rule files have it: "any", "plated" (and no microvia), "microvia", "non-plated"
[[nodiscard]] const char* nameOf(HoleClass holes);
[[nodiscard]] std::optional<HoleClass> holeClassOf(std::string_view name);
/// To how many sides of a rule of this kind a class of holes may be given: 0, 1 or 2 (holes to holes).
[[nodiscard]] std::size_t holeSidesOf(RuleKind kind);

/// Nets that share rules.
struct NetClass {
    std::string name;
    std::vector<std::string> nets;  ///< names, with * for any text and ? for any letter
    bool operator==(const NetClass&) const = default;
};

struct Rule {
    RuleKind kind = RuleKind::CopperToCopper;
    Nm least = 0;
    /// CopperToCopper: between nets of these classes only, either way round; empty: any net.
    std::array<std::string, 2> classes;
    bool isOn = true;                  ///< else nothing is held against it, as if it were not there
    std::array<HoleClass, 2> holes{};  ///< either way round; of kinds with one side (holeSidesOf) the first
    bool operator==(const Rule&) const = default;
};

/// "copper-copper between power and any net", "annular-ring of microvias"
[[nodiscard]] std::string titleOf(const Rule& rule);

/// By how much a distance may be below its limit, if nothing else is said: jobs round coordinates and sizes apart.
inline constexpr Nm kTolerance = 500;
inline constexpr Nm kMostTolerance = 10'000;

/// Of several rules of one kind that fit, a pair of nets or a kind of holes, the last one holds.
struct RuleTable {
    std::vector<NetClass> classes;
    std::vector<Rule> rules;
    Nm tolerance = kTolerance;  ///< 0 to kMostTolerance
    bool operator==(const RuleTable&) const = default;
};

/// Does a distance (nm) break the rule? Less than the limit by more than the tolerance; what touches, overlaps or
/// breaks out does in any case.
[[nodiscard]] bool isBroken(const Rule& rule, Nm tolerance, double distance);

inline constexpr std::size_t kMostNetClasses = 63;
inline constexpr Nm kMostLeast = 100'000'000;  ///< nothing on a board is asked to stay a decimetre apart

/// A rule of every kind, and of microvias those of their own, as common fabricators offer without extra cost.
[[nodiscard]] RuleTable defaultRules();

/// From JSON:
///
///     {"copperscope_rules": 1, "classes": {"power": ["VCC*", "GND"]},
///      "tolerance_um": 0.5,
///      "rules": [{"kind": "copper-copper", "least_um": 100}, {"kind": "copper-copper", "least_um": 250,
///                 "between": ["power", ""], "on": false}]}
///
/// Rules of holes may name which: "holes": "microvia", of hole-hole two: "holes": ["microvia", "any"].
/// A rule without "on" is on; without "tolerance_um" it is kTolerance.
/// Comments are allowed, unknown keys and keys that are there twice are not.
/// Errors: BadInput, saying what is wrong with which rule, key and line.
[[nodiscard]] base::Result<RuleTable> parseRules(std::string_view json);
[[nodiscard]] std::string toJson(const RuleTable& table);
/// The same for people to edit: a rule a line, with comments on what is what. parseRules reads it.
[[nodiscard]] std::string commentedJson(const RuleTable& table);
/// From a file. Errors: BadInput.
[[nodiscard]] base::Result<RuleTable> readRules(const std::filesystem::path& path);

/// Does a name fit a pattern with * and ?; letters count as they are.
[[nodiscard]] bool fitsWildcard(std::string_view name, std::string_view pattern);

}  // namespace model
