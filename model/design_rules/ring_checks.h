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
        std::size_t rule = 0;    ///< of the first layer
        std::size_t layers = 0;  ///< with a rule for it
        LayerId first;           ///< the first one of these
    };

    /// Looks for copper of holes that have none where rules hold for them.
    void lookOnOtherLayers();
    [[nodiscard]] Spacing middleOf(ElementId hole) const;
    /// How many copper layers the plating of a hole joins.
    [[nodiscard]] std::size_t layersOf(ElementId hole) const;

    RuleContext& m_context;
    std::map<ElementId, HoleRings> m_rings;
};

}  // namespace model
