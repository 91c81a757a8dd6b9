#include "model/clearance/nearby.h"

#include <algorithm>
#include <tuple>

#include "model/clearance/copper_owners.h"
#include "model/clearance/layer_geometry.h"
#include "model/figures/distance.h"

namespace model {

namespace {

bool isNearer(const Nearby& a, const Nearby& b) {
    return std::tuple(a.spacing.distance, a.element) < std::tuple(b.spacing.distance, b.element);
}

/// Which elements are targets, and which have a net of theirs. Without `nets` copper has the net that the job gives it.
class Sides {
public:
    Sides(const Document& document, std::span<const ElementId> targets, const CopperNets* nets)
        : m_document(document), m_nets(nets), m_isTarget(document.elements.size()), m_hasTarget(document.nets.size()) {
        for (const ElementId element : targets) {
            m_isTarget[element.row()] = true;
            if (const NetId net = netOf(element); net.isValid()) {
                m_hasTarget[net.row()] = true;
            }
        }
    }

    [[nodiscard]] bool isTarget(ElementId element) const { return m_isTarget[element.row()]; }
    [[nodiscard]] bool isOther(ElementId element) const {
        const NetId net = netOf(element);
        return !m_isTarget[element.row()] && !(net.isValid() && m_hasTarget[net.row()]);
    }

    [[nodiscard]] bool areTied(ElementId a, ElementId b) const { return m_nets != nullptr && m_nets->areTied(a, b); }

private:
    [[nodiscard]] NetId netOf(ElementId element) const {
        return m_nets != nullptr ? m_nets->netOf(element) : m_document.elements.net[element.row()];
    }

    const Document& m_document;
    const CopperNets* m_nets;
    std::vector<bool> m_isTarget;
    std::vector<bool> m_hasTarget;  ///< by net
};

void addNear(const Document& document, LayerId layer, const Sides& sides, double reach, base::Progress& progress,
             std::vector<Nearby>& found) {
    const LayerGeometry targets = copperGeometry(document, layer, [&](ElementId e) { return sides.isTarget(e); });
    if (targets.size() == 0) {
        return;
    }
    const LayerGeometry others = copperGeometry(document, layer, [&](ElementId e) { return sides.isOther(e); });
    PairRequest request;
    request.reach = reach;
    request.isWanted = [&](std::uint32_t other, std::uint32_t target) {
        return !sides.areTied(others.elementOf(other), targets.elementOf(target));
    };
    request.groupOf = [&](std::uint32_t other, std::uint32_t) { return others.elementOf(other).value; };
    for (const FigurePair& pair : closestPairs(others, targets, request, progress)) {
        found.push_back({others.elementOf(pair.a), layer, pair.spacing});
    }
}

std::vector<Nearby> find(const Document& document, const Sides& sides, double reach, base::Progress& progress) {
    std::vector<Nearby> found;
    for (std::size_t row = 0; row < document.layers.size() && !progress.isCancelled(); ++row) {
        if (document.layers[row].isCopper()) {
            addNear(document, LayerId{row}, sides, reach, progress, found);
        }
        progress.setFraction(static_cast<float>(row + 1) / static_cast<float>(document.layers.size()));
    }
    return found;
}

/// Does it depend on what touches what, which takes long to find out?
bool isDoubtful(const Document& document, std::span<const ElementId> targets, std::span<const Nearby> found) {
    const auto hasNoNet = [&](ElementId element) { return !document.elements.net[element.row()].isValid(); };
    return std::ranges::any_of(targets, hasNoNet) || std::ranges::any_of(found, [&](const Nearby& near) {
               return hasNoNet(near.element) || near.spacing.distance <= kTouchNm;
           });
}

}  // namespace

base::Result<std::vector<Nearby>> copperNear(const Document& document, std::span<const ElementId> targets, double reach,
                                             base::Progress& progress) {
    std::vector<Nearby> found = find(document, Sides(document, targets, nullptr), reach, progress);
    if (isDoubtful(document, targets, found)) {
        ASSIGN_OR_RETURN(const CopperNets nets, CopperNets::of(document, progress));
        found = find(document, Sides(document, targets, &nets), reach, progress);
    }
    if (progress.isCancelled()) {
        return base::Error{base::ErrorCode::Cancelled, "cancelled"};
    }
    std::ranges::stable_sort(found, isNearer);  // of one element the upper layer first
    std::vector<bool> isKnown(document.elements.size());
    std::erase_if(found, [&](const Nearby& near) {
        const bool wasKnown = isKnown[near.element.row()];
        isKnown[near.element.row()] = true;
        return wasKnown;
    });
    return found;
}

}  // namespace model
