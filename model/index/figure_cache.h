#pragma once

#include <cstdint>
#include <memory>
#include <mutex>
#include <unordered_map>

#include "model/base/progress.h"
#include "model/board/copies.h"
#include "model/figures/figures.h"

namespace model {

/// The figures of elements for repeated requests, as of a pointer: outlines of large areas are kept once they were
/// made, as many as there is room for. Any thread; a thread never waits for what another one makes.
class FigureCache {
public:
    /// `room`: in edges, of 72 bytes each.
    explicit FigureCache(std::size_t room = 4'000'000) : m_room(room) {}

    /// In the coordinates of the step, a row of `tree.steps`. Always the same tree, but for heights.
    [[nodiscard]] std::shared_ptr<const FigureTable> of(const StepTree& tree, std::uint32_t step, ElementId element);

    /// Makes and keeps the outlines of all large areas before they are requested, the largest first, until half of the
    /// room is taken, memory is short or the work is cancelled. A pointer on a plane would wait for its outline.
    void fill(const StepTree& tree, const base::Progress& progress);
    /// Of what is kept.
    [[nodiscard]] std::size_t edgeCount() const;

private:
    [[nodiscard]] std::shared_ptr<const FigureTable> find(std::uint64_t key) const;
    void keep(std::uint64_t key, std::shared_ptr<const FigureTable> figures);

    std::size_t m_room;
    mutable std::mutex m_mutex;  ///< of all below
    std::unordered_map<std::uint64_t, std::shared_ptr<const FigureTable>> m_large;
    std::size_t m_edgeCount = 0;  ///< of what is kept
};

}  // namespace model
