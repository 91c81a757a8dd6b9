#include "model/design_rules/copper_spacings.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>

#include "model/design_rules/bridged.h"

namespace model {

namespace {

constexpr Nm kConcentric = 1000;  ///< holes this near to each other's middle are one hole, drilled twice

bool areConcentric(const Box& a, const Box& b) {
    const auto twice = [](const Box& box) {
        return base::PointD{double{1} * box.min.x + box.max.x, double{1} * box.min.y + box.max.y};
    };
    return std::hypot(twice(a).x - twice(b).x, twice(a).y - twice(b).y) <= 2 * kConcentric;
}

std::optional<std::size_t> ruleOf(const RuleContext& context, RuleKind kind, LayerId layer, ElementId a, ElementId b) {
    return context.choice().of(kind, layer, context.partyOf(a), context.partyOf(b));
}

/// Do two elements belong to different copper that has to keep a clearance?
bool areForeign(const RuleContext& context, ElementId a, ElementId b) {
    const bool hasNet = context.netOf(a).isValid() || context.netOf(b).isValid();
    return context.owners().of(a) != context.owners().of(b) && (hasNet || context.isLand(a) || context.isLand(b));
}

/// Two holes, not one that is drilled twice, and both pass some layer.
bool areApart(const Document& document, const LayerGeometry& holes, std::uint32_t a, std::uint32_t b) {
    const Layer& layerA = document.layer(document.elements.layer[holes.elementOf(a).row()]);
    const Layer& layerB = document.layer(document.elements.layer[holes.elementOf(b).row()]);
    const bool isStacked = layerA.spanTop.isValid() && layerB.spanTop.isValid() &&
                           (layerA.spanBottom < layerB.spanTop || layerB.spanBottom < layerA.spanTop);
    return holes.elementOf(a) != holes.elementOf(b) && !isStacked &&
           !areConcentric(holes.figures().box(a), holes.figures().box(b));
}

LayerGeometry allHoles(const Document& document) {
    FigureTable figures;
    for (const Layer& layer : document.layers) {
        for (std::uint32_t i = layer.elements.first; i < layer.elements.first + layer.elements.count; ++i) {
            if ((document.elements.flags[i] & kHole) != 0) {
                figures.add(document, ElementId{i});
            }
        }
    }
    return LayerGeometry(std::move(figures));
}

/// The wall of a hole in a pad of its own, which comes nearer to everything.
bool isInPad(const RuleContext& context, const LayerGeometry& copper, std::uint32_t row) {
    const auto isHoleAt = [&](std::uint32_t at) {
        return (context.document().elements.flags[copper.elementOf(at).row()] & kHole) != 0;
    };
    const std::uint32_t owner = context.owners().of(copper.elementOf(row));
    const auto isPad = [&](std::uint32_t other) {
        return !isHoleAt(other) && context.isLand(copper.elementOf(other)) &&
               context.owners().of(copper.elementOf(other)) == owner;
    };
    return isHoleAt(row) && isCovered(copper, base::toDouble(copper.figures().box(row).middle()), isPad);
}

using NetPairs = std::set<std::uint64_t>;
constexpr std::uint64_t kOfElements = std::uint64_t{1} << 63U;  ///< tells pairs of elements from those of nets

/// Two rows, of which none has its highest bit set, as one number.
std::uint64_t bothOf(std::uint32_t a, std::uint32_t b) {
    const auto [low, high] = std::minmax(a, b);
    return std::uint64_t{low} << 32U | high;
}

/// The locations between nets on a layer.
class NetSpacings {
public:
    NetSpacings(RuleContext& context, LayerId layer, const LayerGeometry& copper)
        : m_context(context), m_layer(layer), m_copper(copper) {}

    void check() {
        std::vector<FigurePair> pairs = closestPairs(m_copper, m_copper, request(), m_context.progress());
        if (addAccepted(pairs)) {
            pairs = closestPairs(m_copper, m_copper, request(), m_context.progress());
        }
        NetPairs seen;  // with a location that nobody accepts
        for (const FigurePair& pair : pairs) {
            const RuleFinding found = findingOf(pair);
            if (!isApart(pair.a, pair.b) || m_context.scope().isAccepted(found) ||
                seen.insert(netsOf(pair.a, pair.b)).second) {
                m_context.add(found.rule, m_layer, found.a, found.b, found.spacing);
            }
        }
    }

private:
    [[nodiscard]] std::optional<std::size_t> rule(std::uint32_t a, std::uint32_t b) const {
        return ruleOf(m_context, RuleKind::CopperToCopper, m_layer, m_copper.elementOf(a), m_copper.elementOf(b));
    }

    [[nodiscard]] PairRequest request() const {
        PairRequest request;
        request.reach = m_context.choice().reachOf(RuleKind::CopperToCopper);
        request.isWanted = [this](std::uint32_t a, std::uint32_t b) {
            return areForeign(m_context, m_copper.elementOf(a), m_copper.elementOf(b)) &&
                   m_context.isBetween(m_copper.elementOf(a), m_copper.elementOf(b)) && rule(a, b) &&
                   !m_context.nets().areTied(m_copper.elementOf(a), m_copper.elementOf(b));
        };
        request.groupOf = [this](std::uint32_t a, std::uint32_t b) {
            return isApart(a, b) ? kOfElements | bothOf(m_copper.elementOf(a).value, m_copper.elementOf(b).value)
                                 : netsOf(a, b);
        };
        return request;
    }

    /// The one of the lower net first, as in searches for clearances.
    [[nodiscard]] RuleFinding findingOf(const FigurePair& pair) const {
        const ElementId a = m_copper.elementOf(pair.a);
        const ElementId b = m_copper.elementOf(pair.b);
        const Spacing& s = pair.spacing;
        return m_context.owners().of(b) < m_context.owners().of(a)
                   ? RuleFinding{*rule(pair.a, pair.b), m_layer, b, a, {s.distance, s.to, s.from}}
                   : RuleFinding{*rule(pair.a, pair.b), m_layer, a, b, s};
    }

    [[nodiscard]] std::uint64_t netsOf(std::uint32_t a, std::uint32_t b) const {
        return bothOf(m_context.owners().of(m_copper.elementOf(a)), m_context.owners().of(m_copper.elementOf(b)));
    }

    /// Nets whose closest location is accepted; false if there are none.
    bool addAccepted(const std::vector<FigurePair>& pairs) {
        const std::size_t before = m_apart.size();
        for (const FigurePair& pair : pairs) {
            if (m_context.scope().isAccepted && m_context.scope().isAccepted(findingOf(pair))) {
                m_apart.insert(netsOf(pair.a, pair.b));
            }
        }
        return m_apart.size() > before;
    }

    /// Is there a location for each pair of elements of these two nets?
    [[nodiscard]] bool isApart(std::uint32_t a, std::uint32_t b) const {
        const RuleScope& scope = m_context.scope();
        return m_apart.contains(netsOf(a, b)) ||
               (scope.mayBeAccepted &&
                scope.mayBeAccepted(m_context.netOf(m_copper.elementOf(a)), m_context.netOf(m_copper.elementOf(b))));
    }

    RuleContext& m_context;
    LayerId m_layer;
    const LayerGeometry& m_copper;
    NetPairs m_apart;  ///< nets with a location for each two elements
};

/// The same copper, where each edge of a trail is a figure of its own.
LayerGeometry edgewise(const Document& document, const LayerGeometry& copper) {
    FigureTable figures;
    for (std::size_t row = 0; row < copper.size(); ++row) {
        if (row == 0 || copper.elementOf(row) != copper.elementOf(row - 1)) {
            figures.addEdgewise(document, copper.elementOf(row));
        }
    }
    return LayerGeometry(std::move(figures));
}

}  // namespace

void checkNetSpacings(RuleContext& context, LayerId layer, const LayerGeometry& copper) {
    const bool isThere = context.choice().reachOf(RuleKind::CopperToCopper) > 0 && !context.document().nets.empty();
    if (isThere && context.isWanted(RuleKind::CopperToCopper, layer)) {
        NetSpacings(context, layer, copper).check();
    }
}

void checkOwnNet(RuleContext& context, LayerId layer, const LayerGeometry& copper) {
    const auto isWithin = [](const Rule& rule) { return rule.isOn && rule.isSameNet; };
    if (!context.isWanted(RuleKind::CopperToCopper, layer) || !context.isOfAllNets() ||
        std::ranges::none_of(context.table().rules, isWithin)) {
        return;
    }
    // Tracks that lead on are one element or several, as the job has them in order or not: that must not matter.
    const LayerGeometry edges = edgewise(context.document(), copper);
    const auto rule = [&](std::uint32_t a, std::uint32_t b) {
        return ruleOf(context, RuleKind::CopperToCopper, layer, edges.elementOf(a), edges.elementOf(b));
    };
    PairRequest request;
    request.reach = context.choice().reachOf(RuleKind::CopperToCopper);
    request.isWanted = [&](std::uint32_t a, std::uint32_t b) {
        const NetId net = context.netOf(edges.elementOf(a));
        return net.isValid() && net == context.netOf(edges.elementOf(b)) && rule(a, b);
    };
    request.mayTouch = [](std::uint32_t, std::uint32_t) { return false; };  // they are one piece
    request.groupOf = [](std::uint32_t a, std::uint32_t b) { return bothOf(a, b); };
    std::set<std::uint64_t> seen;  // pairs of elements
    for (const FigurePair& pair : closestPairs(edges, edges, request, context.progress())) {
        const ElementId a = edges.elementOf(pair.a);
        const ElementId b = edges.elementOf(pair.b);
        const auto isOwn = [&](std::uint32_t row) {
            return context.netOf(copper.elementOf(row)) == context.netOf(a);
        };
        if (!isBridged(copper, pair.spacing, isOwn) && seen.insert(bothOf(a.value, b.value)).second) {
            context.add(*rule(pair.a, pair.b), layer, a, b, pair.spacing);
        }
    }
}

void checkToHoles(RuleContext& context, LayerId layer) {
    PairRequest request;
    request.reach = context.choice().reachOf(RuleKind::CopperToHole);
    if (request.reach <= 0 || !context.isWanted(RuleKind::CopperToHole, layer)) {
        return;
    }
    const LayerGeometry copper = layerGeometry(context.document(), layer, context.isThere());
    const LayerGeometry holes = holeGeometry(context.document(), layer);
    const auto rule = [&](std::uint32_t a, std::uint32_t b) {
        return ruleOf(context, RuleKind::CopperToHole, layer, copper.elementOf(a), holes.elementOf(b));
    };
    request.isWanted = [&](std::uint32_t a, std::uint32_t b) {
        const ElementId hole = holes.elementOf(b);
        const bool isPlated = isPlatedHole(context.document().elements.flags[hole.row()]);
        return rule(a, b) && context.isBetween(copper.elementOf(a), hole) &&
               (!isPlated || context.owners().of(copper.elementOf(a)) != context.owners().of(hole));
    };
    for (const FigurePair& pair : closestPairs(copper, holes, request, context.progress())) {
        context.add(*rule(pair.a, pair.b), layer, copper.elementOf(pair.a), holes.elementOf(pair.b), pair.spacing);
    }
}

void checkToEdge(RuleContext& context, LayerId layer, const LayerGeometry& copper) {
    if (!context.document().profile.isValid() || !context.isWanted(RuleKind::CopperToEdge, layer)) {
        return;
    }
    const LayerGeometry edge = edgeGeometry(context.document());
    const auto rule = [&](std::uint32_t a) {
        return context.choice().of(RuleKind::CopperToEdge, layer, context.partyOf(copper.elementOf(a)));
    };
    PairRequest request;
    request.reach = context.choice().reachOf(RuleKind::CopperToEdge);
    request.isWanted = [&](std::uint32_t a, std::uint32_t) {
        return rule(a).has_value() && !isInPad(context, copper, a);
    };
    for (const FigurePair& pair : closestPairs(copper, edge, request, context.progress())) {
        context.add(*rule(pair.a), layer, copper.elementOf(pair.a), edge.elementOf(pair.b), pair.spacing);
    }
}

void checkHoles(RuleContext& context) {
    const Document& document = context.document();
    PairRequest request;
    request.reach = context.choice().reachOf(RuleKind::HoleToHole);
    if (request.reach <= 0 || !context.whyBeyond(RuleKind::HoleToHole).empty()) {
        return;
    }
    const LayerGeometry holes = allHoles(document);
    const auto isOnLayer = [&](ElementId hole) {
        const LayerId layer = context.scopeLayer();
        return !layer.isValid() || document.layer(document.elements.layer[hole.row()]).spans(layer);
    };
    const auto rule = [&](ElementId a, ElementId b) { return ruleOf(context, RuleKind::HoleToHole, {}, a, b); };
    request.isWanted = [&](std::uint32_t rowA, std::uint32_t rowB) {
        const ElementId a = holes.elementOf(rowA);
        const ElementId b = holes.elementOf(rowB);
        return areApart(document, holes, rowA, rowB) && context.isBetween(a, b) && isOnLayer(a) && isOnLayer(b) &&
               rule(a, b);
    };
    for (const FigurePair& pair : closestPairs(holes, holes, request, context.progress())) {
        const ElementId a = holes.elementOf(pair.a);
        const ElementId b = holes.elementOf(pair.b);
        context.add(*rule(a, b), document.elements.layer[a.row()], a, b, pair.spacing);
    }
}

}  // namespace model
