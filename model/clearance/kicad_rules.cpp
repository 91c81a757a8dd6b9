#include "model/clearance/kicad_rules.h"

#include <algorithm>
#include <optional>
#include <regex>

#include "model/base/thickness_units.h"
#include "model/text/formatting.h"
#include "model/text/s_expression.h"

namespace model {

namespace {

struct Constraint {
    const char* word;
    RuleKind kind;
};
constexpr Constraint kConstraints[] = {
    {"clearance", RuleKind::CopperToCopper},    {"edge_clearance", RuleKind::CopperToEdge},
    {"hole_clearance", RuleKind::CopperToHole}, {"hole_to_hole", RuleKind::HoleToHole},
    {"annular_width", RuleKind::AnnularRing},   {"track_width", RuleKind::TrackWidth},
    {"silk_clearance", RuleKind::SilkToPad},    {"creepage", RuleKind::Creepage}};

constexpr std::pair<const char*, CopperObject> kTypes[] = {{"track", CopperObject::Track},
                                                           {"via", CopperObject::Via},
                                                           {"pad", CopperObject::Pad},
                                                           {"zone", CopperObject::Plane}};

/// One term of a condition; false if it has no counterpart.
bool applyTerm(const std::string& term, Rule& rule) {
    static const std::regex kTerm(R"(^\s*([AB])\.(NetClass|NetName|Type)\s*==\s*'([^']*)'\s*$)");
    std::smatch match;
    if (!std::regex_match(term, match, kTerm)) {
        return false;
    }
    const std::size_t side = match[1] == "A" ? 0 : 1;
    const RuleSide kind = sidesOf(rule.kind)[side];
    if (match[2] == "Type") {
        const auto* const type =
            std::ranges::find_if(kTypes, [&](const auto& known) { return lowered(match[3].str()) == known.first; });
        const bool isKnown = type != std::end(kTypes) && kind == RuleSide::Copper;
        rule.objects[side] = isKnown ? type->second : CopperObject::Any;
        return isKnown || (rule.kind == RuleKind::TrackWidth && lowered(match[3].str()) == "track");
    }
    if (kind == RuleSide::None || !rule.classes[side].empty()) {
        return false;
    }
    rule.classes[side] = (match[2] == "NetName" ? std::string(kNetPrefix) : "") + match[3].str();
    return true;
}

bool applyCondition(const std::string& condition, Rule& rule) {
    static const std::regex kAnd("&&");
    return std::all_of(std::sregex_token_iterator(condition.begin(), condition.end(), kAnd, -1), {},
                       [&](const auto& term) { return applyTerm(term.str(), rule); });
}

class Importer {
public:
    RuleFile run(const SExpression& all) {
        for (const SExpression& item : all.items) {
            if (item.head() == "rule") {
                addRule(item);
            } else if (item.head() != "version") {
                leaveOut(item, item.isList ? '(' + item.head() + ')' : item.atom);
            }
        }
        m_file.isOfKicad = true;
        return std::move(m_file);
    }

private:
    void leaveOut(const SExpression& at, const std::string& what) {
        m_file.leftOut.push_back({what + " is left out", static_cast<std::uint32_t>(at.line)});
    }

    void addRule(const SExpression& rule) {
        const SExpression* condition = rule.find("condition");
        const SExpression* layer = rule.find("layer");
        const SExpression* severity = rule.find("severity");
        const bool isIgnored = severity != nullptr && severity->at(1) == "ignore";
        if (isIgnored) {
            m_file.unused.push_back("line " + std::to_string(rule.line) + ": rule " + rule.at(1) +
                                    " has severity ignore, so it is off; KiCad checks nothing of what it fits, "
                                    "here the other rules do");
        }
        for (const SExpression& item : rule.items) {
            if (item.head() == "constraint") {
                addConstraint(rule, item, condition, layer, isIgnored);
            }
        }
    }

    void addConstraint(const SExpression& from, const SExpression& constraint, const SExpression* condition,
                       const SExpression* layer, bool isIgnored) {
        const std::string name = "rule " + from.at(1) + ", ";
        const auto* const known =
            std::ranges::find_if(kConstraints, [&](const Constraint& c) { return constraint.at(1) == c.word; });
        const SExpression* min = constraint.find("min");
        const auto least = min == nullptr ? base::Result<base::Nm>(base::Error{}) : parseLength(min->at(1));
        if (known == std::end(kConstraints) || !least || *least < 1 || *least > kMostLeast) {
            return leaveOut(constraint, name + constraint.at(1) + (min == nullptr ? " without min" : ' ' + min->at(1)));
        }
        Rule rule{known->kind, *least, {}, !isIgnored};
        rule.layer = layer == nullptr ? "" : layer->at(1);
        if ((!rule.layer.empty() && !hasLayer(rule.kind)) ||
            (condition != nullptr && !applyCondition(condition->at(1), rule))) {
            const bool isOfLayer = condition == nullptr;
            return leaveOut(isOfLayer ? *layer : *condition,
                            name + (isOfLayer ? "layer " + rule.layer : "condition " + condition->at(1)));
        }
        addClasses(rule);
        m_file.table.rules.push_back(std::move(rule));
    }

    void addClasses(const Rule& rule) {
        for (const std::string& name : rule.classes) {
            const bool isClass = !name.empty() && !name.starts_with(kNetPrefix);
            if (isClass && std::ranges::count(m_file.table.classes, name, &NetClass::name) == 0) {
                m_file.table.classes.push_back({name, {}});
            }
        }
    }

    RuleFile m_file;
};

}  // namespace

base::Result<RuleFile> parseKicadRules(std::string_view text) {
    ASSIGN_OR_RETURN(const SExpression all, parseSExpressions(text));
    return Importer().run(all);
}

}  // namespace model
