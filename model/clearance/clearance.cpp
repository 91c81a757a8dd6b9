#include "model/clearance/clearance.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "model/base/parallel.h"
#include "model/board/copies.h"
#include "model/clearance/copper_owners.h"
#include "model/clearance/layer_geometry.h"

namespace model {

namespace {

constexpr double kFirstReach = 100e3;  ///< 0.1 mm: what most boards are made with

bool isSmaller(const Clearance& a, const Clearance& b) {
    const auto rank = [](const Clearance& c) {
        return std::tuple(c.spacing.distance, c.layer, c.netA, c.netB, c.a, c.b);
    };
    return rank(a) < rank(b);
}

struct CopperLayer {
    LayerId layer;
    LayerGeometry copper;
};

/// All pairs of nets of a layer that come closer than `reach`.
void search(const CopperNets& nets, const CopperLayer& on, const ClearanceRequest& request, double reach,
            base::Progress& progress, std::vector<Clearance>& found) {
    const auto netOf = [&](std::uint32_t row) { return nets.netOf(on.copper.elementOf(row)); };
    const auto isBetween = [&](NetId a, NetId b) {
        return request.between == std::pair(a, b) || request.between == std::pair(b, a);
    };
    const bool isAny = request.between == std::pair<NetId, NetId>();
    PairRequest pairs;
    pairs.reach = reach;
    pairs.within = request.within;
    pairs.isWanted = [&](std::uint32_t a, std::uint32_t b) {
        return netOf(a) != netOf(b) && (isAny || isBetween(netOf(a), netOf(b))) &&
               !nets.areTied(on.copper.elementOf(a), on.copper.elementOf(b));
    };
    pairs.groupOf = [netOf](std::uint32_t a, std::uint32_t b) {
        const auto [low, high] = std::minmax({netOf(a), netOf(b)});
        return std::uint64_t{low.value} << 32U | high.value;
    };
    for (const FigurePair& pair : closestPairs(on.copper, on.copper, pairs, progress)) {
        Clearance result{
            on.layer,    netOf(pair.a), netOf(pair.b), on.copper.elementOf(pair.a), on.copper.elementOf(pair.b),
            pair.spacing};
        if (result.netB < result.netA) {
            std::swap(result.netA, result.netB);
            std::swap(result.a, result.b);
            std::swap(result.spacing.from, result.spacing.to);
        }
        found.push_back(result);
    }
}

std::vector<CopperLayer> layersOf(const Document& document, const ClearanceRequest& request) {
    std::vector<CopperLayer> layers;
    for (std::size_t row = 0; row < document.layers.size(); ++row) {
        const bool isWanted = !request.layer.isValid() || request.layer == LayerId{row};
        if (document.layers[row].isCopper() && isWanted) {
            layers.push_back({LayerId{row}, {}});
        }
    }
    base::parallelFor(layers.size(),
                      [&](std::size_t i) { layers[i].copper = copperGeometry(document, layers[i].layer); });
    return layers;
}

/// All nets that come closer than a reach which is doubled until they are enough. Empty after a cancel.
std::vector<Clearance> search(const Document& document, const CopperNets& nets, const ClearanceRequest& request,
                              base::Progress& progress) {
    const std::vector<CopperLayer> layers = layersOf(document, request);
    Box extent;
    for (const CopperLayer& on : layers) {
        extent.include(on.copper.extent());
    }
    const double farthest = std::hypot(static_cast<double>(extent.width()), static_cast<double>(extent.height()));
    const double last = std::min(request.below, farthest);
    for (double reach = std::min(kFirstReach, last);; reach = std::min(2 * reach, last)) {
        progress.beginPhase("Measuring clearances");
        std::vector<Clearance> found;
        for (std::size_t i = 0; i < layers.size(); ++i) {
            search(nets, layers[i], request, reach, progress, found);
            progress.setFraction(static_cast<float>(i + 1) / static_cast<float>(layers.size()));
        }
        if (found.size() >= request.count || reach >= last || progress.isCancelled()) {
            return found;
        }
    }
}

}  // namespace

base::Result<std::vector<Clearance>> smallestClearances(const Document& document, const ClearanceRequest& request,
                                                        base::Progress& progress) {
    ASSIGN_OR_RETURN(const CopperNets nets, CopperNets::of(document, progress));
    std::vector<Clearance> clearances = search(document, nets, request, progress);
    if (progress.isCancelled()) {
        return base::Error{base::ErrorCode::Cancelled, "cancelled"};
    }
    std::erase_if(clearances, [&](const Clearance& c) { return c.spacing.distance >= request.below; });
    std::ranges::sort(clearances, isSmaller);
    clearances.resize(std::min(clearances.size(), request.count));
    return clearances;
}

bool isCopperWithoutNets(const Document& step) {
    return step.nets.empty() && std::ranges::any_of(step.layers, [](const Layer& layer) {
               return layer.isCopper() && layer.elements.count > 0;
           });
}

std::vector<std::string> unmeasuredSteps(const Document& board) {
    std::vector<std::string> notes;
    for (const Document* step : distinctSteps(board)) {
        if (isCopperWithoutNets(*step)) {
            notes.push_back("step " + step->job.step + " has copper but no nets; it was not measured");
        }
    }
    return notes;
}

}  // namespace model
