#pragma once

#include <array>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "model/board/document.h"

/// What a board must keep: distances, rings and sizes, by net class.
namespace model {

enum class RuleKind : std::uint8_t {
    CopperToCopper,  ///< between nets, on one layer; walls of plated holes count as copper
    CopperToHole,    ///< from copper to holes as drilled: NPTHs, and plated ones of other nets
    CopperToEdge,    ///< from copper to the board's outline and cut-outs
    HoleToHole,      ///< between holes as drilled that pass a common copper layer
    AnnularRing,     ///< what is left of a pad around a plated hole, on every layer where it has one
    HoleSize,        ///< diameter of round holes as drilled
    SlotWidth,       ///< width of slots and routed paths as drilled or routed
    AspectRatio,     ///< how many times as deep as wide a round plated hole is drilled; a ratio, no length
    MaskSliver,      ///< what is left of solder mask between two openings
    MaskToCopper,    ///< by how much a solder mask opening is larger than the pad in it
    MaskToForeign,   ///< from a solder mask opening to copper of other nets than what it is for
    SilkToPad,       ///< from silkscreen to pads that solder mask leaves free
    TrackWidth,      ///< of tracks
    AcuteAngle,      ///< tracks of a net that meet at less than 90°; asks for no length
    FloatingCopper,  ///< copper that reaches no pad and no plated hole; asks for no length
    Creepage         ///< between nets along an outer face, around cut-outs, slots and NPTHs
};
inline constexpr std::size_t kRuleKindCount = 16;
/// As rule files and tables have it: "copper-copper", "copper-hole", …
[[nodiscard]] const char* nameOf(RuleKind kind);
[[nodiscard]] std::optional<RuleKind> ruleKindOf(std::string_view name);
/// What a rule of this kind is about, in a sentence.
[[nodiscard]] const char* meaningOf(RuleKind kind);

/// What the values that a rule of a kind finds are held against.
enum class RuleLimit : std::uint8_t {
    None,    ///< nothing: all that is found breaks the rule
    Length,  ///< Rule::least, the least that passes
    Ratio    ///< Rule::mostRatio, the largest that passes
};
[[nodiscard]] RuleLimit limitOf(RuleKind kind);
/// Is the limit a length? Otherwise Rule::least does not count.
[[nodiscard]] bool hasLeast(RuleKind kind);

/// What can be named of one side of a rule: nets of anything but None, objects of copper, hole classes of holes.
enum class RuleSide : std::uint8_t { None, Net, Copper, Hole };
/// Of a kind like copper-hole both; of one like annular-ring the first.
[[nodiscard]] std::array<RuleSide, 2> sidesOf(RuleKind kind);
/// Are both sides the same, so that what is named of them holds either way round?
[[nodiscard]] bool isSymmetric(RuleKind kind);
/// Can it be held to some layers only?
[[nodiscard]] bool hasLayer(RuleKind kind);

/// Which holes a rule is for: those that a laser drills (HoleSpan::Micro) are made otherwise than drilled ones.
enum class HoleClass : std::uint8_t { Any, Plated, Microvia, NonPlated };
inline constexpr std::size_t kHoleClassCount = 4;
/// As rule files have it: "any", "plated" (and no microvia), "microvia", "non-plated"
[[nodiscard]] const char* nameOf(HoleClass holes);
[[nodiscard]] std::optional<HoleClass> holeClassOf(std::string_view name);
/// To how many sides of a rule of this kind a class of holes may be given: 0, 1 or 2 (holes to holes).
[[nodiscard]] std::size_t holeSidesOf(RuleKind kind);
/// For how many nets and net classes can be named.
[[nodiscard]] std::size_t netSidesOf(RuleKind kind);

/// What copper is: walls of vias and pads on them are vias, walls of other plated holes pads.
enum class CopperObject : std::uint8_t { Any, Track, Pad, Via, Plane };
inline constexpr std::size_t kCopperObjectCount = 5;
/// For how many sides of a rule of this kind objects can be named: 0, 1 or 2.
[[nodiscard]] std::size_t copperSidesOf(RuleKind kind);
/// As rule files have it: "any", "track", "pad", "via", "plane"
[[nodiscard]] const char* nameOf(CopperObject object);
[[nodiscard]] std::optional<CopperObject> copperObjectOf(std::string_view name);

/// Nets that share rules.
struct NetClass {
    std::string name;
    std::vector<std::string> nets;  ///< names, with * for any text and ? for any letter
    bool operator==(const NetClass&) const = default;
};

struct Rule {
    RuleKind kind = RuleKind::CopperToCopper;
    Nm least = 0;
    /// By side, nets of this class only; empty: any net. "net:CLK*" stands for the nets of these names.
    std::array<std::string, 2> classes;
    bool isOn = true;                       ///< else nothing is held against it, as if it were not there
    std::array<HoleClass, 2> holes{};       ///< of kinds with one side of holes (holeSidesOf) the first
    std::array<CopperObject, 2> objects{};  ///< by side
    /// "top", "bottom", "outer", "inner", or a name with * and ?; empty: all layers
    std::string layer{};
    bool isSameNet = false;  ///< CopperToCopper: within a net instead of between nets
    Nm leastSlot = 0;        ///< Creepage: cut-outs narrower than this are bridged (X of IEC 60664-1)
    double mostRatio = 0.0;  ///< AspectRatio: kLeastRatio to kMostRatio; else 0
    bool operator==(const Rule&) const = default;
};

/// "copper-copper between power and any net", "annular-ring of microvias on inner"
[[nodiscard]] std::string titleOf(const Rule& rule);

inline constexpr double kLeastRatio = 0.1;
inline constexpr double kMostRatio = 100.0;
/// "8 : 1"
[[nodiscard]] std::string ratioText(double ratio);

/// A class that stands for the nets of some names.
inline constexpr std::string_view kNetPrefix = "net:";

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

/// Is a distance less than a limit by more than the tolerance? All of them nm.
[[nodiscard]] bool isBelow(double limit, Nm tolerance, double distance);
/// Does a distance (nm) break a rule whose limit is a length? Where it is below that, and in any case what touches,
/// overlaps or breaks out.
[[nodiscard]] bool isBroken(const Rule& rule, Nm tolerance, double distance);

/// Of a table: net classes, and names of nets that stand for one ("net:CLK*").
[[nodiscard]] std::size_t netClassCount(const RuleTable& table);
inline constexpr std::size_t kMostNetClasses = 63;  ///< what a check can tell apart
inline constexpr Nm kMostLeast = 100'000'000;       ///< nothing on a board is asked to stay a decimetre apart

/// A rule of every kind, and of microvias those of their own, as common fabricators offer without extra cost. Those
/// that many boards break for good reasons are off.
[[nodiscard]] RuleTable defaultRules();

}  // namespace model
