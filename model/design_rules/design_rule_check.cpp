#include "model/design_rules/design_rule_check.h"

#include <algorithm>
#include <array>
#include <tuple>

#include "model/board/layers.h"
#include "model/design_rules/copper_spacings.h"
#include "model/design_rules/creepage.h"
#include "model/design_rules/drill_checks.h"
#include "model/design_rules/floating_copper.h"
#include "model/design_rules/mask_checks.h"
#include "model/design_rules/ring_checks.h"
#include "model/design_rules/rule_context.h"
#include "model/design_rules/track_checks.h"
#include "model/design_rules/unchecked_items.h"

namespace model {

namespace {

/// What cannot be checked, and rules that nothing can meet.
void begin(RuleContext& context) {
    const RuleTable& table = context.table();
    RuleReport& report = context.report();
    const auto whyUnused = [&](std::size_t rule) {
        const RuleKind kind = table.rules[rule].kind;
        return context.choice().whyUnused(rule, holeClassesFor(context.document(), kind, context.holeClasses()));
    };
    report.counts.resize(table.rules.size());
    report.unchecked = uncheckedItems(context.document(), table, context.choice());
    for (std::size_t rule = 0; rule < table.rules.size(); ++rule) {
        const std::string beyond = context.whyBeyond(rule);
        report.unused.push_back(!table.rules[rule].isOn ? "" : !beyond.empty() ? beyond : whyUnused(rule));
    }
    std::erase_if(report.unchecked,
                  [&](const Unchecked& unchecked) { return !context.whyBeyond(unchecked.rule).empty(); });
}

/// What no rule asks for.
void note(RuleContext& context) {
    const Document& document = context.document();
    std::size_t islands = 0;
    std::size_t thin = 0;
    for (const Layer& layer : document.layers) {
        const Range range = layer.isCopper() ? layer.elements : Range{};
        for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
            const ElementId element{i};
            islands += !context.netOf(element).isValid() && !context.isLand(element) ? 1 : 0;
            thin += coversNothing(document, element) ? 1 : 0;
        }
    }
    const auto add = [&](std::size_t count, const char* one, const char* many) {
        if (count > 0) {
            context.report().notes.push_back(std::to_string(count) + (count == 1 ? one : many));
        }
    };
    for (std::string& text : patternsOfNothing(context.table(), context.choice())) {
        context.report().notes.push_back(std::move(text));
    }
    if (std::ranges::any_of(context.table().rules, [](const Rule& rule) { return rule.isOn && rule.isSameNet; })) {
        context.report().notes.push_back("within a net, notches and slits of one area are not measured");
    }
    add(document.nets.empty() ? 0 : islands, " copper element of no net, neither pad nor hole, is held against nets",
        " copper elements of no net, neither pads nor holes, are held against nets, not against each other");
    add(thin, " copper element has no width and leaves no copper",
        " copper elements have no width and leave no copper");
    add(context.awayCount(), " pad lies wholly within an NPTH, which takes it away",
        " pads lie wholly within NPTHs, which take them away");
}

void finish(RuleReport& report) {
    std::ranges::sort(report.findings, {},
                      [](const RuleFinding& f) { return std::tuple(f.rule, f.spacing.distance, f.layer, f.a, f.b); });
    for (const RuleFinding& finding : report.findings) {
        ++report.counts[finding.rule];
    }
    std::ranges::stable_sort(report.unchecked, {}, &Unchecked::rule);
}

class Check {
public:
    explicit Check(RuleContext& context) : m_context(context), m_rings(context) {}

    [[nodiscard]] base::Status run() {
        begin(m_context);
        const std::vector<Layer>& layers = m_context.document().layers;
        const std::vector<bool> isPrint = silkscreenPrints(m_context.document());
        for (std::size_t row = 0; row < layers.size() && !m_context.progress().isCancelled(); ++row) {
            if (m_context.isWanted(LayerId{row})) {
                checkLayer(LayerId{row}, isPrint[row]);
            }
            m_context.progress().setFraction(static_cast<float>(row + 1) / static_cast<float>(layers.size()));
        }
        m_context.progress().beginPhase("Checking holes and floating copper");
        checkHoles(m_context);
        checkDrills(m_context);
        m_rings.finish();
        RETURN_IF_ERROR(checkFloatingCopper(m_context));
        note(m_context);
        constexpr std::array kKinds = {RuleKind::CopperToCopper, RuleKind::CopperToHole, RuleKind::Creepage};
        if (std::ranges::any_of(kKinds, [&](RuleKind kind) { return m_context.choice().reachOf(kind) > 0; })) {
            m_context.report().netTies = m_context.nets().ties.ties();
        }
        finish(m_context.report());
        return base::Done{};
    }

private:
    void checkLayer(LayerId layer, bool isPrint) {
        const Layer& facts = m_context.document().layer(layer);
        if (facts.isCopper()) {
            checkCopper(layer);
        } else if (isMask(facts)) {
            checkSlivers(m_context, layer);
            checkMaskToCopper(m_context, layer);
            checkMaskToForeign(m_context, layer);
        } else if (isPrint && facts.type == LayerType::SilkScreen) {
            checkSilkscreen(m_context, layer);
        }
    }

    void checkCopper(LayerId layer) {
        const LayerGeometry copper = copperGeometry(m_context.document(), layer, m_context.isThere());
        checkNetSpacings(m_context, layer, copper);
        checkOwnNet(m_context, layer, copper);
        checkToHoles(m_context, layer);
        checkToEdge(m_context, layer, copper);
        m_rings.check(layer);
        checkTrackWidths(m_context, layer);
        checkAcuteAngles(m_context, layer, copper);
        checkCreepage(m_context, layer, copper);
    }

    RuleContext& m_context;
    RingChecks m_rings;
};

}  // namespace

bool isRuled(const Layer& layer) {
    return layer.isCopper() || isMask(layer) || (layer.type == LayerType::SilkScreen && !layer.isSynthetic);
}

base::Result<RuleReport> checkRules(const Document& document, const RuleTable& table, base::Progress& progress,
                                    const RuleScope& scope) {
    ASSIGN_OR_RETURN(const CopperNets nets, CopperNets::of(document, progress));
    progress.beginPhase("Checking rules");
    RuleContext context(document, table, scope, nets, progress);
    RETURN_IF_ERROR(Check(context).run());
    if (progress.isCancelled()) {
        return base::Error{base::ErrorCode::Cancelled, "cancelled"};
    }
    return std::move(context.report());
}

}  // namespace model
