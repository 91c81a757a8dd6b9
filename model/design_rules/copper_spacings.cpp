#include "model/design_rules/copper_spacings.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "model/design_rules/bridged.h"
#include "model/design_rules/drilled_holes.h"
#include "model/geometry/discretise.h"
#include "model/nets/net_inference.h"
#include "model/solids/region_distance.h"

namespace model {

namespace {

/// The edge of the board is so near to its chords, nm: within that a point may be on the other side.
constexpr double kEdgeChord = 2000.0;

std::optional<std::size_t> ruleOf(const RuleContext& context, RuleKind kind, LayerId layer, ElementId a, ElementId b) {
    return context.choice().of(kind, layer, context.partyOf(a), context.partyOf(b));
}

/// Do two elements belong to different copper that has to keep a clearance?
bool areForeign(const RuleContext& context, ElementId a, ElementId b) {
    const bool hasNet = context.netOf(a).isValid() || context.netOf(b).isValid();
    return context.owners().of(a) != context.owners().of(b) && (hasNet || context.isLand(a) || context.isLand(b));
}

/// Do two elements belong to different copper that no net tie brings together there?
bool areOfOtherCopper(const RuleContext& context, ElementId a, ElementId b) {
    return context.owners().of(a) != context.owners().of(b) && !context.nets().areTied(a, b);
}

/// Are both drawn by one record of the job, as a pad of KiCad draws its copper and its hole?
bool areOfOneRecord(const Document& document, ElementId a, ElementId b) {
    const auto fileOf = [&](ElementId element) -> const std::string& {
        return document.layer(document.elements.layer[element.row()]).file;
    };
    const std::uint32_t line = document.elements.line[a.row()];
    return line != 0 && line == document.elements.line[b.row()] && fileOf(a) == fileOf(b);
}

/// Is an NPTH drilled in the middle of this pad, or as one with it? Its ring of copper is no other copper that has to
/// keep away.
bool isInItsPad(const RuleContext& context, ElementId hole, ElementId copper) {
    const Document& document = context.document();
    const Box pad = document.boxOf(copper);
    const Box drilled = document.boxOf(hole);
    return (document.elements.flags[copper.row()] & kPad) != 0 && pad.holds(drilled.min) && pad.holds(drilled.max) &&
           (areConcentric(pad, drilled) || areOfOneRecord(document, copper, hole));
}

/// Are two holes with one middle meant so: the same hole in two drill layers, a back-drill or counterbore over a hole,
/// vias of a net stacked on each other? All else is a hole that is drilled into another one.
bool areMeantConcentric(const RuleContext& context, const DrilledHole& a, const DrilledHole& b) {
    const bool isSameNet = context.owners().of(a.element) == context.owners().of(b.element);
    const bool isSameHole = &a.layer != &b.layer && areOneHole(context, a, b);
    const bool isStack = a.isPlated && b.isPlated && isSameNet && areOfStack(a, b);
    return isSameHole || isStack || a.isIntoAnother() || b.isIntoAnother();
}

/// Two holes that have to keep apart: they pass some layer both, and are not meant to have one middle.
bool areApart(const RuleContext& context, const LayerGeometry& holes, std::uint32_t a, std::uint32_t b) {
    const DrilledHole holeA = drilledHole(context.document(), holes, a);
    const DrilledHole holeB = drilledHole(context.document(), holes, b);
    const bool isStacked =
        holeA.hasSpan() && holeB.hasSpan() &&
        (holeA.layer.spanBottom < holeB.layer.spanTop || holeB.layer.spanBottom < holeA.layer.spanTop);
    return holeA.element != holeB.element && !isStacked &&
           !(areConcentric(holeA.box, holeB.box) && areMeantConcentric(context, holeA, holeB));
}

/// Are two holes that touch milled as one opening, as a slot with a corner is, or one whose ends are wider? No drill
/// bit runs off into what a milling cutter left. The same slot twice is a mistake, as the same drilled hole is.
bool areOneOpening(const RuleContext& context, const DrilledHole& a, const DrilledHole& b) {
    const auto isMilled = [&](const DrilledHole& hole) {
        return context.document().elements.kind[hole.element.row()] != ElementKind::Circle;
    };
    const bool isOfOnePlating =
        a.isPlated == b.isPlated && (!a.isPlated || context.owners().of(a.element) == context.owners().of(b.element));
    return isMilled(a) && isMilled(b) && isOfOnePlating && !(areConcentric(a.box, b.box) && areOfOneSize(a.box, b.box));
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
        for (const RuleSearch& search : m_context.searchesOf(RuleKind::CopperToCopper)) {
            m_search = search;
            m_apart.clear();
            checkSearch();
        }
    }

private:
    void checkSearch() {
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

    [[nodiscard]] std::optional<std::size_t> rule(std::uint32_t a, std::uint32_t b) const {
        return m_context.ruleOf(m_search, RuleKind::CopperToCopper, m_layer, m_context.partyOf(m_copper.elementOf(a)),
                                m_context.partyOf(m_copper.elementOf(b)));
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
    RuleSearch m_search;
    NetPairs m_apart;  ///< nets with a location for each two elements
};

/// The distances of a layer's copper to the edge of the board. Copper beyond it, also in a cut-out, has none.
class EdgeSpacings {
public:
    EdgeSpacings(RuleContext& context, LayerId layer, const LayerGeometry& copper)
        : m_context(context), m_layer(layer), m_copper(copper), m_area(boardArea(context.document())) {}

    void check() {
        const LayerGeometry edge = edgeGeometry(m_context.document());
        PairRequest request;
        request.reach = m_context.choice().reachOf(RuleKind::CopperToEdge);
        request.isWanted = [&](std::uint32_t a, std::uint32_t) { return isHeld(a); };
        std::set<ElementId> touching;
        for (const FigurePair& pair : closestPairs(m_copper, edge, request, m_context.progress())) {
            const bool isBeyond = pair.spacing.distance > kEdgeChord && isOff(pair.a);
            if (!isBeyond) {
                touching.insert(m_copper.elementOf(pair.a));
                m_context.add(*rule(pair.a), m_layer, m_copper.elementOf(pair.a), edge.elementOf(pair.b), pair.spacing);
            }
        }
        addBeyond(touching);
    }

private:
    [[nodiscard]] std::optional<std::size_t> rule(std::uint32_t row) const {
        return m_context.choice().of(RuleKind::CopperToEdge, m_layer, m_context.partyOf(m_copper.elementOf(row)));
    }
    [[nodiscard]] bool isHeld(std::uint32_t row) const {
        return rule(row).has_value() && !isInPad(m_context, m_copper, row);
    }
    [[nodiscard]] bool isOff(std::uint32_t row) const {
        const PointD at = m_copper.figures()[row].anchor;
        return !m_area.contains({static_cast<Nm>(std::lround(at.x)), static_cast<Nm>(std::lround(at.y))});
    }
    static PolygonSet boardArea(const Document& document) {
        return discretise(document.shapes, document.profile, {.chordToleranceNm = kEdgeChord});
    }

    /// Pads are, and what has a net. One that nobody named ($7) follows from the copper alone: it may be a text or a
    /// frame, unless some of it lies on the board.
    [[nodiscard]] bool isOfBoard(ElementId element) {
        const NetId net = m_context.netOf(element);
        if (!net.isValid() || m_context.isLand(element)) {
            return m_context.isLand(element);
        }
        const Document& document = m_context.document();
        const auto [known, isNew] = m_isOfBoard.try_emplace(net, true);
        if (isNew && isNumberedNet(document.nets[net.row()].name)) {
            known->second = std::ranges::any_of(document.elementsOf(net), [&](ElementId each) {
                return m_area.contains(document.boxOf(each).middle());
            });
        }
        return known->second;
    }

    /// What is not of the board may be a frame, a coupon or a text: it is only counted, or without any net nobody
    /// knows.
    void addBeyond(const std::set<ElementId>& touching) {
        std::size_t others = 0;
        std::optional<std::size_t> ruleOfOthers;
        ElementId last;
        for (std::uint32_t row = 0; row < m_copper.size() && !m_context.progress().isCancelled(); ++row) {
            const ElementId element = m_copper.elementOf(row);
            if (element == last || touching.contains(element) || !isOff(row) || !isHeld(row)) {
                continue;
            }
            last = element;
            if (isOfBoard(element)) {
                const PointD at = m_copper.figures()[row].anchor;
                m_context.add(*rule(row), m_layer, element, {}, {0.0, at, at});
            } else {
                ++others;
                ruleOfOthers = rule(row);
            }
        }
        if (others > 0) {
            report(others, *ruleOfOthers);
        }
    }

    void report(std::size_t others, std::size_t rule) const {
        const std::string name = m_context.document().layer(m_layer).name;
        if (m_context.document().nets.empty()) {
            m_context.report().unchecked.push_back({rule, others, others == 1 ? "copper element" : "copper elements",
                                                    "they lie beyond the board outline on layer " + name +
                                                        ", and the board has no nets that tell whether they are its"});
        } else {
            m_context.report().notes.push_back(
                std::to_string(others) +
                (others == 1 ? " copper element of no named net lies" : " copper elements of no named net lie") +
                " beyond the board outline on layer " + name);
        }
    }

    RuleContext& m_context;
    LayerId m_layer;
    const LayerGeometry& m_copper;
    EdgeStrips m_area;
    std::map<NetId, bool> m_isOfBoard;
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
        const auto isOwn = [&](std::uint32_t row) { return context.netOf(copper.elementOf(row)) == context.netOf(a); };
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
               (isPlated ? areOfOtherCopper(context, copper.elementOf(a), hole)
                         : !isInItsPad(context, hole, copper.elementOf(a)));
    };
    for (const FigurePair& pair : closestPairs(copper, holes, request, context.progress())) {
        context.add(*rule(pair.a, pair.b), layer, copper.elementOf(pair.a), holes.elementOf(pair.b), pair.spacing);
    }
}

void checkToEdge(RuleContext& context, LayerId layer, const LayerGeometry& copper) {
    const Document& document = context.document();
    const bool hasEdge = document.profile.isValid() && document.profileSource != Source::Assumed;  // else: unchecked
    if (!hasEdge || !context.isWanted(RuleKind::CopperToEdge, layer)) {
        return;
    }
    EdgeSpacings(context, layer, copper).check();
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
        return areApart(context, holes, rowA, rowB) && context.isBetween(a, b) && isOnLayer(a) && isOnLayer(b) &&
               rule(a, b);
    };
    request.mayTouch = [&](std::uint32_t a, std::uint32_t b) {
        return !areOneOpening(context, drilledHole(document, holes, a), drilledHole(document, holes, b));
    };
    for (const FigurePair& pair : closestPairs(holes, holes, request, context.progress())) {
        const ElementId a = holes.elementOf(pair.a);
        const ElementId b = holes.elementOf(pair.b);
        context.add(*rule(a, b), document.elements.layer[a.row()], a, b, pair.spacing);
    }
}

}  // namespace model
