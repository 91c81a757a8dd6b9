#include "model/index/figure_cache.h"

#include <algorithm>
#include <functional>
#include <new>
#include <vector>

#include "model/board/single_element.h"

namespace model {

namespace {

constexpr std::size_t kLargeArea = 256;  // edges; of more the outline is kept

std::uint64_t keyOf(std::uint32_t step, ElementId element) {
    return std::uint64_t{step} << 32U | element.value;
}

std::size_t edgesIn(const FigureTable& figures) {
    std::size_t edges = 0;
    for (std::size_t row = 0; row < figures.size(); ++row) {
        edges += figures[row].edgeCount;
    }
    return edges;
}

std::shared_ptr<const FigureTable> figuresOf(const Document& step, ElementId element) {
    FigureTable figures;
    figures.add(step, element);
    return std::make_shared<const FigureTable>(std::move(figures));
}

struct LargeArea {
    std::uint32_t step = 0;
    ElementId element;
    std::size_t nodes = 0;
};

/// The largest first.
std::vector<LargeArea> largeAreasOf(const StepTree& tree) {
    std::vector<LargeArea> areas;
    for (std::uint32_t row = 0; row < tree.steps.size(); ++row) {
        const Document& step = *tree.steps[row];
        for (std::size_t element = 0; element < step.elements.size(); ++element) {
            const std::size_t nodes = nodeCountOf(step, ElementId{element});
            if (step.elements.kind[element] == ElementKind::Area && nodes > kLargeArea) {
                areas.push_back({row, ElementId{element}, nodes});
            }
        }
    }
    std::ranges::stable_sort(areas, std::greater{}, &LargeArea::nodes);
    return areas;
}

}  // namespace

std::shared_ptr<const FigureTable> FigureCache::of(const StepTree& tree, std::uint32_t step, ElementId element) {
    const std::uint64_t key = keyOf(step, element);
    if (std::shared_ptr<const FigureTable> kept = find(key)) {
        return kept;
    }
    std::shared_ptr<const FigureTable> figures = figuresOf(*tree.steps[step], element);
    keep(key, figures);
    return figures;
}

void FigureCache::fill(const StepTree& tree, const base::Progress& progress) try {
    for (const LargeArea& area : largeAreasOf(tree)) {
        if (progress.isCancelled() || edgeCount() + area.nodes > m_room / 2) {
            return;
        }
        (void)of(tree, area.step, area.element);
    }
} catch (const std::bad_alloc&) {
    return;  // what is missing is made when it is requested
}

std::size_t FigureCache::edgeCount() const {
    const std::scoped_lock lock(m_mutex);
    return m_edgeCount;
}

std::shared_ptr<const FigureTable> FigureCache::find(std::uint64_t key) const {
    const std::scoped_lock lock(m_mutex);
    const auto kept = m_large.find(key);
    return kept != m_large.end() ? kept->second : nullptr;
}

void FigureCache::keep(std::uint64_t key, std::shared_ptr<const FigureTable> figures) {
    const std::size_t edges = edgesIn(*figures);
    if (edges <= kLargeArea) {
        return;
    }
    const std::scoped_lock lock(m_mutex);
    if (m_edgeCount + edges > m_room) {
        m_large.clear();
        m_edgeCount = 0;
    }
    m_edgeCount += m_large.try_emplace(key, std::move(figures)).second ? edges : 0;
}

}  // namespace model
