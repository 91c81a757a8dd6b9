#include "model/clearance/stackup_clearance.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include "model/clearance/layer_geometry.h"
#include "model/nets/net_ties.h"
#include "model/nets/tie_claims.h"

namespace model {

namespace {

constexpr double kFirstReach = 100e3;  // nm

/// Copper between two heights: a layer, or the walls of holes that join the same layers.
struct Slab {
    ZRange z;
    LayerGeometry copper;
    std::vector<std::uint32_t> nets;    ///< by row: of all copies, see Copper::nets
    std::vector<std::uint32_t> copies;  ///< by row
};

enum class Named : std::uint8_t { No, First, Second };

/// All copper that takes part, copies laid on the board.
struct Copper {
    StepTree tree;
    std::vector<Slab> slabs;
    std::vector<Named> named;   ///< by net: is it one of the two that are asked for?
    std::vector<NetTies> ties;  ///< by step of the tree
    double farthest = 0.0;      ///< nm; no two items are farther apart
};

/// First and last copper layer of the board, and whether flipped copies have them on the other side.
struct Span {
    LayerId top;
    LayerId bottom;
    bool isMirrored = false;
    auto operator<=>(const Span&) const = default;
};

Span spanIn(const Document& step, const StepCopy& copy, LayerId top, LayerId bottom) {
    const auto [first, last] =
        std::minmax({step.layerOfCopy(top, copy.isFlipped), step.layerOfCopy(bottom, copy.isFlipped)});
    return {first, last, isMirroredInCopy(step, top, copy.isFlipped)};
}

class Collector {
public:
    explicit Collector(const Document& board) : m_board(board) {}

    Copper run(const StackupClearanceRequest& request) {
        Copper copper;
        copper.tree = unfoldCopies(m_board);
        for (std::uint32_t copy = 0; copy < copper.tree.copies.size(); ++copy) {
            const Document& step = *copper.tree.steps[copper.tree.copies[copy].step];
            m_firstNet = static_cast<std::uint32_t>(copper.named.size());
            for (const Net& net : step.nets) {
                copper.named.push_back(net.name == request.between.first    ? Named::First
                                       : net.name == request.between.second ? Named::Second
                                                                            : Named::No);
            }
            addCopy(step, copper.tree.copies[copy], copy);
        }
        Box extent;
        ZRange z{0, 0};
        for (auto& [span, open] : m_open) {
            copper.slabs.push_back({heightsInCopy(m_board, span.top, span.bottom, span.isMirrored),
                                    LayerGeometry(std::move(open.figures)), std::move(open.nets),
                                    std::move(open.copies)});
            extent.include(copper.slabs.back().copper.extent());
            z = {std::min(z.bottom, copper.slabs.back().z.bottom), std::max(z.top, copper.slabs.back().z.top)};
        }
        copper.farthest = std::hypot(double(extent.width()), double(extent.height()), double(z.top - z.bottom)) + 1.0;
        return copper;
    }

private:
    struct Open {
        FigureTable figures;
        std::vector<std::uint32_t> nets;
        std::vector<std::uint32_t> copies;
    };

    void addCopy(const Document& step, const StepCopy& copy, std::uint32_t row) {
        for (std::uint32_t i = 0; i < step.elements.size(); ++i) {
            const LayerId layer = step.elements.layer[i];
            const bool isWall = isPlatedHole(step.elements.flags[i]);
            if (!step.elements.net[i].isValid() || !(isWall || step.layer(layer).isCopper())) {
                continue;
            }
            const PlatedSpan span = isWall ? step.platedSpanOf(ElementId{i}) : PlatedSpan{{}, layer, layer};
            if (span.top.isValid() && span.bottom.isValid()) {
                Open& open = m_open[spanIn(step, copy, span.top, span.bottom)];
                open.figures.add(step, ElementId{i}, copy.placement);
                open.nets.resize(open.figures.size(), m_firstNet + step.elements.net[i].value);
                open.copies.resize(open.figures.size(), row);
            }
        }
    }

    const Document& m_board;
    std::map<Span, Open> m_open;
    std::uint32_t m_firstNet = 0;  ///< of the copy that is added
};

/// Does a component say that it joins nets? Else there are no ties, and the copper need not be followed.
bool mayTie(const Document& step) {
    for (std::size_t row = 0; row < step.components.size(); ++row) {
        if (!tiedNetsOf(step, ComponentId{row}).groups.empty()) {
            return true;
        }
    }
    return false;
}

/// By step.
base::Result<std::vector<NetTies>> tiesOf(const StepTree& tree, base::Progress& progress) {
    std::vector<NetTies> ties;
    for (const Document* step : tree.steps) {
        if (!mayTie(*step)) {
            ties.emplace_back();
            continue;
        }
        ASSIGN_OR_RETURN(const Connectivity connectivity, Connectivity::of(*step, progress));
        ties.emplace_back(*step, connectivity);
    }
    return ties;
}

double heightBetween(const ZRange& a, const ZRange& b) {
    return std::max({0.0, double(a.bottom - b.top), double(b.bottom - a.top)});
}

using Found = std::map<std::pair<std::uint32_t, std::uint32_t>, StackupClearance>;

class Search {
public:
    Search(const Copper& copper, const StackupClearanceRequest& request, base::Progress& progress)
        : m_copper(copper), m_isAny(request.between.first.empty()), m_progress(progress) {}

    /// The closest of each two nets that come closer than `reach`.
    [[nodiscard]] Found within(double reach) const {
        Found found;
        const std::size_t count = m_copper.slabs.size();
        for (std::size_t i = 0; i < count; ++i) {
            for (std::size_t j = i; j < count && !m_progress.isCancelled(); ++j) {
                search(m_copper.slabs[i], m_copper.slabs[j], reach, found);
            }
            m_progress.setFraction(static_cast<float>(i + 1) / static_cast<float>(count));
        }
        return found;
    }

private:
    [[nodiscard]] bool isWanted(std::uint32_t a, std::uint32_t b) const {
        const Named first = m_copper.named[a];
        const Named second = m_copper.named[b];
        return a != b && (m_isAny || (first != Named::No && second != Named::No && first != second));
    }

    /// Is it a net tie of their copy that brings them together?
    [[nodiscard]] bool areTied(const Slab& a, std::uint32_t i, const Slab& b, std::uint32_t j) const {
        const std::uint32_t step = m_copper.tree.copies[a.copies[i]].step;
        const auto& nets = m_copper.tree.steps[step]->elements.net;
        const ElementId first = a.copper.elementOf(i);
        const ElementId second = b.copper.elementOf(j);
        return a.copies[i] == b.copies[j] &&
               m_copper.ties[step].joins(first, nets[first.row()], second, nets[second.row()]);
    }

    void search(const Slab& a, const Slab& b, double reach, Found& found) const {
        const double height = heightBetween(a.z, b.z);
        if (height >= reach) {
            return;
        }
        PairRequest request;
        request.reach = std::sqrt(reach * reach - height * height);
        request.isWanted = [&](std::uint32_t i, std::uint32_t j) {
            return isWanted(a.nets[i], b.nets[j]) && !areTied(a, i, b, j);
        };
        request.groupOf = [&](std::uint32_t i, std::uint32_t j) {
            const auto [low, high] = std::minmax({a.nets[i], b.nets[j]});
            return std::uint64_t{low} << 32U | high;
        };
        for (const FigurePair& pair : closestPairs(a.copper, b.copper, request, m_progress)) {
            retain(a, b, pair, height, found);
        }
    }

    void retain(const Slab& a, const Slab& b, const FigurePair& pair, double height, Found& found) const {
        const double planar = pair.spacing.distance;
        StackupClearance result{{a.copies[pair.a], a.copper.elementOf(pair.a)},
                                {b.copies[pair.b], b.copper.elementOf(pair.b)},
                                {},
                                {},
                                {std::hypot(planar, height), pair.spacing.from, pair.spacing.to},
                                planar,
                                height};
        if (b.nets[pair.b] < a.nets[pair.a]) {
            std::swap(result.a, result.b);
            std::swap(result.spacing.from, result.spacing.to);
        }
        result.layerA = layerOf(result.a);
        result.layerB = layerOf(result.b);
        const auto nets = std::minmax({a.nets[pair.a], b.nets[pair.b]});
        const auto [known, isNew] = found.try_emplace({nets.first, nets.second}, result);
        const auto rank = [](const StackupClearance& c) { return std::tuple(c.spacing.distance, c.a, c.b); };
        if (!isNew && rank(result) < rank(known->second)) {
            known->second = result;
        }
    }

    [[nodiscard]] LayerId layerOf(const BoardElement& at) const {
        const StepCopy& copy = m_copper.tree.copies[at.copy];
        const Document& step = *m_copper.tree.steps[copy.step];
        return step.layerOfCopy(step.elements.layer[at.element.row()], copy.isFlipped);
    }

    const Copper& m_copper;
    bool m_isAny;
    base::Progress& m_progress;
};

}  // namespace

base::Result<std::vector<StackupClearance>> smallestThroughStackup(const Document& board,
                                                                   const StackupClearanceRequest& request,
                                                                   base::Progress& progress) {
    const auto hasHeight = [](const Layer& layer) { return layer.isCopper() && layer.thickness > 0; };
    if (std::ranges::none_of(board.layers, hasHeight)) {
        return base::Error{base::ErrorCode::BadInput, "no copper layer has a height to measure through the stackup"};
    }
    Copper copper = Collector(board).run(request);
    ASSIGN_OR_RETURN(copper.ties, tiesOf(copper.tree, progress));
    const double last = std::min(request.below, copper.farthest);
    const Search search(copper, request, progress);
    Found found;
    for (double reach = std::min(kFirstReach, last);; reach = std::min(2 * reach, last)) {
        progress.beginPhase("Measuring through the stackup");
        found = search.within(reach);
        if (found.size() >= request.count || reach >= last || progress.isCancelled()) {
            break;
        }
    }
    if (progress.isCancelled()) {
        return base::Error{base::ErrorCode::Cancelled, "cancelled"};
    }
    std::vector<StackupClearance> clearances;
    for (const auto& [nets, clearance] : found) {
        if (clearance.spacing.distance < request.below) {
            clearances.push_back(clearance);
        }
    }
    std::ranges::stable_sort(clearances, {}, [](const StackupClearance& c) { return c.spacing.distance; });
    clearances.resize(std::min(clearances.size(), request.count));
    return clearances;
}

}  // namespace model
