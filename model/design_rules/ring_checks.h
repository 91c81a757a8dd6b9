#pragma once

#include <map>
#include <optional>

#include "model/design_rules/rule_context.h"

namespace model {

/// RuleKind::AnnularRing: layer by layer, and what can be said of a hole only once all were seen.
class RingChecks {
public:
    explicit RingChecks(RuleContext& context) : m_context(context) {}

    void check(LayerId layer);
    /// Holes whose pad the drill takes, and those without a pad on any copper layer that they join, with a rule or
    /// without: once per hole, whatever the number of layers. The latter only where no single layer is checked.
    void finish();

private:
    /// What is known of a hole's rings over all layers so far.
    struct HoleRings {
        std::optional<RuleFinding> removed;  ///< on the first layer where the drill takes the pad
        bool hasCopper = false;
        std::size_t rule = 0;  ///< of the first layer with a rule for it
        LayerId first;         ///< that layer
    };

    [[nodiscard]] std::optional<std::size_t> ruleOf(ElementId hole, LayerId layer) const;
    [[nodiscard]] Spacing middleOf(ElementId hole) const;
    /// Looks for copper of holes that have none where rules hold for them.
    void lookOnOtherLayers();
    /// Is it a copper layer that the plating of the hole joins, without a rule for it?
    [[nodiscard]] bool isUnseen(ElementId hole, LayerId layer) const;

    RuleContext& m_context;
    std::map<ElementId, HoleRings> m_rings;
};

}  // namespace model
