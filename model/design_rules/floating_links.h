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
    /// A path between two nets over one piece of floating copper or several.
    struct Path {
        std::uint32_t a = 0;  ///< rows of the copper: where it begins, and where it ends
        std::uint32_t b = 0;
        Spacing spacing;  ///< `distance` without what lies on copper
    };
    /// The length along the face between two figures, nm; infinite if it is longer than any limit.
    using LinkLength = std::function<double(const FigurePair&)>;

    /// Pieces at most `reach` nm apart are linked.
    FloatingLinks(RuleContext& context, const LayerGeometry& copper, double reach);

    /// The shortest paths from each net to every other one within reach, each pair of nets once.
    [[nodiscard]] std::vector<Path> paths(const LinkLength& lengthOf) const;

private:
    /// From one piece of copper to another, `nearest.a` on the first one.
    struct Link {
        std::uint32_t to = 0;  ///< owner
        FigurePair nearest;
    };
    struct Reached {
        double length = 0.0;
        std::uint32_t start = 0;
        PointD from;
    };

    void add(const FigurePair& pair);
    void addPathsFrom(std::uint32_t net, const std::map<std::uint64_t, double>& lengths,
                      std::vector<Path>& paths) const;

    const RuleContext& m_context;
    const LayerGeometry& m_copper;
    double m_reach = 0.0;
    std::map<std::uint32_t, std::vector<Link>> m_links;  ///< by owner
    std::map<std::uint32_t, bool> m_isFloating;          ///< by owner
};

}  // namespace model
