#include "model/clearance/design_rule_check.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <tuple>

#include "model/clearance/annular_ring.h"
#include "model/clearance/copper_owners.h"
#include "model/clearance/drilled_away.h"
#include "model/clearance/layer_geometry.h"
#include "model/clearance/net_ties.h"
#include "model/clearance/rule_choice.h"
#include "model/clearance/unchecked_items.h"
#include "model/figures/distance.h"

namespace model {

namespace {

constexpr Nm kConcentric = 1000;  ///< holes this near to each other's middle are one hole, drilled twice

bool areConcentric(const Box& a, const Box& b) {
    const auto twice = [](const Box& box) {
        return base::PointD{double{1} * box.min.x + box.max.x, double{1} * box.min.y + box.max.y};
    };
    return std::hypot(twice(a).x - twice(b).x, twice(a).y - twice(b).y) <= 2 * kConcentric;
}

/// What is known of a hole's rings over all layers so far.
struct HoleRings {
    std::optional<RuleFinding> removed;  ///< on the first layer where the drill takes the pad
    bool hasCopper = false;
    LayerId first;  ///< the first layer that it passes
};

class Check {
public:
    Check(const Document& document, const RuleTable& table, const RuleScope& scope, const CopperOwners& owners,
          base::Progress& progress)
        : m_document(document),
          m_scope(scope),
          m_table(table),
          m_owners(owners),
          m_choice(document, table),
          m_ties(document, owners, progress),
          m_isAway(drilledAway(document)),
          m_holes(holeClassesOf(document)),
          m_progress(progress) {}

    [[nodiscard]] RuleReport run() {
        m_report.counts.resize(m_table.rules.size());
        m_report.unchecked = uncheckedItems(m_document, m_table, m_choice);
        for (std::size_t rule = 0; rule < m_table.rules.size(); ++rule) {
            const std::string beyond = whyBeyond(m_table.rules[rule].kind);
            m_report.unused.push_back(!m_table.rules[rule].isOn ? ""
                                      : !beyond.empty()         ? beyond
                                                                : m_choice.whyUnused(rule, m_holes));
        }
        std::erase_if(m_report.unchecked, [&](const Unchecked& unchecked) {
            return !whyBeyond(m_table.rules[unchecked.rule].kind).empty();
        });
        for (std::size_t row = 0; row < m_document.layers.size() && !m_progress.isCancelled(); ++row) {
            const LayerId layer{row};
            if (m_scope.layer.isValid() && m_scope.layer != layer) {
                continue;
            }
            if (m_document.layers[row].isCopper()) {
                checkCopper(layer);
            } else if (isMask(m_document.layers[row])) {
                checkMask(layer);
            }
            m_progress.setFraction(static_cast<float>(row + 1) / static_cast<float>(m_document.layers.size()));
        }
        checkHoles();
        addHolesWithoutRing();
        note();
        finish();
        return std::move(m_report);
    }

private:
    [[nodiscard]] bool isOfAllNets() const { return m_scope.between == std::pair<NetId, NetId>(); }

    /// Why the scope leaves out rules of a kind; empty if it does not.
    [[nodiscard]] std::string whyBeyond(RuleKind kind) const {
        const bool isOfMask = kind == RuleKind::MaskSliver;
        if (!isOfAllNets() && (isOfMask || kind == RuleKind::CopperToEdge || kind == RuleKind::AnnularRing)) {
            return "it is not between two nets";
        }
        if (m_scope.layer.isValid() && isOfMask != isMask(m_document.layer(m_scope.layer))) {
            return "layer " + m_document.layer(m_scope.layer).name +
                   (isOfMask ? " is no solder mask" : " is no copper layer");
        }
        return {};
    }

    [[nodiscard]] bool isInScope(RuleKind kind) const { return whyBeyond(kind).empty(); }

    /// Are they of the two nets of the scope?
    [[nodiscard]] bool isBetween(ElementId a, ElementId b) const {
        const std::pair nets(m_owners.netOf(a), m_owners.netOf(b));
        return isOfAllNets() || nets == m_scope.between || std::pair(nets.second, nets.first) == m_scope.between;
    }

    /// As the job has it, with its openings.
    static bool isMask(const Layer& layer) { return layer.type == LayerType::SolderMask && !layer.isSynthetic; }

    void finish() {
        std::ranges::sort(m_report.findings, {}, [](const RuleFinding& f) {
            return std::tuple(f.rule, f.spacing.distance, f.layer, f.a, f.b);
        });
        for (const RuleFinding& finding : m_report.findings) {
            ++m_report.counts[finding.rule];
        }
        std::ranges::stable_sort(m_report.unchecked, {}, &Unchecked::rule);
    }

    void add(std::size_t rule, LayerId layer, ElementId a, ElementId b, const Spacing& spacing) {
        if (isBroken(m_table.rules[rule], m_table.tolerance, spacing.distance)) {
            m_report.findings.push_back({rule, layer, a, b, spacing, FindingReason::TooClose});
        }
    }

    /// Copper that no NPTH takes away.
    [[nodiscard]] ElementFilter isThere() const {
        return [this](ElementId element) { return !m_isAway[element.row()]; };
    }

    void checkCopper(LayerId layer) {
        const LayerGeometry copper = copperGeometry(m_document, layer, isThere());
        checkNets(layer, copper);
        checkToHoles(layer);
        checkToEdge(layer, copper);
        checkRings(layer);
    }

    /// Pads and holes: what has no net and is none of them is text, a shape or a part of one.
    [[nodiscard]] bool isLand(ElementId element) const {
        return (m_document.elements.flags[element.row()] & (kPad | kHole)) != 0;
    }

    /// Do two elements belong to different copper that has to keep a clearance?
    [[nodiscard]] bool areForeign(ElementId a, ElementId b) const {
        const bool hasNet = m_owners.netOf(a).isValid() || m_owners.netOf(b).isValid();
        return m_owners.of(a) != m_owners.of(b) && (hasNet || isLand(a) || isLand(b));
    }

    void checkNets(LayerId layer, const LayerGeometry& copper) {
        const auto ruleOf = [&](std::uint32_t a, std::uint32_t b) {
            return m_choice.between(m_owners.netOf(copper.elementOf(a)), m_owners.netOf(copper.elementOf(b)));
        };
        PairRequest request;
        request.reach = m_document.nets.empty() ? 0.0 : m_choice.reachOf(RuleKind::CopperToCopper);
        request.isWanted = [&](std::uint32_t a, std::uint32_t b) {
            return areForeign(copper.elementOf(a), copper.elementOf(b)) &&
                   isBetween(copper.elementOf(a), copper.elementOf(b)) && ruleOf(a, b) &&
                   !m_ties.joins(copper.elementOf(a), copper.elementOf(b));
        };
        request.groupOf = [&](std::uint32_t a, std::uint32_t b) {
            const auto [low, high] = std::minmax({m_owners.of(copper.elementOf(a)), m_owners.of(copper.elementOf(b))});
            return std::uint64_t{low} << 32U | high;
        };
        if (request.reach <= 0) {
            return;
        }
        for (const FigurePair& pair : closestPairs(copper, copper, request, m_progress)) {
            const auto [a, b] = inOrder(copper.elementOf(pair.a), copper.elementOf(pair.b));
            const bool isTurned = a != copper.elementOf(pair.a);
            const Spacing& s = pair.spacing;
            add(*ruleOf(pair.a, pair.b), layer, a, b, isTurned ? Spacing{s.distance, s.to, s.from} : s);
        }
    }

    /// What no rule asks for.
    void note() {
        std::size_t islands = 0;
        std::size_t thin = 0;
        for (const Layer& layer : m_document.layers) {
            const Range range = layer.isCopper() ? layer.elements : Range{};
            for (std::uint32_t i = range.first; i < range.first + range.count; ++i) {
                const ElementId element{i};
                islands += !m_owners.netOf(element).isValid() && !isLand(element) ? 1 : 0;
                thin += coversNothing(m_document, element) ? 1 : 0;
            }
        }
        const auto add = [&](std::size_t count, const char* what) {
            if (count > 0) {
                m_report.notes.push_back(std::to_string(count) + what);
            }
        };
        add(m_document.nets.empty() ? 0 : islands,
            " copper elements of no net, neither pads nor holes, are held against nets, not against each other");
        add(thin, " copper elements have no width and leave no copper");
        add(static_cast<std::size_t>(std::ranges::count(m_isAway, true)),
            " pads lie wholly within NPTHs, which take them away");
        if (m_choice.reachOf(RuleKind::CopperToCopper) > 0) {
            m_report.netTies = m_ties.ties();
        }
    }

    /// The one of the lower net first, as in searches for clearances.
    [[nodiscard]] std::pair<ElementId, ElementId> inOrder(ElementId a, ElementId b) const {
        return m_owners.of(b) < m_owners.of(a) ? std::pair(b, a) : std::pair(a, b);
    }

    [[nodiscard]] std::optional<std::size_t> ruleOf(RuleKind kind, ElementId hole) const {
        return m_choice.of(kind, m_holes[hole.row()]);
    }

    void checkToHoles(LayerId layer) {
        const LayerGeometry copper = layerGeometry(m_document, layer, isThere());
        const LayerGeometry holes = holeGeometry(m_document, layer);
        PairRequest request;
        request.reach = m_choice.reachOf(RuleKind::CopperToHole);
        request.isWanted = [&](std::uint32_t a, std::uint32_t b) {
            const ElementId hole = holes.elementOf(b);
            const bool isPlated = isPlatedHole(m_document.elements.flags[hole.row()]);
            return ruleOf(RuleKind::CopperToHole, hole) && isBetween(copper.elementOf(a), hole) &&
                   (!isPlated || m_owners.of(copper.elementOf(a)) != m_owners.of(hole));
        };
        if (request.reach <= 0) {
            return;
        }
        for (const FigurePair& pair : closestPairs(copper, holes, request, m_progress)) {
            const ElementId hole = holes.elementOf(pair.b);
            add(*ruleOf(RuleKind::CopperToHole, hole), layer, copper.elementOf(pair.a), hole, pair.spacing);
        }
    }

    void checkToEdge(LayerId layer, const LayerGeometry& copper) {
        const auto rule = m_choice.of(RuleKind::CopperToEdge);
        if (rule && m_document.profile.isValid() && isInScope(RuleKind::CopperToEdge)) {
            const LayerGeometry edge = edgeGeometry(m_document);
            PairRequest request;
            request.reach = m_table.rules[*rule].least;
            for (const FigurePair& pair : closestPairs(copper, edge, request, m_progress)) {
                add(*rule, layer, copper.elementOf(pair.a), edge.elementOf(pair.b), pair.spacing);
            }
        }
    }

    void checkRings(LayerId layer) {
        const double reach = m_choice.reachOf(RuleKind::AnnularRing);
        if (reach <= 0 || !isInScope(RuleKind::AnnularRing)) {
            return;
        }
        for (const AnnularRing& ring : annularRings(m_document, layer, reach)) {
            if (const auto rule = ruleOf(RuleKind::AnnularRing, ring.hole)) {
                checkRing(*rule, layer, ring);
            }
        }
    }

    void checkRing(std::size_t rule, LayerId layer, const AnnularRing& ring) {
        HoleRings& rings = m_rings[ring.hole];
        rings.first = rings.first.isValid() ? rings.first : layer;
        rings.hasCopper = rings.hasCopper || ring.ring.state != RingState::Apart;
        if (ring.ring.state == RingState::Removed && !rings.removed) {
            rings.removed =
                RuleFinding{rule, layer, ring.hole, ring.pad, middleOf(ring.hole), FindingReason::PadRemoved};
        } else if (ring.ring.state == RingState::BreaksOut || ring.ring.state == RingState::Around) {
            add(rule, layer, ring.hole, ring.pad, ring.ring.width);
        }
    }

    [[nodiscard]] Spacing middleOf(ElementId hole) const {
        const PointD middle = base::toDouble(m_document.boxOf(hole).middle());
        return {0.0, middle, middle};
    }

    /// Once per hole, whatever the number of layers.
    void addHolesWithoutRing() {
        for (const auto& [hole, rings] : m_rings) {
            if (rings.removed) {
                m_report.findings.push_back(*rings.removed);
            } else if (!rings.hasCopper && !m_scope.layer.isValid()) {
                m_report.findings.push_back({*ruleOf(RuleKind::AnnularRing, hole),
                                             rings.first,
                                             hole,
                                             {},
                                             middleOf(hole),
                                             FindingReason::NoPad});
            }
        }
    }

    void checkMask(LayerId layer) {
        const auto rule = m_choice.of(RuleKind::MaskSliver);
        if (!rule || !isInScope(RuleKind::MaskSliver)) {
            return;
        }
        const LayerGeometry openings = layerGeometry(m_document, layer);
        std::size_t bridged = 0;
        PairRequest request;
        request.reach = m_table.rules[*rule].least;
        request.mayTouch = [](std::uint32_t, std::uint32_t) { return false; };  // they are one opening
        for (const FigurePair& pair : closestPairs(openings, openings, request, m_progress)) {
            if (isOpenBetween(openings, pair.spacing)) {
                ++bridged;
            } else {
                add(*rule, layer, openings.elementOf(pair.a), openings.elementOf(pair.b), pair.spacing);
            }
        }
        if (bridged > 0) {
            m_report.unchecked.push_back({*rule, bridged, bridged == 1 ? "pair of openings" : "pairs of openings",
                                          "on " + m_document.layer(layer).name +
                                              " a third opening lies where they are closest, and other locations "
                                              "were not searched"});
        }
    }

    /// A third opening may leave nothing of what is between two.
    static bool isOpenBetween(const LayerGeometry& openings, const Spacing& spacing) {
        FigureTable middle;
        middle.addTrack(spacing.from, spacing.to, 0.0);
        FigureTable point;
        const PointD half{(spacing.from.x + spacing.to.x) / 2, (spacing.from.y + spacing.to.y) / 2};
        point.addTrack(half, half, 0.0);
        bool isOpen = false;
        openings.visitNear(middle.box(0), 0.0, [&](std::uint32_t row) {
            isOpen = isOpen || spacingBetween(point, 0, openings.figures(), row, kTouchNm).has_value();
        });
        return isOpen;
    }

    void checkHoles() {
        const auto ruleOf = [&](ElementId a, ElementId b) {
            return m_choice.between(m_holes[a.row()], m_holes[b.row()]);
        };
        FigureTable figures;
        for (const Layer& layer : m_document.layers) {
            for (std::uint32_t i = layer.elements.first; i < layer.elements.first + layer.elements.count; ++i) {
                if ((m_document.elements.flags[i] & kHole) != 0) {
                    figures.add(m_document, ElementId{i});
                }
            }
        }
        const LayerGeometry holes(std::move(figures));
        PairRequest request;
        request.reach = m_choice.reachOf(RuleKind::HoleToHole);
        request.isWanted = [&](std::uint32_t a, std::uint32_t b) {
            return areApart(holes, a, b) && isBetween(holes.elementOf(a), holes.elementOf(b)) &&
                   isOnLayer(holes.elementOf(a)) && isOnLayer(holes.elementOf(b)) &&
                   ruleOf(holes.elementOf(a), holes.elementOf(b));
        };
        if (request.reach <= 0 || !isInScope(RuleKind::HoleToHole)) {
            return;
        }
        for (const FigurePair& pair : closestPairs(holes, holes, request, m_progress)) {
            const ElementId a = holes.elementOf(pair.a);
            const ElementId b = holes.elementOf(pair.b);
            add(*ruleOf(a, b), m_document.elements.layer[a.row()], a, b, pair.spacing);
        }
    }

    /// Does a hole pass the layer of the scope, if there is one?
    [[nodiscard]] bool isOnLayer(ElementId hole) const {
        return !m_scope.layer.isValid() || m_document.layer(m_document.elements.layer[hole.row()]).spans(m_scope.layer);
    }

    /// Two holes, not one that is drilled twice, and both pass some layer.
    [[nodiscard]] bool areApart(const LayerGeometry& holes, std::uint32_t a, std::uint32_t b) const {
        const Layer& layerA = m_document.layer(m_document.elements.layer[holes.elementOf(a).row()]);
        const Layer& layerB = m_document.layer(m_document.elements.layer[holes.elementOf(b).row()]);
        const bool isStacked = layerA.spanTop.isValid() && layerB.spanTop.isValid() &&
                               (layerA.spanBottom < layerB.spanTop || layerB.spanBottom < layerA.spanTop);
        return holes.elementOf(a) != holes.elementOf(b) && !isStacked &&
               !areConcentric(holes.figures().box(a), holes.figures().box(b));
    }

    const Document& m_document;
    const RuleScope& m_scope;
    const RuleTable& m_table;
    const CopperOwners& m_owners;
    RuleChoice m_choice;
    NetTies m_ties;
    std::vector<bool> m_isAway;      ///< elements that NPTHs take away
    std::vector<HoleClass> m_holes;  ///< by element
    base::Progress& m_progress;
    std::map<ElementId, HoleRings> m_rings;
    RuleReport m_report;
};

}  // namespace

base::Result<RuleReport> checkRules(const Document& document, const RuleTable& table, base::Progress& progress,
                                    const RuleScope& scope) {
    ASSIGN_OR_RETURN(const CopperOwners owners, CopperOwners::of(document, progress));
    progress.beginPhase("Checking rules");
    RuleReport report = Check(document, table, scope, owners, progress).run();
    if (progress.isCancelled()) {
        return base::Error{base::ErrorCode::Cancelled, "cancelled"};
    }
    return report;
}

}  // namespace model
