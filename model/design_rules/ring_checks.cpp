#include "model/design_rules/ring_checks.h"

#include <algorithm>
#include <iterator>
#include <vector>

#include "model/clearance/annular_ring.h"

namespace model {

void RingChecks::check(LayerId layer) {
    if (!m_context.isWanted(RuleKind::AnnularRing, layer)) {
        return;
    }
    const double reach = m_context.choice().reachOf(RuleKind::AnnularRing);
    for (const AnnularRing& found : annularRings(m_context.document(), layer, reach)) {
        const auto rule = ruleOf(found.hole, layer);
        if (!rule) {
            continue;
        }
        HoleRings& rings = m_rings[found.hole];
        rings.rule = rings.first.isValid() ? rings.rule : *rule;
        rings.first = rings.first.isValid() ? rings.first : layer;
        rings.hasCopper = rings.hasCopper || found.ring.state != RingState::Apart;
        if (found.ring.state == RingState::Removed && !rings.removed) {
            rings.removed =
                RuleFinding{*rule, layer, found.hole, found.pad, middleOf(found.hole), FindingReason::PadRemoved};
        } else if (found.ring.state == RingState::BreaksOut || found.ring.state == RingState::Around) {
            RuleFinding finding{*rule, layer, found.hole, found.pad, found.ring.width};
            finding.isWithoutPad = !found.isOfPads;
            m_context.addIfBroken(finding);
        }
    }
}

std::optional<std::size_t> RingChecks::ruleOf(ElementId hole, LayerId layer) const {
    return m_context.choice().of(RuleKind::AnnularRing, layer, m_context.partyOf(hole));
}

Spacing RingChecks::middleOf(ElementId hole) const {
    const PointD middle = base::toDouble(m_context.document().boxOf(hole).middle());
    return {0.0, middle, middle};
}

bool RingChecks::isUnseen(ElementId hole, LayerId layer) const {
    const Document& document = m_context.document();
    const bool isJoined = document.layer(layer).isCopper() &&
                          document.layer(document.elements.layer[hole.row()]).spans(layer) &&
                          document.platedSpanOf(hole).joins(layer);
    return isJoined && !ruleOf(hole, layer);
}

void RingChecks::lookOnOtherLayers() {
    std::vector<ElementId> holes;
    for (const auto& [hole, rings] : m_rings) {
        if (!rings.removed && !rings.hasCopper) {
            holes.push_back(hole);
        }
    }
    const Document& document = m_context.document();
    const double reach = m_context.choice().reachOf(RuleKind::AnnularRing);
    for (std::size_t row = 0; row < document.layers.size() && !m_context.progress().isCancelled(); ++row) {
        const LayerId layer{row};
        std::vector<ElementId> unseen;
        std::ranges::copy_if(holes, std::back_inserter(unseen),
                             [&](ElementId hole) { return isUnseen(hole, layer) && !m_rings.at(hole).hasCopper; });
        if (unseen.empty()) {
            continue;
        }
        for (const AnnularRing& found : annularRings(document, layer, unseen, reach)) {
            m_rings[found.hole].hasCopper =
                found.ring.state == RingState::BreaksOut || found.ring.state == RingState::Around;
        }
    }
}

void RingChecks::finish() {
    const bool isWhole = !m_context.scopeLayer().isValid();
    if (isWhole) {
        lookOnOtherLayers();
    }
    for (const auto& [hole, rings] : m_rings) {
        if (rings.removed) {
            m_context.add(*rings.removed);
        } else if (!rings.hasCopper && isWhole) {
            m_context.add({rings.rule, rings.first, hole, {}, middleOf(hole), FindingReason::NoPad});
        }
    }
}

}  // namespace model
