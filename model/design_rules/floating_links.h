#pragma once

#include <functional>
#include <map>
#include <vector>

#include "model/design_rules/rule_context.h"

namespace model {

/// Copper without a net on a face, over which a current creeps without any distance: between two nets only what is left
/// on either side of it counts (IEC 60664-1, floating conductive parts).
class FloatingLinks {
public:
    /// A way between two nets over one piece of floating copper or several.
    struct Way {
        std::uint32_t a = 0;  ///< rows of the copper: where it begins, and where it ends
        std::uint32_t b = 0;
        Spacing spacing;  ///< `distance` without what lies on copper
    };
    /// The length along the face of the gap between two figures, nm; infinite if it is longer than any limit.
    using GapLength = std::function<double(const FigurePair&)>;

    /// Gaps of `reach` nm at most.
    FloatingLinks(RuleContext& context, const LayerGeometry& copper, double reach);

    /// The shortest ways from each net to every other one within reach, each pair of nets once.
    [[nodiscard]] std::vector<Way> ways(const GapLength& lengthOf) const;

private:
    /// From one piece of copper to another, `gap.a` on the first one.
    struct Link {
        std::uint32_t to = 0;  ///< owner
        FigurePair gap;
    };
    struct Reached {
        double length = 0.0;
        std::uint32_t start = 0;
        PointD from;
    };

    void add(const FigurePair& pair);
    void addWaysFrom(std::uint32_t net, const std::map<std::uint64_t, double>& lengths, std::vector<Way>& ways) const;

    const RuleContext& m_context;
    const LayerGeometry& m_copper;
    double m_reach = 0.0;
    std::map<std::uint32_t, std::vector<Link>> m_links;  ///< by owner
    std::map<std::uint32_t, bool> m_isFloating;          ///< by owner
};

}  // namespace model
