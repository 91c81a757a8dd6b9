#include "model/agreement/layer_agreement.h"

#include <algorithm>
#include <limits>

#include "model/base/ascii.h"
#include "model/board/copies.h"
#include "model/figures/element_polygons.h"
#include "model/geometry/boolean.h"
#include "model/text/formatting.h"

namespace model {

namespace {

constexpr Discretisation kChords{1000.0, false};
constexpr Box kEverywhere{{std::numeric_limits<Nm>::min(), std::numeric_limits<Nm>::min()},
                          {std::numeric_limits<Nm>::max(), std::numeric_limits<Nm>::max()}};

bool isOfAspect(const Layer& layer, Aspect aspect) {
    if (layer.isSynthetic || layer.context != LayerContext::Board) {
        return false;
    }
    switch (aspect) {
        case Aspect::Copper: return layer.isCopper();
        case Aspect::SolderMask: return layer.type == LayerType::SolderMask;
        case Aspect::SolderPaste: return layer.type == LayerType::SolderPaste;
        case Aspect::Silkscreen: return layer.type == LayerType::SilkScreen;
        default: return false;
    }
}

bool isDrawnOn(const Layer& layer) {
    return std::ranges::any_of(layer.countsWithCopies, [](std::uint64_t count) { return count > 0; });
}

using Layers = std::vector<LayerId>;

Layers layersOf(const Document& board, Aspect aspect, LayerSide side) {
    Layers layers;
    for (std::size_t row = 0; row < board.layers.size(); ++row) {
        const bool isOnSide = aspect == Aspect::Copper || board.layers[row].side == side;
        if (isOnSide && isOfAspect(board.layers[row], aspect)) {
            layers.emplace_back(row);
        }
    }
    return layers;
}

class LayerPairer {
public:
    LayerPairer(const Document& a, const Document& b) : m_a(a), m_b(b) {}

    std::vector<LayerPair> run() {
        pair(Aspect::Copper, LayerSide::None);
        for (const Aspect aspect : {Aspect::SolderMask, Aspect::SolderPaste, Aspect::Silkscreen}) {
            pair(aspect, LayerSide::Top);
            pair(aspect, LayerSide::Bottom);
        }
        return std::move(m_pairs);
    }

private:
    void pair(Aspect aspect, LayerSide side) {
        Layers ours = layersOf(m_a, aspect, side);
        Layers theirs = layersOf(m_b, aspect, side);
        if (aspect != Aspect::Copper || ours.size() != theirs.size()) {
            pairByName(aspect, ours, theirs);
        }
        const bool isByOrder = aspect != Aspect::Copper || ours.size() == theirs.size();
        const std::size_t both = isByOrder ? std::min(ours.size(), theirs.size()) : 0;
        for (std::size_t i = 0; i < both; ++i) {
            add(aspect, ours[i], theirs[i]);
        }
        for (std::size_t i = both; i < ours.size(); ++i) {
            add(aspect, ours[i], {});
        }
        for (std::size_t i = both; i < theirs.size(); ++i) {
            add(aspect, {}, theirs[i]);
        }
    }

    /// Takes those with one name out of both.
    void pairByName(Aspect aspect, Layers& ours, Layers& theirs) {
        std::erase_if(ours, [&](LayerId a) {
            const std::string name = base::lowerCase(m_a.layer(a).name);
            const auto found =
                std::ranges::find(theirs, name, [&](LayerId b) { return base::lowerCase(m_b.layer(b).name); });
            if (found == theirs.end()) {
                return false;
            }
            add(aspect, a, *found);
            theirs.erase(found);
            return true;
        });
    }

    void add(Aspect aspect, LayerId a, LayerId b) {
        const bool isDrawn = (a.isValid() && isDrawnOn(m_a.layer(a))) || (b.isValid() && isDrawnOn(m_b.layer(b)));
        if (isDrawn) {
            m_pairs.push_back({aspect, a, b});
        }
    }

    const Document& m_a;
    const Document& m_b;
    std::vector<LayerPair> m_pairs;
};

/// What is drawn on a layer of the board, copies included, by elements that reach into `box`, all whole.
PolygonSet polygonsOn(const Document& board, const StepTree& tree, LayerId layer, const Placement& shift,
                      const Box& box) {
    PolygonSet all;
    for (const StepCopy& copy : tree.copies) {
        const Document& step = *tree.steps[copy.step];
        const Placement placement = shift.after(copy.placement);
        const Range range = step.layer(board.layerOfCopy(layer, copy.isFlipped)).elements;
        PolygonSet own;
        for (std::uint32_t i = 0; i < range.count; ++i) {
            const ElementId element{std::size_t{range.first} + i};
            if (placement.boxOf(step.boxOf(element)).meets(box)) {
                own.append(discretise(step, element, kChords));
            }
        }
        all.append(placed(own, placement));
    }
    return all;
}

PolygonSet outlineOf(const Document& board, const Placement& shift) {
    return board.profile.isValid() ? discretise(board.shapes, board.profile, kChords, &shift) : PolygonSet{};
}

std::string squareMm(double nm2) {
    return formatted("%.4f mm²", nm2 / 1e12);
}

/// "only in A 0.1044 mm²"
std::string onlyText(const RegionDifference::Place& place) {
    const std::string a = "only in A " + squareMm(place.only[0]);
    const std::string b = "only in B " + squareMm(place.only[1]);
    return place.only[1] == 0.0 ? a : place.only[0] == 0.0 ? b : a + ", " + b;
}

class LayerComparer {
public:
    LayerComparer(const Document& a, const Document& b, Point shift, const AgreementRequest& request)
        : m_a(a),
          m_b(b),
          m_shift{shift, 0.0, false},
          m_request(request),
          m_treeA(unfoldCopies(a)),
          m_treeB(unfoldCopies(b)) {}

    [[nodiscard]] Comparison compare(const LayerPair& pair) const {
        Comparison comparison;
        comparison.aspect = pair.aspect;
        comparison.pair = pair;
        comparison.layers = {pair.a.isValid() ? m_a.layer(pair.a).name : "",
                             pair.b.isValid() ? m_b.layer(pair.b).name : ""};
        if (!pair.a.isValid() || !pair.b.isValid()) {
            compareWithNothing(pair, comparison);
            return comparison;
        }
        judge(polygonsOn(m_a, m_treeA, pair.a, {}, kEverywhere), polygonsOn(m_b, m_treeB, pair.b, m_shift, kEverywhere),
              comparison);
        return comparison;
    }

    [[nodiscard]] Comparison compareOutlines() const {
        Comparison comparison;
        comparison.aspect = comparison.pair.aspect = Aspect::Outline;
        const PolygonSet ours = outlineOf(m_a, {});
        const PolygonSet theirs = outlineOf(m_b, m_shift);
        if (ours.points.empty() || theirs.points.empty()) {
            comparison.accord = Accord::NotCompared;
            comparison.note = std::string(ours.points.empty() ? "A" : "B") + " has no outline";
            return comparison;
        }
        judge(ours, theirs, comparison);
        return comparison;
    }

private:
    void compareWithNothing(const LayerPair& pair, Comparison& comparison) const {
        const Document& other = pair.a.isValid() ? m_b : m_a;
        const char* const name = pair.a.isValid() ? "B" : "A";
        const bool hasAny =
            std::ranges::any_of(other.layers, [&](const Layer& layer) { return isOfAspect(layer, pair.aspect); });
        if (hasAny || pair.aspect == Aspect::Copper) {
            comparison.add({std::string(name) + " has no such layer", {}}, m_request.most);
        } else {
            comparison.accord = Accord::NotCompared;
            comparison.note = std::string(name) + " has no layers of this kind";
        }
    }

    void judge(const PolygonSet& ours, const PolygonSet& theirs, Comparison& comparison) const {
        comparison.region = differenceOf(ours, theirs, m_request.tolerance);
        if (comparison.region->share() <= m_request.allowed) {
            return;
        }
        for (const RegionDifference::Place& place : comparison.region->places) {
            comparison.add({onlyText(place), place.at, place.box}, m_request.most);
        }
    }

    const Document& m_a;
    const Document& m_b;
    Placement m_shift;
    const AgreementRequest& m_request;
    StepTree m_treeA;
    StepTree m_treeB;
};

}  // namespace

std::array<PolygonSet, 2> onlyDrawn(const Document& a, const Document& b, Point shift, const LayerPair& pair,
                                    const Box& box) {
    PolygonSet window;
    window.beginPolygon();
    window.addLoop(std::array<Point, 4>{{box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}}});
    const auto within = [&](const Document& board, LayerId layer, const Placement& placement) {
        const PolygonSet drawn = pair.aspect == Aspect::Outline ? outlineOf(board, placement)
                                 : layer.isValid() ? polygonsOn(board, unfoldCopies(board), layer, placement, box)
                                                   : PolygonSet{};
        return intersect(drawn, window);
    };
    const PolygonSet ours = within(a, pair.a, {});
    const PolygonSet theirs = within(b, pair.b, {shift, 0.0, false});
    return {subtract(ours, theirs), subtract(theirs, ours)};
}

std::vector<LayerPair> pairLayers(const Document& a, const Document& b) {
    return LayerPairer(a, b).run();
}

base::Result<std::vector<Comparison>> compareLayers(const Document& a, const Document& b, Point shift,
                                                    const AgreementRequest& request, base::Progress& progress) {
    std::vector<LayerPair> pairs = pairLayers(a, b);
    std::erase_if(pairs, [&](const LayerPair& pair) { return !request.wants(pair.aspect); });
    const LayerComparer comparer(a, b, shift, request);
    std::vector<Comparison> comparisons;
    for (std::size_t i = 0; i < pairs.size(); ++i) {
        if (progress.isCancelled()) {
            return base::Error{base::ErrorCode::Cancelled, "cancelled"};
        }
        progress.setFraction(static_cast<float>(i) / static_cast<float>(pairs.size()));
        comparisons.push_back(comparer.compare(pairs[i]));
    }
    comparisons.push_back(comparer.compareOutlines());
    return comparisons;
}

}  // namespace model
