#include "model/index/figure_cache.h"

namespace model {

namespace {

/// Outlines kept for areas: those of more edges than this, until so many edges are kept (72 bytes each).
constexpr std::size_t kLargeArea = 256;
constexpr std::size_t kMostCachedEdges = 4'000'000;

}  // namespace

const FigureTable& FigureCache::of(const BoardIndex& index, std::uint32_t step, ElementId element) {
    const std::uint64_t key = std::uint64_t{step} << 32U | element.value;
    if (const auto cached = m_large.find(key); cached != m_large.end()) {
        return cached->second;
    }
    FigureTable figures;
    figures.add(*index.tree.steps[step], element);
    std::size_t edges = 0;
    for (std::size_t row = 0; row < figures.size(); ++row) {
        edges += figures[row].edgeCount;
    }
    if (edges <= kLargeArea) {
        m_small = std::move(figures);
        return m_small;
    }
    if (m_cachedEdges + edges > kMostCachedEdges) {
        m_large.clear();
        m_cachedEdges = 0;
    }
    m_cachedEdges += edges;
    return m_large.emplace(key, std::move(figures)).first->second;
}

}  // namespace model
