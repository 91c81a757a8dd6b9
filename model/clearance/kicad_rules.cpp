#include "model/clearance/kicad_rules.h"

#include <algorithm>
#include <iterator>
#include <string>
#include <vector>

#include "model/base/thickness_units.h"
#include "model/clearance/kicad_conditions.h"
#include "model/text/formatting.h"
#include "model/text/s_expression.h"
#include "model/text/utf8.h"

namespace model {

namespace {

struct Constraint {
    const char* word;
    RuleKind kind;
};
constexpr Constraint kConstraints[] = {{"clearance", RuleKind::CopperToCopper},
                                       {"edge_clearance", RuleKind::CopperToEdge},
                                       {"hole_clearance", RuleKind::CopperToHole},
                                       {"hole_to_hole", RuleKind::HoleToHole},
                                       {"hole_size", RuleKind::HoleSize},
                                       {"annular_width", RuleKind::AnnularRing},
                                       {"track_width", RuleKind::TrackWidth},
                                       {"silk_clearance", RuleKind::SilkToPad},
                                       {"creepage", RuleKind::Creepage}};

/// The size of a hole is to KiCad the width of a slot, too; microvias are round.
std::vector<Rule> withSlots(std::vector<Rule> rules) {
    for (Rule rule : std::vector(rules)) {
        if (rule.kind == RuleKind::HoleSize && rule.holes[0] != HoleClass::Microvia) {
            rule.kind = RuleKind::SlotWidth;
            rules.push_back(std::move(rule));
        }
    }
    return rules;
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
        leaveOutExcessClasses(m_file);
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
        if (!rule.layer.empty() && !hasLayer(rule.kind)) {
            return leaveOut(*layer, name + "layer " + rule.layer);
        }
        std::vector<Rule> rules = condition == nullptr ? std::vector{rule} : rulesUnder(rule, condition->at(1));
        if (rules.empty()) {
            return leaveOut(*condition, name + "condition " + condition->at(1));
        }
        const bool isText = isUtf8(rule.layer) && (condition == nullptr || isUtf8(condition->at(1)));
        if (!isText) {  // rules are saved as JSON, which knows no other text
            return leaveOut(constraint, name + constraint.at(1) + " with names that are no UTF-8");
        }
        std::ranges::for_each(rules, [this](const Rule& one) { addClasses(one); });
        std::ranges::move(withSlots(std::move(rules)), std::back_inserter(m_file.table.rules));
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

std::optional<LeftOutRule> clearancesOfItems(std::string_view board, Nm least) {
    constexpr std::string_view kWord = "(clearance ";
    constexpr std::size_t kMostDigits = 32;
    std::vector<std::size_t> places;
    Nm largest = 0;
    const std::size_t begin = std::min({board.find("(footprint"), board.find("(module"), board.find("(zone")});
    for (std::size_t at = board.find(kWord, begin); at != std::string_view::npos; at = board.find(kWord, at + 1)) {
        const std::string_view behind = board.substr(at + kWord.size(), kMostDigits);
        const auto length = parseLength(std::string(behind.substr(0, behind.find(')'))) + "mm");
        if (length && *length > least) {
            places.push_back(at);
            largest = std::max(largest, *length);
        }
    }
    if (places.empty()) {
        return {};
    }
    const auto line = std::ranges::count(board.substr(0, places.front()), '\n') + 1;
    return LeftOutRule{"what zones, pads and footprints ask for themselves (" + std::to_string(places.size()) +
                           (places.size() == 1 ? " clearance" : " clearances") + ", up to " + lengthText(largest) +
                           ") is left out",
                       static_cast<std::uint32_t>(line)};
}

}  // namespace model
