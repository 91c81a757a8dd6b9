#pragma once

#include <cstdint>
#include <unordered_map>

#include "model/figures/figures.h"
#include "model/index/board_index.h"

namespace model {

/// The figures of elements for repeated requests, as of a pointer: outlines of large areas are cached once
/// they were requested. One thread at a time.
class FigureCache {
public:
    /// In the coordinates of the step, a row of `index.tree.steps`. Counts until the next call.
    const FigureTable& of(const BoardIndex& index, std::uint32_t step, ElementId element);

private:
    std::unordered_map<std::uint64_t, FigureTable> m_large;
    FigureTable m_small;  ///< of the element requested last, if that is not worth keeping
    std::size_t m_cachedEdges = 0;
};

}  // namespace model
