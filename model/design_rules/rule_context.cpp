#include "model/design_rules/rule_context.h"

#include <algorithm>

#include "model/clearance/copper_objects.h"
#include "model/design_rules/drilled_away.h"
#include "model/design_rules/text_strokes.h"

namespace model {

namespace {

RulePlane planeOf(const Layer& layer) {
    return layer.isCopper() ? RulePlane::Copper : isMask(layer) ? RulePlane::SolderMask : RulePlane::Silkscreen;
}

bool namesObjects(const Rule& rule) {
    return rule.objects != std::array<CopperObject, 2>{};
}

bool isBetweenNets(RuleKind kind) {
    return kind == RuleKind::CopperToCopper || kind == RuleKind::CopperToHole || kind == RuleKind::HoleToHole ||
           kind == RuleKind::Creepage;
}

}  // namespace

RuleContext::RuleContext(const Document& document, const RuleTable& table, const RuleScope& scope,
                         const CopperNets& nets, base::Progress& progress)
    : m_document(document),
      m_table(table),
      m_scope(scope),
      m_nets(nets),
      m_choice(document, table),
      m_isAway(drilledAway(document)),
      m_holes(holeClassesOf(document)),
      m_objects(copperObjectsOf(document)),
      m_progress(progress) {}

std::string RuleContext::whyBeyond(RuleKind kind) const {
    if (!isOfAllNets() && !isBetweenNets(kind)) {
        return "it is not between two nets";
    }
    if (m_scope.layer.isValid() && planeOf(m_document.layer(m_scope.layer)) != planeOf(kind)) {
        constexpr const char* kWhat[] = {" is no copper layer", " is no solder mask", " is no silkscreen"};
        return "layer " + m_document.layer(m_scope.layer).name + kWhat[static_cast<std::size_t>(planeOf(kind))];
    }
    return {};
}

std::string RuleContext::whyBeyond(std::size_t rule) const {
    const std::string why = whyBeyond(m_table.rules[rule].kind);
    return !why.empty() ? why : m_choice.whyWithoutLayer(m_document, rule, m_scope.layer);
}

bool RuleContext::isWanted(RuleKind kind, LayerId layer) const {
    return m_choice.isOn(kind, layer) && whyBeyond(kind).empty();
}

std::vector<RuleSearch> RuleContext::searchesOf(RuleKind kind) const {
    std::vector<RuleSearch> searches{std::nullopt};
    for (const std::size_t row : m_choice.rowsOf(kind)) {
        if (namesObjects(m_table.rules[row]) && !m_table.rules[row].isSameNet) {
            searches.emplace_back(row);
        }
    }
    return searches;
}

std::optional<std::size_t> RuleContext::ruleOf(RuleSearch search, RuleKind kind, LayerId layer, const RuleParty& a,
                                               const RuleParty& b) const {
    const std::optional<std::size_t> rule = m_choice.of(kind, layer, a, b);
    const bool isOfSearch = rule && (namesObjects(m_table.rules[*rule]) ? rule == search : !search);
    return isOfSearch ? rule : std::nullopt;
}

const std::vector<bool>& RuleContext::textStrokes() {
    if (m_textStrokes.empty()) {
        m_textStrokes = textStrokesOf(m_document);
    }
    return m_textStrokes;
}

bool RuleContext::isBetween(ElementId a, ElementId b) const {
    const std::pair nets(netOf(a), netOf(b));
    return isOfAllNets() || nets == m_scope.between || std::pair(nets.second, nets.first) == m_scope.between;
}

std::size_t RuleContext::awayCount() const {
    return static_cast<std::size_t>(std::ranges::count(m_isAway, true));
}

void RuleContext::add(std::size_t rule, LayerId layer, ElementId a, ElementId b, const Spacing& spacing,
                      FindingReason reason) {
    addIfBroken({rule, layer, a, b, spacing, reason});
}

void RuleContext::addIfBroken(const RuleFinding& finding) {
    if (isBroken(m_table.rules[finding.rule], m_table.tolerance, finding.spacing.distance)) {
        add(finding);
    }
}

}  // namespace model
