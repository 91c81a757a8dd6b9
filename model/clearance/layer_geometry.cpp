#include "model/clearance/layer_geometry.h"

#include <algorithm>
#include <tuple>
#include <unordered_map>

#include "model/base/parallel.h"
#include "model/figures/distance.h"

namespace model {

namespace {

/// Figures per task: small enough to share out one heavy layer, large enough to be worth a task.
constexpr std::size_t kFiguresPerTask = 512;

using Closest = std::unordered_map<std::uint64_t, FigurePair>;

bool isCloser(const FigurePair& x, const FigurePair& y) {
    return std::tuple(x.spacing.distance, x.a, x.b) < std::tuple(y.spacing.distance, y.a, y.b);
}

void retain(Closest& closest, std::uint64_t group, const FigurePair& found) {
    const auto [location, isFirst] = closest.try_emplace(group, found);
    if (!isFirst && isCloser(found, location->second)) {
        location->second = found;
    }
}

std::uint64_t bothOf(std::uint32_t a, std::uint32_t b) {
    return std::uint64_t{a} << 32U | b;
}

bool holds(const Box& box, PointD p) {
    return box.min.x <= p.x && p.x <= box.max.x && box.min.y <= p.y && p.y <= box.max.y;
}

class PairSearch {
public:
    PairSearch(const LayerGeometry& a, const LayerGeometry& b, const PairRequest& request)
        : m_a(a), m_b(b), m_request(request) {}

    /// Between figures first … end - 1 of the first layer geometry and those of the second.
    void search(std::size_t first, std::size_t end, Closest& found) const {
        std::vector<std::uint32_t> near;
        for (std::size_t i = first; i < end; ++i) {
            const auto row = static_cast<std::uint32_t>(i);
            near.clear();
            m_b.visitNear(m_a.figures().box(i), m_request.reach, [&](std::uint32_t j) {
                if ((&m_a != &m_b || j > row) && m_request.isWanted(row, j)) {
                    near.push_back(j);
                }
            });
            std::ranges::sort(near);
            for (const std::uint32_t j : near) {
                measure(row, j, found);
            }
        }
    }

private:
    [[nodiscard]] bool isInside(const Spacing& spacing) const {
        return !m_request.within || holds(*m_request.within, spacing.from) || holds(*m_request.within, spacing.to);
    }

    void measure(std::uint32_t i, std::uint32_t j, Closest& found) const {
        const std::uint64_t group =
            m_request.groupOf ? m_request.groupOf(i, j) : bothOf(m_a.elementOf(i).value, m_b.elementOf(j).value);
        const auto known = found.find(group);
        const double limit = known == found.end() ? m_request.reach : known->second.spacing.distance;
        const std::optional<Spacing> spacing = spacingBetween(m_a.figures(), i, m_b.figures(), j, limit);
        if (spacing && isInside(*spacing) && (spacing->distance > kTouchNm || m_request.mayTouch(i, j))) {
            retain(found, group, {i, j, *spacing});
        }
    }

    const LayerGeometry& m_a;
    const LayerGeometry& m_b;
    const PairRequest& m_request;
};

void addLayer(FigureTable& figures, const Document& document, const Layer& layer, const ElementFilter& isWanted) {
    for (std::uint32_t i = layer.elements.first; i < layer.elements.first + layer.elements.count; ++i) {
        if (isWanted(ElementId{i})) {
            figures.add(document, ElementId{i});
        }
    }
}

}  // namespace

Box LayerGeometry::extent() const {
    Box extent;
    for (std::size_t row = 0; row < size(); ++row) {
        extent.include(m_figures.box(row));
    }
    return extent;
}

void LayerGeometry::visitNear(const Box& box, double reach, const std::function<void(std::uint32_t)>& visit) const {
    m_index->visit(box.grownBy(static_cast<Nm>(reach) + 1), visit);
}

bool isAnyElement(ElementId) {
    return true;
}

LayerGeometry copperGeometry(const Document& document, LayerId layer, const ElementFilter& isWanted) {
    FigureTable figures;
    addLayer(figures, document, document.layer(layer), isWanted);
    for (const Layer& drill : document.layers) {
        if (drill.spans(layer)) {
            addLayer(figures, document, drill, [&](ElementId hole) {
                return isPlatedHole(document.elements.flags[hole.row()]) && document.platedSpanOf(hole).joins(layer) &&
                       isWanted(hole);
            });
        }
    }
    return LayerGeometry(std::move(figures));
}

LayerGeometry holeGeometry(const Document& document, LayerId layer) {
    FigureTable figures;
    for (const Layer& drill : document.layers) {
        if (drill.spans(layer)) {
            addLayer(figures, document, drill,
                     [&](ElementId hole) { return (document.elements.flags[hole.row()] & kHole) != 0; });
        }
    }
    return LayerGeometry(std::move(figures));
}

LayerGeometry layerGeometry(const Document& document, LayerId layer, const ElementFilter& isWanted) {
    FigureTable figures;
    addLayer(figures, document, document.layer(layer), isWanted);
    return LayerGeometry(std::move(figures));
}

LayerGeometry edgeGeometry(const Document& document) {
    FigureTable figures;
    if (document.profile.isValid()) {
        figures.addOutline(document.shapes, document.profile);
    }
    return LayerGeometry(std::move(figures));
}

bool coversNothing(const Document& document, ElementId element) {
    FigureTable figures;
    figures.add(document, element);
    return figures.size() == 0;
}

bool hasNoSize(const Document& document, ElementId hole) {
    const Box box = document.boxOf(hole);
    return coversNothing(document, hole) || (box.width() < kLeastHole && box.height() < kLeastHole);
}

std::vector<FigurePair> closestPairs(const LayerGeometry& a, const LayerGeometry& b, const PairRequest& request,
                                     base::Progress& progress) {
    const PairSearch search(a, b, request);
    std::vector<Closest> found((a.size() + kFiguresPerTask - 1) / kFiguresPerTask);
    base::parallelFor(found.size(), [&](std::size_t task) {
        if (!progress.isCancelled()) {
            const std::size_t first = task * kFiguresPerTask;
            search.search(first, std::min(first + kFiguresPerTask, a.size()), found[task]);
        }
    });
    Closest all;
    for (const Closest& part : found) {
        for (const auto& [group, pair] : part) {
            retain(all, group, pair);
        }
    }
    std::vector<FigurePair> pairs;
    for (const auto& [group, pair] : all) {
        pairs.push_back(pair);
    }
    std::ranges::sort(pairs, isCloser);
    return pairs;
}

}  // namespace model
