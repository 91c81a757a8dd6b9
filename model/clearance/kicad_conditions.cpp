#include "model/clearance/kicad_conditions.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <optional>
#include <string>
#include <utility>

#include "model/base/ascii.h"
#include "model/text/formatting.h"
#include "model/text/kicad_condition.h"

namespace model {

namespace {

constexpr std::pair<const char*, CopperObject> kTypes[] = {{"track", CopperObject::Track},
                                                           {"via", CopperObject::Via},
                                                           {"pad", CopperObject::Pad},
                                                           {"zone", CopperObject::Plane}};

std::optional<CopperObject> typeOf(const std::string& word) {
    const auto* const type =
        std::ranges::find_if(kTypes, [&](const auto& known) { return base::lowerCase(word) == known.first; });
    return type == std::end(kTypes) ? std::nullopt : std::optional(type->second);
}

/// Holds one alternative against a rule: A is its side `m_sideOfA`.
class Translation {
public:
    Translation(const Rule& rule, std::size_t sideOfA) : m_rule(rule), m_sideOfA(sideOfA) {}

    /// Empty if a term has no counterpart.
    std::vector<Rule> of(const ConditionTerms& terms) {
        for (const bool isOfBoth : {false, true}) {  // "B.Type == A.Type" needs to know of A's
            for (const ConditionTerm& term : terms) {
                if (!term.other.empty() == isOfBoth && !(isOfBoth ? applyPair(term) : apply(term))) {
                    return {};
                }
            }
        }
        for (std::size_t side = 0; side < 2; ++side) {
            if (m_isHoleOfPad[side] && holesOf(side) != HoleClass::NonPlated) {
                return {};  // holes of vias and of pads are not told apart
            }
        }
        return withMicrovias();
    }

private:
    [[nodiscard]] std::size_t sideOf(const ConditionTerm& term) const { return (m_sideOfA + term.side) % 2; }

    bool apply(const ConditionTerm& term) {
        const std::size_t side = sideOf(term);
        if (term.name == "isPlated()") {
            return applyPlated(side, !term.isNegated);
        }
        if (term.isNegated) {
            return false;
        }
        if (term.name == "Type") {
            return applyType(side, term.text);
        }
        if (term.name == "NetClass" || term.name == "hasNetclass()" || term.name == "hasExactNetclass()") {
            return base::lowerCase(term.text) != "default" && applyNets(side, term.text);
        }
        if (term.name == "NetName") {
            return applyNets(side, std::string(kNetPrefix) + term.text);
        }
        if (term.name == "isMicroVia()") {
            return applyHoles(side, HoleClass::Microvia);
        }
        if (term.name == "Pad_Type") {
            return base::lowerCase(term.text) == "npth, mechanical" && applyHoles(side, HoleClass::NonPlated);
        }
        return term.name == "Layer" && applyLayer(term.text);
    }

    bool applyType(std::size_t side, const std::string& word) {
        const std::optional<CopperObject> type = typeOf(word);
        if (!type) {
            return false;
        }
        if (m_rule.kind == RuleKind::TrackWidth) {
            return type == CopperObject::Track;
        }
        if (m_rule.kind == RuleKind::SilkToPad) {
            return type == CopperObject::Pad;
        }
        if (sidesOf(m_rule.kind)[side] == RuleSide::Hole && type == CopperObject::Pad) {
            m_isHoleOfPad[side] = true;
            return true;
        }
        if (sidesOf(m_rule.kind)[side] != RuleSide::Copper || m_rule.objects[side] != CopperObject::Any) {
            return false;
        }
        m_rule.objects[side] = *type;
        return true;
    }

    bool applyNets(std::size_t side, std::string name) {
        const RuleSide kind = sidesOf(m_rule.kind)[side];
        if (kind == RuleSide::None || !m_rule.classes[side].empty() || name.empty()) {
            return false;
        }
        m_rule.classes[side] = std::move(name);
        return true;
    }

    bool applyPlated(std::size_t side, bool isPlated) {
        return applyHoles(side, isPlated ? HoleClass::Plated : HoleClass::NonPlated);
    }

    bool applyHoles(std::size_t side, HoleClass holes) {
        const bool isOther = holesOf(side) != HoleClass::Any && holesOf(side) != holes;
        if (sidesOf(m_rule.kind)[side] != RuleSide::Hole || isOther) {
            return false;
        }
        holesOf(side) = holes;
        return true;
    }

    HoleClass& holesOf(std::size_t side) { return m_rule.holes[holeSidesOf(m_rule.kind) == 2 ? side : 0]; }

    bool applyLayer(const std::string& layer) {
        if (m_rule.kind == RuleKind::SilkToPad && base::lowerCase(layer) == "?.silkscreen") {
            return true;  // it is about nothing else
        }
        if (!hasLayer(m_rule.kind) || layer.empty() || (!m_rule.layer.empty() && m_rule.layer != layer)) {
            return false;
        }
        m_rule.layer = layer;
        return true;
    }

    /// A term that holds a property of one side against the other's.
    bool applyPair(const ConditionTerm& term) {
        if (term.name != term.other) {
            return false;
        }
        if (term.name == "Net" || term.name == "NetName") {
            return applySameNet(!term.isNegated);
        }
        CopperObject& a = m_rule.objects[0];
        CopperObject& b = m_rule.objects[1];
        if (term.name != "Type" || term.isNegated || (a == CopperObject::Any) == (b == CopperObject::Any) ||
            sidesOf(m_rule.kind)[1] != RuleSide::Copper) {
            return false;
        }
        a = b = std::max(a, b);
        return true;
    }

    /// Most kinds are about different nets anyway.
    bool applySameNet(bool isSame) {
        if (m_rule.kind == RuleKind::CopperToCopper) {
            m_rule.isSameNet = isSame;
            return true;
        }
        return !isSame && (m_rule.kind == RuleKind::CopperToHole || m_rule.kind == RuleKind::Creepage);
    }

    /// To KiCad microvias are plated like others, here they are a class of their own.
    [[nodiscard]] std::vector<Rule> withMicrovias() const {
        std::vector<Rule> rules{m_rule};
        for (std::size_t side = 0; side < m_rule.holes.size(); ++side) {
            if (m_rule.holes[side] == HoleClass::Plated) {
                std::vector<Rule> others = rules;
                std::ranges::for_each(others, [&](Rule& other) { other.holes[side] = HoleClass::Microvia; });
                std::ranges::move(others, std::back_inserter(rules));
            }
        }
        return rules;
    }

    Rule m_rule;
    std::size_t m_sideOfA;
    std::array<bool, 2> m_isHoleOfPad{};  ///< by side, as a condition says
};

std::vector<Rule> rulesOf(const Rule& rule, const ConditionTerms& terms) {
    std::vector<Rule> rules = Translation(rule, 0).of(terms);
    const bool hasTwoSides = sidesOf(rule.kind)[1] != RuleSide::None;
    return rules.empty() && hasTwoSides ? Translation(rule, 1).of(terms) : rules;
}

}  // namespace

std::vector<Rule> rulesUnder(const Rule& rule, std::string_view condition) {
    const auto alternatives = parseKicadCondition(condition);
    std::vector<Rule> rules;
    for (const ConditionTerms& terms : alternatives.value_or(std::vector<ConditionTerms>{})) {
        std::vector<Rule> more = rulesOf(rule, terms);
        if (more.empty()) {
            return {};
        }
        std::ranges::move(more, std::back_inserter(rules));
    }
    return rules;
}

}  // namespace model
