#include "model/clearance/rule_file.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>
#include <span>

#include "model/base/units.h"
#include "model/clearance/kicad_project_rules.h"
#include "model/clearance/kicad_rules.h"
#include "model/clearance/rule_presets.h"
#include "model/text/formatting.h"
#include "model/text/json_text.h"
#include "model/text/strict_json.h"
#include "model/text/whole_file.h"

namespace model {

using nlohmann::ordered_json;

namespace {

constexpr const char* kVersionKey = "copperscope_rules";
constexpr int kVersion = 1;
constexpr std::size_t kMostNamed = 20;  ///< of what is left out, in one sentence

base::Error bad(const std::string& what) {
    return {base::ErrorCode::BadInput, "the rules cannot be used: " + what};
}

base::Result<NetClass> parseClass(const std::string& name, const ordered_json& nets, const StrictJson& file) {
    const std::string where = file.lineOf("/classes/" + name) + ": ";
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

/// A string, or a list of as many as there are sides.
std::optional<std::vector<std::string>> namesOf(const ordered_json& json, std::size_t sides) {
    const ordered_json list = json.is_string() ? ordered_json::array({json}) : json;
    if (sides == 0 || !list.is_array() || list.size() != sides ||
        std::ranges::any_of(list, [](const ordered_json& name) { return !name.is_string(); })) {
        return std::nullopt;
    }
    return list.get<std::vector<std::string>>();
}

/// "between" of two sides, "of" of one.
base::Status parseNets(const ordered_json& json, const std::string& key, const RuleTable& table,
                       const std::string& where, Rule& rule) {
    const std::size_t sides = key == "between" ? 2 : 1;
    const auto names = netSidesOf(rule.kind) == sides ? namesOf(json, sides) : std::nullopt;
    if (!names) {
        return bad(where + ": \"between\" names two net classes of a rule like copper-copper, \"of\" one of a rule " +
                   "like annular-ring");
    }
    for (std::size_t i = 0; i < sides; ++i) {
        rule.classes[i] = (*names)[i];
        if (!rule.classes[i].empty() && !rule.classes[i].starts_with(kNetPrefix) &&
            std::ranges::find(table.classes, rule.classes[i], &NetClass::name) == table.classes.end()) {
            return bad(where + ": there is no net class \"" + rule.classes[i] + "\"");
        }
    }
    return base::Done{};
}

base::Status parseHoles(const ordered_json& json, const std::string& where, Rule& rule) {
    const auto names = namesOf(json, holeSidesOf(rule.kind));
    if (!names) {
        return bad(where +
                   ": \"holes\" names one kind of a rule like copper-hole or annular-ring, two of a hole-hole rule");
    }
    for (std::size_t i = 0; i < names->size(); ++i) {
        const std::optional<HoleClass> holes = holeClassOf((*names)[i]);
        if (!holes) {
            return bad(where + ": \"holes\" are any, plated, microvia or non-plated, not \"" + (*names)[i] + '"');
        }
        rule.holes[i] = *holes;
    }
    return base::Done{};
}

base::Status parseObjects(const ordered_json& json, const std::string& where, Rule& rule) {
    const auto names = namesOf(json, copperSidesOf(rule.kind));
    if (!names) {
        return bad(where + ": \"objects\" names what the copper of a rule is, two of copper-copper and creepage");
    }
    for (std::size_t i = 0; i < names->size(); ++i) {
        const std::optional<CopperObject> object = copperObjectOf((*names)[i]);
        if (!object) {
            return bad(where + ": \"objects\" are any, track, pad, via or plane, not \"" + (*names)[i] + '"');
        }
        rule.objects[i] = *object;
    }
    return base::Done{};
}

base::Status parseLayer(const ordered_json& json, const std::string& where, Rule& rule) {
    if (!json.is_string() || !hasLayer(rule.kind)) {
        return bad(where +
                   ": \"layer\" is top, bottom, outer, inner or the name of one; a rule like hole-hole has none");
    }
    rule.layer = json.get<std::string>();
    return base::Done{};
}

base::Status parseSameNet(const ordered_json& json, const std::string& where, Rule& rule) {
    if (!json.is_boolean() || rule.kind != RuleKind::CopperToCopper) {
        return bad(where + ": \"same_net\" is true or false, of a copper-copper rule");
    }
    rule.isSameNet = json.get<bool>();
    return base::Done{};
}

base::Status parseOn(const ordered_json& json, const std::string& where, Rule& rule) {
    if (!json.is_boolean()) {
        return bad(where + ": \"on\" is true or false");
    }
    rule.isOn = json.get<bool>();
    return base::Done{};
}

/// Micrometres from `least` on, up to what any rule may ask for.
base::Result<Nm> parseLength(const ordered_json& json, Nm least, const std::string& where, const std::string& key) {
    const double um = json.is_number() ? json.get<double>() : -1.0;
    if (!(um >= static_cast<double>(least) / base::kNmPerUm && um <= kMostLeast / base::kNmPerUm)) {
        return bad(where + ": \"" + key + "\" must be " + (least > 0 ? "above 0 (0.001 at least)" : "a number from 0") +
                   " and at most 100000");
    }
    return static_cast<Nm>(std::lround(um * base::kNmPerUm));
}

base::Result<double> parseRatio(const ordered_json& json, const std::string& where) {
    const double ratio = json.is_number() ? json.get<double>() : 0.0;
    if (!(ratio >= kLeastRatio && ratio <= kMostRatio)) {
        return bad(where + ": \"most_ratio\" must be a number from 0.1 to 100");
    }
    return ratio;
}

base::Status parseSlot(const ordered_json& json, const std::string& where, Rule& rule) {
    if (rule.kind != RuleKind::Creepage) {
        return bad(where + ": \"least_slot_um\" belongs to a creepage rule");
    }
    ASSIGN_OR_RETURN(rule.leastSlot, parseLength(json, 0, where, "least_slot_um"));
    return base::Done{};
}

/// Everything but the kind.
base::Status parseKey(const std::string& key, const ordered_json& value, const RuleTable& table,
                      const std::string& where, Rule& rule) {
    if (key == "between" || key == "of") {
        return parseNets(value, key, table, where, rule);
    }
    using Parse = base::Status (*)(const ordered_json&, const std::string&, Rule&);
    constexpr std::pair<const char*, Parse> kParsers[] = {{"holes", parseHoles}, {"objects", parseObjects},
                                                          {"layer", parseLayer}, {"same_net", parseSameNet},
                                                          {"on", parseOn},       {"least_slot_um", parseSlot}};
    const auto* const parser = std::ranges::find_if(kParsers, [&](const auto& known) { return key == known.first; });
    return parser == std::end(kParsers) ? base::Status(base::Done{}) : parser->second(value, where, rule);
}

base::Result<RuleKind> parseKind(const ordered_json& json, const std::string& where) {
    const std::optional<RuleKind> kind = ruleKindOf(json.get<std::string>());
    return kind ? base::Result<RuleKind>(*kind) : bad(where + ": there is no kind \"" + json.get<std::string>() + "\"");
}

constexpr std::pair<const char*, RuleLimit> kLimits[] = {{"least_um", RuleLimit::Length},
                                                         {"most_ratio", RuleLimit::Ratio}};

/// The limit that rules of the kind have, and no other one. `where` gives the line of a key.
template <class Where>
base::Status parseLimit(const ordered_json& json, const Where& where, Rule& rule) {
    for (const auto& [key, limit] : kLimits) {
        const bool isNeeded = limitOf(rule.kind) == limit;
        const std::string quoted = '"' + std::string(key) + '"';
        if (isNeeded != json.contains(key)) {
            return bad(where("") + (isNeeded ? " needs a number " + quoted : ": a rule of this kind has no " + quoted));
        }
    }
    if (limitOf(rule.kind) == RuleLimit::Length) {
        ASSIGN_OR_RETURN(rule.least, parseLength(json["least_um"], 1, where("least_um"), "least_um"));
    }
    if (limitOf(rule.kind) == RuleLimit::Ratio) {
        ASSIGN_OR_RETURN(rule.mostRatio, parseRatio(json["most_ratio"], where("most_ratio")));
    }
    return base::Done{};
}

base::Result<Rule> parseRule(const ordered_json& json, const RuleTable& table, const StrictJson& file) {
    constexpr const char* kKeys[] = {"kind",    "least_um", "most_ratio", "between",       "of", "holes",
                                     "objects", "layer",    "same_net",   "least_slot_um", "on"};
    const std::string path = "/rules/" + std::to_string(table.rules.size());
    const auto where = [&](const std::string& key) {
        return file.lineOf(path + '/' + key) + ", rule " + std::to_string(table.rules.size() + 1);
    };
    if (!json.is_object() || !json.contains("kind") || !json["kind"].is_string()) {
        return bad(where("") + " needs a \"kind\"");
    }
    RETURN_IF_ERROR(file.checkKeys(json, path, kKeys));
    Rule rule;
    ASSIGN_OR_RETURN(rule.kind, parseKind(json["kind"], where("kind")));
    RETURN_IF_ERROR(parseLimit(json, where, rule));
    for (const auto& [key, value] : json.items()) {
        RETURN_IF_ERROR(parseKey(key, value, table, where(key), rule));
    }
    return rule;
}

base::Result<Nm> parseTolerance(const StrictJson& file) {
    const ordered_json value = file.json().value("tolerance_um", ordered_json(kTolerance / base::kNmPerUm));
    const double um = value.is_number() ? value.get<double>() : -1.0;
    if (!(um >= 0 && um <= kMostTolerance / base::kNmPerUm)) {
        return bad(file.lineOf("/tolerance_um") + ": \"tolerance_um\" must be a number from 0 to 10");
    }
    return static_cast<Nm>(std::lround(um * base::kNmPerUm));
}

/// One name, or as many as there are sides.
ordered_json listOf(const std::array<std::string, 2>& names, std::size_t sides) {
    return sides == 2 ? ordered_json(names) : ordered_json(names[0]);
}

ordered_json jsonOf(const Rule& rule) {
    ordered_json json{{"kind", nameOf(rule.kind)}};
    if (hasLeast(rule.kind)) {
        json["least_um"] = rule.least / base::kNmPerUm;
    }
    if (limitOf(rule.kind) == RuleLimit::Ratio) {
        json["most_ratio"] = rule.mostRatio;
    }
    if (rule.classes != std::array<std::string, 2>{}) {
        const std::size_t sides = netSidesOf(rule.kind);
        json[sides == 2 ? "between" : "of"] = listOf(rule.classes, sides);
    }
    if (rule.holes != std::array<HoleClass, 2>{}) {
        json["holes"] = listOf({nameOf(rule.holes[0]), nameOf(rule.holes[1])}, holeSidesOf(rule.kind));
    }
    if (rule.objects != std::array<CopperObject, 2>{}) {
        json["objects"] = listOf({nameOf(rule.objects[0]), nameOf(rule.objects[1])}, copperSidesOf(rule.kind));
    }
    if (!rule.layer.empty()) {
        json["layer"] = rule.layer;
    }
    if (rule.isSameNet) {
        json["same_net"] = true;
    }
    if (rule.leastSlot > 0) {
        json["least_slot_um"] = rule.leastSlot / base::kNmPerUm;
    }
    if (!rule.isOn) {
        json["on"] = false;
    }
    return json;
}

}  // namespace

base::Result<RuleTable> parseRules(std::string_view text) {
    ASSIGN_OR_RETURN(const StrictJson file, StrictJson::parse(text, "rules", kVersionKey));
    const ordered_json& json = file.json();
    constexpr const char* kKeys[] = {kVersionKey, "tolerance_um", "classes", "rules"};
    RETURN_IF_ERROR(file.checkKeys(json, "", kKeys));
    const ordered_json classes = json.value("classes", ordered_json::object());
    const ordered_json rules = json.value("rules", ordered_json::array());
    if (!classes.is_object() || !rules.is_array()) {
        return bad("\"classes\" must be an object and \"rules\" a list");
    }
    RuleTable table;
    ASSIGN_OR_RETURN(table.tolerance, parseTolerance(file));
    for (const auto& [name, nets] : classes.items()) {
        ASSIGN_OR_RETURN(NetClass netClass, parseClass(name, nets, file));
        table.classes.push_back(std::move(netClass));
    }
    for (const ordered_json& rule : rules) {
        ASSIGN_OR_RETURN(Rule parsed, parseRule(rule, table, file));
        table.rules.push_back(parsed);
    }
    if (netClassCount(table) > kMostNetClasses) {
        return bad("there are more than " + std::to_string(kMostNetClasses) + " net classes and names of nets");
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
    const auto inOneLine = [](const ordered_json& json) {
        return json.dump(-1, ' ', false, ordered_json::error_handler_t::replace);
    };
    ordered_json classes = ordered_json::object();
    for (const NetClass& netClass : table.classes) {
        classes[netClass.name] = netClass.nets;
    }
    std::string text = "// Design rules for copperscope clearance --rules FILE. Lengths in micrometres.\n{\n";
    text += "  \"" + std::string(kVersionKey) + "\": " + std::to_string(kVersion) + ",\n";
    text += "  // How far a distance may be below its limit and still pass, 0 to 10.\n";
    text += "  \"tolerance_um\": " + inOneLine(table.tolerance / base::kNmPerUm) + ",\n";
    text += "  // Net classes: {\"power\": [\"VCC*\", \"GND\"]}, with * for any text and ? for any letter.\n";
    text += "  \"classes\": " + inOneLine(classes) + ",\n";
    text +=
        "  // Of several rules that fit the last one holds. \"between\": [\"power\", \"\"] names net classes of a\n"
        "  // copper-copper rule (\"\": any net); \"on\": false switches a rule off.\n  \"rules\": [\n";
    for (std::size_t row = 0; row < table.rules.size(); ++row) {
        const Rule& rule = table.rules[row];
        text += std::string("    // ") + meaningOf(rule.kind) + "\n    " + inOneLine(jsonOf(rule)) +
                (row + 1 < table.rules.size() ? ",\n" : "\n");
    }
    return text + "  ]\n}\n";
}

std::string textOf(const LeftOutRule& one) {
    return (one.line > 0 ? "line " + std::to_string(one.line) + ": " : "") + one.text;
}

void leaveOutExcessClasses(RuleFile& file, const std::filesystem::path& from) {
    std::set<std::string> names;
    std::vector<Rule> kept;
    for (Rule& rule : file.table.rules) {
        std::set<std::string> all = names;
        std::ranges::copy_if(rule.classes, std::inserter(all, all.end()),
                             [](const auto& name) { return !name.empty(); });
        if (all.size() > kMostNetClasses) {
            const std::string most = std::to_string(kMostNetClasses) + " net classes and names of nets";
            file.leftOut.push_back({titleOf(rule) + ", beyond the first " + most + ", is left out", 0, from});
        } else {
            names = std::move(all);
            kept.push_back(std::move(rule));
        }
    }
    file.table.rules = std::move(kept);
    std::size_t room = kMostNetClasses - names.size();
    std::erase_if(file.table.classes, [&](const NetClass& one) {
        const bool isKept = names.contains(one.name) || room > 0;
        room -= isKept && !names.contains(one.name) ? 1 : 0;
        return !isKept;
    });
}

namespace {

/// What KiCad's files ask for may all have no counterpart: then nothing would be checked, and the answer would be a
/// pass.
base::Result<RuleFile> usable(RuleFile file) {
    if (!file.table.rules.empty()) {
        return file;
    }
    std::string text = "no minimum in KiCad's files has a counterpart";
    for (std::size_t i = 0; i < std::min(file.leftOut.size(), kMostNamed); ++i) {
        const std::string name = file.leftOut[i].file.filename().string();
        text += "; " + (name.empty() ? "" : name + ", ") + textOf(file.leftOut[i]);
    }
    if (file.leftOut.size() > kMostNamed) {
        text += "; and " + std::to_string(file.leftOut.size() - kMostNamed) + " more";
    }
    return bad(text);
}

}  // namespace

base::Result<RuleFile> readRules(const std::filesystem::path& path) {
    std::error_code unreadable;
    if (const RulePreset* preset = findPreset(path.string());
        preset != nullptr && !std::filesystem::exists(path, unreadable)) {
        ASSIGN_OR_RETURN(RuleTable table, parseRules(preset->text));
        return RuleFile{std::move(table), {}};
    }
    if (path.extension() == ".kicad_pcb") {
        ASSIGN_OR_RETURN(RuleFile file, readKicadRulesOf(path));
        return usable(std::move(file));
    }
    ASSIGN_OR_RETURN(const std::string text, readWholeFile(path, base::kMostSettingBytes));
    if (path.extension() == ".kicad_pro") {
        ASSIGN_OR_RETURN(RuleFile file, parseKicadProjectRules(text));
        return usable(std::move(file));
    }
    if (path.extension() == ".kicad_dru") {
        ASSIGN_OR_RETURN(RuleFile file, parseKicadRules(text));
        return usable(std::move(file));
    }
    ASSIGN_OR_RETURN(RuleTable table, parseRules(text));
    return RuleFile{std::move(table), {}};
}

}  // namespace model
