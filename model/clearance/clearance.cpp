#include "model/clearance/clearance.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <utility>

#include "model/base/parallel.h"
#include "model/board/copies.h"
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

/// The copper of one layer as a result sees it.
class CopperPairs {
public:
    CopperPairs(const Document& document, LayerId layer, const ClearanceRequest& request, LayerGeometry plane)
        : m_document(document), m_layer(layer), m_request(request), m_plane(std::move(plane)) {}

    [[nodiscard]] Box extent() const { return m_plane.extent(); }

    /// All pairs of nets that come closer than `reach`.
    void search(double reach, base::Progress& progress, std::vector<Clearance>& found) const {
        PairRequest pairs;
        pairs.reach = reach;
        pairs.within = m_request.within;
        pairs.isWanted = [this](std::uint32_t a, std::uint32_t b) { return isWanted(netOf(a), netOf(b)); };
        pairs.groupOf = [this](std::uint32_t a, std::uint32_t b) {
            const auto [low, high] = std::minmax({netOf(a), netOf(b)});
            return std::uint64_t{low.value} << 32U | high.value;
        };
        // Copper without a net that touches a net belongs to it.
        pairs.mayTouch = [this](std::uint32_t a, std::uint32_t b) { return netOf(a).isValid() && netOf(b).isValid(); };
        for (const FigurePair& pair : closestPairs(m_plane, m_plane, pairs, progress)) {
            found.push_back(resultOf(pair));
        }
    }

private:
    [[nodiscard]] NetId netOf(std::uint32_t row) const { return m_document.elements.net[m_plane.elementOf(row).row()]; }

    [[nodiscard]] bool isWanted(NetId a, NetId b) const {
        const auto [x, y] = m_request.between;
        const bool isAny = !x.isValid() && !y.isValid();
        return a != b && (isAny || (a == x && b == y) || (a == y && b == x));
    }

    [[nodiscard]] Clearance resultOf(const FigurePair& pair) const {
        Clearance result{
            m_layer, netOf(pair.a), netOf(pair.b), m_plane.elementOf(pair.a), m_plane.elementOf(pair.b), pair.spacing};
        if (result.netB < result.netA) {
            std::swap(result.netA, result.netB);
            std::swap(result.a, result.b);
            std::swap(result.spacing.from, result.spacing.to);
        }
        return result;
    }

    const Document& m_document;
    LayerId m_layer;
    const ClearanceRequest& m_request;
    LayerGeometry m_plane;
};

std::vector<CopperPairs> layersOf(const Document& document, const ClearanceRequest& request) {
    std::vector<LayerId> rows;
    for (std::size_t row = 0; row < document.layers.size(); ++row) {
        const bool isWanted = !request.layer.isValid() || request.layer == LayerId{row};
        if (document.layers[row].isCopper() && isWanted) {
            rows.emplace_back(row);
        }
    }
    std::vector<LayerGeometry> geometry(rows.size());
    base::parallelFor(rows.size(), [&](std::size_t i) { geometry[i] = copperGeometry(document, rows[i]); });
    std::vector<CopperPairs> layers;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        layers.emplace_back(document, rows[i], request, std::move(geometry[i]));
    }
    return layers;
}

/// All nets that come closer than a reach which is doubled until they are enough. Empty after a cancel.
std::vector<Clearance> search(const std::vector<CopperPairs>& layers, const ClearanceRequest& request,
                              base::Progress& progress) {
    Box extent;
    for (const CopperPairs& layer : layers) {
        extent.include(layer.extent());
    }
    const double farthest = std::hypot(static_cast<double>(extent.width()), static_cast<double>(extent.height()));
    const double last = std::min(request.below, farthest);
    for (double reach = std::min(kFirstReach, last);; reach = std::min(2 * reach, last)) {
        std::vector<Clearance> found;
        for (std::size_t i = 0; i < layers.size(); ++i) {
            layers[i].search(reach, progress, found);
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
    progress.beginPhase("Measuring clearances");
    std::vector<Clearance> clearances = search(layersOf(document, request), request, progress);
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
