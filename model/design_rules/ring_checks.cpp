#include "model/design_rules/ring_checks.h"

#include <set>

#include "model/clearance/annular_ring.h"

namespace model {

void RingChecks::check(LayerId layer) {
    if (!m_context.isWanted(RuleKind::AnnularRing, layer)) {
        return;
    }
    const double reach = m_context.choice().reachOf(RuleKind::AnnularRing);
    for (const AnnularRing& found : annularRings(m_context.document(), layer, reach)) {
        const auto rule = m_context.choice().of(RuleKind::AnnularRing, layer, m_context.partyOf(found.hole));
        if (!rule) {
            continue;
        }
        HoleRings& rings = m_rings[found.hole];
        ++rings.layers;
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

Spacing RingChecks::middleOf(ElementId hole) const {
    const PointD middle = base::toDouble(m_context.document().boxOf(hole).middle());
    return {0.0, middle, middle};
}

std::size_t RingChecks::layersOf(ElementId hole) const {
    const Document& document = m_context.document();
    const Layer& drill = document.layer(document.elements.layer[hole.row()]);
    const PlatedSpan plated = document.platedSpanOf(hole);
    std::size_t count = 0;
    for (std::size_t row = 0; row < document.layers.size(); ++row) {
        const LayerId layer{row};
        count += document.layers[row].isCopper() && drill.spans(layer) && plated.joins(layer) ? 1 : 0;
    }
    return count;
}

void RingChecks::lookOnOtherLayers() {
    std::set<ElementId> holes;
    for (const auto& [hole, rings] : m_rings) {
        if (!rings.removed && !rings.hasCopper && rings.layers < layersOf(hole)) {
            holes.insert(hole);
        }
    }
    const Document& document = m_context.document();
    const double reach = m_context.choice().reachOf(RuleKind::AnnularRing);
    for (std::size_t row = 0; row < document.layers.size() && !holes.empty(); ++row) {
        if (!document.layers[row].isCopper() || m_context.progress().isCancelled()) {
            continue;
        }
        for (const AnnularRing& found : annularRings(document, LayerId{row}, reach)) {
            const bool isThere = found.ring.state == RingState::BreaksOut || found.ring.state == RingState::Around;
            if (isThere && holes.erase(found.hole) > 0) {
                m_rings[found.hole].hasCopper = true;
            }
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
