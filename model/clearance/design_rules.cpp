#include "model/clearance/design_rules.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>

#include "model/figures/distance.h"
#include "model/text/formatting.h"

namespace model {

namespace {

/// What there is to know of a kind; rows in the order of RuleKind.
struct KindTraits {
    const char* name;
    std::array<RuleSide, 2> sides;
    RuleLimit limit;
    bool hasLayer;
    const char* meaning;
};
constexpr auto kNone = RuleSide::None;
constexpr auto kNet = RuleSide::Net;
constexpr auto kCopper = RuleSide::Copper;
constexpr auto kAHole = RuleSide::Hole;
constexpr auto kLength = RuleLimit::Length;
constexpr std::array<KindTraits, kRuleKindCount> kKinds = {{
    {"copper-copper",
     {kCopper, kCopper},
     kLength,
     true,
     "Between nets, on one layer; walls of plated holes count as copper."},
    {"copper-hole",
     {kCopper, kAHole},
     kLength,
     true,
     "From copper to holes as drilled: NPTHs, and plated ones of other nets."},
    {"copper-edge", {kCopper, kNone}, kLength, true, "From copper to the outline of the board and its cut-outs."},
    {"hole-hole", {kAHole, kAHole}, kLength, false, "Between holes as drilled that pass a common copper layer."},
    {"annular-ring",
     {kAHole, kNone},
     kLength,
     true,
     "What is left of the pads around a plated hole or slot, on every layer; where a layer has none, of other copper."},
    {"hole-size", {kAHole, kNone}, kLength, false, "Diameter of round holes as drilled."},
    {"slot-width", {kAHole, kNone}, kLength, false, "Width of slots and routed paths as drilled or routed."},
    {"aspect-ratio",
     {kAHole, kNone},
     RuleLimit::Ratio,
     false,
     "How many times as deep as wide a round plated hole is drilled."},
    {"mask-sliver", {kNone, kNone}, kLength, true, "What is left of solder mask between two openings."},
    {"mask-copper", {kNet, kNone}, kLength, true, "By how much a solder mask opening is larger than the pad in it."},
    {"mask-foreign",
     {kCopper, kNone},
     kLength,
     true,
     "From a solder mask opening to copper of other nets than what it is for."},
    {"silk-pad", {kNone, kNone}, kLength, true, "From silkscreen to pads that solder mask leaves free."},
    {"track-width", {kNet, kNone}, kLength, true, "Width of tracks."},
    {"acute-angle", {kNet, kNone}, RuleLimit::None, true, "Tracks of a net that meet at less than 90 degrees."},
    {"floating-copper", {kNone, kNone}, RuleLimit::None, true, "Copper that reaches no pad and no plated hole."},
    {"creepage",
     {kCopper, kCopper},
     kLength,
     true,
     "Between nets along an outer face, around cut-outs, slots and NPTHs."},
}};

const KindTraits& traitsOf(RuleKind kind) {
    return kKinds[static_cast<std::size_t>(kind)];
}

constexpr std::array<const char*, kHoleClassCount> kHoleNames = {"any", "plated", "microvia", "non-plated"};
constexpr std::array<const char*, kCopperObjectCount> kObjectNames = {"any", "track", "pad", "via", "plane"};

std::size_t sidesWith(RuleKind kind, bool (*counts)(RuleSide)) {
    const std::array<RuleSide, 2> sides = sidesOf(kind);
    return static_cast<std::size_t>(std::ranges::count_if(sides, counts));
}

/// "between power and any net", "of any net"; empty if nothing is named.
std::string sidesText(const std::array<std::string, 2>& words, std::size_t sides) {
    return sides == 2 ? " between " + words[0] + " and " + words[1] : " of " + words[0];
}

std::string holesText(const Rule& rule) {
    constexpr const char* kMany[] = {"any holes", "plated holes", "microvias", "NPTHs"};
    const auto word = [&](std::size_t side) { return std::string(kMany[static_cast<std::size_t>(rule.holes[side])]); };
    return sidesText({word(0), word(1)}, holeSidesOf(rule.kind));
}

std::string objectsText(const Rule& rule) {
    constexpr const char* kMany[] = {"any copper", "tracks", "pads", "vias", "planes"};
    const auto word = [&](std::size_t side) {
        return std::string(kMany[static_cast<std::size_t>(rule.objects[side])]);
    };
    return sidesText({word(0), word(1)}, copperSidesOf(rule.kind));
}

std::string netsText(const Rule& rule) {
    const auto word = [&](std::size_t side) {
        const std::string& name = rule.classes[side];
        return name.empty()                   ? std::string("any net")
               : name.starts_with(kNetPrefix) ? name.substr(kNetPrefix.size())
                                              : name;
    };
    return sidesText({word(0), word(1)}, netSidesOf(rule.kind));
}

}  // namespace

const char* nameOf(RuleKind kind) {
    return traitsOf(kind).name;
}

std::optional<RuleKind> ruleKindOf(std::string_view name) {
    const auto* const kind = std::ranges::find_if(kKinds, [&](const KindTraits& known) { return name == known.name; });
    return kind == kKinds.end() ? std::nullopt : std::optional(static_cast<RuleKind>(kind - kKinds.begin()));
}

const char* meaningOf(RuleKind kind) {
    return traitsOf(kind).meaning;
}

RuleLimit limitOf(RuleKind kind) {
    return traitsOf(kind).limit;
}

bool hasLeast(RuleKind kind) {
    return limitOf(kind) == RuleLimit::Length;
}

std::array<RuleSide, 2> sidesOf(RuleKind kind) {
    return traitsOf(kind).sides;
}

bool isSymmetric(RuleKind kind) {
    return sidesOf(kind)[1] != RuleSide::None && sidesOf(kind)[0] == sidesOf(kind)[1];
}

bool hasLayer(RuleKind kind) {
    return traitsOf(kind).hasLayer;
}

const char* nameOf(HoleClass holes) {
    return kHoleNames[static_cast<std::size_t>(holes)];
}

std::optional<HoleClass> holeClassOf(std::string_view name) {
    const auto* const found = std::ranges::find_if(kHoleNames, [&](const char* known) { return name == known; });
    return found == kHoleNames.end() ? std::nullopt : std::optional(static_cast<HoleClass>(found - kHoleNames.begin()));
}

const char* nameOf(CopperObject object) {
    return kObjectNames[static_cast<std::size_t>(object)];
}

std::optional<CopperObject> copperObjectOf(std::string_view name) {
    const auto* const found = std::ranges::find_if(kObjectNames, [&](const char* known) { return name == known; });
    return found == kObjectNames.end() ? std::nullopt
                                       : std::optional(static_cast<CopperObject>(found - kObjectNames.begin()));
}

std::size_t holeSidesOf(RuleKind kind) {
    return sidesWith(kind, [](RuleSide side) { return side == RuleSide::Hole; });
}

std::size_t netSidesOf(RuleKind kind) {
    return sidesWith(kind, [](RuleSide side) { return side != RuleSide::None; });
}

std::size_t copperSidesOf(RuleKind kind) {
    return sidesWith(kind, [](RuleSide side) { return side == RuleSide::Copper; });
}

std::string titleOf(const Rule& rule) {
    std::string title = nameOf(rule.kind);
    title += rule.isSameNet ? " within a net" : "";
    title += rule.classes != std::array<std::string, 2>{} ? netsText(rule) : "";
    title += rule.objects != std::array<CopperObject, 2>{} ? objectsText(rule) : "";
    title += rule.holes != std::array<HoleClass, 2>{} ? holesText(rule) : "";
    return rule.layer.empty() ? title : title + " on " + rule.layer;
}

std::string ratioText(double ratio) {
    return formatted("%.4g : 1", ratio);
}

std::size_t netClassCount(const RuleTable& table) {
    std::set<std::string> named;
    for (const Rule& rule : table.rules) {
        std::ranges::copy_if(rule.classes, std::inserter(named, named.end()),
                             [](const std::string& name) { return name.starts_with(kNetPrefix); });
    }
    return table.classes.size() + named.size();
}

bool isBelow(double limit, Nm tolerance, double distance) {
    constexpr double kRounding = 0.01;  // distances are exact to a tenth of this
    return distance < limit - std::max<double>(tolerance, kRounding);
}

bool isBroken(const Rule& rule, Nm tolerance, double distance) {
    return distance <= kTouchNm || isBelow(rule.least, tolerance, distance);
}

RuleTable defaultRules() {
    constexpr Nm kUm = 1000;
    constexpr bool kOff = false;
    return {{},
            {{RuleKind::CopperToCopper, 100 * kUm, {}},
             {RuleKind::CopperToHole, 200 * kUm, {}},
             {RuleKind::CopperToEdge, 250 * kUm, {}},
             {RuleKind::HoleToHole, 250 * kUm, {}},
             {RuleKind::AnnularRing, 100 * kUm, {}},
             {RuleKind::MaskSliver, 75 * kUm, {}},
             {RuleKind::CopperToHole, 125 * kUm, {}, true, {HoleClass::Microvia}},
             {RuleKind::HoleToHole, 150 * kUm, {}, true, {HoleClass::Microvia, HoleClass::Any}},
             {RuleKind::AnnularRing, 75 * kUm, {}, true, {HoleClass::Microvia}},
             {RuleKind::TrackWidth, 100 * kUm, {}},
             {RuleKind::HoleSize, 200 * kUm, {}},
             {RuleKind::HoleSize, 100 * kUm, {}, true, {HoleClass::Microvia}},
             {RuleKind::SlotWidth, 500 * kUm, {}},
             {RuleKind::CopperToCopper, 100 * kUm, {}, kOff, {}, {}, "", true},
             {RuleKind::MaskToCopper, 25 * kUm, {}, kOff},
             {RuleKind::MaskToForeign, 50 * kUm, {}, kOff},
             {RuleKind::SilkToPad, 100 * kUm, {}, kOff},
             {RuleKind::AcuteAngle, 0, {}, kOff},
             {RuleKind::FloatingCopper, 0, {}, kOff},
             {RuleKind::Creepage, 600 * kUm, {}, kOff, {}, {}, "", false, 1000 * kUm},
             {RuleKind::AspectRatio, 0, {}, kOff, {}, {}, "", false, 0, 10.0},
             {RuleKind::AspectRatio, 0, {}, kOff, {HoleClass::Microvia}, {}, "", false, 0, 1.0}}};
}

}  // namespace model
