#include "model/design_rules/creepage.h"

#include <algorithm>
#include <limits>
#include <map>
#include <set>

#include "model/board/layers.h"
#include "model/design_rules/floating_links.h"
#include "model/design_rules/surface_paths.h"

namespace model {

namespace {

using NetPair = std::uint64_t;

class CreepageCheck {
public:
    CreepageCheck(RuleContext& context, LayerId layer, const LayerGeometry& copper)
        : m_context(context), m_layer(layer), m_copper(copper) {}

    void run() {
        for (const RuleSearch& search : m_context.searchesOf(RuleKind::Creepage)) {
            m_search = search;
            m_best.clear();
            m_around.clear();
            runSearch();
        }
        noteFloating();
    }

private:
    using Around = std::map<NetPair, std::optional<FigurePair>>;

    void runSearch() {
        for (const FigurePair& pair : pairsOf({}, [this](auto a, auto b) { return netsOf(a, b); })) {
            const SurfacePaths& paths = pathsOf(*ruleOf(pair.a, pair.b));
            if (paths.isClear(pair.spacing.from, pair.spacing.to)) {
                keep(pair);  // no way along the face is shorter
            } else {
                m_around.emplace(netsOf(pair.a, pair.b), std::nullopt);
            }
        }
        // Of the other nets the nearest copper may not be what is nearest along the face.
        const auto byFigures = [](std::uint32_t a, std::uint32_t b) { return std::uint64_t{a} << 32U | b; };
        for (const FigurePair& pair : m_around.empty() ? std::vector<FigurePair>{} : pairsOf(m_around, byFigures)) {
            follow(pair);
        }
        for (const auto& [nets, found] : m_around) {
            if (found) {
                keep(*found);
            }
        }
        followFloating();
        for (const auto& [nets, found] : m_best) {
            add(found.a, found.b, found.spacing);
        }
    }

    [[nodiscard]] std::optional<std::size_t> ruleOf(std::uint32_t a, std::uint32_t b) const {
        return m_context.ruleOf(m_search, RuleKind::Creepage, m_layer, m_context.partyOf(m_copper.elementOf(a)),
                                m_context.partyOf(m_copper.elementOf(b)));
    }

    [[nodiscard]] NetPair netsOf(std::uint32_t a, std::uint32_t b) const {
        const auto [low, high] =
            std::minmax({m_context.owners().of(m_copper.elementOf(a)), m_context.owners().of(m_copper.elementOf(b))});
        return std::uint64_t{low} << 32U | high;
    }

    /// Pairs within reach in a straight line, of some nets or of all, the closest first.
    template <class Group>
    [[nodiscard]] std::vector<FigurePair> pairsOf(const Around& nets, Group group) const {
        PairRequest request;
        request.reach = m_context.choice().reachOf(RuleKind::Creepage);
        request.isWanted = [&](std::uint32_t a, std::uint32_t b) {
            const ElementId elementA = m_copper.elementOf(a);
            const ElementId elementB = m_copper.elementOf(b);
            return m_context.netOf(elementA).isValid() && m_context.netOf(elementB).isValid() &&
                   m_context.netOf(elementA) != m_context.netOf(elementB) &&
                   (nets.empty() || nets.contains(netsOf(a, b))) && isHeld(a, b);
        };
        request.groupOf = group;
        return closestPairs(m_copper, m_copper, request, m_context.progress());
    }

    void follow(const FigurePair& pair) {
        if (m_context.progress().isCancelled()) {
            return;
        }
        const std::size_t rule = *ruleOf(pair.a, pair.b);
        std::optional<FigurePair>& best = m_around[netsOf(pair.a, pair.b)];
        const double limit = best ? best->spacing.distance : static_cast<double>(m_context.table().rules[rule].least);
        if (pair.spacing.distance >= limit) {
            return;
        }
        if (const auto way = pathsOf(rule).between(m_copper.figures(), pair.a, pair.b, limit)) {
            best = FigurePair{pair.a, pair.b, *way};
        }
    }

    /// The shorter one of two ways between the same nets. True if it is this one.
    bool keep(const FigurePair& pair) {
        const auto [found, isNew] = m_best.try_emplace(netsOf(pair.a, pair.b), pair);
        const bool isShorter = isNew || pair.spacing.distance < found->second.spacing.distance;
        found->second = isShorter ? pair : found->second;
        return isShorter;
    }

    /// Is there a rule for them, and no net tie that joins them?
    [[nodiscard]] bool isHeld(std::uint32_t a, std::uint32_t b) const {
        const ElementId elementA = m_copper.elementOf(a);
        const ElementId elementB = m_copper.elementOf(b);
        return m_context.isBetween(elementA, elementB) && ruleOf(a, b) && !m_context.nets().areTied(elementA, elementB);
    }

    /// Copper without a net shortens a path by what of it lies on that copper.
    void followFloating() {
        std::set<Nm> slots;
        for (const std::size_t rule : m_context.choice().rowsOf(RuleKind::Creepage)) {
            slots.insert(m_context.table().rules[rule].leastSlot);
        }
        const double reach = m_context.choice().reachOf(RuleKind::Creepage);
        const FloatingLinks links(m_context, m_copper, reach);
        for (const Nm slot : slots) {
            for (const FloatingLinks::Path& path :
                 links.paths([&](const FigurePair& pair) { return lengthOf(pair, slot, reach); })) {
                const bool isOfSlot = isHeld(path.a, path.b) && slotOf(*ruleOf(path.a, path.b)) == slot;
                const bool isBelow = isOfSlot && isBroken(m_context.table().rules[*ruleOf(path.a, path.b)],
                                                          m_context.table().tolerance, path.spacing.distance);
                m_floating += isBelow && keep({path.a, path.b, path.spacing}) ? 1 : 0;
            }
        }
    }

    void noteFloating() {
        if (m_floating > 0) {
            m_context.report().notes.push_back(
                "creepage on layer " + m_context.document().layer(m_layer).name +
                ", locations that lead over copper of no net, which adds no distance: " + std::to_string(m_floating));
        }
    }

    /// Along the face.
    [[nodiscard]] double lengthOf(const FigurePair& pair, Nm slot, double limit) {
        const SurfacePaths& paths = pathsWith(slot);
        if (paths.isClear(pair.spacing.from, pair.spacing.to)) {
            return pair.spacing.distance;
        }
        const std::optional<Spacing> way = paths.between(m_copper.figures(), pair.a, pair.b, limit);
        return way ? way->distance : std::numeric_limits<double>::infinity();
    }

    void add(std::uint32_t a, std::uint32_t b, const Spacing& spacing) {
        m_context.add(*ruleOf(a, b), m_layer, m_copper.elementOf(a), m_copper.elementOf(b), spacing);
    }

    [[nodiscard]] Nm slotOf(std::size_t rule) const { return m_context.table().rules[rule].leastSlot; }
    const SurfacePaths& pathsOf(std::size_t rule) { return pathsWith(slotOf(rule)); }
    const SurfacePaths& pathsWith(Nm leastSlot) {
        return m_paths.try_emplace(leastSlot, m_context.document(), leastSlot).first->second;
    }

    RuleContext& m_context;
    LayerId m_layer;
    const LayerGeometry& m_copper;
    RuleSearch m_search;
    std::size_t m_floating = 0;            ///< locations that lead over copper of no net
    std::map<NetPair, FigurePair> m_best;  ///< the shortest ways
    Around m_around;                       ///< nets that see each other across an opening, and their shortest way
    std::map<Nm, SurfacePaths> m_paths;    ///< by least slot
};

}  // namespace

void checkCreepage(RuleContext& context, LayerId layer, const LayerGeometry& copper) {
    const LayerSide face = faceOf(context.document(), layer);
    const bool isOuter = face == LayerSide::Top || face == LayerSide::Bottom;
    if (isOuter && context.isWanted(RuleKind::Creepage, layer)) {
        CreepageCheck(context, layer, copper).run();
    }
}

}  // namespace model
