#include "model/base/parallel.h"

#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <atomic>
#include <new>
#include <numeric>
#include <stdexcept>

#ifdef COPPERSCOPE_THREAD_SANITIZER
#include <sanitizer/tsan_interface.h>
#endif

namespace base {

namespace {

/// The order that parallel_for guarantees: what the caller did before is seen by every task, what tasks did is seen by
/// the caller after. The thread sanitizer has to be told, because TBB's library is not instrumented; in other builds
/// this is nothing.
class ForkJoin {
public:
#ifdef COPPERSCOPE_THREAD_SANITIZER
    ForkJoin() {
        __tsan_release(&m_fork);
    }
    ~ForkJoin() {
        __tsan_acquire(&m_join);
    }
    void beginTask() {
        __tsan_acquire(&m_fork);
    }
    void endTask() {
        __tsan_release(&m_join);
    }

private:
    char m_fork = 0;
    char m_join = 0;
#else
    void beginTask() {}
    void endTask() {}
#endif
};

/// Hands out rows in rising order, one by one while they may be large, a thousandth of those that are gone later, so
/// that many small tasks cost nothing to speak of.
class Rows {
public:
    explicit Rows(std::size_t count) : m_count(count) {}

    struct Range {
        std::size_t first;
        std::size_t end;
    };
    /// Empty once there are none left.
    Range take() {
        std::size_t first = m_next.load(std::memory_order_relaxed);
        std::size_t end = 0;
        do {
            end = std::min(first + 1 + first / 1024, m_count);
        } while (first < m_count && !m_next.compare_exchange_weak(first, end, std::memory_order_relaxed));
        return {first, std::max(first, end)};
    }
    void drop() { m_next = m_count; }

private:
    std::size_t m_count;
    std::atomic<std::size_t> m_next = 0;
};

}  // namespace

void parallelFor(std::size_t count, const std::function<void(std::size_t)>& task) {
    ForkJoin order;
    Rows rows(count);
    std::atomic<bool> hasTaskThrown = false;
    const auto run = [&](std::size_t) {
        order.beginTask();
        try {
            for (Rows::Range range = rows.take(); range.first < range.end; range = rows.take()) {
                for (std::size_t i = range.first; i < range.end; ++i) {
                    task(i);
                }
            }
        } catch (...) {
            hasTaskThrown = true;
            rows.drop();
            order.endTask();
            throw;
        }
        order.endTask();
    };
    try {
        // TBB's own division gives a thread runs of neighbours, the largest of which would all be the first one's.
        const auto threads = static_cast<std::size_t>(tbb::this_task_arena::max_concurrency());
        tbb::parallel_for(std::size_t{0}, std::min(count, threads), run, tbb::simple_partitioner());
    } catch (const std::runtime_error&) {
        if (hasTaskThrown) {
            throw;
        }
        throw std::bad_alloc();  // TBB found no room for the stack of a thread
    }
}

std::vector<std::uint32_t> largestFirst(std::size_t count, const std::function<std::size_t(std::size_t)>& sizeOf) {
    std::vector<std::uint32_t> rows(count);
    std::iota(rows.begin(), rows.end(), 0U);
    std::ranges::stable_sort(rows, std::greater{}, sizeOf);
    return rows;
}

ThreadLimit::ThreadLimit(int threads)
    : m_control(threads > 0 ? new tbb::global_control(tbb::global_control::max_allowed_parallelism,
                                                      static_cast<std::size_t>(threads))
                            : nullptr) {}

ThreadLimit::~ThreadLimit() {
    delete static_cast<tbb::global_control*>(m_control);
}

}  // namespace base
