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

using Narrowest = std::unordered_map<std::uint64_t, FigurePair>;

bool isNarrower(const FigurePair& x, const FigurePair& y) {
    return std::tuple(x.gap.distance, x.a, x.b) < std::tuple(y.gap.distance, y.a, y.b);
}

void keep(Narrowest& narrowest, std::uint64_t group, const FigurePair& found) {
    const auto [location, isFirst] = narrowest.try_emplace(group, found);
    if (!isFirst && isNarrower(found, location->second)) {
        location->second = found;
    }
}

bool holds(const Box& box, PointD p) {
    return box.min.x <= p.x && p.x <= box.max.x && box.min.y <= p.y && p.y <= box.max.y;
}

class PairSearch {
public:
    PairSearch(const LayerGeometry& a, const LayerGeometry& b, const PairQuestion& question)
        : m_a(a), m_b(b), m_question(question) {}

    /// Between figures first … end - 1 of the first sheet and those of the second.
    void search(std::size_t first, std::size_t end, Narrowest& found) const {
        std::vector<std::uint32_t> near;
        for (std::size_t i = first; i < end; ++i) {
            const auto row = static_cast<std::uint32_t>(i);
            near.clear();
            m_b.visitNear(m_a.figures().box(i), m_question.reach, [&](std::uint32_t j) {
                if ((&m_a != &m_b || j > row) && m_question.isWanted(row, j)) {
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
    [[nodiscard]] bool isInside(const Gap& gap) const {
        return !m_question.within || holds(*m_question.within, gap.from) || holds(*m_question.within, gap.to);
    }

    void measure(std::uint32_t i, std::uint32_t j, Narrowest& found) const {
        const std::uint64_t group = m_question.groupOf(i, j);
        const auto known = found.find(group);
        const double limit = known == found.end() ? m_question.reach : known->second.gap.distance;
        const std::optional<Gap> gap = spacingBetween(m_a.figures(), i, m_b.figures(), j, limit);
        if (gap && isInside(*gap) && (gap->distance > kTouchNm || m_question.mayTouch(i, j))) {
            keep(found, group, {i, j, *gap});
        }
    }

    const LayerGeometry& m_a;
    const LayerGeometry& m_b;
    const PairQuestion& m_question;
};

void addLayer(LayerGeometry& plane, const Document& document, const Layer& layer, const ElementFilter& isWanted) {
    for (std::uint32_t i = layer.elements.first; i < layer.elements.first + layer.elements.count; ++i) {
        if (isWanted(ElementId{i})) {
            plane.add(document, ElementId{i});
        }
    }
}

}  // namespace

void LayerGeometry::addOutlines(const Document& document, ShapeId shape) {
    m_figures.addOutline(document.shapes, shape);
}

void LayerGeometry::finish() {
    m_index = std::make_shared<const BoxIndex>(m_figures.outerBoxes());
}

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
    LayerGeometry plane;
    addLayer(plane, document, document.layer(layer), isWanted);
    for (const Layer& drill : document.layers) {
        if (drill.spans(layer)) {
            addLayer(plane, document, drill, [&](ElementId hole) {
                return isPlatedHole(document.elements.flags[hole.row()]) && document.platedSpanOf(hole).joins(layer) &&
                       isWanted(hole);
            });
        }
    }
    plane.finish();
    return plane;
}

LayerGeometry holeGeometry(const Document& document, LayerId layer) {
    LayerGeometry plane;
    for (const Layer& drill : document.layers) {
        if (drill.spans(layer)) {
            addLayer(plane, document, drill,
                     [&](ElementId hole) { return (document.elements.flags[hole.row()] & kHole) != 0; });
        }
    }
    plane.finish();
    return plane;
}

LayerGeometry layerGeometry(const Document& document, LayerId layer) {
    LayerGeometry plane;
    addLayer(plane, document, document.layer(layer), isAnyElement);
    plane.finish();
    return plane;
}

LayerGeometry edgeGeometry(const Document& document) {
    LayerGeometry plane;
    if (document.profile.isValid()) {
        plane.addOutlines(document, document.profile);
    }
    plane.finish();
    return plane;
}

std::vector<FigurePair> narrowestPairs(const LayerGeometry& a, const LayerGeometry& b, const PairQuestion& question,
                                       base::Progress& progress) {
    const PairSearch search(a, b, question);
    std::vector<Narrowest> found((a.size() + kFiguresPerTask - 1) / kFiguresPerTask);
    base::parallelFor(found.size(), [&](std::size_t task) {
        if (!progress.isCancelled()) {
            const std::size_t first = task * kFiguresPerTask;
            search.search(first, std::min(first + kFiguresPerTask, a.size()), found[task]);
        }
    });
    Narrowest all;
    for (const Narrowest& part : found) {
        for (const auto& [group, pair] : part) {
            keep(all, group, pair);
        }
    }
    std::vector<FigurePair> pairs;
    for (const auto& [group, pair] : all) {
        pairs.push_back(pair);
    }
    std::ranges::sort(pairs, isNarrower);
    return pairs;
}

}  // namespace model
