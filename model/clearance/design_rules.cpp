#include "model/clearance/design_rules.h"

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <span>

#include "model/base/units.h"
#include "model/figures/distance.h"
#include "model/text/formatting.h"
#include "model/text/json_lines.h"
#include "model/text/json_text.h"

namespace model {

using nlohmann::ordered_json;

namespace {

constexpr const char* kVersionKey = "copperscope_rules";
constexpr int kVersion = 1;
constexpr std::array<const char*, kRuleKindCount> kNames = {"copper-copper", "copper-hole",  "copper-edge",
                                                            "hole-hole",     "annular-ring", "mask-sliver"};

constexpr std::array<const char*, kHoleClassCount> kHoleNames = {"any", "plated", "microvia", "non-plated"};

constexpr std::array<const char*, kRuleKindCount> kMeanings = {
    "Between nets, on one layer; walls of plated holes count as copper.",
    "From copper to holes as drilled: NPTHs, and plated ones of other nets.",
    "From copper to the outline of the board and its cut-outs.",
    "Between holes as drilled that pass a common copper layer.",
    "What is left of a pad around a plated hole or slot, on every layer where it has one.",
    "What is left of solder mask between two openings."};

base::Error bad(const std::string& what) {
    return {base::ErrorCode::BadInput, "the rules cannot be used: " + what};
}

base::Result<NetClass> parseClass(const std::string& name, const ordered_json& nets, const JsonLines& lines) {
    const std::string where = "line " + std::to_string(lines.of("/classes/" + name)) + ": ";
    if (name.empty() || !nets.is_array()) {
        return bad(where + "class \"" + name + "\" needs a name and a list of nets");
    }
    NetClass netClass{name, {}};
    for (const ordered_json& net : nets) {
        if (!net.is_string()) {
            return bad(where + "class \"" + name + "\" lists an item that is no name");
        }
        netClass.nets.push_back(net);
    }
    return netClass;
}

base::Status parseBetween(const ordered_json& between, const RuleTable& table, const std::string& where, Rule& rule) {
    const bool isPair = between.is_array() && between.size() == 2 && between[0].is_string() && between[1].is_string();
    if (!isPair || rule.kind != RuleKind::CopperToCopper) {
        return bad(where + ": \"between\" names two net classes of a copper-copper rule");
    }
    for (std::size_t i = 0; i < 2; ++i) {
        rule.classes[i] = between[i];
        if (!rule.classes[i].empty() &&
            std::ranges::find(table.classes, rule.classes[i], &NetClass::name) == table.classes.end()) {
            return bad(where + ": there is no net class \"" + rule.classes[i] + "\"");
        }
    }
    return base::Done{};
}

base::Status parseHoles(const ordered_json& json, const std::string& where, Rule& rule) {
    const std::size_t sides = holeSidesOf(rule.kind);
    const ordered_json names = json.is_string() ? ordered_json::array({json}) : json;
    if (sides == 0 || !names.is_array() || names.size() != sides) {
        return bad(where + ": \"holes\" names one kind of a copper-hole or annular-ring rule, two of a hole-hole rule");
    }
    for (std::size_t i = 0; i < sides; ++i) {
        const std::optional<HoleClass> holes =
            names[i].is_string() ? holeClassOf(names[i].get<std::string>()) : std::nullopt;
        if (!holes) {
            return bad(where + ": \"holes\" are any, plated, microvia or non-plated, not " + names[i].dump());
        }
        rule.holes[i] = *holes;
    }
    return base::Done{};
}

/// A key that nothing reads is a typing error; `path` is that of the object.
base::Status checkKeys(const ordered_json& json, const std::string& path, std::span<const char* const> known,
                       const JsonLines& lines) {
    for (const auto& [key, value] : json.items()) {
        if (std::ranges::none_of(known, [&](const char* name) { return key == name; })) {
            const std::vector<std::string> names(known.begin(), known.end());
            return bad("line " + std::to_string(lines.of(path + '/' + key)) + ": unknown key \"" + key +
                       "\"; there are " + joined(names));
        }
    }
    return base::Done{};
}

base::Result<Nm> parseLeast(double least, const std::string& where) {
    const double most = kMostLeast / base::kNmPerUm;
    if (!(least >= 1 / base::kNmPerUm && least <= most)) {
        return bad(where + ": \"least_um\" must be above 0 (0.001 at least) and at most 100000");
    }
    return static_cast<Nm>(std::lround(least * base::kNmPerUm));
}

base::Result<Rule> parseRule(const ordered_json& json, const RuleTable& table, const JsonLines& lines) {
    constexpr const char* kKeys[] = {"kind", "least_um", "between", "holes", "on"};
    const std::string path = "/rules/" + std::to_string(table.rules.size());
    const auto where = [&](const std::string& key) {
        return "line " + std::to_string(lines.of(path + '/' + key)) + ", rule " +
               std::to_string(table.rules.size() + 1);
    };
    if (!json.is_object() || !json.contains("kind") || !json["kind"].is_string() || !json.contains("least_um") ||
        !json["least_um"].is_number()) {
        return bad(where("") + " needs a \"kind\" and a number \"least_um\"");
    }
    RETURN_IF_ERROR(checkKeys(json, path, kKeys, lines));
    const std::optional<RuleKind> kind = ruleKindOf(json["kind"].get<std::string>());
    if (!kind) {
        return bad(where("kind") + ": there is no kind \"" + json["kind"].get<std::string>() + "\"");
    }
    ASSIGN_OR_RETURN(const Nm least, parseLeast(json["least_um"], where("least_um")));
    const ordered_json isOn = json.value("on", ordered_json(true));
    if (!isOn.is_boolean()) {
        return bad(where("on") + ": \"on\" is true or false");
    }
    Rule rule{*kind, least, {}, isOn};
    if (json.contains("between")) {
        RETURN_IF_ERROR(parseBetween(json["between"], table, where("between"), rule));
    }
    if (json.contains("holes")) {
        RETURN_IF_ERROR(parseHoles(json["holes"], where("holes"), rule));
    }
    return rule;
}

base::Result<Nm> parseTolerance(const ordered_json& json, const JsonLines& lines) {
    const ordered_json value = json.value("tolerance_um", ordered_json(kTolerance / base::kNmPerUm));
    const double um = value.is_number() ? value.get<double>() : -1.0;
    if (!(um >= 0 && um <= kMostTolerance / base::kNmPerUm)) {
        return bad("line " + std::to_string(lines.of("/tolerance_um")) +
                   ": \"tolerance_um\" must be a number from 0 to 10");
    }
    return static_cast<Nm>(std::lround(um * base::kNmPerUm));
}

base::Result<ordered_json> parseText(std::string_view text) {
    try {
        ordered_json json = ordered_json::parse(text, nullptr, true, true);  // with comments
        if (!json.is_object() || json.value(kVersionKey, ordered_json()) != kVersion) {
            return bad("this is no file of Copperscope's rules of version 1 (\"copperscope_rules\": 1)");
        }
        return json;
    } catch (const ordered_json::exception& error) {
        return bad(std::string("this is no file of JSON: ") + error.what());
    }
}

ordered_json jsonOf(const Rule& rule) {
    ordered_json json{{"kind", nameOf(rule.kind)}, {"least_um", rule.least / base::kNmPerUm}};
    if (rule.classes != std::array<std::string, 2>{}) {
        json["between"] = rule.classes;
    }
    if (rule.holes != std::array<HoleClass, 2>{}) {
        json["holes"] = nameOf(rule.holes[0]);
        if (holeSidesOf(rule.kind) == 2) {
            json["holes"] = {nameOf(rule.holes[0]), nameOf(rule.holes[1])};
        }
    }
    if (!rule.isOn) {
        json["on"] = false;
    }
    return json;
}

}  // namespace

const char* nameOf(RuleKind kind) {
    return kNames[static_cast<std::size_t>(kind)];
}

std::optional<RuleKind> ruleKindOf(std::string_view name) {
    const auto kind = std::ranges::find_if(kNames, [&](const char* known) { return name == known; });
    return kind == kNames.end() ? std::nullopt : std::optional(static_cast<RuleKind>(kind - kNames.begin()));
}

const char* nameOf(HoleClass holes) {
    return kHoleNames[static_cast<std::size_t>(holes)];
}

std::optional<HoleClass> holeClassOf(std::string_view name) {
    const auto found = std::ranges::find_if(kHoleNames, [&](const char* known) { return name == known; });
    return found == kHoleNames.end() ? std::nullopt : std::optional(static_cast<HoleClass>(found - kHoleNames.begin()));
}

std::size_t holeSidesOf(RuleKind kind) {
    return kind == RuleKind::HoleToHole ? 2 : kind == RuleKind::CopperToHole || kind == RuleKind::AnnularRing ? 1 : 0;
}

std::string titleOf(const Rule& rule) {
    std::string title = nameOf(rule.kind);
    if (rule.classes != std::array<std::string, 2>{}) {
        const auto word = [](const std::string& name) { return name.empty() ? std::string("any net") : name; };
        title += " between " + word(rule.classes[0]) + " and " + word(rule.classes[1]);
    }
    if (rule.holes != std::array<HoleClass, 2>{}) {
        constexpr const char* kMany[] = {"any holes", "plated holes", "microvias", "NPTHs"};
        const auto word = [&](std::size_t side) {
            return std::string(kMany[static_cast<std::size_t>(rule.holes[side])]);
        };
        title += holeSidesOf(rule.kind) == 2 ? " between " + word(0) + " and " + word(1) : " of " + word(0);
    }
    return title;
}

bool isBroken(const Rule& rule, Nm tolerance, double distance) {
    constexpr double kRounding = 0.01;  // distances are exact to a tenth of this
    return distance <= kTouchNm || distance < rule.least - std::max<double>(tolerance, kRounding);
}

RuleTable defaultRules() {
    constexpr Nm kUm = 1000;
    return {{},
            {{RuleKind::CopperToCopper, 100 * kUm, {}},
             {RuleKind::CopperToHole, 200 * kUm, {}},
             {RuleKind::CopperToEdge, 250 * kUm, {}},
             {RuleKind::HoleToHole, 250 * kUm, {}},
             {RuleKind::AnnularRing, 100 * kUm, {}},
             {RuleKind::MaskSliver, 75 * kUm, {}},
             {RuleKind::CopperToHole, 125 * kUm, {}, true, {HoleClass::Microvia}},
             {RuleKind::HoleToHole, 150 * kUm, {}, true, {HoleClass::Microvia, HoleClass::Any}},
             {RuleKind::AnnularRing, 75 * kUm, {}, true, {HoleClass::Microvia}}}};
}

base::Result<RuleTable> parseRules(std::string_view text) {
    ASSIGN_OR_RETURN(const ordered_json json, parseText(text));
    const JsonLines lines(text);
    constexpr const char* kKeys[] = {kVersionKey, "tolerance_um", "classes", "rules"};
    RETURN_IF_ERROR(checkKeys(json, "", kKeys, lines));
    if (!lines.duplicate().empty()) {
        return bad("line " + std::to_string(lines.of(lines.duplicate())) + ": the key " +
                   lines.duplicate().substr(lines.duplicate().rfind('/') + 1) + " is there twice");
    }
    const ordered_json classes = json.value("classes", ordered_json::object());
    const ordered_json rules = json.value("rules", ordered_json::array());
    if (!classes.is_object() || !rules.is_array()) {
        return bad("\"classes\" must be an object and \"rules\" a list");
    }
    RuleTable table;
    ASSIGN_OR_RETURN(table.tolerance, parseTolerance(json, lines));
    for (const auto& [name, nets] : classes.items()) {
        ASSIGN_OR_RETURN(NetClass netClass, parseClass(name, nets, lines));
        table.classes.push_back(std::move(netClass));
    }
    if (table.classes.size() > kMostNetClasses) {
        return bad("there are more than " + std::to_string(kMostNetClasses) + " net classes");
    }
    for (const ordered_json& rule : rules) {
        ASSIGN_OR_RETURN(Rule parsed, parseRule(rule, table, lines));
        table.rules.push_back(parsed);
    }
    return table.rules.empty() ? base::Result<RuleTable>(bad("there are none")) : table;
}

std::string toJson(const RuleTable& table) {
    ordered_json classes = ordered_json::object();
    for (const NetClass& netClass : table.classes) {
        classes[netClass.name] = netClass.nets;
    }
    ordered_json rules = ordered_json::array();
    for (const Rule& rule : table.rules) {
        rules.push_back(jsonOf(rule));
    }
    return jsonText({{kVersionKey, kVersion},
                     {"tolerance_um", table.tolerance / base::kNmPerUm},
                     {"classes", classes},
                     {"rules", rules}});
}

std::string commentedJson(const RuleTable& table) {
    ordered_json classes = ordered_json::object();
    for (const NetClass& netClass : table.classes) {
        classes[netClass.name] = netClass.nets;
    }
    std::string text = "// Design rules for copperscope clearance --rules FILE. Lengths in micrometres.\n{\n";
    text += "  \"" + std::string(kVersionKey) + "\": " + std::to_string(kVersion) + ",\n";
    text += "  // How far a distance may be below its limit and still pass, 0 to 10.\n";
    text += "  \"tolerance_um\": " + ordered_json(table.tolerance / base::kNmPerUm).dump() + ",\n";
    text += "  // Net classes: {\"power\": [\"VCC*\", \"GND\"]}, with * for any text and ? for any letter.\n";
    text += "  \"classes\": " + classes.dump() + ",\n";
    text +=
        "  // Of several rules that fit the last one holds. \"between\": [\"power\", \"\"] names net classes of a\n"
        "  // copper-copper rule (\"\": any net); \"on\": false switches a rule off.\n  \"rules\": [\n";
    for (std::size_t row = 0; row < table.rules.size(); ++row) {
        const Rule& rule = table.rules[row];
        text += std::string("    // ") + kMeanings[static_cast<std::size_t>(rule.kind)] + "\n    " +
                jsonOf(rule).dump() + (row + 1 < table.rules.size() ? ",\n" : "\n");
    }
    return text + "  ]\n}\n";
}

base::Result<RuleTable> readRules(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    const std::string text(std::istreambuf_iterator<char>(file), {});
    if (!file.is_open() || file.bad()) {
        return base::Error{base::ErrorCode::BadInput, path.string() + " cannot be read"};
    }
    return parseRules(text);
}

bool fitsWildcard(std::string_view name, std::string_view pattern) {
    // The last star seen takes more and more of the name until what follows it fits.
    std::size_t at = 0;
    std::size_t p = 0;
    std::size_t star = std::string_view::npos;
    std::size_t afterStar = 0;
    while (at < name.size()) {
        if (p < pattern.size() && (pattern[p] == '?' || (pattern[p] != '*' && pattern[p] == name[at]))) {
            ++at;
            ++p;
        } else if (p < pattern.size() && pattern[p] == '*') {
            star = p++;
            afterStar = at;
        } else if (star != std::string_view::npos) {
            p = star + 1;
            at = ++afterStar;
        } else {
            return false;
        }
    }
    return pattern.find_first_not_of('*', p) == std::string_view::npos;
}

}  // namespace model
