#include "model/design_rules/mask_checks.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "model/base/disjoint_sets.h"
#include "model/base/parallel.h"
#include "model/board/layers.h"
#include "model/clearance/ring_width.h"
#include "model/design_rules/bridged.h"
#include "model/figures/distance.h"

namespace model {

namespace {

bool isAnyRow(std::uint32_t) {
    return true;
}

/// The copper layer that a layer of mask or silkscreen lies on; none on a face without copper.
LayerId copperUnder(const Document& document, LayerId layer) {
    const LayerSide face = faceOf(document, layer);
    const LayerId copper = outerCopper(document, face);
    const LayerSide other = face == LayerSide::Bottom ? LayerSide::Top : LayerSide::Bottom;
    return copper.isValid() && document.layer(copper).side == other ? LayerId{} : copper;
}

/// Pads of components on a copper layer that are still there.
LayerGeometry padsOf(const RuleContext& context, LayerId copper, bool withVias) {
    return layerGeometry(context.document(), copper, [&](ElementId element) {
        const CopperObject object = context.objectOf(element);
        return !context.isAway(element) && (object == CopperObject::Pad || (withVias && object == CopperObject::Via));
    });
}

/// How an opening lies to a pad in it.
struct Opening {
    std::optional<std::uint32_t> row;  ///< of the opening that leaves most; none: no mask is open here
    RingWidth ring;
};

/// Does all of a pad lie within the element of an opening?
bool isWithin(const LayerGeometry& pads, std::uint32_t pad, const LayerGeometry& openings, std::uint32_t opening,
              const Document& document) {
    FigureTable figures;
    figures.add(document, openings.elementOf(opening));
    return ringAround(figures, pads.figures(), pad, 0.0).state == RingState::Removed;
}

Opening openingAround(const LayerGeometry& openings, const LayerGeometry& pads, std::uint32_t pad,
                      const Document& document, double reach) {
    FigureTable figures;
    figures.add(document, pads.elementOf(pad));
    Opening best;
    const auto rank = [](const RingWidth& ring) {
        return std::pair(static_cast<int>(ring.state), ring.width.distance);
    };
    openings.visitNear(pads.figures().box(pad), 0.0, [&](std::uint32_t row) {
        const RingWidth ring = ringAround(figures, openings.figures(), row, reach);
        if (ring.state != RingState::Apart && (!best.row || rank(ring) > rank(best.ring))) {
            best = {row, ring};
        }
    });
    // An opening within the pad that has the pad within itself is as large: nothing is left on either side.
    if (best.row && best.ring.state == RingState::Removed && isWithin(pads, pad, openings, *best.row, document)) {
        best.ring.state = RingState::BreaksOut;
    }
    return best;
}

using Touching = std::vector<std::set<std::uint32_t>>;

/// Rows of the copper that each opening touches.
Touching touchingOf(const LayerGeometry& openings, const LayerGeometry& copper) {
    Touching rows(openings.size());
    base::parallelFor(openings.size(), [&](std::size_t opening) {
        copper.visitNear(openings.figures().box(opening), 0.0, [&](std::uint32_t row) {
            if (spacingBetween(openings.figures(), opening, copper.figures(), row, kTouchNm)) {
                rows[opening].insert(row);
            }
        });
    });
    return rows;
}

/// Whose copper an opening is for.
std::set<std::uint32_t> ownersIn(const RuleContext& context, const LayerGeometry& copper,
                                 const std::set<std::uint32_t>& touching) {
    for (const CopperObject wanted : {CopperObject::Pad, CopperObject::Via, CopperObject::Any}) {
        std::set<std::uint32_t> owners;
        for (const std::uint32_t row : touching) {
            const ElementId element = copper.elementOf(row);
            if (wanted == CopperObject::Any || context.objectOf(element) == wanted) {
                owners.insert(context.owners().of(element));
            }
        }
        if (!owners.empty()) {
            return owners;
        }
    }
    return {};
}

/// The distances of a mask's openings to copper of other nets than those they are for.
class ForeignCopper {
public:
    ForeignCopper(RuleContext& context, LayerId mask, LayerId layer)
        : m_context(context),
          m_mask(mask),
          m_openings(layerGeometry(context.document(), mask)),
          m_copper(copperGeometry(context.document(), layer, context.isThere())) {
        for (const std::set<std::uint32_t>& touching : touchingOf(m_openings, m_copper)) {
            m_owners.push_back(ownersIn(context, m_copper, touching));
        }
        lendOwners();
    }

    /// Of each opening and net the closest location that falls under a rule of the search.
    void check(RuleSearch search) const {
        PairRequest request;
        request.reach = m_context.choice().reachOf(RuleKind::MaskToForeign);
        request.isWanted = [&](std::uint32_t opening, std::uint32_t row) {
            return isForeign(opening, row) && ruleOf(search, row);
        };
        request.groupOf = [&](std::uint32_t opening, std::uint32_t row) {
            return std::uint64_t{m_openings.elementOf(opening).value} << 32U |
                   m_context.owners().of(m_copper.elementOf(row));
        };
        for (const FigurePair& pair : closestPairs(m_openings, m_copper, request, m_context.progress())) {
            m_context.add(*ruleOf(search, pair.b), m_mask, m_openings.elementOf(pair.a), m_copper.elementOf(pair.b),
                          pair.spacing);
        }
    }

private:
    [[nodiscard]] std::optional<std::size_t> ruleOf(RuleSearch search, std::uint32_t row) const {
        return m_context.ruleOf(search, RuleKind::MaskToForeign, m_mask, m_context.partyOf(m_copper.elementOf(row)));
    }
    [[nodiscard]] bool isForeign(std::uint32_t opening, std::uint32_t row) const {
        const ElementId element = m_copper.elementOf(row);
        const bool isCopperOfSome = m_context.netOf(element).isValid() || m_context.isLand(element);
        return isCopperOfSome && !m_owners[opening].contains(m_context.owners().of(element));
    }
    /// Openings that touch no copper are for what those are for that they are one with: strokes of one that is drawn.
    void lendOwners() {
        DisjointSets pieces(m_openings.size());
        PairRequest request;
        request.reach = kTouchNm;
        request.isWanted = [&](std::uint32_t a, std::uint32_t b) { return m_owners[a].empty() || m_owners[b].empty(); };
        request.groupOf = [](std::uint32_t a, std::uint32_t b) { return std::uint64_t{a} << 32U | b; };
        for (const FigurePair& pair : closestPairs(m_openings, m_openings, request, m_context.progress())) {
            pieces.join(pair.a, pair.b);
        }
        std::map<std::uint32_t, std::set<std::uint32_t>> owners;  // by piece
        for (std::uint32_t row = 0; row < m_owners.size(); ++row) {
            owners[pieces.find(row)].insert(m_owners[row].begin(), m_owners[row].end());
        }
        for (std::uint32_t row = 0; row < m_owners.size(); ++row) {
            if (m_owners[row].empty()) {
                m_owners[row] = owners[pieces.find(row)];
            }
        }
    }

    RuleContext& m_context;
    LayerId m_mask;
    LayerGeometry m_openings;
    LayerGeometry m_copper;
    std::vector<std::set<std::uint32_t>> m_owners;  ///< by opening, whose copper it is for; nobody's: all is foreign
};

/// The layer of solder mask on a face; none if the job has none.
LayerId maskOn(const Document& document, LayerSide face) {
    for (std::size_t row = 0; row < document.layers.size(); ++row) {
        if (isMask(document.layers[row]) && faceOf(document, LayerId{row}) == face) {
            return LayerId{row};
        }
    }
    return {};
}

/// By row: is it free of solder mask?
std::vector<bool> areOpen(const RuleContext& context, const LayerGeometry& pads, LayerId mask) {
    std::vector<bool> open(pads.size(), !mask.isValid());
    if (mask.isValid()) {
        const LayerGeometry openings = layerGeometry(context.document(), mask);
        for (const std::set<std::uint32_t>& rows : touchingOf(openings, pads)) {
            std::ranges::for_each(rows, [&](std::uint32_t row) { open[row] = true; });
        }
    }
    return open;
}

}  // namespace

void checkSlivers(RuleContext& context, LayerId mask) {
    const auto rule = context.choice().of(RuleKind::MaskSliver, mask, {});
    if (!rule || !context.isWanted(RuleKind::MaskSliver, mask)) {
        return;
    }
    const LayerGeometry openings = layerGeometry(context.document(), mask);
    std::size_t bridged = 0;
    PairRequest request;
    request.reach = static_cast<double>(context.table().rules[*rule].least);
    request.mayTouch = [](std::uint32_t, std::uint32_t) { return false; };  // they are one opening
    for (const FigurePair& pair : closestPairs(openings, openings, request, context.progress())) {
        if (pair.spacing.distance <= static_cast<double>(context.table().tolerance)) {
            continue;  // they abut, but for rounding
        }
        if (isBridged(openings, pair.spacing, isAnyRow)) {
            ++bridged;
        } else {
            context.add(*rule, mask, openings.elementOf(pair.a), openings.elementOf(pair.b), pair.spacing);
        }
    }
    if (bridged > 0) {
        context.report().unchecked.push_back({*rule, bridged, bridged == 1 ? "pair of openings" : "pairs of openings",
                                              "on " + context.document().layer(mask).name +
                                                  " a third opening lies where they are closest, and other locations "
                                                  "were not searched"});
    }
}

void checkMaskToCopper(RuleContext& context, LayerId mask) {
    const LayerId layer = copperUnder(context.document(), mask);
    if (!layer.isValid() || !context.isWanted(RuleKind::MaskToCopper, mask)) {
        return;
    }
    const LayerGeometry openings = layerGeometry(context.document(), mask);
    const LayerGeometry pads = padsOf(context, layer, true);
    const double reach = context.choice().reachOf(RuleKind::MaskToCopper);
    std::vector<Opening> around(pads.size());
    base::parallelFor(around.size(), [&](std::size_t pad) {
        around[pad] = openingAround(openings, pads, static_cast<std::uint32_t>(pad), context.document(), reach);
    });
    std::size_t smaller = 0;
    for (std::uint32_t pad = 0; pad < pads.size(); ++pad) {
        const auto& [row, ring] = around[pad];
        const auto rule = context.choice().of(RuleKind::MaskToCopper, mask, context.partyOf(pads.elementOf(pad)));
        if (!row || !rule) {
            continue;
        }
        smaller += ring.state == RingState::Removed ? 1 : 0;
        if (ring.state != RingState::Removed) {
            context.add(*rule, mask, openings.elementOf(*row), pads.elementOf(pad),
                        {ring.width.distance, ring.width.to, ring.width.from});
        }
    }
    if (smaller > 0) {
        const bool isOne = smaller == 1;
        context.report().notes.push_back(
            std::to_string(smaller) + (isOne ? " pad under " : " pads under ") + context.document().layer(mask).name +
            (isOne ? " is larger than its" : " are larger than their") + " opening (defined by solder mask)");
    }
}

void checkMaskToForeign(RuleContext& context, LayerId mask) {
    const LayerId layer = copperUnder(context.document(), mask);
    if (!layer.isValid() || !context.isWanted(RuleKind::MaskToForeign, mask)) {
        return;
    }
    const ForeignCopper foreign(context, mask, layer);
    for (const RuleSearch& search : context.searchesOf(RuleKind::MaskToForeign)) {
        foreign.check(search);
    }
}

void checkSilkscreen(RuleContext& context, LayerId silkscreen) {
    const auto rule = context.choice().of(RuleKind::SilkToPad, silkscreen, {});
    const LayerId layer = copperUnder(context.document(), silkscreen);
    if (!rule || !layer.isValid() || !context.isWanted(RuleKind::SilkToPad, silkscreen)) {
        return;
    }
    const LayerGeometry print = layerGeometry(context.document(), silkscreen);
    const LayerGeometry pads = padsOf(context, layer, false);
    const std::vector<bool> isOpen =
        areOpen(context, pads, maskOn(context.document(), faceOf(context.document(), silkscreen)));
    PairRequest request;
    request.reach = context.choice().reachOf(RuleKind::SilkToPad);
    request.isWanted = [&](std::uint32_t, std::uint32_t pad) { return isOpen[pad]; };
    request.groupOf = [&](std::uint32_t, std::uint32_t pad) { return std::uint64_t{pads.elementOf(pad).value}; };
    for (const FigurePair& pair : closestPairs(print, pads, request, context.progress())) {
        context.add(*rule, silkscreen, print.elementOf(pair.a), pads.elementOf(pair.b), pair.spacing);
    }
}

}  // namespace model
